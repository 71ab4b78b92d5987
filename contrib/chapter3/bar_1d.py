#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 3.3 and 3.4: nodal internal and external force of a bar, wherever it
lies on the grid, for every method, with standard MPM and with GIMP."""

import numpy as np
from common import (METHODS, Nodes, Runs, parse_arguments, plt, save, save_data,
                    save_numbers)

LENGTH = 3.0
STEP = 0.02  # m between offsets


def evaluate(runs, file, methods, offset):
    """{"internal" or method: horizontal force at nodes 1, 2, 3 (kN)}, and the
    sum of differences at all nodes that the left end reaches, by method."""
    end = offset + LENGTH
    corners = [(offset, 0.0), (end, 0.0), (end, 1.0), (offset, 1.0)]
    label = f"bar_1d/{file[:-4]}-{offset:.3f}"
    chain = runs.write_chain(f"bar_1d/chain-{offset:.3f}", corners)
    sets = {"Soil profile/bar/Polygon":
            "; ".join(f"{x!r}, {y!r}" for x, y in corners),
            "Tractions/points/Surface file": chain,
            "Tractions/surface/Surface file": chain,
            "Output/Particles": "false", "Output/Surface": "false"}
    nodes = Nodes(runs.run(label, file, sets))
    values = {"internal": [nodes.at("internal_force", x, 0.0)
                           for x in (0.0, 1.0, 2.0)]}
    left = nodes.position[:, 0] < offset + LENGTH / 2
    internal = nodes["internal_force"][left, 0]
    error = {}
    for method in methods:
        values[method] = [nodes.at("force_" + method, x, 0.0)
                          for x in (0.0, 1.0, 2.0)]
        error[method] = np.abs(nodes.force(method)[left, 0] - internal).sum()
    return values, error


def main():
    arguments = parse_arguments(__doc__)
    runs = Runs(arguments)
    offsets = np.arange(0.0, 2.0 + STEP / 2, STEP)
    common = ["points", "nodes", "surface", "detected"]
    cases = {"MPM": ("bar_1d_mpm.prm", common + ["volume"]),
             "GIMP": ("bar_1d.prm", common + ["contour"])}
    numbers = {}
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.5), sharex=True,
                                sharey=True)
    for row, (case, (file, methods)) in zip(axes, cases.items()):
        results = [evaluate(runs, file, methods, float(round(x, 6)))
                   for x in offsets]
        columns = {"offset_m": offsets.tolist()}
        for key in ["internal"] + methods:
            series = np.array([values[key] for values, _ in results])
            for node in range(3):
                columns[f"{key}_node{node + 1}_kN"] = series[:, node].tolist()
                style = ({"color": "black", "linewidth": 2.2, "alpha": 0.6}
                         if key == "internal" else
                         dict(zip(("color", "linestyle"), METHODS[key][1:])))
                row[node].plot(offsets, series[:, node], **style,
                               label="$F_{int}$" if key == "internal"
                               else METHODS[key][0])
        save_data(f"figure_3_4_{case.lower()}", columns)
        for method in methods:
            # The load is 1 kN/m: errors are shares of it.
            error = np.array([errors[method] for _, errors in results])
            numbers[f"{case} {method}"] = {
                "mean": float(error.mean()), "max": float(error.max()),
                "share of offsets below 1e-5": float((error < 1e-5).mean())}
        for node in range(3):
            row[node].set_title(f"{case}, node {node + 1}", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel("offset of the bar's end from node 1 (m)")
    for axis in axes[:, 0]:
        axis.set_ylabel("horizontal force (kN)")
    for axis in axes[:, 2]:
        axis.legend(fontsize=7)
    figure.tight_layout()
    save(figure, "figure_3_4")
    save_numbers("bar_1d", numbers)


if __name__ == "__main__":
    main()
