#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The factor of safety of the dyke of chapter 5 by strength reduction: the thesis
says 1.3 (doc/verification/softening.md).

    /usr/bin/python3 tests/cases/dyke_fos.py WAKER SOURCE_DIRECTORY
"""

from waker_case import Checks, workspace_of_arguments


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace as work:
        # A narrower bracket than the file's, for speed; it must hold the
        # answer, or the program says so.
        result = work.factor_of_safety("fos", "chapter5/dyke_fos.prm",
                                       {"Strength reduction/Lower factor": 1,
                                        "Strength reduction/Upper factor": 1.6,
                                        "Strength reduction/Tolerance": 0.02})
        checks.between("factor of safety", result["factor_of_safety"], 1.25,
                       1.35)
        checks.below("width of the bracket",
                     result["lowest_failed_factor"]
                     - result["highest_stable_factor"], 0.02)
    checks.finish()


if __name__ == "__main__":
    main()
