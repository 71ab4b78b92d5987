#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slopes that water flows through: effective stress with pore pressure goes as buoyant
weight with a seepage force, and a long slope has the factor of its closed form
(doc/verification/pore_water.md).

usage: seeping_slope.py WAKER SOURCE_DIRECTORY
"""

from seepage_measures import (AT_START, BUOYANT, HYDROSTATIC, KINKED, LONG,
                              closed_form, difference, mobilised)
from waker_case import Checks, workspace_of_arguments


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        rms = []
        for cell in 1, 0.5:
            sets = {**AT_START, "Grid/Cell size": cell}
            water = work.run(f"water-{cell}", KINKED, sets)
            light = work.run(f"light-{cell}", KINKED, {**sets, **BUOYANT})
            rms.append((difference(water, light), difference(water, light, 1.5)))
        checks.below("stress against that of buoyant weight and seepage force, rms",
                     rms[1][0], 0.003)
        checks.below("  deeper than 1.5 m", rms[1][1], 2e-4)
        checks.below("  over that with cells of twice the size", rms[1][1] / rms[0][1],
                     0.4)
        # The control: without the seepage force it is another stress.
        still = work.run("still", KINKED, {**sets, **BUOYANT,
                                           "Point loads/seepage/Force": "0, 0"})
        checks.above("  without the seepage force", difference(water, still), 0.1)

        for name, sets, is_parallel in (("flow along it", {}, True),
                                        ("heads that fall along x", HYDROSTATIC, False)):
            factor = mobilised(work.run(name.replace(" ", "-"), LONG, sets))
            checks.between(f"long slope, {name}: factor over the closed form, "
                           f"{closed_form(is_parallel):.4f}",
                           factor / closed_form(is_parallel), 0.9995, 1.0005)
    checks.finish()


if __name__ == "__main__":
    main()
