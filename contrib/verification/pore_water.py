#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/pore_water.md; runs the program.

    /usr/bin/python3 contrib/verification/pore_water.py [--waker build/bin/waker]
"""

import argparse
import os

from common import ROOT, plt, save
from dyke_runs import Workspace, write_csv

CASE = "verification/slope_drawdown.prm"
HEIGHT = 10.0  # m
# Griffiths & Lane 1999: under water, where it is least, and without water.
PUBLISHED = {0.0: 1.85, 0.7: 1.3, 1.0: 1.4}
DEPTHS = (0.0, 0.1, 0.3, 0.5, 0.7, 0.9)  # of the water below the crest, over H


def factor(work, name, settings):
    return work.factor_of_safety(name, CASE, settings)["factor_of_safety"]


def drawdown(work, cell):
    rows = []
    for depth in DEPTHS + (1.0,):
        level = HEIGHT * (1.0 - depth)
        sets = {"Grid/Cell size": cell, "Time stepping/Time step": 0.02 * cell,
                "Pore water/Phreatic line": f"-1, {level:g}; 47, {level:g}"}
        if depth == 1.0:
            sets["Tractions/Names"] = ""
        else:
            sets["Tractions/reservoir/Level"] = level
        rows.append((cell, depth, factor(work, f"{cell}-{depth}", sets),
                     PUBLISHED.get(depth, float("nan"))))
        print("| %g m | %g | %.3f | %s |"
              % (cell, depth, rows[-1][2], PUBLISHED.get(depth, "")),
              flush=True)
    return rows


def buoyant(work):
    """Under water, two ways: pore water and reservoir; half the weight."""
    cell = {"Grid/Cell size": 0.5}
    under = factor(work, "under", {
        **cell, "Tractions/reservoir/Level": HEIGHT,
        "Pore water/Phreatic line": f"-1, {HEIGHT:g}; 47, {HEIGHT:g}"})
    light = factor(work, "light", {
        **cell, "Materials/soil/Unit weight": 10, "Tractions/Names": "",
        "Pore water/Phreatic line": ""})
    print("| under water: %.3f | buoyant weight: %.3f |" % (under, light))
    return under, light


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"))
    parser.add_argument("--cells", default="0.5,0.25")
    arguments = parser.parse_args()
    with Workspace(arguments.waker, ROOT) as work:
        buoyant(work)
        rows = []
        for cell in arguments.cells.split(","):
            rows += drawdown(work, float(cell))
    write_csv("pore_water_drawdown",
              dict(zip(("cell_m", "depth_over_height", "factor", "published"),
                       zip(*rows))))
    figure, axes = plt.subplots()
    for cell in sorted({row[0] for row in rows}, reverse=True):
        mine = [row for row in rows if row[0] == cell]
        axes.plot([r[1] for r in mine], [r[2] for r in mine], "o-",
                  label=f"h = {cell:g} m")
    axes.plot(PUBLISHED.keys(), PUBLISHED.values(), "k*", markersize=10,
              label="Griffiths & Lane 1999")
    axes.set_xlabel("water below the crest, over the height of the slope")
    axes.set_ylabel("factor of safety")
    axes.legend()
    save(figure, "pore_water_drawdown")


if __name__ == "__main__":
    main()
