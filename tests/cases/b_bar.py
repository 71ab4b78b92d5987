#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-bar does not lock: a strip footing against Prandtl, a slope of 45 degrees
against its slip circle. Nor does it move ground under water (doc/verification/b_bar.md).

usage: b_bar.py WAKER SOURCE_DIRECTORY
"""

import math

import numpy as np
from waker_case import Checks, workspace_of_arguments

FOOTING, SLOPE = "verification/strip_footing.prm", "verification/slope_45.prm"
FORELAND = "verification/foreland.prm"
KIND = "Kinematics and mapping/Volumetric strain"
COHESION, CIRCLE = 10.0, 3.30  # kPa


def load(run):
    """Load per area of 1 m over c, by step: work of the footing over its
    settlement, 1 mm a step."""
    return np.diff(run.statistics["Work of the supports (kJ)"]) / 1e-3 / COHESION


def foreland(checks, work):
    """Soil in cells that it hardly fills stands under water: dykes with ground in
    front of the toe, at several places on the grid."""
    for shift, run_out in ((0.0, 12.0), (0.1, 12.0), (0.35, 12.0), (0.1, 16.0)):
        outline = (f"{shift}, 2; {run_out + 11}, 2; {run_out + 3}, 6; "
                   f"{run_out}, 6")
        name = f"outer slope of {run_out:g} m less {shift:g} m"
        run = work.run(f"foreland-{run_out:g}-{shift:g}", FORELAND,
                       {"Soil profile/dyke/Polygon": outline})
        checks.equal(name + ": outcome", run["outcome"], "stable")
        checks.equal("  masses that slide",
                     len(run["sliding_masses"]["masses"]), 0)
        checks.below("  largest displacement (m)",
                     np.linalg.norm(run.points()["displacement"], axis=1).max(),
                     0.05)


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        loads = {}
        for kind in ("B-bar", "standard"):
            run = work.run("footing-" + kind, FOOTING, {KIND: kind})
            checks.equal(kind + ": steps that did not converge",
                         run["unconverged_steps"], 0)
            loads[kind] = load(run)
        prandtl = 2.0 + math.pi
        final = float(loads["B-bar"][-1])
        checks.between("B-bar: load over Prandtl's", final / prandtl, 1.0, 1.07)
        checks.between("the same for a footing half a cell wider",
                       final / prandtl / 1.0625, 0.97, 1.03)
        checks.between("as before", final, 5.405, 5.415)
        checks.below("plateau: growth in the last quarter",
                     final / loads["B-bar"][-11] - 1.0, 1e-3)
        checks.above("standard: load over Prandtl's",
                     float(loads["standard"][-1]) / prandtl, 1.5)

        # Only supports act: their forces are what convergence is measured by,
        # not round-off.
        run = work.run("fine", FOOTING, {"Grid/Cell size": 0.0625,
                                         "Time stepping/End time": 3})
        checks.equal("fine: steps that did not converge",
                     run["unconverged_steps"], 0)

        for kind, low, high in (("B-bar", 3.10, 3.14), ("standard", 2.76, 2.81)):
            result = work.factor_of_safety("slope-" + kind, SLOPE, {KIND: kind})
            critical = 4.0 / result["factor_of_safety"]
            checks.between(kind + ": critical c of the slope, as before",
                           critical, low, high, "kPa")
            checks.equal(kind + ": slope that slides",
                         result["failure"]["slope"], "inner")
            if kind == "B-bar":
                checks.between("over the slip circle's", critical / CIRCLE,
                               0.92, 1.02)

        foreland(checks, work)
    checks.finish()


if __name__ == "__main__":
    main()
