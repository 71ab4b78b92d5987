#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large elastic strain: the column under its weight and the cantilever
(doc/verification/column.md, cantilever.md).

    /usr/bin/python3 tests/cases/large_strain.py WAKER SOURCE_DIR
"""

import os
import sys
import tempfile

import numpy as np
from runs import Check, run
from waker_case import Run

HEIGHT, UNIT_WEIGHT, YOUNG = 50.0, 0.8, 10.0  # m, kN/m^3, kPa
AMPLE = {8: 1.294e-2, 16: 3.659e-3, 32: 1.049e-3}  # error of the stress


def column_parameters(cells, **mapping):
    """{"Section/Name": value} of column.prm with so many cells."""
    h = repr(HEIGHT / cells)
    return {"Grid/Cell size": h, "Grid/Upper corner": f"{h}, 50",
            "Soil profile/column/Polygon": f"0, 0; {h}, 0; {h}, 50; 0, 50",
            **{f"Kinematics and mapping/{key}": value
               for key, value in mapping.items()}}


def lambert(q):
    """W(q), the solution of W exp(W) = q."""
    w = np.log1p(q)
    for _ in range(20):
        w = w - (w * np.exp(w) - q) / (np.exp(w) * (1.0 + w))
    return w


def deformed_height(cells_weight=UNIT_WEIGHT * HEIGHT / YOUNG):
    """Of the column under its full weight (m)."""
    w = lambert(cells_weight)
    return YOUNG / UNIT_WEIGHT * (w + 0.5 * w * w)


def column_error(points):
    """Mean error of sigma_yy over the stress at the base."""
    start = points["position"][:, 1] - points["displacement"][:, 1]
    exact = -UNIT_WEIGHT * (HEIGHT - start)
    mass = points["mass"]
    return (np.sum(np.abs(points["stress_yy"] - exact) * mass)
            / (UNIT_WEIGHT * HEIGHT * np.sum(mass)))


def tip_box(h, per_direction):
    """From and To of the two points next to the middle of the end."""
    size = h / per_direction
    return {"Point loads/tip/From": f"{10 - size!r}, {9.5 - size!r}",
            "Point loads/tip/To": f"10, {9.5 + size!r}"}


def cantilever_parameters(h, per_direction, force=10.417, **more):
    return {"Grid/Cell size": h,
            "Material points/Points per direction": per_direction,
            "Point loads/tip/Force": f"0, {-force}",
            **tip_box(h, per_direction), **more}


def tip_displacement(points, h, per_direction):
    """Displacement (m) of the loaded points: back and down positive."""
    size = h / per_direction
    start = points["position"] - points["displacement"]
    loaded = ((start[:, 0] > 10 - size)
              & (np.abs(start[:, 1] - 9.5) < size))
    assert loaded.sum() == 2
    u = points["displacement"][loaded].mean(axis=0)
    return float(-u[0]), float(-u[1])


def run_case(waker, source, folder, name, parameters):
    sections = {}
    for path, value in parameters.items():
        section, _, key = path.rpartition("/")
        sections.setdefault(section.replace("/", "__"), {})[key] = value
    run(waker, os.path.join(source, "parameters", "chapter3", name + ".prm"),
        folder, **sections)
    return Run(folder)


def main(waker, source):
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        errors = {}
        for cells in (8, 16):
            points = run_case(waker, source, folder, "column",
                              column_parameters(cells)).points()
            errors[cells] = column_error(points)
            check(f"column, {cells} cells: error of the stress",
                  errors[cells], 0.98 * AMPLE[cells], 1.02 * AMPLE[cells])
        check("column: order", np.log2(errors[8] / errors[16]), 1.6, 2.2)
        points = run_case(waker, source, folder, "column",
                          column_parameters(16, Domains="constant")).points()
        check("column, constant domains: error", column_error(points),
              4 * errors[16], 0.05)

        down = {}
        for h in (0.25, 0.125):
            case = run_case(waker, source, folder, "cantilever",
                            cantilever_parameters(h, 3))
            back, down[h] = tip_displacement(case.points(), h, 3)
            rows = case.statistics
            check(f"cantilever, h = {h}: elastic energy / work of the force",
                  rows["Elastic energy (kJ)"][-1]
                  / rows["Work of the water (kJ)"][-1], 0.98, 1.002)
        check("cantilever: tip down (m)", down[0.125], 0.98 * 3.039,
              1.02 * 3.039)
        check("cantilever: tip back (m)", back, 0.98 * 0.568, 1.02 * 0.568)
        check("cantilever: error with h / with 2 h",
              abs(down[0.125] - 3.039) / abs(down[0.25] - 3.039), 0.0, 0.5)
    check.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
