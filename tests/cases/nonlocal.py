#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nonlocal softening, as users run it (doc/verification/nonlocal.md): a sheared
layer on two grids, the explicit scheme beside the implicit one, and a factor of
safety. restart.py kills and resumes such a run.

    /usr/bin/python3 tests/cases/nonlocal.py WAKER SOURCE_DIRECTORY
"""

import numpy as np
from waker_case import Checks, workspace_of_arguments

LAYER = "verification/sheared_layer.prm"
WORK = "Work of the supports (kJ)"
DISSIPATION = "Plastic dissipation (kJ)"
REMAINDER = "Energy remainder (kJ)"
CLAY = "Materials/clay/"
NONLOCAL = {CLAY + "Regularisation": "nonlocal",
            CLAY + "Averaging length": 0.5,
            CLAY + "Softening modulus": -300}


def softening_work(run):
    """Beyond what the residual strength takes: 4 kPa on 2 m by 0.6 m."""
    return run.statistics[WORK][-1] - 4.8


def layer(work, checks):
    local = {CLAY + "Regularisation": "softening length"}
    works = {}
    for name, changes in (("nonlocal", {}), ("local", local)):
        for cell in (0.5, 0.25):
            run = work.run("layer", LAYER, {"Grid/Cell size": cell, **changes})
            works[name, cell] = softening_work(run)
            checks.below(f"{name}, h = {cell}: energy remainder over work",
                         abs(run.statistics[REMAINDER][-1])
                         / run.statistics[WORK][-1], 1e-3)
            steps = np.diff(run.statistics[DISSIPATION])
            checks.between(f"{name}, h = {cell}: least dissipation of a step",
                           steps.min(), 0, 1)
    ratio = works["nonlocal", 0.25] / works["nonlocal", 0.5]
    # Met: 0.868, and 0.957 from 0.25 to 0.125 m.
    checks.between("nonlocal: softening work, cells of half the size", ratio,
                   0.8, 1.1)
    # Negative control: a band of half the width takes half of it.
    ratio = works["local", 0.25] / works["local", 0.5]
    checks.between("local: the same", ratio, 0.35, 0.6)


def schemes(work, checks):
    """The same slide, explicit and implicit."""
    sets = {"Grid/Cell size": 0.5, **NONLOCAL,
            CLAY + "Initial strength": 8, CLAY + "Residual strength": 8 / 2.6,
            "Time stepping/End time": 5}
    times = {}
    for scheme in ("Newmark", "explicit"):
        run = work.run(scheme, "chapter5/dyke_weak.prm",
                       {**sets, "Time stepping/Scheme": scheme})
        times[scheme] = run["initial_failure_time"] or 99.
    checks.between("initial failure, explicit less implicit (s)",
                   times["explicit"] - times["Newmark"], -0.1, 0.1)


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace as work:
        layer(work, checks)
        schemes(work, checks)
        result = work.factor_of_safety(
            "fos", "chapter5/dyke_fos.prm",
            {"Grid/Cell size": 0.5, **NONLOCAL,
             "Strength reduction/Lower factor": 1.2,
             "Strength reduction/Upper factor": 1.4,
             "Strength reduction/Tolerance": 0.01})
        checks.between("factor of safety on cells of 0.5 m (0.25 m: 1.292)",
                       result["factor_of_safety"], 1.26, 1.35)
        checks.between("the same, as before", result["factor_of_safety"],
                       1.305, 1.33)
    checks.finish()


if __name__ == "__main__":
    main()
