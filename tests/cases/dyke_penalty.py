#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base held by penalty springs instead of removed equations: the same failure.

    /usr/bin/python3 tests/cases/dyke_penalty.py WAKER SOURCE_DIRECTORY

On cells of 0.5 m with c_i = 8 kPa. The times differ by 2 %: unlike
fixed nodes, those on springs start a step with the velocity of the points above them.
"""

from waker_case import Checks, workspace_of_arguments

COARSE = {"Grid/Cell size": 0.5, "Materials/clay/Initial strength": 8,
          "Output/Interval": 0}

workspace, _ = workspace_of_arguments()
with workspace as work:
    removed = work.run("removed", "chapter5/dyke_weak.prm", COARSE)
    springs = work.run("springs", "chapter5/dyke_weak.prm",
                       {**COARSE,
                        "Boundary conditions/base/Method": "penalty"})

    checks = Checks()
    checks.equal("outcome", springs["outcome"], removed["outcome"])
    for key in ("initial_failure_time", "flooding_time"):
        checks.between(f"{key}, springs / removed", springs[key] / removed[key],
                       0.95, 1.05)
    reaction = "Reaction y (kN)"
    checks.between("force of the springs / of the removed equations, at 1.5 s",
                   springs.value(reaction, 1.5) / removed.value(reaction, 1.5),
                   0.99, 1.01)
checks.finish()
