# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of columns of sand that collapse, and what experiments found.

Shared by granular_columns.py here and in contrib/verification.
"""

import numpy as np

CASE = "verification/sand_column.prm"
ANGLE = "Materials/sand/Friction angle"
WIDTH = 0.1  # m, L
BOX = 0.9  # m, length of the grid
# (L' - L)/L over a, of plane columns: Lube et al. (sand), Lajeunesse et al. (beads).
LAWS = {31.0: 1.2, 22.0: 1.8}


def settings(ratio, cell):
    """Of a column of the ratio a = H/L, on cells of this size (m)."""
    height = ratio * WIDTH
    return {"Grid/Cell size": cell, "Time stepping/Time step": 0.05 * cell,
            "Soil profile/pile/Polygon":
                f"0, 0; 0.1, 0; 0.1, {height:g}; 0, {height:g}"}


def profile(run, width=WIDTH / 10):
    """Places, and the mean height of the soil (m) in strips around them."""
    points = run.points()
    edges = np.arange(0, BOX + width / 2, width)
    volume, _ = np.histogram(points["position"][:, 0], edges,
                             weights=points["volume"])
    return (edges[1:] + edges[:-1]) / 2, volume / width


def front(run, height):
    """How far (m) the soil reaches with this height, without a gap; NaN: to the end
    of the box."""
    x, h = profile(run)
    lower = np.nonzero(h < height)[0]
    if len(lower) == 0:
        return float("nan")
    end = lower[0]
    return float(np.interp(height, [h[end], h[end - 1]], [x[end], x[end - 1]]))
