#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/mohr_coulomb.md; runs the program.

    /usr/bin/python3 contrib/verification/mohr_coulomb.py [--waker build/bin/waker]
        [--only slopes|footing|pile] [--cells 0.125,0.0625] [--results FOLDER]

--cells are those of the footing: 0.0625 m takes some minutes each; rows of
other cells stay in doc/verification/data/mohr_coulomb_footing.csv. With --results the
piles that are in the folder are read, and none is made; they take half a minute, on cells
of 2.5 mm and on the ground some ten minutes.
"""

import csv
import itertools
import os

import numpy as np
from common import DATA, plt, save
from dyke_runs import draw_points, option, workspace, write_csv
import friction_measures as measures
from waker_case import Run

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


PILES = (  # angle, cell (m), case
    (19.8, 0.005, measures.COLUMN), (30.0, 0.005, measures.COLUMN),
    (19.8, 0.0025, measures.COLUMN), (19.8, 0.005, measures.COLUMN_ON_GROUND))
# Of the front (m): the last that was measured, and a cell of 5 mm, where a trail of one
# point no longer counts.
FRONTS = (0.0015, 0.005)


def pile_on(axes, run, label):
    points = run.points()
    draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                vmin=0.0, vmax=2.0)
    axes.plot(*measures.MEASURED.T, "o-", color="C3", markersize=4,
              label="measured, 19.8°")
    axes.set_ylabel(f"{label}\ny (m)")
    axes.set_xlim(0.0, 0.6)
    axes.set_ylim(0.0, 0.11)


def pile(work, results):
    figure, panels = plt.subplots(3, 1, figsize=(7.0, 6.4), sharex=True)
    rows, columns = [], {"x_m": measures.MEASURED[:, 0],
                         "measured_m": measures.MEASURED[:, 1]}
    for number, (angle, cell, case) in enumerate(PILES):
        base = "held" if case == measures.COLUMN else "ground"
        name = f"pile-{angle}-{cell:g}-{base}"
        folder = os.path.join(results, name)
        if results and not os.path.exists(os.path.join(folder, "summary.json")):
            continue
        run = Run(folder) if results else work.run(
            name, case, {"Materials/bars/Friction angle": angle,
                         "Grid/Cell size": cell,
                         "Time stepping/Time step": 0.05 * cell})
        heights = measures.heights(run)
        off = heights - measures.MEASURED[:, 1]
        over = [measures.front(run, h) / measures.measured_front(h) - 1.0
                for h in FRONTS]
        rows.append((angle, base, cell, 1e3 * float(np.sqrt((off**2).mean())),
                     measures.front(run, FRONTS[0]), *over))
        print("| %g° | %s | %g m | %.1f mm | %.3f m | %+.1f %% | %+.1f %% |"
              % (*rows[-1][:5], *(100 * o for o in over)), flush=True)
        if base == "held":
            pile_on(panels[number], run, f"{angle:g}°, {1e3 * cell:g} mm")
            columns[f"computed_{angle:g}_degrees_{1e3 * cell:g}_mm_cells_m"] = heights
    write_csv("mohr_coulomb_pile", columns)
    write_csv("mohr_coulomb_pile_fronts", dict(zip(
        ("angle", "base", "cell_m", "rms_mm", "front_m", "front_1.5_mm_over",
         "front_5_mm_over"), zip(*rows))), digits=4)
    panels[0].legend()
    panels[-1].set_xlabel("x (m)")
    save(figure, "mohr_coulomb_pile")


def main():
    only = option("--only", "slopes,footing,pile").split(",")
    cells = [float(c) for c in option("--cells", "0.125,0.0625").split(",")]
    results = option("--results", "")
    with workspace(__doc__) as work:
        if "slopes" in only:
            slopes(work)
        if "footing" in only:
            footing(work, cells)
        if "pile" in only:
            pile(work, results)


if __name__ == "__main__":
    main()
