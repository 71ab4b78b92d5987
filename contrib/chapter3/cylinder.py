#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick cylinder that the grid cuts anyhow: how fast the error of each method
falls with the cell size."""

import numpy as np
from common import (METHODS, Runs, parse_arguments, plt, save, save_data,
                    save_numbers)
from thick_cylinder import B, exact, outline

CELLS = (4, 6, 8, 12, 16, 24, 32)  # per metre
# Placement of the points, and the share of a full mass below which a node
# carries no load.
VARIANTS = (("sub-cells", 0.0), ("sub-cells", 0.02), ("rows", 0.0),
            ("rows", 0.02))
NAMES = {"points": "fixed points", "nodes": "surface nodes",
         "surface": "user surface", "detected": "proximity field",
         "contour": "contour"}


def errors(runs, placement, support, method, cells):
    """Errors in the volume's L2 norm: displacement, stress."""
    corners = outline()
    sets = {"Grid/Cell size": repr(1 / cells),
            "Grid/Upper corner": f"{B + 2 / cells!r}, {B + 2 / cells!r}",
            "Material points/Placement": placement,
            "Soil profile/cylinder/Polygon":
            "; ".join(f"{x!r}, {y!r}" for x, y in corners),
            "Tractions/pressure/Method": NAMES[method],
            "Tractions/pressure/Minimum support": support,
            "Tractions/pressure/Surface file":
            runs.write_chain("cylinder/chain", corners)
            if method in ("points", "surface") else "",
            "Output/Grid": "false", "Output/Interval": 0}
    run = runs.run(f"cylinder/{placement}-{support:g}-{method}-{cells}",
                   "cylinder.prm", sets)
    points = run.points()
    start = points["position"][:, :2] - points["displacement"][:, :2]
    u, sigma = exact(start)
    got = np.stack([points["stress_" + c] for c in ("xx", "yy", "zz", "xy")],
                   axis=1)
    weight = points["volume"][:, None]
    twice = np.array([1, 1, 1, 2])

    def norm(values, factor=1):
        return np.sqrt((weight * factor * values**2).sum())

    return (float(norm(points["displacement"][:, :2] - u) / norm(u)),
            float(norm(got - sigma, twice) / norm(sigma, twice)))


def order(cells, values):
    """Slope of the error over the cell size in the finer half of the grids."""
    n = len(cells) // 2 + 1
    return float(-np.polyfit(np.log(cells[-n:]), np.log(values[-n:]), 1)[0])


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers = {}
    columns = {"placement": [], "minimum_support": [], "method": [], "cells_per_m": [],
               "displacement_error": [], "stress_error": []}
    figure, axes = plt.subplots(4, 2, figsize=(10, 13.5), sharex=True)
    for row, (placement, support) in zip(axes, VARIANTS):
        for method in NAMES:
            values = np.array([errors(runs, placement, support, method,
                                      n)
                               for n in CELLS])
            for n, (u, sigma) in zip(CELLS, values.tolist()):
                for key, value in zip(columns, (placement, support, method,
                                                n, u, sigma)):
                    columns[key].append(value)
            label, colour, line = METHODS[method]
            for k, axis in enumerate(row):
                axis.loglog(1 / np.array(CELLS), values[:, k], color=colour,
                            linestyle=line, marker="o", markersize=3,
                            label=label)
            numbers[f"{placement}, {support:g}, {method}"] = {
                "displacement": float(values[-1, 0]),
                "stress": float(values[-1, 1]),
                "order of displacement": order(CELLS, values[:, 0]),
                "order of stress": order(CELLS, values[:, 1])}
        for k, name in enumerate(("displacement", "stress")):
            h = 1 / np.array([CELLS[0], CELLS[-1]])
            for power in (1, 2):
                row[k].loglog(h, 0.05 * (h / h[0])**power, color="grey",
                              linewidth=0.8, linestyle="-")
            row[k].set_ylabel(f"relative error of {name}")
            row[k].set_title(f"{placement}, minimum support {support:g}",
                             fontsize=9)
    axes[0, 0].legend(fontsize=7)
    for axis in axes[-1]:
        axis.set_xlabel("cell size (m); grey: orders 1 and 2")
    figure.tight_layout()
    save_data("cylinder", columns)
    save(figure, "cylinder")
    save_numbers("cylinder", numbers)


if __name__ == "__main__":
    main()
