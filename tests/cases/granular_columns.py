#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of sand that collapse (a = H/L = 0.5 and 1) against the run-out of experiments
(doc/verification/mohr_coulomb.md).

usage: granular_columns.py WAKER SOURCE_DIRECTORY
"""

from column_measures import ANGLE, CASE, LAWS, WIDTH, front, profile, settings
from waker_case import Checks, workspace_of_arguments

SAND = 31.0  # degrees
CELL = 0.01  # m
# The front is where the surface comes down to the height of one point. Half or twice that
# height would move it by a third.
HEIGHT = CELL / 2
BAND = LAWS[SAND] / 3


def run_out(work, ratio, angle=SAND):
    """(L' - L)/L over a, and the height at the wall over L."""
    run = work.run(f"{ratio}-{angle}", CASE,
                   {**settings(ratio, CELL), ANGLE: angle})
    return ((front(run, HEIGHT) / WIDTH - 1) / ratio, profile(run)[1][0] / WIDTH,
            run["unconverged_steps"])


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    low, high = LAWS[SAND] - BAND, LAWS[SAND] + BAND
    with work:
        # As before: to 0.1; programs that differ in round-off were 0.02 apart.
        for ratio, before, height in (0.5, 0.83, 0.5), (1.0, 1.40, 0.83):
            reach, kept, unconverged = run_out(work, ratio)
            checks.between(f"column, a = {ratio}: run-out over a (experiments: "
                           f"{LAWS[SAND]})", reach, low, high)
            checks.between("  as before", reach, before - 0.1,
                           before + 0.1)
            checks.between("  height at the wall over L, as before", kept,
                           height - 0.04, height + 0.04)
            checks.equal("  steps that did not converge", unconverged, 0)
        # The controls: with the friction of other soils they miss the band.
        checks.above("  a = 1 with 22 degrees", run_out(work, 1.0, 22.0)[0],
                     high + 0.1)
        checks.below("  a = 0.5 with 45 degrees", run_out(work, 0.5, 45.0)[0],
                     low - 0.05)
    checks.finish()


if __name__ == "__main__":
    main()
