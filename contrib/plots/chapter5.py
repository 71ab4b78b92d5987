#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw figures 5.5 to 5.14 of Remmerswaal (2023) from campaigns.

    /usr/bin/python3 contrib/plots/chapter5.py --analysis1 DIR --analysis2 DIR \\
        --analysis3 DIR --output DIR [--waker build/bin/waker]

DIR is the folder of a campaign after `waker merge`. Any of the three may be left
out: what can be drawn is drawn, and what is missing is said. Each figure comes as
PNG, PDF and CSV (the numbers that it shows). Figures 5.5 and 5.11 compute some
realisations again, and need the program. What the thesis prints is drawn beside
campaigns with its parameters only; of another dyke it would say nothing. Figures
of any campaign, with levels above datum: contrib/plots/campaign.py.
"""

import argparse
import os
import sys

import geometry_figures as geometry
import probability_figures as probability
import realisation_figures as realisations
from figure_files import FigureFiles
from store import Store, with_base_case
from thesis_parameters import is_thesis


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--analysis1", metavar="DIR", help="the base case")
    parser.add_argument("--analysis1-points", metavar="DIR",
                        help="the base case with `Statistics of = points`:\n"
                             "dotted in figure 5.6")
    parser.add_argument("--analysis2", metavar="DIR",
                        help="sweep over the horizontal scale of fluctuation")
    parser.add_argument("--analysis3", metavar="DIR",
                        help="sweep over the water level")
    parser.add_argument("--output", metavar="DIR", required=True)
    parser.add_argument("--waker", metavar="PATH",
                        help="the program, for figures 5.5 and 5.11")
    parser.add_argument("--runs", metavar="DIR",
                        help="where the realisations of 5.5 and 5.11 are kept\n"
                             "(default: OUTPUT/runs)")
    arguments = parser.parse_args()
    stores = {number: Store(folder) for number in (1, 2, 3)
              if (folder := getattr(arguments, f"analysis{number}"))}
    if not stores:
        parser.error("needs at least one of --analysis1, 2 and 3")

    files = FigureFiles(arguments.output)
    runner = arguments.waker and realisations.Runner(
        arguments.waker,
        arguments.runs or os.path.join(arguments.output, "runs"))
    missing = {}
    # Also of the campaigns that go into a figure beside those of its analysis.
    thesis = {number: is_thesis(store, number)
              for number, store in stores.items()}

    def draw(names, number, function, *more):
        """One or more figures of analysis `number`."""
        if number not in stores:
            reason = f"needs --analysis{number}"
        elif more == (None,):
            reason = "needs --waker"
        else:
            reason = function(files, scenarios[number], *more)
        if reason:
            missing[names] = reason

    base = stores[1].scenarios[0] if 1 in stores else None
    points = (Store(arguments.analysis1_points).scenarios[0]
              if arguments.analysis1_points else None)
    scenarios = {1: base}
    for number, key in ((2, "scale_x"), (3, "freeboard")):
        if number in stores:
            scenarios[number] = sorted(
                with_base_case(stores[number].scenarios, base),
                key=lambda scenario: getattr(scenario, key))

    draw("5.5", 1, realisations.figure_5_5, runner)
    draw("5.6", 1, lambda files, base: probability.in_time(
        files, "figure_5_06", base, points, thesis[1]))
    draw("5.7, 5.8", 2, probability.draw_scales, thesis.get(2))
    draw("5.9", 2, geometry.figure_5_9, thesis.get(2))
    draw("5.10", 2, geometry.figure_5_10)
    draw("5.11", 3, realisations.figure_5_11, runner)
    draw("5.12, 5.13", 3, probability.draw_water_levels, thesis.get(3))
    draw("5.14", 3, geometry.figure_5_14)
    for names, reason in missing.items():
        print(f"figure {names} is not complete: {reason}", file=sys.stderr)


if __name__ == "__main__":
    main()
