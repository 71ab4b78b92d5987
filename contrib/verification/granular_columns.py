#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, data and figure of the columns of sand in doc/verification/mohr_coulomb.md;
runs the program.

    /usr/bin/python3 contrib/verification/granular_columns.py [--cells 0.01,0.005,0.0025]
        [--results FOLDER] [--waker build/bin/waker]

A column takes some seconds on cells of 10 mm, 10 to 30 s on cells of 5 mm, and one to
five minutes on cells of 2.5 mm.
With --results, the runs that are in the folder are read, and none is made: columns
that are not there are left out.
"""

import os

from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv
from column_measures import ANGLE, CASE, LAWS, WIDTH, front, profile, settings
from waker_case import Run

RATIOS = (0.5, 1.0, 2.0)  # a
HEIGHTS = (0.02, 0.01, 0.005, 0.0025)  # m, of what counts as the front


def columns(work, cells, results):
    rows, runs = [], {}
    for cell in cells:
        for angle in LAWS:
            for ratio in RATIOS:
                name = f"{cell:g}-{angle:g}-{ratio:g}"
                folder = os.path.join(results, name)
                if results and not os.path.exists(os.path.join(folder, "summary.json")):
                    continue
                if results:
                    run = Run(folder)
                else:
                    run = work.run(name, CASE,
                                   {**settings(ratio, cell), ANGLE: angle})
                if runs.get((angle, ratio), (1, None))[0] > cell:
                    runs[angle, ratio] = cell, run
                out = [(front(run, h) / WIDTH - 1) / ratio for h in HEIGHTS]
                kept = profile(run)[1][0] / WIDTH
                rows.append((angle, ratio, cell, *out, LAWS[angle], kept))
                print("| %g° | %g | %g mm | %.2f a | %.2f a | %.2f a | %.2f a | %.1f a | %.2f L |"
                      % (angle, ratio, 1e3 * cell, *rows[-1][3:]), flush=True)
    write_csv("mohr_coulomb_columns",
              dict(zip(("angle", "ratio", "cell_m", "run_out_20_mm_over_a",
                        "run_out_10_mm_over_a",
                        "run_out_5_mm_over_a", "run_out_2.5_mm_over_a", "law_over_a", "height_over_width"),
                       zip(*rows))), digits=4)
    return runs


def main():
    cells = [float(cell) for cell in option("--cells", "0.01,0.005,0.0025").split(",")]
    results = option("--results", "")
    with workspace(__doc__) as work:
        runs = columns(work, cells, results)
        figure, panels = plt.subplots(3, 2, figsize=(9.5, 5.0), sharex=True)
        for column, angle in enumerate(LAWS):
            for axes, ratio in zip(panels[:, column], RATIOS):
                cell, run = runs[angle, ratio]
                points = run.points()
                draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                            vmin=0, vmax=2)
                reach = WIDTH * (1 + LAWS[angle] * ratio)
                axes.plot([reach, reach], [0, 0.04], color="C3")
                axes.plot([0, WIDTH, WIDTH], [ratio * WIDTH] * 2 + [0], "k:",
                          linewidth=0.8)
                axes.set_xlim(0, 0.7)
                axes.set_ylim(0, 0.21 if ratio == 2 else 0.11)
                axes.set_ylabel(f"a = {ratio:g}\ny (m)")
                axes.text(0.35, 0.06, f"h = {1e3 * cell:g} mm")
            panels[0, column].set_title(f"φ = {angle:g}°", fontsize=9)
            panels[-1, column].set_xlabel("x (m)")
        save(figure, "mohr_coulomb_columns")


if __name__ == "__main__":
    main()
