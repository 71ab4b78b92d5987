#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slide under water: effective stress with water in the ground and on the moving
surface goes as soil of half the weight under half the gravity.

    /usr/bin/python3 tests/cases/submerged_slide.py WAKER SOURCE_DIRECTORY
"""

from slide_measures import BUOYANT, CASE, reach
from waker_case import Checks, workspace_of_arguments

COARSE = {"Grid/Cell size": 1, "Time stepping/Time step": 0.02}


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        under = work.run("water", CASE, COARSE)
        light = work.run("buoyant", CASE, {**COARSE, **BUOYANT})
        dry = work.run("dry", CASE, {**COARSE, "Tractions/Names": "",
                                     "Pore water/Phreatic line": ""})
        start = reach(under.points(0.0))
        ends = [reach(run.points()) for run in (under, light, dry)]
    moved = [end[1] - start[1] for end in ends]
    checks.above("the soil's centre moves (m)", moved[0], 0.5)
    checks.between("  over that with buoyant weight", moved[0] / moved[1],
                   0.9, 1.1)
    checks.between("  front behind that with buoyant weight (m)",
                   ends[1][0] - ends[0][0], -0.5, 0.5)
    # The control: without water it goes further.
    checks.above("  without water: further", moved[2] / moved[0], 1.3)
    checks.finish()


if __name__ == "__main__":
    main()
