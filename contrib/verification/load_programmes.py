#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and numbers of doc/verification/load_programmes.md: the slope of chapter 6 of
Remmerswaal (2023) in plane strain under a foundation load that grows until it fails.

    /usr/bin/python3 contrib/verification/load_programmes.py
"""

import numpy as np
from common import plt, save
from dyke_runs import workspace, write_csv

LOAD = "Load programmes/foundation/"
CASE = "chapter6/foundation_2d.prm"
DRAWDOWN = "chapter6/drawdown_2d.prm"
# The same load as a traction on the strip, instead of points that get heavier.
STRIP = {"Tractions/Names": "strip", "Tractions/strip/Kind": "vector",
         "Tractions/strip/Value": "0; -20", "Tractions/strip/From": "1.5, 0.9",
         "Tractions/strip/To": "2, 1.1", LOAD + "Drives": "traction",
         LOAD + "Load": "strip", LOAD + "From": "", LOAD + "To": ""}
PERFECT = {"Materials/clay/Softening modulus": 0,
           "Materials/clay/Residual strength": 3.6}
SLOW = {**PERFECT, LOAD + "Rate": 0.1, LOAD + "Hold above": 0.01}

VARIANTS = {
    "top": {},
    "top, with mass": {LOAD + "Mass": "with mass"},
    "column": {LOAD + "Points": "column"},
    "column, with mass": {LOAD + "Points": "column",
                          LOAD + "Mass": "with mass"},
    "traction on the strip": STRIP,
    "top, dt = 0.005 s": {"Time stepping/Time step": 0.005},
    "top, dt = 0.0025 s": {"Time stepping/Time step": 0.0025},
    "top, h = 0.0625 m": {"Grid/Cell size": 0.0625,
                          "Time stepping/Time step": 0.005},
    "no softening, 0.1 m/s, held above 0.01 m/s: top": SLOW,
    "the same, traction on the strip": {**STRIP, **SLOW},
    "the same, column": {**SLOW, LOAD + "Points": "column"},
    "the same, top, h = 0.0625 m": {**SLOW, "Grid/Cell size": 0.0625,
                                    "Time stepping/Time step": 0.005},
}

# Strengths (kPa), as examples in the manner of figure 6.2.
STRENGTHS = (3.0, 3.6, 4.2)


def crest_cut(run):
    """x at which the slide leaves the crest (m), and its share of the profile."""
    slide = run["inner_slide"]
    return (np.nan, np.nan) if slide is None else (slide["crest_cut"],
                                                   slide["share"])


def draw(axes, run, time):
    points = run.points(time)
    x = points["position"]
    axes.scatter(x[:, 0], x[:, 1], c=points["plastic_strain"], s=9, marker="s",
                 linewidths=0, cmap="viridis", vmin=0, vmax=1.6)
    loaded = points["programme_foundation"] > 0
    axes.scatter(x[loaded, 0], x[loaded, 1], s=14, facecolors="none",
                 edgecolors="red", linewidths=0.7)
    axes.set(xlim=(0, 6), ylim=(-0.05, 1.15), aspect="equal", ylabel="y (m)")
    axes.set_title(f"t = {time:g} s", loc="left", fontsize=9)
    axes.grid(False)


def drawdown(work):
    """Water that falls: each step until it has been stopped, and half a second."""
    run = work.run("drawdown", DRAWDOWN, {"Output/Interval": 0})
    rows, load = run.statistics, run["loads"][0]
    shown = rows["Time (s)"] <= load["stop_time"] + 0.5
    columns = {"time_s": "Time (s)", "load_m": "Load drawdown (m)",
               "held": "Load drawdown held", "stopped": "Load drawdown stopped",
               "settlement_m": "Largest settlement (m)",
               "settlement_rate_m_per_s": "Largest settlement rate (m/s)"}
    write_csv("load_programmes_drawdown",
              {key: rows[name][shown] for key, name in columns.items()})
    first = rows["Time (s)"][np.argmax(rows["Load drawdown held"] > 0)]
    print(f"  drawdown {load['factor']:.3f} m, waits from {first:.2f} s on, "
          f"stopped at {load['stop_time']:.2f} s; leaves the crest at x = "
          f"{run['outer_slide']['crest_cut']:.2f} m")


with workspace(__doc__) as work:
    drawdown(work)
    table = {key: [] for key in ("variant", "load_m", "stop_time_s", "held_s",
                                 "crest_cut_m", "share")}
    for name, changes in VARIANTS.items():
        ends = {"Time stepping/End time": 15 if "0.1 m/s" in name
                or "the same" in name else 4}
        run = work.run("run", CASE, {"Output/Interval": 0, **ends, **changes})
        load, (cut, share) = run["loads"][0], crest_cut(run)
        row = (name, load["factor"], load["stop_time"] or np.nan,
               load["held_for"], cut, share)
        for key, value in zip(table, row):
            table[key].append(value)
        print("| " + " | ".join(value if isinstance(value, str)
                                else f"{value:.3g}" for value in row) + " |",
              flush=True)
    write_csv("load_programmes", table)

    figure, (total, step) = plt.subplots(1, 2, figsize=(9.5, 3.6))
    history = {key: [] for key in ("strength_kPa", "time_s", "load_m",
                                   "settlement_m", "settlement_rate_m_per_s")}
    for strength in STRENGTHS:
        run = work.run(f"c{strength}", CASE, {
            "Materials/clay/Initial strength": strength,
            "Materials/clay/Residual strength": strength / 10})
        # As in the thesis: each tenth step, until it has failed.
        failed = np.argmax(run.statistics["Largest settlement (m)"] > 0.12)
        rows = slice(0, failed + 10, 10)
        load = run.statistics["Load foundation (m)"][rows]
        settlement = run.statistics["Largest settlement (m)"][rows]
        rate = run.statistics["Largest settlement rate (m/s)"][rows]
        for axes, value in ((total, settlement), (step, 0.01 * rate)):
            axes.plot(value, load, "o-", markersize=2.5, linewidth=1,
                      label=f"{strength} kPa")
        for key, values in zip(history, (
                np.full(len(load), strength), run.statistics["Time (s)"][rows],
                load, settlement, rate)):
            history[key] += list(values)
        print(f"  {strength} kPa: load {load[-1]:.3f} m")
    write_csv("load_programmes_history", history)
    total.set(xlim=(0, 0.12), xlabel="largest settlement (m)",
              ylabel="load (m of soil)")
    total.axvline(0.1, color="black", linewidth=0.6)
    step.set(xlim=(0, 0.006), xlabel="largest settlement in 0.01 s (m)")
    step.axvline(0.0005, color="black", linewidth=0.6)
    total.legend()
    save(figure, "load_programmes")

    slope = work.run("slope", CASE, {})
    figure, axes = plt.subplots(4, 1, figsize=(7, 7.2), sharex=True)
    for one, time in zip(axes, (0.5, 1.25, 2.5, 15)):
        draw(one, slope, time)
    axes[-1].set_xlabel("x (m)")
    save(figure, "load_programmes_slope")
