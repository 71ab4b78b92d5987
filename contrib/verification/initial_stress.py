#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/initial_stress.md; runs the program for
some minutes.

    /usr/bin/python3 contrib/verification/initial_stress.py [--waker build/bin/waker]
        [--only start|factors]
"""

import json
import os

import numpy as np
from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv

CASE = "verification/dyke_stages.prm"
DAILY = {"Water/Level": 0.5,
         "Pore water/Phreatic line": "-20, 0.5; 1.5, 0.5; 28, -0.3; 50, -0.3"}
AT_ONCE = {"Initial stress/Daily stage": "false", "Initial stress/Daily level": ""}
VARIANTS = (  # name, settings
    ("daily, then high water", {}),
    ("high water at once, K0", AT_ONCE),
    ("high water at once, elastic gravity step",
     {**AT_ONCE, "Initial stress/From": "gravity", "Initial stress/Laws": "elastic"}),
    ("daily water", {**AT_ONCE, **DAILY}))


def start(work):
    """Yield stress, OCR, and what is horizontal of the effective stress."""
    points = work.run("start", CASE, {"Time stepping/End time": 0}).points(0)
    x, y = points["position"][:, 0], points["position"][:, 1]
    clay = points["overconsolidation_ratio"] > 0
    line = np.interp(x, (-20, 10.5, 28, 50), (3.5, 3.5, 0, 0))
    pressure = np.where(clay, np.maximum(10.0 * (line - y), 0.0), 0.0)
    vertical = -points["stress_yy"] - pressure
    horizontal = -points["stress_xx"] - pressure
    figure, axes = plt.subplots(4, 1, figsize=(9, 9), sharex=True)

    def some(values):
        return np.where(clay, values, np.nan)

    draw_points(axes[0], points, vertical, "σ'_v (kPa)", vmin=0, vmax=60)
    draw_points(axes[1], points, np.clip(horizontal / np.maximum(vertical, 0.5), 0, 3),
                "σ'_h / σ'_v", vmin=0.3, vmax=1.5)
    draw_points(axes[2], points, some(points["yield_stress"]), "yield stress (kPa)",
                vmin=20, vmax=90)
    draw_points(axes[3], points, some(points["overconsolidation_ratio"]), "OCR",
                vmin=1, vmax=10, cmap="magma")
    for ax in axes:
        ax.set_ylim(-6.1, 4.5)
    axes[3].set_xlabel("x (m)")
    save(figure, "initial_stress")
    off = np.abs(vertical - points["initial_vertical_stress"])
    print("sigma'_v, points against columns: mean %.2f, 95 %% below %.2f kPa"
          % (off.mean(), np.quantile(off, 0.95)))


def factors(work):
    rows = []
    for name, settings in VARIANTS:
        try:
            work.factor_of_safety(name, CASE, {
                **settings, "Strength reduction/Tolerance": 0.02,
                "Strength reduction/Lower factor": 1,
                "Strength reduction/Upper factor": 1.6})
        except SystemExit:  # no factor: some dykes still move
            pass
        with open(os.path.join(work.folder, name, "strength_reduction.json"),
                  encoding="utf-8") as file:
            result = json.load(file)
        rows.append((name, *(np.nan if result[key] is None else result[key]
                             for key in ("highest_stable_factor",
                                         "lowest_failed_factor"))))
        print("| %s | %.3f | %.3f |" % rows[-1], flush=True)
    write_csv("initial_stress", dict(zip(("stress", "stable", "fails"), zip(*rows))))


def main():
    only = option("--only", "start,factors").split(",")
    with workspace(__doc__) as work:
        if "start" in only:
            start(work)
        if "factors" in only:
            factors(work)


if __name__ == "__main__":
    main()
