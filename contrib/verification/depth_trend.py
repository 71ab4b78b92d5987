#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of doc/verification/depth_trend.md: the dyke of chapter 5 of clay that
grows stronger with depth, against slip circles.

    /usr/bin/python3 contrib/verification/depth_trend.py
"""

import numpy as np
from dyke_runs import workspace

CASE = "verification/dyke_depth.prm"
WEIGHT = 15.0  # kN/m^3


def height(x):
    """Of the dyke at x (m)."""
    return np.minimum(np.minimum(x, 5.0), (30.0 - x) / 3.0)


def circle_through(entry, leave, sagitta):
    """From the crest at x = entry to the inner slope at x = leave (m)."""
    a, b = np.array([entry, 5.0]), np.array([leave, height(leave)])
    chord = np.hypot(*(b - a))
    up = np.array([a[1] - b[1], b[0] - a[0]]) / chord
    radius = (chord**2 / 4 + sagitta**2) / (2 * sagitta)
    return (a + b) / 2 + up * (radius - sagitta), radius


def deepest(entry, leave):
    """The sagitta (m) with which the circle touches the firm base, at most that
    of half a circle."""
    low, high = 1e-3, np.hypot(leave - entry, 5 - height(leave)) / 2
    for _ in range(40):
        middle = 0.5 * (low + high)
        centre, radius = circle_through(entry, leave, middle)
        lowest = (centre[1] - radius if centre[0] < leave
                  else height(leave))
        low, high = (middle, high) if lowest >= 0 else (low, middle)
    return low


def factor_of_circle(entry, leave, share, top, k, n=400):
    """Moment of the strength top + k depth over that of the weight, about the
    centre. share: of the deepest circle's sagitta."""
    centre, radius = circle_through(entry, leave,
                                    share * deepest(entry, leave))
    width = (leave - entry) / n
    x = entry + (np.arange(n) + 0.5) * width
    inside = radius**2 - (x - centre[0])**2
    if centre[1] < 5 or inside.min() <= 0:
        return np.inf
    depth = height(x) - (centre[1] - np.sqrt(inside))
    if depth.min() < 0:
        return np.inf  # out of the dyke
    weight = WEIGHT * (depth * (centre[0] - x)).sum() * width
    length = radius / np.sqrt(inside) * width
    strength = radius * ((top + k * depth) * length).sum()
    return strength / weight if weight > 0 else np.inf


def smallest_factor(top, k):
    """A search of grids, each around the best of the one before."""
    best, place = np.inf, np.array([9.0, 25.0, 0.5])
    for width in 5.0 * 0.7**np.arange(18):
        centre = place.copy()
        for step in np.stack(np.meshgrid(*[np.linspace(-1, 1, 7)] * 3),
                             axis=-1).reshape(-1, 3):
            entry, leave, share = centre + width * step * (1, 1, 0.1)
            share = min(share, 1.0)
            if not (5 <= entry < leave <= 30 and share > 0.01):
                continue
            found = factor_of_circle(entry, leave, share, top, k)
            if found < best:
                best, place = found, np.array([entry, leave, share])
    return best


def main():
    print(f"c = 13 kPa, circle: {smallest_factor(13.0, 0.0):.3f}")
    print(f"c = 6 + 1.5 d kPa, circle: {smallest_factor(6.0, 1.5):.3f}")
    bracket = {"Strength reduction/Lower factor": 0.75,
               "Strength reduction/Upper factor": 1.5,
               "Strength reduction/Tolerance": 0.02}
    with workspace(__doc__) as work:
        for name, sets in (
                ("no softening", {
                    "Materials/clay/Residual strength": "initial_strength",
                    "Materials/clay/Softening modulus": 0}),
                ("softening", {})):
            result = work.factor_of_safety(name.replace(" ", "-"), CASE,
                                           {**bracket, **sets})
            print(f"{name}: {result['factor_of_safety']:.3f}, "
                  f"{result['failure']['slope']} slope", flush=True)


if __name__ == "__main__":
    main()
