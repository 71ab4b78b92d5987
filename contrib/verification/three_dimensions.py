#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and data of doc/verification/three_dimensions.md; runs the program.

    /usr/bin/python3 contrib/verification/three_dimensions.py [--waker build/bin/waker]
"""

import argparse
import csv
import os
import sys

import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from waker_case import Workspace

SLOPE, DYKE = "chapter6/slope.prm", "chapter6/dyke_3d.prm"
START = {"Time stepping/End time": 0}


def section(points, cell):
    """x, y of the points of the first slice."""
    x = points["position"]
    return x[x[:, 2] < cell / 2][:, :2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
    waker = parser.parse_args().waker
    os.chdir(ROOT)  # the dyke's table is named from here
    rows = []
    figure = plt.figure(figsize=(9.0, 6.5))
    with Workspace(waker, ROOT) as work:
        axes = figure.add_subplot(2, 2, 1)
        for name, mark in (("whole sub-cells", "s"), ("sub-cells", ".")):
            points = work.run(name, SLOPE, {
                **START, "Grid/Upper corner": "6, 1.5, 0.125",
                "Material points/Placement": name}).points()
            plane = section(points, 0.125)
            rows += [(name, *place) for place in plane]
            axes.plot(*plane.T, mark, label=name, markersize=4,
                      markerfacecolor="none")
        axes.plot([2.4, 2.5, 3.5, 3.6], [1, 1, 0, 0], "k-", linewidth=0.8)
        axes.set(xlim=(2.4, 3.0), ylim=(0.5, 1.05), xlabel="x (m)",
                 ylabel="y (m)", aspect="equal",
                 title="points of the slope's cells")
        axes.legend()

        for place, file, title, name in (
                (2, SLOPE, "slope.prm, h = 0.25 m: stress", "slope"),
                (3, DYKE, "dyke_3d.prm: from a height map", "dyke")):
            settings = {**START, **({"Grid/Cell size": 0.25}
                                    if file == SLOPE else {})}
            points = work.run(name, file, settings).points()
            x = points["position"]
            axes = figure.add_subplot(2, 2, place, projection="3d")
            drawn = axes.scatter(x[:, 2], x[:, 0], x[:, 1], s=2,
                                 c=points["stress_yy"], cmap="viridis")
            axes.set(xlabel="z (m)", ylabel="x (m)", zlabel="y (m)",
                     title=title)
            axes.set_box_aspect(np.ptp(x[:, [2, 0, 1]], axis=0))
            axes.view_init(elev=25, azim=-60)
            figure.colorbar(drawn, ax=axes, shrink=0.6,
                            label="vertical stress (kPa)")
    figure.tight_layout()
    save(figure, "three_dimensions")
    path = os.path.join(DATA, "three_dimensions.csv")
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["placement", "x (m)", "y (m)"])
        writer.writerows((name, f"{x:.6g}", f"{y:.6g}") for name, x, y in rows)
    print(os.path.relpath(path, ROOT))


if __name__ == "__main__":
    main()
