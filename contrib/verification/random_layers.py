#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/random_layers.md; runs a campaign,
some minutes.

    /usr/bin/python3 contrib/verification/random_layers.py [--waker ...] [--set ...]
"""

import csv
import os
import subprocess

import numpy as np
from common import ROOT, plt, save
from dyke_runs import draw_points, workspace, write_csv
from waker_case import Run

CASE = "verification/dyke_random_layers.prm"


def waker(work, command, folder, sets, *arguments):
    settings = {**work.settings, **sets, "Output/Directory": folder}
    subprocess.run([work.waker, command,
                    os.path.join(ROOT, "parameters", CASE), *arguments]
                   + [part for item in settings.items()
                      for part in ("--set", "%s=%s" % item)], check=True,
                   stdout=subprocess.DEVNULL)


def draw_fields(work):
    """S, unit weight and strength of a realisation at the start."""
    folder = os.path.join(work.folder, "start")
    waker(work, "run", folder, {"Time stepping/End time": 0}, "--realisation",
          "0")
    points = Run(folder).points(0)
    figure, axes = plt.subplots(3, 1, figsize=(9, 6.5), sharex=True)
    for ax, name, label in zip(
            axes, ("strength_ratio", "unit_weight", "undrained_shear_strength"),
            ("S (-)", "unit weight (kN/m³)", "s_u (kPa)")):
        values = np.array(points[name])
        draw_points(ax, points, np.where(values > 0, values, np.nan), label)
        ax.set_ylim(-4.1, 4.5)
    axes[2].set_xlabel("x (m)")
    save(figure, "random_layers_fields")


def campaign(work):
    """{column: values} of realisations.csv."""
    folder = os.path.join(work.folder, "campaign")
    waker(work, "campaign", folder, {})
    path = os.path.join(folder, "report", "realisations.csv")
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: [row[key] for row in rows] for key in rows[0]}


def main():
    with workspace(__doc__) as work:
        draw_fields(work)
        table = campaign(work)
    failed = np.array([float(t or "nan") > 0
                       for t in table["initial_failure_time_displacement"]])
    score = np.array(table["field_S_average_score"], dtype=float)
    mean = np.array(table["field_S_mean"], dtype=float)
    pop = np.array(table["field_POP_mean"], dtype=float)
    print("%d of %d slide" % (failed.sum(), failed.size))
    for name, values in (("S", mean), ("POP", pop)):
        print("%s: mean %.3f, deviation %.3f; of those that slide %.3f" % (
            name, values.mean(), values.std(ddof=1),
            values[failed].mean() if failed.any() else np.nan))
    order = np.argsort(score)
    thirds = np.array_split(order, 3)
    for name, third in zip(("low", "middle", "high"), thirds):
        print("| %s | %.3f | %d of %d |" % (name, mean[third].mean(),
                                            failed[third].sum(), third.size))
    figure, ax = plt.subplots()
    for marked, style in ((False, "o"), (True, "x")):
        ax.plot(mean[failed == marked], pop[failed == marked], style,
                label="slides" if marked else "stands")
    ax.set_xlabel("mean of S (-)")
    ax.set_ylabel("mean of POP (kPa)")
    ax.legend()
    save(figure, "random_layers_averages")
    write_csv("random_layers", {"S_average_score": score, "S_mean": mean,
                                "POP_mean": pop,
                                "slides": failed.astype(int)})


if __name__ == "__main__":
    main()
