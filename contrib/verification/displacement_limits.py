#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which dykes the reading of initial failure by displacement sees, and how far
they have moved in the end: evidence for its limits (factor_of_safety.md).

    /usr/bin/python3 contrib/verification/displacement_limits.py WIDE NARROW \\
        [--runs output-realisations] [--waker build/bin/waker]

WIDE and NARROW are folders of campaigns of the base case (analysis1.prm) with
the limits of today and with much smaller ones. Dykes that displacement alone has
seen, or only with the small limits, are computed again, one by one.
"""

import argparse
import os
import sys

import numpy as np
from common import ROOT
from dyke_runs import write_csv

sys.path.append(os.path.join(ROOT, "contrib", "plots"))
# pylint: disable=wrong-import-position
from realisation_figures import Runner, final_points  # noqa: E402
from store import STABLE, Store  # noqa: E402


def moved(points):
    """Largest displacement, and the one that 2 % of the volume exceed (m)."""
    distance = np.linalg.norm(points.point_data["displacement"], axis=1)
    volume = points.point_data["volume"].ravel()
    order = np.argsort(distance)
    below = np.cumsum(volume[order]) < 0.98 * volume.sum()
    return distance.max(), distance[order][below.sum()]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("wide", metavar="WIDE")
    parser.add_argument("narrow", metavar="NARROW")
    parser.add_argument("--runs", default="output-realisations")
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"))
    arguments = parser.parse_args()
    wide = Store(arguments.wide).scenarios[0]
    narrow = Store(arguments.narrow).scenarios[0]
    n = min(len(wide.realisation), len(narrow.realisation))

    def seen(scenario, reading):
        return ~np.isnan(scenario.event_time("initial_failure_" + reading)[:n])

    geometry = seen(wide, "geometry")
    by_wide = seen(wide, "displacement")
    by_narrow = seen(narrow, "displacement")
    print(f"of {n}: {geometry.sum()} by width or height, {by_wide.sum()} by "
          f"displacement, {by_narrow.sum()} with the small limits, "
          f"{(geometry & ~by_wide).sum()} missed, "
          f"{(wide['outcome'][:n] == STABLE).sum()} stable")
    runner = Runner(arguments.waker, arguments.runs)
    columns = {"realisation": [], "by": [], "largest_m": [], "2_percent_m": []}
    for i in np.flatnonzero((by_wide & ~geometry) | (by_narrow & ~by_wide)):
        number = int(wide.realisation[i])
        largest, usual = moved(final_points(runner.run(wide, number)))
        columns["realisation"].append(number)
        columns["by"].append("displacement" if by_wide[i] else
                             "small limits only")
        columns["largest_m"].append(largest)
        columns["2_percent_m"].append(usual)
        print(f"{number}: {columns['by'][-1]}, {largest:.3f} and {usual:.3f} m",
              flush=True)
    write_csv("displacement_limits", columns, digits=4)


if __name__ == "__main__":
    main()
