#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The weak dyke of chapter 5 with the water on the contour of the support
domains instead of the proximity field, and with points placed in rows."""

import os

import numpy as np
from common import Runs, parse_arguments, plt, save, save_data, save_numbers

VARIANTS = {
    "proximity field": {},
    "contour": {"Surface/Method": "contour"},
    "proximity field, rows": {"Material points/Placement": "rows"},
    "contour, rows": {"Surface/Method": "contour",
                      "Material points/Placement": "rows"},
}


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers, columns = {}, {}
    times = np.arange(0, 7.51, 0.05)
    figure, axis = plt.subplots(figsize=(7, 4))
    for name, sets in VARIANTS.items():
        run = runs.run("dyke/" + name.replace(", ", "-").replace(" ", "-"),
                       os.path.join("..", "chapter5", "dyke_weak.prm"),
                       {"Output/Interval": 0, "Output/Grid": "false", **sets})
        numbers[name] = {
            "outcome": run["outcome"],
            "initial failure (s)": run["initial_failure_time"],
            "flooding (s)": run["flooding_time"],
            "points": run["particles"]}
        time = run.statistics["Time (s)"]
        width = np.where(times <= time[-1] + 1e-9,
                         np.interp(times, time,
                                   run.statistics["Dyke width W (m)"]),
                         np.nan)
        columns[name.replace(", ", "_").replace(" ", "_") + "_m"] = \
            width.tolist()
        axis.plot(times, width, label=name)
    axis.set_xlabel("time (s)")
    axis.set_ylabel("width at the water level (m)")
    axis.legend()
    save_data("dyke_contour", {"time_s": times.tolist(), **columns})
    save(figure, "dyke_contour")
    reference = numbers["proximity field"]
    for name, values in numbers.items():
        for key in ("initial failure (s)", "flooding (s)"):
            if values[key] is not None and reference[key]:
                values[key + " / proximity field"] = \
                    values[key] / reference[key]
    save_numbers("dyke_contour", numbers)


if __name__ == "__main__":
    main()
