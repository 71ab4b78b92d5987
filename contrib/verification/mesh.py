#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/mesh.md: factor of safety and times on
cells of 0.5, 0.25 and 0.125 m, with softening, without, and with a softening
modulus in proportion to the cell. It takes some minutes.

    /usr/bin/python3 contrib/verification/mesh.py
"""

import numpy as np
from common import plt, save
from dyke_runs import draw_points, sampled, workspace, write_csv
import dyke_measures as measures
from slip_surface import horizontal_width

CELLS = (0.5, 0.25, 0.125)
WIDTH = "Dyke width W (m)"
MODULUS = "Materials/clay/Softening modulus"
SEARCH = {"Strength reduction/Lower factor": 1,
          "Strength reduction/Upper factor": 1.6,
          "Strength reduction/Tolerance": 0.02}


def text(value):
    return "none" if value is None else f"{value:.2f}"


with workspace(__doc__) as work:
    table = {key: [] for key in ("h_m", "fos_softening", "fos_perfect",
                                 "fos_scaled_softening")}
    curves, states = {}, {}
    for cell in CELLS:
        grid = {"Grid/Cell size": cell}
        row = [cell]
        for file, changes in (
                ("chapter5/dyke_fos.prm", {}),
                ("verification/dyke_no_softening.prm",
                 {**measures.strength(13, 13),
                  "Strength reduction/Lower factor": 1.5,
                  "Strength reduction/Upper factor": 2.1}),
                ("chapter5/dyke_fos.prm", {MODULUS: -50 * cell / 0.25})):
            result = work.factor_of_safety("fos", file,
                                           {**grid, **SEARCH, **changes})
            row.append(result["factor_of_safety"])
        for key, value in zip(table, row):
            table[key].append(value)
        print("| " + " | ".join(f"{value:.3f}" for value in row) + " |",
              flush=True)
        for c in (10, 9):
            run = work.run("run", "chapter5/dyke_weak.prm",
                           {**grid, "Output/Interval": 0.25,
                            **measures.strength(c, c / 2.6)})
            start = run["initial_failure_time"]
            band = ("" if start is None else
                    f"{horizontal_width(run.points(start + 1), cell, c):.2f}")
            print(f"| h = {cell} | c_i = {c} | {run['outcome']} | "
                  f"{text(start)} | {text(run['flooding_time'])} | {band} | "
                  f"{run['unconverged_steps']} unconverged | "
                  f"{run['particles']} points, {run['wall_time']:.1f} s |",
                  flush=True)
            if c == 9:
                curves[cell] = sampled(run, [WIDTH])
                states[cell] = run.points(start + 1), start + 1
    for time_step in (0.005, 0.0025):
        run = work.run("run", "chapter5/dyke_weak.prm",
                       {"Grid/Cell size": 0.125, "Output/Interval": 0,
                        "Time stepping/Time step": time_step})
        print(f"| h = 0.125, dt = {time_step} | c_i = 10 | {run['outcome']} | "
              f"{text(run['initial_failure_time'])} | "
              f"{text(run['flooding_time'])} |", flush=True)

write_csv("mesh", table)
longest = max((times for times, _ in curves.values()), key=len)
write_csv("mesh_width", {
    "time_s": longest,
    **{f"W_m_h_{cell:g}": np.interp(longest, times, columns[WIDTH])
       for cell, (times, columns) in curves.items()}})

figure = plt.figure(figsize=(11, 5))
layout = figure.add_gridspec(3, 2, width_ratios=(1, 1.5))
left = figure.add_subplot(layout[:, 0])
for key, label, line in (("fos_perfect", "no softening", "s--"),
                         ("fos_scaled_softening",
                          "$H_s$ in proportion to h", "^-"),
                         ("fos_softening", "$H_s$ = -50 kPa", "o-")):
    left.plot(table["h_m"], table[key], line, label=label)
left.axhline(1.736, color="black", linewidth=0.8, label="slip circle")
left.set_xscale("log", base=2)
left.set_xticks(CELLS, [f"{cell:g}" for cell in CELLS])
left.set_xlabel("cell size h (m)")
left.set_ylabel("factor of safety")
left.set_ylim(1.0, None)
left.legend(loc="lower right")
for number, (cell, (points, time)) in enumerate(states.items()):
    axes = figure.add_subplot(layout[number, 1])
    draw_points(axes, points, points["undrained_shear_strength"],
                cmap="viridis", s=2.2 * (cell / 0.25)**2)
    axes.set_xlim(-1, 33)
    axes.set_title(f"strength, h = {cell:g} m, $c_i$ = 9 kPa, "
                   f"t = {time:.2f} s", fontsize=9)
figure.tight_layout()
save(figure, "mesh")
