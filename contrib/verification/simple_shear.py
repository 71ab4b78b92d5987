#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/simple_shear.md, from data that unit tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Materials.*'
    /usr/bin/python3 contrib/verification/simple_shear.py
"""

import csv
import os

from common import DATA, plt, read_csv, save

INITIAL, RESIDUAL, SOFTENING = 13.0, 5.0, 50.0  # kPa
G = 1000.0 / 2.9  # kPa

figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
for name, factor, colour in (("equivalent", 3 ** -0.5, "C0"),
                             ("half", 0.5, "C1")):
    data = read_csv("simple_shear_" + name)
    kink = (INITIAL - RESIDUAL) / (SOFTENING * factor) + RESIDUAL / G
    left.plot([0, INITIAL / G, kink, 0.6], [0, INITIAL, RESIDUAL, RESIDUAL],
              color="0.75", linewidth=5)
    left.plot(data["gamma"], data["tau"], color=colour,
              label=f"softens with the {name} strain")
left.set_xlabel("shear strain γ (-)")
left.set_ylabel("shear stress τ (kPa)")
left.set_xlim(0, 0.6)
left.set_ylim(0, 14)
left.set_title("Simple shear; grey: closed form", fontsize=10)
left.legend(fontsize=8)

with open(os.path.join(DATA, "simple_shear_return_map.csv"),
          encoding="utf-8") as file:
    table = list(csv.DictReader(file))
for colour, path in zip(("C0", "C1"), ("to softening",
                                       "to residual strength")):
    points = [row for row in table if row["path"] == path]
    right.loglog([int(row["steps"]) for row in points],
                 [float(row["plastic strain error"]) for row in points],
                 "o-", color=colour, label=path)
right.loglog([25, 400], [1.2e-4, 7.5e-6], color="black", linewidth=0.8,
             linestyle=":", label="first order")
right.set_xticks([25, 50, 100, 200, 400], ["25", "50", "100", "200", "400"],
                 minor=False)
right.minorticks_off()
right.set_xlabel("steps")
right.set_ylabel("error of the plastic strain (-)")
right.set_title("Turning path, against the rate equations", fontsize=10)
right.legend(fontsize=8)
figure.tight_layout()
save(figure, "simple_shear")
