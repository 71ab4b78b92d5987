#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dyke of chapter 5 without softening fails where slip circles say,
c = 7.49 kPa (doc/verification/no_softening.md).

    /usr/bin/python3 tests/cases/dyke_no_softening.py WAKER SOURCE_DIRECTORY
"""

import dyke_measures as measures
from waker_case import Checks, workspace_of_arguments

CASE = "verification/dyke_no_softening.prm"  # to 40 s, or to rest


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace as work:
        stands = work.run("stands", CASE,
                          {"Output/Interval": 0, **measures.strength(8, 8)})
        checks.equal("c = 8 kPa: outcome", stands["outcome"], "stable")
        checks.below("c = 8 kPa: change of W",
                     abs(stands["residual_width"] - stands["initial_width"]),
                     0.3, "m")
        checks.below("  as before: 0.08 m",
                     abs(stands["residual_width"] - stands["initial_width"]),
                     0.15, "m")
        slides = work.run("slides", CASE, {"Output/Interval": 0})
        checks.equal("c = 7 kPa: outcome", slides["outcome"],
                     "initial failure")
        checks.above("c = 7 kPa: W drops by",
                     slides["initial_width"] - slides["residual_width"], 1,
                     "m")
        checks.between("  as before: at 2.01 s", slides["initial_failure_time"],
                       1.95, 2.1, "s")
        checks.between("  as before: 1.34 m",
                       slides["initial_width"] - slides["residual_width"], 1.2,
                       1.5, "m")
    checks.finish()


if __name__ == "__main__":
    main()
