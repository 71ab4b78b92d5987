#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/tangent_choice.md: the weak dyke with the
consistent and with the double-mapped tangent.

    /usr/bin/python3 contrib/verification/tangent_choice.py [--repeat N]

Wall times are medians of N runs that take turns; only their ratio means much.
"""

import sys

import numpy as np
from common import plt, save
from dyke_runs import workspace, write_csv

repeat = 3
if "--repeat" in sys.argv:
    at = sys.argv.index("--repeat")
    repeat = int(sys.argv[at + 1])
    del sys.argv[at:at + 2]

TANGENTS = ("consistent", "double mapping")
TOLERANCES = (1e-2, 1e-3, 1e-4)
# Neither files nor frames: the solver is measured.
QUIET = {"Output/Interval": 0, "Output/Surface": "false",
         "Output/Particles": "false"}

rows, curves = [], {}
with workspace(__doc__) as work:
    for functions in ("GIMP", "linear"):
        for tolerance in TOLERANCES if functions == "GIMP" else (1e-3,):
            walls = {tangent: [] for tangent in TANGENTS}
            runs = {}
            for number in range(repeat):
                for tangent in TANGENTS:
                    runs[tangent] = work.run(
                        f"{tangent}{functions}{tolerance}",
                        "chapter5/dyke_weak.prm",
                        {**QUIET, "Newton/Tangent": tangent,
                         "Newton/Tolerance": tolerance,
                         "Kinematics and mapping/Functions": functions})
                    walls[tangent].append(runs[tangent]["wall_time"])
            for tangent, run in runs.items():
                rows.append((functions, tolerance, tangent,
                             run["initial_failure_time"],
                             run["flooding_time"],
                             run["newton_iterations"] / run["steps"],
                             run["linear_iterations"] / run["steps"],
                             run["unconverged_steps"],
                             np.median(walls[tangent])
                             / np.median(walls["consistent"])))
                if functions == "GIMP" and tolerance == 1e-3:
                    curves[tangent] = run.statistics

names = ("functions", "tolerance", "tangent", "initial_failure_s", "flooding_s",
         "newton_per_step", "linear_per_step", "unconverged", "time_ratio")
write_csv("tangent_choice", {name: [row[i] for row in rows]
                             for i, name in enumerate(names)})
print("| " + " | ".join(names) + " |")
for row in rows:
    print("| " + " | ".join(value if isinstance(value, str) else
                            "-" if value is None else f"{value:.4g}"
                            for value in row) + " |")

figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.6))
for tangent, statistics in curves.items():
    left.plot(statistics["Time (s)"], statistics["Newton iterations"],
              ".", ms=2.5, label=tangent)
left.set_xlabel("time (s)")
left.set_ylabel("Newton iterations of a step")
left.legend(loc="upper left", markerscale=4)
gimp = [row for row in rows if row[0] == "GIMP"]
for offset, tangent in ((-0.2, TANGENTS[0]), (0.2, TANGENTS[1])):
    mine = [row for row in gimp if row[2] == tangent]
    right.bar(np.arange(len(mine)) + offset, [row[8] for row in mine], 0.38,
              label=tangent)
right.set_xticks(range(len(TOLERANCES)), [f"{t:g}" for t in TOLERANCES])
right.set_xlabel("Newton/Tolerance")
right.set_ylabel("wall time / consistent")
right.legend()
save(figure, "tangent_choice")
