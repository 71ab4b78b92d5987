#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of realisations with and without B-bar, for doc/verification/b_bar.md.

    /usr/bin/python3 contrib/verification/b_bar_pairs.py STANDARD B_BAR

Both are folders of campaigns with the same random fields (seed, base case); those
realisations count that both have computed. Writes data/b_bar_pairs.csv.
"""

import csv
import os
import sys

import numpy as np
from common import DATA

COLUMNS = ("initial_failure_time", "flooding_time", "residual_width",
           "residual_height")


def read(folder):
    path = os.path.join(folder, "report", "realisations.csv")
    with open(path, encoding="utf-8") as file:
        return {int(row["realisation"]): row for row in csv.DictReader(file)
                if row["outcome"] != "numerical failure"}


def happened(row, column):
    return not np.isnan(float(row[column]))


def main():
    standard, b_bar = (read(folder) for folder in sys.argv[1:3])
    common = sorted(set(standard) & set(b_bar))
    print(f"{len(common)} pairs")
    strange = [k for k in common
               if standard[k]["least_strength"] != b_bar[k]["least_strength"]]
    if strange:
        sys.exit(f"not the same fields, first in realisation {strange[0]}")
    for name, column in (
            ("slides by width or height", "initial_failure_time"),
            ("slides by displacement", "initial_failure_time_displacement"),
            ("floods", "flooding_time")):
        a = np.array([happened(standard[k], column) for k in common])
        b = np.array([happened(b_bar[k], column) for k in common])
        print(f"{name}: standard {a.sum()}, B-bar {b.sum()}; both "
              f"{(a & b).sum()}, standard only {(a & ~b).sum()}, B-bar only "
              f"{(~a & b).sum()}")
        both = [k for k, x, y in zip(common, a, b) if x and y]
        earlier = np.array([float(b_bar[k][column]) - float(standard[k][column])
                            for k in both])
        print(f"  time with B-bar less time without: median "
              f"{np.median(earlier):.2f} s, half of them "
              f"{np.percentile(earlier, 25):.2f} to "
              f"{np.percentile(earlier, 75):.2f} s")
    with open(os.path.join(DATA, "b_bar_pairs.csv"), "w", newline="",
              encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["realisation"] + [f"{column}_{kind}"
                                          for column in COLUMNS
                                          for kind in ("standard", "b_bar")])
        for k in common:
            table.writerow([k] + [f"{float(rows[k][column]):.5g}"
                                  for column in COLUMNS
                                  for rows in (standard, b_bar)])


if __name__ == "__main__":
    main()
