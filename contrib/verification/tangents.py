#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/tangents.md, from data that unit tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Materials.*:Mechanics.*'
    /usr/bin/python3 contrib/verification/tangents.py
"""

import csv
import os

from common import DATA, plt, save

with open(os.path.join(DATA, "tangents_differences.csv"),
          encoding="utf-8") as file:
    table = list(csv.DictReader(file))

figure, axes = plt.subplots()
for dimension, style in (("2", "o-"), ("3", "s--")):
    for functions, colour in (("GIMP", "C0"), ("linear", "C1")):
        rows = [row for row in table if row["dimension"] == dimension
                and row["functions"] == functions]
        axes.loglog([float(row["step / h"]) for row in rows],
                    [float(row["relative error"]) for row in rows], style,
                    color=colour, markersize=4,
                    label=f"{functions}, {dimension}D")
axes.loglog([1e-3, 1e-6], [4e-5, 4e-11], color="black", linewidth=0.8,
            linestyle=":", label="second order")
axes.set_xlabel("step of the differences (h)")
axes.set_ylabel("|difference − K v| / |K v|")
axes.set_title("Consistent tangent: elastic, softening and residual points, "
               "29° of rotation", fontsize=10)
axes.legend(fontsize=8)
save(figure, "tangents")
