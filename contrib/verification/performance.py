#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table and figure of doc/verification/performance.md, from the CPU times of
data/performance.csv; with the output of the benchmarks as JSON, that file first:

    build/bin/benchmarks --benchmark_min_time=0.3 --benchmark_format=json >times.json
    /usr/bin/python3 contrib/verification/performance.py [times.json]
"""

import csv
import json
import os
import sys

import numpy as np
from common import DATA, plt, save

TABLE = os.path.join(DATA, "performance.csv")
MS = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}

if len(sys.argv) > 1:
    with open(sys.argv[1], encoding="utf-8") as file:
        benchmarks = json.load(file)["benchmarks"]
    with open(TABLE, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "part", "cpu_ms", "us_per_point"])
        for run in benchmarks:
            case, part = run["name"].split("/iterations:")[0].rsplit("/", 1)
            if "points" not in run:
                continue  # campaigns, the contour of a whole run
            ms = run["cpu_time"] * MS[run["time_unit"]]
            steps = run.get("steps", 1.0)
            if case == "contour/dyke/2D":
                case, part = f"2D/{part}", "contour"
            writer.writerow([case, part, f"{ms:.4g}",
                             f"{1e3 * ms / run['points'] / steps:.4g}"])

with open(TABLE, encoding="utf-8") as file:
    times = {(row["case"], row["part"]): float(row["us_per_point"])
             for row in csv.DictReader(file)}

CASES = {"2D/6k": "2D, 6,440 points", "2D/100k": "2D, 102,560 points",
         "3D/100k": "3D, 103,040 points"}
print("| µs per point | " + " | ".join(name.replace(" points", "")
                                       for name in CASES.values()) + " |")
print("|---" * (len(CASES) + 1) + "|")
for part in dict.fromkeys(part for _, part in times):
    found = [times.get((case, part)) for case in CASES]
    if sum(t is not None for t in found) > 1:
        print(f"| {part} | " + " | ".join("" if t is None else f"{t:.2g}"
                                          for t in found) + " |")

# How often a step in motion does it.
PARTS = {"weights": 1, "points to nodes": 1, "nodes to points": 1,
         "stress and internal force": 2, "consistent tangent: set-up": 1,
         "consistent tangent: solve": 1, "surface detection": 1}

figure, axes = plt.subplots(figsize=(8, 2.8))
left = np.zeros(len(CASES))
total = np.array([times[case, "step, in motion"] for case in CASES])
for part, count in PARTS.items():
    share = np.array([count * times[case, part] for case in CASES]) / total
    axes.barh(list(CASES.values()), share, 0.6, left=left,
              label=part + (f" (x {count})" if count > 1 else ""))
    left += share
axes.axvline(1, color="black", lw=1)
axes.invert_yaxis()
axes.set_xlabel("share of a step in motion (parts timed on their own)")
axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), fontsize=8)
save(figure, "performance")
