#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A column that sinks to half its height under its weight: error of the stress
with stretched and constant support domains and with linear functions
(doc/verification/column.md)."""

import numpy as np
from common import Runs, parse_arguments, plt, save, save_data, save_numbers

from large_strain import (AMPLE, HEIGHT, UNIT_WEIGHT, column_error,
                          column_parameters, deformed_height)

KINDS = {
    "GIMP, stretched domains": ({}, "C0", "o-"),
    "GIMP, stretched, ghost stiffness": (
        {"Time stepping/Ghost stiffness": 1e-4}, "C4", "x--"),
    "GIMP, constant domains": (
        {"Kinematics and mapping/Domains": "constant"}, "C1", "s-"),
    "linear functions (MPM)": (
        {"Kinematics and mapping/Domains": "constant",
         "Kinematics and mapping/Functions": "linear"}, "C3", "^-"),
}
CELLS = (8, 16, 32, 64)


def main():
    runs = Runs(parse_arguments(__doc__))
    columns = {"cells": list(CELLS)}
    stresses = {}
    numbers = {"deformed height (m)": deformed_height()}
    for kind, (sets, _, _) in KINDS.items():
        errors, tops = [], []
        for cells in CELLS:
            name = f"column/{kind.replace(' ', '-').replace(',', '')}-{cells}"
            run = runs.run(name, "column.prm",
                           {**column_parameters(cells), **sets})
            points = run.points()
            errors.append(float(column_error(points)))
            # The top: of the highest point, and half its own deformed domain.
            y, u = points["position"][:, 1], points["displacement"][:, 1]
            top = y.argmax()
            volume = points["volume"][top] / (0.5 * HEIGHT / cells)
            tops.append(float(y[top] + 0.5 * volume))
            if cells == 16:
                stresses[kind] = (y - u, points["stress_yy"])
        columns[kind] = errors
        orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
        numbers[kind] = {"error": dict(zip(map(str, CELLS), errors)),
                         "order": [round(float(o), 2) for o in orders],
                         "height (m)": dict(zip(map(str, CELLS), tops))}
        if not sets:
            numbers[kind]["error / AMPLE's"] = {
                str(cells): errors[CELLS.index(cells)] / AMPLE[cells]
                for cells in AMPLE}
    columns["AMPLE"] = [AMPLE.get(cells, float("nan")) for cells in CELLS]

    figure, axes = plt.subplots(1, 2, figsize=(10, 4))
    for kind, (_, colour, style) in KINDS.items():
        axes[0].loglog(CELLS, columns[kind], style, color=colour, label=kind)
        if "ghost" not in kind:
            y0, sigma = stresses[kind]
            axes[1].plot(sigma, y0, style[0], color=colour, markersize=4,
                         label=kind)
    axes[0].loglog(list(AMPLE), list(AMPLE.values()), "k+", markersize=12,
                   label="AMPLE")
    axes[0].set_xlabel("cells over the height")
    axes[0].set_ylabel("mean error of $\\sigma_{yy}$ / weight")
    axes[0].set_xticks(CELLS, CELLS)
    axes[0].minorticks_off()
    axes[0].legend(fontsize=7)
    axes[1].plot([-UNIT_WEIGHT * HEIGHT, 0.0], [0.0, HEIGHT], "k-",
                 linewidth=0.8, label="exact")
    axes[1].set_xlabel("$\\sigma_{yy}$ (kPa), 16 cells")
    axes[1].set_ylabel("height at the start (m)")
    axes[1].legend(fontsize=7)
    figure.tight_layout()
    save_data("column", columns)
    save(figure, "column")
    save_numbers("column", numbers)


if __name__ == "__main__":
    main()
