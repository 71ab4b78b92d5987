#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dyke of chapter 5 that stands, watched for 10 s: water on its outer face
must not load single points (doc/verification/stable_dyke.md).

    /usr/bin/python3 tests/cases/dyke_stable.py WAKER SOURCE_DIRECTORY
"""

import dyke_measures as measures
from waker_case import Checks, workspace_of_arguments

TEN_SECONDS = {"Time stepping/End time": 10, "Stop rules/At rest": "false",
               "Output/Interval": 0.1, "Output/Surface": "false"}


def check_face(checks, name, run):
    face = measures.FaceHistory(run)
    checks.equal(f"{name}: outcome", run["outcome"], "stable")
    checks.equal(f"{name}: end time (s)", round(run["end_time"], 6), 10)
    checks.below(f"{name}: largest |p| of the outer face in the gravity state, "
                 "as a share of that inside", face.first / face.deepest, 1)
    checks.below(f"{name}: |p| of the outer face / that of the gravity state",
                 face.growth, 1.5)
    checks.below("  as before: 1.00 and 1.02", face.growth, 1.1)
    checks.equal(f"{name}: points of the outer face that yield", face.yielded,
                 0)
    print(f"       largest |p| of the face: {face.first:.1f} kPa at the start, "
          f"{max(face.pressure):.1f} kPa later; inside {face.deepest:.1f} kPa; "
          f"{face.inside} points yield inside")
    return face


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace as work:
        run = work.run("mean", "chapter5/dyke.prm", TEN_SECONDS)
        check_face(checks, "c_i = 13 kPa", run)
        # At the mean strength nothing yields at all. A little above failure
        # the inner toe does, and the dyke moves.
        run = work.run("low", "chapter5/dyke.prm",
                       {**TEN_SECONDS, **measures.strength(10.1, 10.1 / 2.6)})
        face = check_face(checks, "c_i = 10.1 kPa", run)
        checks.above("c_i = 10.1 kPa: points that yield elsewhere",
                     face.inside, 100)
    checks.finish()


if __name__ == "__main__":
    main()
