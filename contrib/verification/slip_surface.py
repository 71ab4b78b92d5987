# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of slip surfaces."""

import numpy as np


def horizontal_width(points, cell, c):
    """Horizontal width (m) at a height of 2 m of the main slip: from the first
    point, seen from the water, that has lost more than half of what it can lose
    of its strength, to the next one that has not. c: initial strength (kPa), of
    a sensitivity of 2.6."""
    x, y = points["position"][:, 0], points["position"][:, 1]
    row = np.abs(y - 2.0) < 0.5 * cell
    order = np.argsort(x[row])
    intact = points["undrained_shear_strength"][row][order] \
        > 0.5 * (c + c / 2.6)
    x = x[row][order]
    if intact.all():
        return 0.0
    start = np.argmin(intact)
    after = intact[start:]
    return (x[start + np.argmax(after)] if after.any() else x[-1]) - x[start]
