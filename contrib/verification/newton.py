#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/newton.md, from data that unit tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Mechanics.*'
    /usr/bin/python3 contrib/verification/newton.py
"""

import csv
import os

from common import DATA, plt, save

with open(os.path.join(DATA, "newton.csv"), encoding="utf-8") as file:
    table = list(csv.DictReader(file))

figure, axes = plt.subplots(1, 2, figsize=(9.5, 3.8), sharey=True)
for axis, step in zip(axes, ("elastic rotation", "softening")):
    for cells, style in (("full cells", "-"), ("cut cells", "--")):
        for tangent, colour in (("consistent", "C0"),
                                ("double mapping", "C1")):
            rows = [row for row in table if row["tangent"] == tangent
                    and row["step"] == f"{step}, {cells}"]
            axis.semilogy([int(row["iteration"]) for row in rows],
                          # A residual of 0 is below what can be computed.
                          [max(float(row["residual"]), 1e-15)
                           for row in rows], style, color=colour,
                          marker="o" if tangent == "consistent" else None,
                          markersize=4, label=f"{tangent}, {cells}")
    axis.set_xlim(0, 40)
    axis.set_ylim(1e-16, 3)
    axis.set_xlabel("Newton iteration")
    axis.set_title(step[0].upper() + step[1:], fontsize=10)
axes[0].set_ylabel("relative residual")
axes[0].legend(fontsize=8)
figure.tight_layout()
save(figure, "newton")
