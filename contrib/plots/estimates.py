# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proportions and their intervals, with numpy alone."""

import math

import numpy as np


def _continued_fraction(a, b, x):
    """Of the incomplete beta function, for x < (a + 1) / (a + b + 2)
    (DLMF 8.17.22, by the modified algorithm of Lentz)."""
    tiny = 1e-300
    c, d = 1.0, 1.0 - (a + b) * x / (a + 1)
    d = 1.0 / (d if abs(d) > tiny else tiny)
    value = d
    for m in range(1, 1000):
        for term in (m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                     -(a + m) * (a + b + m) * x
                     / ((a + 2 * m) * (a + 2 * m + 1))):
            d = 1.0 + term * d
            d = 1.0 / (d if abs(d) > tiny else tiny)
            c = 1.0 + term / c
            c = c if abs(c) > tiny else tiny
            factor = c * d
            value *= factor
        if abs(factor - 1.0) < 1e-14:
            break
    return value


def incomplete_beta(a, b, x):
    """I_x(a, b), regularised."""
    if x <= 0.0 or x >= 1.0:
        return float(x >= 1.0)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b)
                     + a * math.log(x) + b * math.log1p(-x))
    if x < (a + 1) / (a + b + 2):
        return front * _continued_fraction(a, b, x) / a
    return 1.0 - front * _continued_fraction(b, a, 1.0 - x) / b


def beta_quantile(a, b, probability):
    """x with I_x(a, b) = probability, by bisection."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if incomplete_beta(a, b, middle) < probability:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def clopper_pearson(count, n, level=0.95):
    """(low, high): the exact interval of a proportion, after `count` of n
    (Clopper & Pearson 1934)."""
    tail = (1.0 - level) / 2
    low = beta_quantile(count, n - count + 1, tail) if count > 0 else 0.0
    high = beta_quantile(count + 1, n - count, 1 - tail) if count < n else 1.0
    return low, high


def proportion(count, n):
    """(estimate, low, high) with the 95 % interval; the estimate is NaN and the
    interval all of [0, 1] if n = 0."""
    if n == 0:
        return math.nan, 0.0, 1.0
    return (count / n,) + clopper_pearson(count, n)


def sign_test(one, other):
    """p, two-sided and exact, of McNemar's test: of the pairs that differ, `one`
    have it in the first alone, `other` in the second."""
    n = one + other
    tail = sum(math.comb(n, k) for k in range(min(one, other) + 1)) / 2**n
    return min(1.0, 2.0 * tail)


def kind(estimate):
    """What an estimate says by itself, in the words of the report: none of n is
    an upper bound, all of n a lower one."""
    if math.isnan(estimate):
        return "unknown"
    return ("upper bound" if estimate <= 0.0 else
            "lower bound" if estimate >= 1.0 else "estimate")


def before(times, n, grid):
    """Probability that an event has occurred at each time of the grid or
    before: arrays (estimate, low, high)."""
    counts = np.searchsorted(np.sort(times), grid + 1e-9, side="right")
    table = {count: proportion(int(count), n) for count in np.unique(counts)}
    return np.array([table[count] for count in counts]).T


def mean_with_interval(values):
    """(mean, low, high) with the normal 95 % interval; NaN where too few."""
    if len(values) == 0:
        return math.nan, math.nan, math.nan
    mean = float(np.mean(values))
    if len(values) == 1:
        return mean, math.nan, math.nan
    half = 1.96 * float(np.std(values, ddof=1)) / math.sqrt(len(values))
    return mean, mean - half, mean + half


def student(degrees, level=0.95):
    """t that the modulus of Student's t exceeds with probability 1 - level."""
    x = beta_quantile(degrees / 2, 0.5, 1.0 - level)
    return math.sqrt(degrees * (1.0 / x - 1.0))


def mean_of_few(values):
    """(mean, low, high) with Student's 95 % interval; NaN where too few."""
    n = len(values)
    if n < 2:
        return (float(values[0]) if n else math.nan), math.nan, math.nan
    mean = float(np.mean(values))
    half = student(n - 1) * float(np.std(values, ddof=1)) / math.sqrt(n)
    return mean, mean - half, mean + half


def histogram(values, edges):
    """Shares (%) of the values in each bin; zeros if there are none."""
    counts, _ = np.histogram(values, edges)
    return counts, 100.0 * counts / max(1, len(values))
