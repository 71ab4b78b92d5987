#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""All studies of chapter 3: runs, figures with their data, and the tables of
doc/results/chapter3/README.md. The last five have their pages in
doc/verification.

    contrib/chapter3/run_all.py [--waker build/bin/waker] [--runs FOLDER]
                                [--study NAME ...] [--again]

What has been run is not run again, so it may be interrupted at any time.
Without --study it takes about half an hour on one core.
"""

import argparse
import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
STUDIES = {
    "uniaxial_block": "stress in a block under traction",
    "bar_1d": "figures 3.3, 3.4: nodal forces of a bar",
    "inclined_bar": "figures 3.5 to 3.7: nodal forces of an inclined bar",
    "cylinder": "thick cylinder: convergence of each method",
    "dyke_contour": "dyke of chapter 5 with the contour",
    "submerged_slope": "figures 3.14 to 3.18: submerged slope",
    "walls": "walls off the grid: block, strip footing",
    "flow": "inflow and outflow",
    "point_loads": "point loads: bar, half-space",
    "column": "column under its weight, large strain",
    "cantilever": "cantilever, large rotation",
}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--waker", default=os.path.join(
        os.path.dirname(os.path.dirname(HERE)), "build", "bin", "waker"))
    parser.add_argument("--runs", default="chapter3-runs",
                        help="folder for the runs (default: %(default)s)")
    parser.add_argument("--study", action="append", choices=list(STUDIES),
                        metavar="NAME", help="only this one; may be repeated: "
                        + ", ".join(STUDIES))
    parser.add_argument("--again", action="store_true",
                        help="repeat runs that are there")
    arguments = parser.parse_args()
    if not os.access(arguments.waker, os.X_OK):
        sys.exit(f"no program {arguments.waker}: build it, or say --waker")

    failed = []
    for study in arguments.study or STUDIES:
        print(f"{study}: {STUDIES[study]}", flush=True)
        start = time.monotonic()
        command = [sys.executable, os.path.join(HERE, study + ".py"),
                   "--waker", arguments.waker, "--runs", arguments.runs]
        done = subprocess.run(command + ["--again"] * arguments.again,
                              check=False)
        if done.returncode != 0:
            failed.append(study)
        print(f"    {time.monotonic() - start:.0f} s", flush=True)
    print("tables", flush=True)
    tables = subprocess.run([sys.executable, os.path.join(HERE, "tables.py")],
                            check=False)
    if failed or tables.returncode != 0:
        sys.exit("failed: " + ", ".join(failed or ["tables"]))


if __name__ == "__main__":
    main()
