#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slides of the slope of chapter 6 with B-bar in all and in filled cells, for
doc/results/chapter6/README.md.

    /usr/bin/python3 contrib/verification/b_bar_slides.py ALL FILLED

Both are tables of realisations as contrib/plots/chapter6.py puts them into its data
folder, of the same random fields; those count that both have.
"""

import csv
import sys

import numpy as np

COLUMNS = ("load", "retrogression_distance", "relative_failure_volume")


def read(path):
    with open(path, encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    return {int(row["realisation"]): [float(row[column]) for column in COLUMNS]
            for row in csv.DictReader(lines)}


def main():
    everywhere, filled = (read(path) for path in sys.argv[1:3])
    common = sorted(set(everywhere) & set(filled))
    a, b = (np.array([table[k] for k in common]) for table in (everywhere, filled))
    print(f"{len(common)} pairs")
    for column, (x, y) in zip(COLUMNS, zip(a.T, b.T)):
        half = 1.96 * (y - x).std(ddof=1) / np.sqrt(len(common))
        print(f"{column}: {x.mean():.4f}, {y.mean():.4f}; difference "
              f"{(y - x).mean():+.4f} +- {half:.4f}")
    print(f"bear less than 0.1 m: {(a[:, 0] < 0.1).sum()}, {(b[:, 0] < 0.1).sum()}")
    print(f"more than half of the volume: {(a[:, 2] > 0.5).sum()}, "
          f"{(b[:, 2] > 0.5).sum()}")


if __name__ == "__main__":
    main()
