#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/mohr_coulomb.md; runs the program.

    /usr/bin/python3 contrib/verification/mohr_coulomb.py [--waker build/bin/waker]
        [--only slopes|footing|pile] [--cells 0.125,0.0625]

--cells are those of the footing: 0.0625 m takes some minutes each; rows of
other cells stay in doc/verification/data/mohr_coulomb_footing.csv.
"""

import csv
import itertools
import os

import numpy as np
from common import DATA, plt, save
from dyke_runs import draw_points, option, workspace, write_csv
import friction_measures as measures

SLOPES = (  # case, published factor, cell (m), dilatancy
    ("slope_friction", 1.4, 0.5, "0"),
    ("slope_friction", 1.4, 0.25, "0"),
    ("slope_friction", 1.4, 0.5, "friction_angle"),
    ("slope_acads", 0.987, 0.5, "0"),
    ("slope_acads", 0.987, 0.25, "0"),
    ("slope_acads", 0.987, 0.5, "friction_angle"))
FOOTING_COLUMNS = ("cell_m", "angle", "points_per_direction", "load_over_c",
                   "over_n_c", "over_n_c_half_a_cell_wider")


def slopes(work):
    rows = []
    for case, published, cell, dilatancy in SLOPES:
        result = work.factor_of_safety(
            f"{case}-{cell}-{dilatancy}", f"verification/{case}.prm",
            {"Grid/Cell size": cell, "Time stepping/Time step": 0.02 * cell,
             "Materials/soil/Dilatancy angle": dilatancy})
        factor = result["factor_of_safety"]
        rows.append((case, cell, "psi = phi" if dilatancy != "0" else "psi = 0",
                     factor, published, factor / published - 1.0))
        print("| %s | %g m | %s | %.3f | %g | %+.1f %% |"
              % (*rows[-1][:5], 100 * rows[-1][5]), flush=True)
    write_csv("mohr_coulomb_slopes",
              dict(zip(("case", "cell_m", "dilatancy", "factor", "published",
                        "difference"), zip(*rows))))


def footing(work, cells):
    path = os.path.join(DATA, "mohr_coulomb_footing.csv")
    rows = {}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                values = tuple(float(row[key]) for key in FOOTING_COLUMNS)
                rows[values[:3]] = values
    figure, axes = plt.subplots()
    for cell, angle, number in itertools.product(cells, (20.0, 30.0), (1.0, 2.0)):
        run = work.run(f"footing-{cell}-{angle}-{number}",
                       "verification/strip_footing_friction.prm",
                       {"Grid/Cell size": cell,
                        "Material points/Points per direction": int(number),
                        "Materials/soil/Friction angle": angle})
        load = measures.load(run)
        over = load[-1] / measures.n_c(angle)
        rows[cell, angle, number] = (cell, angle, number, load[-1], over - 1.0,
                                     over / (1.0 + cell) - 1.0)
        axes.plot(1e3 * measures.RATE * run.statistics["Time (s)"][1:], load,
                  color=("C0" if angle == 20.0 else "C1") if number == 1.0
                  else ("C2" if angle == 20.0 else "C3"),
                  linestyle="-" if cell == min(cells) else "--",
                  label=f"φ = {angle:g}°, h = {cell:g} m, {number**2:g} a cell")
    for (cell, angle, number), row in sorted(
            rows.items(), key=lambda r: (r[0][1], -r[0][2], -r[0][0])):
        print("| %g° | %g | %g m | %.2f c | %+.1f %% | %+.1f %% |"
              % (angle, number**2, cell, row[3], 100 * row[4], 100 * row[5]))
    write_csv("mohr_coulomb_footing",
              dict(zip(FOOTING_COLUMNS, zip(*(rows[k] for k in sorted(rows))))))
    for angle in (20.0, 30.0):
        axes.axhline(measures.n_c(angle), color="grey", linewidth=0.8)
        axes.text(20, measures.n_c(angle) - 1.6, f"N_c, {angle:g}°", color="grey")
    axes.set_xlabel("settlement (mm)")
    axes.set_ylabel("load / c")
    axes.legend(fontsize=7)
    save(figure, "mohr_coulomb_footing")


def pile(work):
    figure, panels = plt.subplots(2, 1, figsize=(7.0, 4.4), sharex=True)
    rows = []
    for axes, angle in zip(panels, (19.8, 30.0)):
        run = work.run(f"pile-{angle}", measures.COLUMN,
                       {"Materials/bars/Friction angle": angle})
        heights = measures.heights(run)
        off = heights - measures.MEASURED[:, 1]
        rms = float(np.sqrt((off**2).mean()))
        front = measures.front(run)
        rows.append((angle, 1e3 * rms, front, front / 0.442 - 1.0))
        print("| %g° | %.1f mm | %.3f m | %+.1f %% |"
              % (angle, 1e3 * rms, front, 100 * rows[-1][3]), flush=True)
        points = run.points()
        draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                    vmin=0.0, vmax=2.0)
        axes.plot(*measures.MEASURED.T, "o-", color="C3", markersize=4,
                  label="measured, 19.8°")
        axes.set_ylabel(f"φ = {angle:g}°\ny (m)")
        axes.set_xlim(0.0, 0.6)
        axes.set_ylim(0.0, 0.11)
        if angle == 19.8:
            axes.legend()
            write_csv("mohr_coulomb_pile",
                      {"x_m": measures.MEASURED[:, 0],
                       "measured_m": measures.MEASURED[:, 1],
                       "computed_m": heights})
    panels[1].set_xlabel("x (m)")
    save(figure, "mohr_coulomb_pile")


def main():
    only = option("--only", "slopes,footing,pile").split(",")
    cells = [float(c) for c in option("--cells", "0.125,0.0625").split(",")]
    with workspace(__doc__) as work:
        if "slopes" in only:
            slopes(work)
        if "footing" in only:
            footing(work, cells)
        if "pile" in only:
            pile(work)


if __name__ == "__main__":
    main()
