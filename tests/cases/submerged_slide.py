#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slides under water, at rest and flowing: effective stress with water in the ground and
on the moving surface goes as soil of half the weight under half the gravity, with the
seepage force.

    /usr/bin/python3 tests/cases/submerged_slide.py WAKER SOURCE_DIRECTORY
"""

from slide_measures import BUOYANT, CASE, SEEPAGE, SEEPING, cells, reach
from waker_case import Checks, workspace_of_arguments

COARSE = cells(1)


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        under = work.run("water", CASE, COARSE)
        light = work.run("buoyant", CASE, {**COARSE, **BUOYANT})
        dry = work.run("dry", CASE, {**COARSE, "Tractions/Names": "",
                                     "Pore water/Phreatic line": ""})
        seeping = work.run("seeping", SEEPING, COARSE)
        pushed = work.run("pushed", SEEPING, {**COARSE, **SEEPAGE})
        start = reach(under.points(0.0))
        ends = [reach(run.points()) for run in (under, light, dry, seeping, pushed)]
    moved = [end[1] - start[1] for end in ends]
    checks.above("the soil's centre moves (m)", moved[0], 0.5)
    checks.between("  over that with buoyant weight", moved[0] / moved[1],
                   0.9, 1.1)
    checks.between("  front behind that with buoyant weight (m)",
                   ends[1][0] - ends[0][0], -0.5, 0.5)
    # The control: without water it goes further.
    checks.above("  without water: further", moved[2] / moved[0], 1.3)
    # Met: 1.008, and 0.28 of 15 m.
    checks.between("water that flows: over buoyant weight with the seepage force",
                   moved[3] / moved[4], 0.95, 1.05)
    checks.between("  front behind (m)", ends[4][0] - ends[3][0], -1, 1)
    # The control: without that force it goes a third as far.
    checks.above("  over buoyant weight without it", moved[3] / moved[1], 2)
    checks.finish()


if __name__ == "__main__":
    main()
