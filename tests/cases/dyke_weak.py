#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The weak dyke of chapter 5, implicit and explicit: times, energy, blocks
(doc/verification: softening, energy, explicit).

    /usr/bin/python3 tests/cases/dyke_weak.py WAKER SOURCE_DIRECTORY
"""

import dyke_measures as measures
import numpy as np
from waker_case import Checks, workspace_of_arguments

C_I, C_R = 10.0, 3.85  # kPa, of dyke_weak.prm

# What the program computes today, beside what the thesis and physics expect:
# a change that makes it worse must not hide in a band as wide as theirs. Half
# the time step and 1/2 to 1/10 of the tolerance move the times by up to 0.02 s
# (doc/verification/invariance.md), which is far more than round-off does, and
# the remainder by 0.002 %.
FAILURE, FLOODING, SCATTER = 2.93, 3.74, 0.05  # s, flooding after failure
REMAINDER, EXPLICIT_REMAINDER = 0.06, 0.1      # %: 0.033 and 0.048 today


def check_times(checks, run):
    checks.equal("outcome", run["outcome"], "flooding")
    start = run["initial_failure_time"]
    checks.between("W starts to shrink at", start, 2.5, 4.5, "s")
    checks.between("  as before", start, FAILURE - SCATTER, FAILURE + SCATTER,
                   "s")
    checks.equal("the thesis's reading is the same",
                 run["initial_failure_time_thesis"], start)
    checks.between("flooding after that", run["flooding_time"] - start,
                   3.0, 4.5, "s")
    checks.between("  as before", run["flooding_time"] - start,
                   FLOODING - SCATTER, FLOODING + SCATTER, "s")
    checks.equal("unconverged steps", run["unconverged_steps"], 0)


def check_energy(checks, run):
    terms, largest = measures.energy_shares(run)
    for name, value in terms.items():
        print(f"       {name}: {value:.4f} kJ/m")
    released = terms["potential energy released"]
    checks.above("potential energy released", released, 100, "kJ/m")
    checks.below("largest |remainder|", 100 * largest / released, 0.3,
                 "% of the potential energy released")
    checks.below("  as before", 100 * largest / released, REMAINDER, "%")
    steps = np.diff(run.statistics["Plastic dissipation (kJ)"])
    checks.above("least dissipation of a step", steps.min(), 0, "kJ/m")
    # When it floods: 524 and 433 kJ/m today, and 0.52 % below.
    checks.between("potential energy released, as before", released, 505, 545,
                   "kJ/m")
    checks.between("plastic dissipation", terms["plastic dissipation"], 415,
                   450, "kJ/m")
    checks.above("mapping loss", terms["mapping loss"], 0, "kJ/m")
    checks.below("mapping loss", 100 * terms["mapping loss"] / released, 2,
                 "% of the potential energy released")
    checks.below("  as before", 100 * terms["mapping loss"] / released, 0.7,
                 "%")


def check_blocks(checks, run):
    for time in (4.5, 5.5):
        blocks = measures.Blocks(run.points(time), C_I, C_R)
        checks.above(f"t = {time} s: blocks besides what stands",
                     len(blocks) - 1, 2)
        band = blocks.band_before_toe()
        checks.between(f"t = {time} s: angle of the band between them",
                       None if band is None else band[1], 35, 55, "degrees")
    blocks = measures.Blocks(run.points(), C_I, C_R)
    checks.above("at flooding: blocks besides what stands", len(blocks) - 1, 3)


def check_explicit(checks, run, explicit):
    for name in ("initial_failure_time", "flooding_time"):
        checks.between(f"explicit / implicit: {name}",
                       explicit[name] / run[name], 0.95, 1.05)
        # +0.9 and +0.5 % today.
        checks.between("  as before", explicit[name] / run[name], 0.98, 1.025)
    share, distance = measures.surface_agreement(run.surface(),
                                                 explicit.surface())
    checks.above("final surface within one cell over", 100 * share, 80,
                 "% of its length")
    # 100 % and 0.05 m today.
    checks.above("  as before", 100 * share, 98, "%")
    checks.below("largest distance", distance.max(), measures.CELL, "m")
    _, largest = measures.energy_shares(explicit)
    released = explicit.statistics["Potential energy released (kJ)"][-1]
    checks.below("explicit: largest |remainder|", 100 * largest / released,
                 0.3, "% of the potential energy released")
    checks.below("  as before", 100 * largest / released, EXPLICIT_REMAINDER,
                 "%")


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace as work:
        run = work.run("implicit", "chapter5/dyke_weak.prm",
                       {"Output/Interval": 0.5})
        check_times(checks, run)
        check_energy(checks, run)
        check_blocks(checks, run)
        explicit = work.run("explicit", "chapter5/dyke_weak.prm",
                            {"Output/Interval": 0,
                             "Time stepping/Scheme": "explicit"})
        check_explicit(checks, run, explicit)
    checks.finish()


if __name__ == "__main__":
    main()
