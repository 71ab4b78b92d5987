# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inner toe of the weak dyke on bases that hold it and on ground with friction:
settings, and where it ends.

Shared by contact.py here and in contrib/verification.
"""

import numpy as np

HELD = "chapter5/dyke_weak.prm"
ON_GROUND = "verification/dyke_on_ground.prm"
TOE = 30.0  # m, where it is at the start
END = {"Stop rules/On flooding": "false"}


def cells(size):
    """Of held nodes, with as much work in a band on cells of any size (m)."""
    return {"Grid/Cell size": size, "Time stepping/Time step": 0.04 * size,
            "Materials/clay/Softening length": 0.25}


def cells_on_ground(size):
    """Of ground, which lies in the middle of a row of cells."""
    return {**cells(size), "Time stepping/Time step": 0.01 * size,
            "Grid/Lower corner": f"-6, {-size / 2:g}",
            "Grid/Upper corner": f"42, {6 - size / 2:g}"}


def profile(points, cell):
    """Columns of half a cell: x, lowest and highest edge of the soil (m)."""
    x, y = points["position"][:, 0], points["position"][:, 1]
    edges = np.arange(15.0, 42.0, 0.5 * cell)
    rows = []
    for left, right in zip(edges[:-1], edges[1:]):
        inside = (x >= left) & (x < right)
        if inside.any():
            rows.append((0.5 * (left + right),
                         y[inside].min() - 0.25 * cell,
                         y[inside].max() + 0.25 * cell))
    return np.array(rows)


def fronts(rows, cell):
    """Of such columns, how far the soil is beyond the first toe, how far that which lies
    on the ground (within a quarter of a cell), and how high the tip hangs (m)."""
    on_ground = rows[rows[:, 1] < 0.25 * cell]
    return (rows[-1, 0] + 0.25 * cell - TOE,
            on_ground[-1, 0] + 0.25 * cell - TOE, rows[-1, 1])
