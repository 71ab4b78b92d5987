#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slope of chapter 6: what failed, how far, under which load, from the
realisations of its campaigns.

usage: chapter6.py DATA_FOLDER FIGURE_FOLDER [CAMPAIGN_FOLDER ...]

Each campaign folder (merged: report/realisations.csv, campaign.json) is first
put into DATA_FOLDER as <name>.csv with the columns that count, named after its
Output/Directory without "output-chapter6-". Then figures and the table of all
that is in DATA_FOLDER are made; the table is printed as Markdown.
"""
import csv
import glob
import json
import os
import sys

import numpy as np
from estimates import proportion
from figure_files import BLUE, GREY, VERMILLION, plt

COLUMNS = ("realisation", "outcome", "load", "load_stop_time",
           "relative_failure_volume", "retrogression_distance",
           "damaged_crest_width", "n_masses", "first_mass_volume",
           "first_mass_width",
           "n_masses_remnant", "n_masses_side",
           "n_masses_behind_centred", "n_masses_behind_off_centre",
           "mean_strength", "unconverged_steps", "steps",
           "wall_time", "field_time")
# Load heights below this (m) are those of slopes that fail under their own
# weight: the first class of the thesis's histograms.
INHERENT = 0.1


def take(folder, data):
    """The columns of a campaign as a table in the data folder."""
    with open(os.path.join(folder, "campaign.json"), encoding="utf-8") as file:
        campaign = json.load(file)
    name = os.path.basename(os.path.normpath(folder))
    name = name.replace("output-chapter6-", "")
    with open(os.path.join(folder, "report", "realisations.csv"),
              encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = [c for c in COLUMNS if c in rows[0]]
    path = os.path.join(data, name + ".csv")
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(f"# campaign {campaign['hash']}, seed {campaign['seed']}, "
                   f"Waker {campaign['version']}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        for row in rows:
            writer.writerow([row[c] if c == "outcome" else short(row[c])
                             for c in columns])
    return path


def short(text):
    """A number with six digits; nothing for NaN."""
    try:
        x = float(text)
    except ValueError:
        return ""
    return "" if np.isnan(x) else f"{x:.6g}"


class Set:
    """The realisations of one table that gave a result."""

    def __init__(self, path):
        self.name = os.path.splitext(os.path.basename(path))[0]
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(
                line for line in file if not line.startswith("#")))
        self.n_lost = sum(r["outcome"] == "numerical failure" for r in rows)
        self.rows = [r for r in rows if r["outcome"] != "numerical failure"]

    def __getitem__(self, column):
        return np.array([float(r[column]) if r.get(column) else np.nan
                         for r in self.rows])

    @property
    def is_plane(self):
        return self.name.endswith("-2d")

    @property
    def label(self):
        return self.name.replace("analysis", "analysis ").replace("-2d", ", 2D")

    def share(self, condition):
        """'0.21 [0.17, 0.26]', n counted."""
        p = proportion(int(np.sum(condition)), len(self.rows))
        return f"{p[0]:.3g} [{p[1]:.3g}, {p[2]:.3g}]"


def spread(values):
    """'0.36 (0.04 to 0.7)': mean, and 5 to 95 %."""
    values = values[~np.isnan(values)]
    if len(values) == 0:
        return ""
    low, high = np.quantile(values, (0.05, 0.95))
    return f"{values.mean():.2f} ({low:.2f} to {high:.2f})"


def table(sets):
    lines = ["| | N | inherently unstable | load (m) | failure volume (-) | "
             "more than half | retrogression (m) | s each |",
             "|---|---|---|---|---|---|---|---|"]
    for s in sets:
        volume = s["relative_failure_volume"]
        lines.append(
            f"| {s.label} | {len(s.rows)} | {s.share(s['load'] < INHERENT)} | "
            f"{spread(s['load'])} | {spread(volume)} | "
            f"{s.share(volume > 0.5)} | {spread(s['retrogression_distance'])} | "
            f"{np.nanmean(s['wall_time']):.3g} |")
    return "\n".join(lines)


def histograms(sets, figures):
    """As figures 6.12 to 6.14: load, failure volume, retrogression."""
    quantities = (("load", "ultimate load (m of soil)", 0.1),
                  ("relative_failure_volume", "relative failure volume (-)",
                   0.1),
                  ("retrogression_distance", "retrogression distance (m)",
                   0.2))
    figure, axes = plt.subplots(len(sets), 3, squeeze=False,
                                figsize=(9, 0.6 + 2.1 * len(sets)))
    for row, s in zip(axes, sets):
        inherent = s["load"] < INHERENT
        for axis, (column, name, width) in zip(row, quantities):
            values = s[column]
            top = max(np.nanmax(values), width)
            edges = np.arange(0., top + width, width)
            axis.hist([values[inherent], values[~inherent]], bins=edges,
                      stacked=True, color=[VERMILLION, BLUE],
                      label=["under its own weight", "under the load"])
            axis.set_xlabel(name)
            axis.set_ylabel("realisations")
        row[0].set_title(f"{s.label}, N = {len(s.rows)}")
        row[0].legend()
    figure.savefig(os.path.join(figures, "histograms.png"))
    plt.close(figure)


def pairs(sets, figures):
    """Each realisation in 3D beside its twin in the plane."""
    by_name = {s.name: s for s in sets}
    found = [(s, by_name[s.name + "-2d"]) for s in sets
             if s.name + "-2d" in by_name]
    lines = []
    for space, plane in found:
        twin = {r["realisation"]: r for r in plane.rows}
        both = [(float(r["load"]), float(twin[r["realisation"]]["load"]))
                for r in space.rows if r["realisation"] in twin]
        if not both:
            continue
        x, y = np.array(both).T
        lines.append(f"{space.label}: {len(x)} pairs, 3D bears more in "
                     f"{np.sum(x > y)}, mean {x.mean():.2f} m against "
                     f"{y.mean():.2f} m in the plane")
        figure, axis = plt.subplots(figsize=(4, 4))
        axis.plot(y, x, "o", color=BLUE)
        top = 1.05 * max(x.max(), y.max())
        axis.plot([0., top], [0., top], color=GREY, linewidth=0.8)
        axis.set_xlabel("ultimate load in plane strain (m)")
        axis.set_ylabel("ultimate load in 3D (m)")
        axis.set_title(space.label)
        figure.savefig(os.path.join(figures, f"pairs_{space.name}.png"))
        plt.close(figure)
    return lines


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    data, figures, *campaigns = sys.argv[1:]
    for folder in (data, figures):
        os.makedirs(folder, exist_ok=True)
    for folder in campaigns:
        print(f"wrote {take(folder, data)}")
    sets = [Set(path) for path in sorted(glob.glob(os.path.join(data,
                                                                "*.csv")))]
    sets = [s for s in sets if s.rows]
    if not sets:
        sys.exit(f"no realisations in {data}")
    histograms(sets, figures)
    print(table(sets))
    print("\n".join(pairs(sets, figures)))


if __name__ == "__main__":
    main()
