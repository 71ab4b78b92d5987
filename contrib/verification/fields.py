#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and table of doc/verification/fields.md, from the data that the tests
Long.c*fields* have written.

    /usr/bin/python3 contrib/verification/fields.py
"""

import csv
import os

import numpy as np

from common import DATA, plt, read_csv, save

CELL = 0.125  # m
CASES = {"circulant_24": r"$\theta_h$ = 24 m", "circulant_4": r"$\theta_h$ = 4 m"}


def matrix(name):
    return np.loadtxt(os.path.join(DATA, name + ".csv"), delimiter=",")


def rows(name):
    with open(os.path.join(DATA, name + ".csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def show(axes, values, title, **options):
    n_rows, n_columns = values.shape
    image = axes.imshow(values, origin="lower", aspect="equal",
                        extent=(0, n_columns * CELL, 0, n_rows * CELL),
                        interpolation="nearest", **options)
    axes.set_title(title, fontsize=10)
    axes.grid(False)
    return image


figure = plt.figure(figsize=(10, 7.2), constrained_layout=True)
grid = figure.add_gridspec(3, 2, height_ratios=(1, 1, 2.6))
for column, (case, label) in enumerate(CASES.items()):
    axes = figure.add_subplot(grid[0, column])
    image = show(axes, matrix("fields_picture_" + case),
                 f"one field, {label}", cmap="viridis", vmin=5, vmax=21)
    figure.colorbar(image, ax=axes, label=r"$c_i$ (kPa)")
    axes.set_ylabel("y (m)")

    axes = figure.add_subplot(grid[1, column])
    image = show(axes, matrix("fields_variance_" + case),
                 f"variance of 5,000 fields / theory, {label}",
                 cmap="RdBu", vmin=0.9, vmax=1.1)
    figure.colorbar(image, ax=axes)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")

for direction, name in enumerate(("horizontal", "vertical")):
    axes = figure.add_subplot(grid[2, direction])
    for colour, (case, label) in zip(("C0", "C1"), CASES.items()):
        data = read_csv("fields_covariance_" + case)
        keep = np.array(data["direction"]) == direction
        lag = np.array(data["lag (m)"])[keep]
        axes.plot(lag, np.array(data["theory"])[keep], colour,
                  label=f"theory, {label}")
        axes.plot(lag, np.array(data["covariance"])[keep], colour + "o",
                  markersize=4, label="mean of 5,000 fields")
    axes.set_xlabel(f"{name} lag (m)")
    axes.set_ylabel("covariance of cell averages")
    axes.legend()
save(figure, "fields")

print("| fields | statistic | smallest | largest | bounds |")
checks = {(row["case"], row["statistic"]): row for row in rows("fields_checks")}
for (case, statistic), row in checks.items():
    bounds = f"{float(row['lower']):.3f} to {float(row['upper']):.3f}"
    if statistic.endswith(" smallest"):
        largest = checks[case, statistic.replace("smallest", "largest")]
        print(f"| {case} | {statistic[:-9]} | {float(row['obtained']):.3f} | "
              f"{float(largest['obtained']):.3f} | {bounds} |")
    elif not statistic.endswith(" largest"):
        print(f"| {case} | {statistic} | | {float(row['obtained']):.3f} | "
              f"{bounds} |")

print("| fields | score | probability | obtained | standard error |")
for row in rows("fields_truncation"):
    print(f"| {row['case']} | {row['score']} | "
          f"{float(row['probability']):.3g} | {float(row['obtained']):.3g} | "
          f"{float(row['standard error']):.2g} |")
