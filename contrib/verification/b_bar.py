#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/b_bar.md; runs the program.

    /usr/bin/python3 contrib/verification/b_bar.py [--waker build/bin/waker]
"""

import argparse
import os
import sys

import numpy as np
from common import ROOT, plt, save
from dyke_runs import write_csv

sys.path.append(os.path.join(ROOT, "contrib", "chapter3"))
# pylint: disable=wrong-import-position
from thick_cylinder import exact, outline  # noqa: E402
from waker_case import Workspace  # noqa: E402


KINDS = ("standard", "B-bar")
KEY = "Kinematics and mapping/Volumetric strain"
INCOMPRESSIBLE = 0.4999  # Poisson's ratio of the cylinder
COHESION = 10.0  # kPa, strip footing
PRANDTL = 2.0 + np.pi
CIRCLE = 0.1652 * 20.0  # kPa, slope of 45 degrees, 1 m high (12.4 of numerics)


def oscillation(points, h):
    """Of the pressure over the mesh, root mean squares over the volume: of the
    points in a cell about their mean, and of the cells about the mean of their
    four neighbours. Cells by where the points were at first."""
    pressure = (points["stress_xx"] + points["stress_yy"]
                + points["stress_zz"]) / 3.0
    start = points["position"][:, :2] - points["displacement"][:, :2]
    cells = np.floor(start / h + 1e-9).astype(int)
    cells -= cells.min(axis=0)
    shape = tuple(cells.max(axis=0) + 1)
    volume = points["volume"]
    at = np.ravel_multi_index(cells.T, shape)
    whole = np.bincount(at, volume, np.prod(shape)).reshape(shape)
    with np.errstate(invalid="ignore"):
        mean = np.bincount(at, volume * pressure,
                           np.prod(shape)).reshape(shape) / whole
    inside = np.sqrt((volume * (pressure - mean.ravel()[at])**2).sum()
                     / volume.sum())
    centre = mean[1:-1, 1:-1]
    around = 0.25 * (mean[:-2, 1:-1] + mean[2:, 1:-1] + mean[1:-1, :-2]
                     + mean[1:-1, 2:])
    there = ~np.isnan(centre + around)
    between = np.sqrt(((centre - around)[there]**2).mean())
    return float(inside), float(between)


def footing(work):
    """Load over settlement: {(kind, h): (settlement, load / c)}, and rows."""
    curves, rows = {}, []
    for h in (0.25, 0.125, 0.0625):
        for kind in KINDS:
            run = work.run(f"footing-{kind}-{h}",
                           "verification/strip_footing.prm",
                           {KEY: kind, "Grid/Cell size": h})
            settlement = 1e-3 * run.statistics["Time (s)"]
            support = run.statistics["Work of the supports (kJ)"]
            load = np.diff(support) / np.diff(settlement) / COHESION
            curves[kind, h] = settlement[1:], load
            growth = load[-1] / np.interp(0.03, settlement[1:], load) - 1.0
            rows.append((kind, h, load[-1], load[-1] / PRANDTL - 1.0,
                         load[-1] / (1.0 + 0.5 * h) / PRANDTL - 1.0, growth,
                         *(x / COHESION for x in oscillation(run.points(), h))))
            print("| %s | %g m | %.3f c | %+.1f %% | %+.1f %% | %.1f %% | %.3f c | "
                  "%.3f c |" % (kind, h, rows[-1][2],
                                *(100 * x for x in rows[-1][3:6]),
                                *rows[-1][6:]), flush=True)
    return curves, rows


def cylinder(work):
    """Thick cylinder, nearly incompressible: error of the displacement."""
    corners = outline()
    chain = os.path.join(work.folder, "chain.txt")
    np.savetxt(chain, corners + corners[:1], "%.12g")
    rows = []
    for cells in (4, 8, 16):
        for kind in KINDS:
            run = work.run(
                f"cylinder-{kind}-{cells}", "chapter3/cylinder.prm",
                {KEY: kind, "Grid/Cell size": repr(1 / cells),
                 "Grid/Upper corner": f"{2 + 2 / cells!r}, {2 + 2 / cells!r}",
                 "Materials/elastic/Poisson's ratio": INCOMPRESSIBLE,
                 "Soil profile/cylinder/Polygon":
                 "; ".join(f"{x!r}, {y!r}" for x, y in corners),
                 "Tractions/pressure/Surface file": chain})
            points = run.points()
            start = points["position"][:, :2] - points["displacement"][:, :2]
            expected, _ = exact(start, INCOMPRESSIBLE)
            weight = points["volume"][:, None]
            difference = points["displacement"][:, :2] - expected
            error = np.sqrt((weight * difference**2).sum()
                            / (weight * expected**2).sum())
            deviation = oscillation(points, 1 / cells)
            rows.append((kind, 1 / cells, float(error), *deviation))
            print("| %s | %g m | %.1f %% | %.3f kPa | %.3f kPa |"
                  % (kind, 1 / cells, 100 * error, *deviation), flush=True)
    return rows


def slope(work):
    rows = []
    for h in (0.25, 0.125, 0.0625):
        for kind in KINDS:
            result = work.factor_of_safety(
                f"slope-{kind}-{h}", "verification/slope_45.prm",
                {KEY: kind, "Grid/Cell size": h,
                 "Time stepping/Time step": 0.04 * h})
            critical = 4.0 / result["factor_of_safety"]
            rows.append((kind, h, critical, critical / CIRCLE - 1.0))
            print("| %s | %g m | %.2f kPa | %+.1f %% |"
                  % (kind, h, critical, 100 * rows[-1][3]), flush=True)
    return rows


def write_footing(curves, rows):
    names = ("kind", "cell_m", "load_over_c", "over_prandtl",
             "over_prandtl_half_a_cell_wider", "growth_last_quarter",
             "deviation_in_cells_over_c", "deviation_of_cells_over_c")
    write_csv("b_bar_footing", dict(zip(names, zip(*rows))))
    draw(curves)


def draw(curves):
    figure, axes = plt.subplots()
    for (kind, h), (settlement, load) in curves.items():
        axes.plot(1000 * settlement, load,
                  color="C0" if kind == "B-bar" else "C3",
                  linestyle={0.25: ":", 0.125: "--", 0.0625: "-"}[h],
                  label=f"{kind}, h = {h:g} m")
    axes.axhline(PRANDTL, color="grey", linewidth=0.8)
    axes.text(30, PRANDTL - 0.35, "Prandtl, 2 + π", color="grey")
    axes.set_xlabel("settlement (mm)")
    axes.set_ylabel("load per area over c")
    axes.set_ylim(0, 11)
    axes.legend(fontsize=8)
    save(figure, "b_bar")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"))
    parser.add_argument("--only", choices=("footing", "cylinder", "slope"))
    arguments = parser.parse_args()
    wanted = (arguments.only,) if arguments.only else ("footing", "cylinder",
                                                       "slope")
    with Workspace(arguments.waker, ROOT) as work:
        if "footing" in wanted:
            write_footing(*footing(work))
        if "cylinder" in wanted:
            names = ("kind", "cell_m", "displacement_error",
                     "deviation_in_cells_kPa", "deviation_of_cells_kPa")
            write_csv("b_bar_cylinder", dict(zip(names,
                                                 zip(*cylinder(work)))))
        if "slope" in wanted:
            names = ("kind", "cell_m", "critical_c_kPa", "over_circle")
            write_csv("b_bar_slope", dict(zip(names, zip(*slope(work)))))


if __name__ == "__main__":
    main()
