#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and numbers of doc/verification/nonlocal.md: the dyke of chapter 5 on
cells of 0.5, 0.25 and 0.125 m with softening as it is, scaled by the cells, and
nonlocal; and a sheared layer. It takes some ten minutes.

    /usr/bin/python3 contrib/verification/nonlocal.py
"""

import numpy as np
from common import plt, save
from dyke_runs import draw_points, sampled, workspace, write_csv
import dyke_measures as measures
from slip_surface import horizontal_width

CELLS = (0.5, 0.25, 0.125)
CLAY = "Materials/clay/"
WAYS = {
    "as it is": {},
    "scaled": {CLAY + "Softening length": 0.25},
    "nonlocal": {CLAY + "Regularisation": "nonlocal",
                 CLAY + "Averaging length": 0.5,
                 CLAY + "Softening modulus": -300},
}
SEARCH = {"Strength reduction/Lower factor": 1.15,
          "Strength reduction/Upper factor": 1.5,
          "Strength reduction/Tolerance": 0.005}
STRESS = "Reaction x (kN)"
WORK = "Work of the supports (kJ)"
REMAINDER = "Energy remainder (kJ)"


def text(value):
    return "none" if value is None else f"{value:.2f}"


def factors(work, table):
    for way, changes in WAYS.items():
        for cell in CELLS:
            result = work.factor_of_safety(
                "fos", "chapter5/dyke_fos.prm",
                {"Grid/Cell size": cell, **SEARCH, **changes})
            factor = result["factor_of_safety"]
            print(f"| {way} | {cell} | {factor:.3f} |", flush=True)
            for key, value in zip(table, (way, cell, factor)):
                table[key].append(value)
    for step in (0.005, 0.0025):
        result = work.factor_of_safety(
            "fos", "chapter5/dyke_fos.prm",
            {**SEARCH, **WAYS["nonlocal"], "Time stepping/Time step": step})
        print(f"| nonlocal | 0.25, dt = {step} | "
              f"{result['factor_of_safety']:.3f} |", flush=True)


def slides(work, table, states, c=9):
    """To 10 s, beyond flooding: how far soil gets."""
    for way, changes in WAYS.items():
        for cell in CELLS:
            run = work.run("run", "chapter5/dyke_weak.prm",
                           {"Grid/Cell size": cell, "Output/Interval": 0.25,
                            "Stop rules/On flooding": "false",
                            "Time stepping/End time": 10,
                            **measures.strength(c, c / 2.6), **changes})
            start = run["initial_failure_time"]
            points = run.points(start + 1)
            width = horizontal_width(points, cell, c)
            toe = run.points()["position"][:, 0].max()
            row = (way, cell, start, run["flooding_time"] or np.nan,
                   toe - 30, width)
            for key, value in zip(table, row):
                table[key].append(value)
            print(f"| {way} | {cell} | {text(start)} | "
                  f"{text(run['flooding_time'])} | {toe - 30:.2f} | "
                  f"{width:.2f} | {run['outcome']} at {run['end_time']:.1f} s, "
                  f"{run['unconverged_steps']} unconverged |", flush=True)
            states[way, cell] = points, start + 1


def layers(work, table, profiles):
    """The sheared layer: what the top does, and who shears."""
    for way in ("as it is", "nonlocal"):
        for cell in CELLS:
            local = {CLAY + "Regularisation": "softening length"}
            run = work.run("layer", "verification/sheared_layer.prm",
                           {"Grid/Cell size": cell,
                            **(local if way == "as it is" else {})})
            points = run.points()
            y = np.round(points["position"][:, 1], 6)
            rows = np.unique(y)
            strain = np.array([points["plastic_strain"][y == row].mean()
                               for row in rows])
            middle = (strain * rows).sum() / strain.sum()
            width = np.sqrt(12 * (strain * (rows - middle)**2).sum()
                            / strain.sum())
            last = {key: run.statistics[key][-1] for key in (WORK, REMAINDER)}
            # 4 kPa on 2 m by 0.6 m is what the residual strength takes.
            row = (way, cell, width, last[WORK], last[WORK] - 4.8,
                   last[REMAINDER])
            for key, value in zip(table, row):
                table[key].append(value)
            print("| " + " | ".join(str(value) for value in row) + " |",
                  flush=True)
            profiles[way, cell] = rows, strain


def draw(table, states, profiles):
    figure = plt.figure(figsize=(12, 8))
    layout = figure.add_gridspec(4, 3, width_ratios=(1, 1, 1.6))
    axes = figure.add_subplot(layout[:2, 0])
    for way, line in zip(WAYS, ("o-", "^-", "s-")):
        rows = [i for i, name in enumerate(table["softening"]) if name == way]
        axes.plot([table["h_m"][i] for i in rows],
                  [table["factor_of_safety"][i] for i in rows], line, label=way)
    axes.set_xscale("log", base=2)
    axes.set_xticks(CELLS, [f"{cell:g}" for cell in CELLS])
    axes.set_xlabel("cell size h (m)")
    axes.set_ylabel("factor of safety")
    axes.legend()
    for column, way in enumerate(("as it is", "nonlocal")):
        axes = figure.add_subplot(layout[2:, column])
        for (name, cell), (rows, strain) in profiles.items():
            if name != way:
                continue
            axes.plot(strain, rows, label=f"h = {cell:g} m")
        axes.set_xlabel("plastic strain (-)")
        axes.set_ylabel("y (m)")
        axes.set_title(f"sheared layer, {way}", fontsize=9)
        axes.legend()
    shown = [(way, cell) for way in ("as it is", "nonlocal")
             for cell in (0.5, 0.125)]
    for number, key in enumerate(shown):
        points, time = states[key]
        axes = figure.add_subplot(layout[number, 2])
        draw_points(axes, points, points["undrained_shear_strength"],
                    cmap="viridis", s=2.2 * (key[1] / 0.25)**2)
        axes.set_xlim(-1, 36)
        axes.set_title(f"strength, {key[0]}, h = {key[1]:g} m, "
                       f"t = {time:.2f} s", fontsize=9)
    figure.tight_layout()
    save(figure, "nonlocal")


def main():
    factor_table = {key: [] for key in ("softening", "h_m",
                                        "factor_of_safety")}
    slide_table = {key: [] for key in (
        "softening", "h_m", "initial_failure_s", "flooding_s", "run_out_m",
        "slip_surface_m")}
    layer_table = {key: [] for key in (
        "softening", "h_m", "band_width_m", "work_kJ", "softening_work_kJ",
        "energy_remainder_kJ")}
    states, profiles = {}, {}
    with workspace(__doc__) as work:
        layers(work, layer_table, profiles)
        factors(work, factor_table)
        slides(work, slide_table, states)
    write_csv("nonlocal", factor_table)
    write_csv("nonlocal_slides", slide_table)
    write_csv("nonlocal_layer", layer_table)
    draw(factor_table, states, profiles)


if __name__ == "__main__":
    main()
