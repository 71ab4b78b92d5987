#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and numbers of doc/verification/contour.md: the time that the contour
of support domains takes as the body grows, and what its filling of gaps lacks in
symmetry. From data/contour_cost.csv and data/contour_symmetry.csv:

    build/bin/benchmarks --benchmark_filter=^contour/ \\
        --benchmark_out=contour.json --benchmark_out_format=json
    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter=Surface.contour_filled_from_the_left_is_not_symmetric
    /usr/bin/python3 contrib/verification/contour.py contour.json

Without an argument the figures are drawn again from the data.
"""

import csv
import json
import os
import sys

import numpy as np
from common import DATA, plt, read_csv, save

COST = os.path.join(DATA, "contour_cost.csv")


def write_cost(path):
    """contour_cost.csv from what the benchmark program has written."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    with open(COST, "w", encoding="utf-8") as file:
        file.write("body,points,surface,swept,total_ms,coverage_ms\n")
        for run in runs:
            if "surface" in run:
                body = run["name"].split("/")[1]
                file.write(f"\"{body}\",{run['points']:.0f},"
                           f"{run['surface']:.0f},{run['swept']:.0f},"
                           f"{run['cpu_time']:.5g},"
                           f"{1e3 * run['coverage']:.5g}\n")


if len(sys.argv) > 1:
    write_cost(sys.argv[1])

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8))
bodies = {}
with open(COST, encoding="utf-8") as file:
    for row in csv.DictReader(file):
        bodies.setdefault(row.pop("body"), []).append(
            {key: float(value) for key, value in row.items()})
print("body                 points  surface  swept  total ms  "
      "us per surface domain: sweep, total")
for colour, (body, rows) in zip(("C0", "C1", "C3"), bodies.items()):
    points, surface, total, coverage = (
        np.array([row[key] for row in rows])
        for key in ("points", "surface", "total_ms", "coverage_ms"))
    left.loglog(points, total, "o-", color=colour, label=body)
    if "all domains" not in body:
        sweep = 1e3 * (total - coverage) / surface
        right.semilogx(surface, sweep, "o-", color=colour,
                       label=body + ": sweep")
        right.semilogx(surface, 1e3 * total / surface, "o--", color=colour,
                       label=body + ": with the search for open blocks")
    for row in rows:
        us = 1e3 / row["surface"]
        print(f"{body:20s} {row['points']:7.0f}  {row['surface']:7.0f} "
              f"{row['swept']:6.0f}  {row['total_ms']:8.3f}  "
              f"{us * (row['total_ms'] - row['coverage_ms']):.2f}, "
              f"{us * row['total_ms']:.2f}")
left.axhline(50, color="black", lw=0.8, ls=":")
left.set_xlabel("support domains")
left.set_ylabel("time (ms)")
left.legend(fontsize=8)
right.set_ylim(0, 8)
right.set_xlabel("domains at the surface")
right.set_ylabel("time per domain at the surface (µs)")
right.legend(fontsize=8, loc="upper right")
save(figure, "contour_cost")

data = {key: np.array(values)
        for key, values in read_csv("contour_symmetry").items()}
area = data["symmetric"]
difference = data["one_only"] / area
print(f"{len(area)} bodies; filled from left and right differently: "
      f"{np.mean(difference > 1e-9):.3f} of them; area that only one has: "
      f"mean {np.mean(difference):.2e}, largest {np.max(difference):.2e}")
for name, key in (("gaps filled, symmetric", "unfilled"),
                  ("more from the left", "from_left"),
                  ("more from the right", "from_right")):
    share = np.abs(data[key] - area) / area
    print(f"{name}: mean {np.mean(share):.2e}, largest {np.max(share):.2e}")
figure, axes = plt.subplots()
share = np.arange(1, len(area) + 1) / len(area)
for key, label in ((difference, "in one of left and right only"),
                   (data["from_left"] / area - 1, "left against symmetric"),
                   (1 - data["unfilled"] / area, "symmetric against unfilled")):
    axes.semilogx(np.maximum(np.sort(key), 1e-7), share, label=label)
axes.set_xlabel("difference as a share of the body's area")
axes.set_ylabel("share of the bodies with less")
axes.set_ylim(0, 1.02)
axes.legend()
save(figure, "contour_symmetry")
