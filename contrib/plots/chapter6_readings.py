# SPDX-License-Identifier: LGPL-2.1-or-later
"""How numbers are read from the realisations of chapter 6: each reading is a pair
of functions of the sets, in 3D and in 2D, that return text, or None if there are
no realisations."""

import numpy as np
from chapter6_data import FIRST_CLASS, paired
from estimates import mean_of_few, proportion

NOT_ASKED = "–"
CREST = 2.5  # m, width of the crest
LENGTH = 8.0  # m


def ratio(mask):
    count, n = int(np.sum(mask)), len(mask)
    if n == 0:
        return None
    p, low, high = proportion(count, n)
    return f"{p:.3g} [{low:.3g}, {high:.3g}], {count} of {n}"


def average(values):
    values = values[~np.isnan(values)]
    if len(values) == 0:
        return None
    middle, low, high = mean_of_few(values)
    between = "" if np.isnan(low) else f" [{low:.2f}, {high:.2f}]"
    return f"{middle:.2f}{between}, N = {len(values)}".replace("-", "−")


def reach(values):
    """Mean and the range of 5 to 95 %; all of few."""
    values = values[~np.isnan(values)]
    n = len(values)
    if n == 0:
        return None
    if n < 20:
        return (f"{values.min():.2f} to {values.max():.2f}, all of {n}; mean "
                + average(values).split(", N")[0])
    low, high = np.quantile(values, (0.05, 0.95))
    return (f"{low:.2f} to {high:.2f} (5 to 95 %); mean "
            + average(values))


def peak(values):
    """The most frequent value."""
    values = values[~np.isnan(values)]
    if len(values) == 0:
        return None
    kinds, counts = np.unique(values, return_counts=True)
    return (f"most often {kinds[np.argmax(counts)]:.2f}, {counts.max()} of "
            f"{len(values)}")


def both(get):
    """The same reading in 3D and in 2D: two functions of the sets."""
    return (lambda sets: get(sets, False)), (lambda sets: get(sets, True))


def of(analysis, read):
    """`read(set)` of one analysis, or None if it is not there."""
    def get(sets, plane):
        s = sets.analysis(analysis, plane)
        return None if s is None or not len(s) else read(s)
    return both(get)


def slides(analysis):
    """The screen under own weight alone."""
    def get(sets, plane):
        s = sets.screen(analysis, plane)
        if s is None:
            return None
        failed = s.mask_outcome & s.mask_fails
        return ratio(s.mask_fails) + (
            "" if np.array_equal(failed, s.mask_fails) else
            f"; the outcome of {int(failed.sum())} is *initial failure*")
    return both(get)


def slid(analysis, read):
    """`read(set, rows)` of those that slide in the screen."""
    def get(sets, plane):
        s = sets.screen(analysis, plane)
        return None if s is None or not s.mask_fails.any() else \
            read(s, s.mask_fails)
    return both(get)


def stands(analysis):
    def get(sets, plane):
        s = sets.screen(analysis, plane)
        return None if s is None else ratio(~s.mask_fails)
    return both(get)


def below(limit):
    return lambda s: ratio(s["load"] < limit - 1e-9)


def above(column, limit):
    return lambda s: ratio(s[column] > limit)


def ranges(column, chosen=lambda s: np.full(len(s), True)):
    return lambda s: reach(s[column][chosen(s)])


def bearing(s):
    return s["load"] >= FIRST_CLASS - 1e-9


def inherent(s):
    return ~bearing(s)


def cut(chosen):
    """How far behind the edge of the crest the first slide leaves it (m)."""
    return lambda s: reach(CREST - s["inner_slide_crest_cut"][chosen(s)])


def times(numerator, denominator):
    """How many times as many are inherently unstable, by the screen or, without
    it, by the first class."""
    def get(sets, plane):
        pairs = [(sets.screen(a, plane), lambda s: s.mask_fails)
                 for a in (numerator, denominator)]
        how = "screen"
        if any(s is None for s, _ in pairs):
            pairs = [(sets.analysis(a, plane), inherent)
                     for a in (numerator, denominator)]
            how = "load below 0.1 m"
        rows = paired(*(s for s, _ in pairs))
        if not len(rows[0]):
            return None
        p, q = (np.mean(mask(s)[i]) for (s, mask), i in zip(pairs, rows))
        return (f"{p:.3g} against {q:.3g} ({how}), N = {len(rows[0])}"
                + (f": {p / q:.2f} times" if q > 0 else ""))
    return both(get)


def common(sets, plane, column, one, other):
    """The values of two analyses, of the same realisations."""
    pair = [sets.analysis(a, plane) for a in (one, other)]
    rows = paired(*pair)
    return [s[column][i] for s, i in zip(pair, rows)] if len(rows[0]) else None


def against(column, one, other):
    """Means of two analyses."""
    def get(sets, plane):
        values = common(sets, plane, column, one, other)
        if values is None:
            return None
        texts = [average(v) for v in values]
        return None if None in texts else " against ".join(
            [texts[0].split(", N")[0], texts[1]])
    return both(get)


def deviations(column, one, other):
    def get(sets, plane):
        values = common(sets, plane, column, one, other)
        if values is None or len(values[0]) < 2:
            return None
        return " against ".join(f"{np.nanstd(v, ddof=1):.2f}" for v in values
                                ) + f", N = {len(values[0])}"
    return both(get)


def over_mean(column, analysis):
    """Mean over that of the slope of mean strengths."""
    def get(sets, plane):
        s = sets.analysis(analysis, plane)
        mean = sets.deterministic(analysis, plane, column)
        if s is None or mean is None:
            return None
        values = s[column][~np.isnan(s[column])]
        return f"{np.mean(values):.2f} against {mean:.2f}, N = {len(values)}"
    return both(get)


def ratio_to_mean(column, analysis):
    def get(sets, plane):
        s = sets.analysis(analysis, plane)
        mean = sets.deterministic(analysis, plane, column)
        return None if s is None or mean is None else reach(s[column] / mean)
    return both(get)


def alone(column, analysis, digits=2):
    """Of the slope of mean strengths itself."""
    def get(sets, plane):
        value = sets.deterministic(analysis, plane, column)
        return None if value is None else f"{value:.{digits}f}"
    return both(get)


def only_space(pair):
    return pair[0], NOT_ASKED
