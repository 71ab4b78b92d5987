#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A river that rises slowly, and the phreatic line with it: at the end effective stress and pore
pressure are those of a river that always stood there; and they are not without the line. A slice of it in space, weaker, moves as in the plane.

    /usr/bin/python3 tests/cases/rising_line.py WAKER SOURCE_DIRECTORY
"""

import numpy as np
from waker_case import Checks, workspace_of_arguments

CASE = "verification/dyke_rising_line.prm"
STRESSES = ("stress_xx", "stress_yy", "stress_xy")


def at_end(work, name, settings):
    run = work.run(name, CASE, settings)
    points = run.points()
    order = np.argsort(points["id"])
    return run, {key: points[key][order] for key in (*STRESSES, "pore_pressure",
                                                     "position")}


def difference(a, b, away):
    """rms of the stresses' differences over that of the stress, away from the
    surface, where a point yields in one way or another."""
    square = sum(np.sum((a[s][away] - b[s][away])**2) for s in STRESSES)
    whole = sum(np.sum(b[s][away]**2) for s in STRESSES)
    return np.sqrt(square / whole)


def in_space(work, checks):
    """Drained soil that yields while the line rises in it."""
    weak = {"Materials/sandy clay/Cohesion": 3, "Materials/sandy clay/Friction angle": 20,
            "Materials/sandy clay/Young's modulus": 2000,
            "Water/Rise": "0: 0, 2: 2", "Time stepping/End time": 2,
            "Water/Minimum support": 0, "Newton/Tolerance": 1e-6,
            "Newton/Linear tolerance": 1e-3}
    slice_ = {"Dimension": 3, "Grid/Lower corner": "-4, 0, 0",
              "Grid/Upper corner": "34, 6, 0.5",
              "Boundary conditions/Names": "base, back side, front side",
              **{f"Boundary conditions/{name} side/{key}": value
                 for name in ("back", "front")
                 for key, value in (("Region", name), ("Type", "roller"))}}
    ends = {}
    for name, more in (("plane", {}), ("slice", slice_)):
        run = work.run(name, CASE, {**weak, **more})
        points = run.points()
        checks.above(f"{name}: share of the points that yield",
                     np.mean(points["plastic_strain"] > 1e-4), 0.1)
        ends[name] = {key: points[key][:, :2].mean(axis=0) if key == "displacement"
                      else points[key].mean()
                      for key in ("displacement", "pore_pressure",
                                  "plastic_strain")}
    for key in ends["plane"]:
        largest = np.abs(ends["plane"][key]).max()
        checks.below(f"mean {key}: slice by plane, difference by the largest",
                     np.abs(ends["slice"][key] - ends["plane"][key]).max() / largest, 1e-4)
    checks.above("mean displacement", np.abs(ends["plane"]["displacement"]).max(), 0.003, "m")


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        run, rose = at_end(work, "rose", {})
        checks.equal("outcome", run["outcome"], "stable")
        _, stood = at_end(work, "stood", {"Water/Level": 3, "Water/Rise": 0})
        _, low = at_end(work, "low", {"Water/Rise": 0})
        _, skin = at_end(work, "skin", {
            "Pore water/Lines by level": "",
            "Pore water/Phreatic line": "-1, 1; 3, 1; 28, 0; 29, 0"})
        in_space(work, checks)
    checks.below("pore pressure, largest difference (kPa)",
                 np.abs(rose["pore_pressure"] - stood["pore_pressure"]).max(), 0.1)
    checks.above("  while it rose by (kPa)",
                 np.abs(rose["pore_pressure"] - low["pore_pressure"]).max(), 19)
    x, y = stood["position"][:, 0], stood["position"][:, 1]
    away = y < np.minimum(np.minimum(x, 28 - x) / 3, 4) - 0.75
    checks.above("points away from the surface", int(away.sum()), 500)
    checks.below("effective stress: rms difference by its rms",
                 difference(rose, stood, away), 0.02)
    checks.above("  before the rise", difference(low, stood, away), 0.1)
    checks.above("  with a line that stays", difference(skin, stood, away), 0.1)
    checks.finish()


if __name__ == "__main__":
    main()
