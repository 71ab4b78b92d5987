#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/performance.md, from data/performance.csv: the CPU times
that build/bin/benchmarks printed.

    /usr/bin/python3 contrib/verification/performance.py
"""

import csv
import os

import numpy as np
from common import DATA, plt, save

with open(os.path.join(DATA, "performance.csv"), encoding="utf-8") as file:
    times = {(row["case"], row["part"]): float(row["us_per_point"])
             for row in csv.DictReader(file)}

CASES = {"2D/6k": "2D, 6,440 points", "2D/100k": "2D, 102,560 points",
         "3D/100k": "3D, 103,040 points"}
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
