#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/invariance.md: the weak dyke mirrored,
shifted, as a slice in 3D, with half the time step and tolerance.

    /usr/bin/python3 contrib/verification/invariance.py
"""

import numpy as np
from common import plt, save
from dyke_runs import Checks, sampled, workspace, write_csv
import dyke_invariance as case
import dyke_measures as measures

CELL = 0.25
WIDTH = "Dyke width W (m)"
SETTINGS = {"Output/Interval": 0, "Output/Surface": "false",
            **measures.strength(10, 3.85)}

with workspace(__doc__) as work:
    checks = Checks()
    base = work.run("base", case.WEAK, SETTINGS)
    runs = {"as it is": sampled(base, [WIDTH])}
    widths = {"as it is": base["initial_width"]}
    table = {"variant": ["as it is"],
             "initial_failure_s": [base["initial_failure_time"]],
             "flooding_s": [base["flooding_time"]],
             "initial_failure_ratio": [1.0], "flooding_ratio": [1.0],
             "largest_difference_of_W_m": [0.0]}
    for name, (file, changes) in case.variants(CELL, True).items():
        run = work.run("run", file, {**SETTINGS, **changes})
        difference, ratios = case.compare(checks, name, base, run, CELL)
        for key, value in zip(table, (name, run["initial_failure_time"],
                                      run["flooding_time"], *ratios.values(),
                                      difference)):
            table[key].append(value)
        runs[name] = sampled(run, [WIDTH])
        widths[name] = run["initial_width"]
    case.check_mirrored(checks, work, SETTINGS)

for row in zip(*table.values()):
    print("| " + " | ".join(value if isinstance(value, str)
                            else f"{value:.4g}" for value in row) + " |")
write_csv("invariance_times", table)
longest = max((times for times, _ in runs.values()), key=len)
write_csv("invariance", {
    "time_s": longest,
    **{name.replace(" ", "_") + "_m": np.interp(longest, times, columns[WIDTH])
       for name, (times, columns) in runs.items()}})

figure, axes = plt.subplots()
for name, (times, columns) in runs.items():
    line = "-" if name == "as it is" else "--"
    axes.plot(times, columns[WIDTH] - widths[name], line, linewidth=1.2,
              label=name)
axes.set_xlabel("time (s)")
axes.set_ylabel("change of the width W (m)")
axes.legend(fontsize=8)
save(figure, "invariance")
