#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modified Cam clay: the oedometer and an undrained footing
(doc/verification/cam_clay.md).

usage: cam_clay.py WAKER SOURCE_DIRECTORY
"""

import numpy as np
from cam_clay_measures import (COMPRESSION, FOOTING, HALF_WIDTH, LAMBDA,
                               OEDOMETER, PRESSURE, load, oedometer, rigid_k0,
                               virgin_compression)
from waker_case import Checks, workspace_of_arguments


def compression(checks, work):
    run = work.run("oedometer", OEDOMETER)
    strain, vertical, k0 = oedometer(run).T
    exact = virgin_compression(strain)
    checks.equal("oedometer: steps that did not converge",
                 run["unconverged_steps"], 0)
    checks.below("  vertical stress against the integrated rates, relative",
                 float(np.abs(vertical / exact[:, 0] - 1).max()), 1e-4)
    checks.below("  K0 likewise", float(np.abs(k0 - exact[:, 1]).max()), 1e-3)
    checks.between("  slope over lambda*",
                   float((strain[-1] - strain[-2])
                         / np.log(vertical[-1] / vertical[-2]) / COMPRESSION),
                   0.99, 1.01)
    checks.between("  K0 over that of soil rigid in shear", float(k0[5] / rigid_k0()),
                   0.995, 1.005)
    work_done = run.statistics["Work of the supports (kJ)"][-1]
    checks.below("  energy remainder over the work",
                 abs(run.statistics["Energy remainder (kJ)"][-1]) / work_done, 0.02)
    fine = work.run("fine", OEDOMETER, {"Time stepping/Time step": 0.25,
                                        "Output/Interval": 0})
    checks.between("  of that what a quarter of the step leaves",
                   fine.statistics["Energy remainder (kJ)"][-1]
                   / run.statistics["Energy remainder (kJ)"][-1], 0.2, 0.3)
    # The control: another Lambda is another stress.
    other = oedometer(work.run("other", OEDOMETER, {"Materials/clay/Lambda": 0.25}))
    checks.below("  stress with another Lambda over this one",
                 float(other[-1, 1] / vertical[-1]), 0.7)


def footing(checks, work):
    run = work.run("footing", FOOTING, {"Grid/Cell size": 0.25,
                                        "Output/Interval": 50})
    over = load(run)
    checks.equal("footing: steps that did not converge",
                 run["unconverged_steps"], 0)
    checks.between("  load over (2 + pi) s_u of a footing half a cell wider",
                   float(over[-1]) / (1 + 0.125 / HALF_WIDTH), 0.9, 1.05)
    checks.between("  load over (2 + pi) s_u, as before", float(over[-1]), 1.172, 1.180)
    checks.below("  growth over the last third",
                 float(over[-1] / over[len(over) * 2 // 3]) - 1, 0.02)
    # Effective pressure at critical state below the footing.
    points = run.points()
    x, y = points["position"][:, 0], points["position"][:, 1]
    below = (x < 0.5) & (y > 2.5) & (y < 2.9)
    mean = sum(points[f"stress_{a}"] for a in ("xx", "yy", "zz")) / 3
    pressure = -(mean + points["excess_pore_pressure"])[below]
    checks.between("  p' below it over that at the start",
                   float(pressure.mean()) / PRESSURE, 0.5**LAMBDA, 0.68)


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        compression(checks, work)
        footing(checks, work)
    checks.finish()


if __name__ == "__main__":
    main()
