#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A block that a traction of 1 kPa pulls on: sigma_xx must be 1 kPa in every
point. All methods, standard MPM and GIMP, ends on and off a line of the grid."""

import numpy as np
from common import (METHODS, Runs, parse_arguments, plt, save, save_data,
                    save_numbers)

NAMES = {"points": "fixed points", "nodes": "surface nodes",
         "surface": "user surface", "detected": "proximity field",
         "volume": "volume", "contour": "contour"}
ENDS = (5.0, 4.7, 4.5)  # m
CASES = [(functions, method)
         for functions, last in (("linear", "volume"), ("GIMP", "contour"))
         for method in ("points", "nodes", "surface", "detected", last)]


def stress(runs, functions, method, end):
    """Position along the block and sigma_xx of each point."""
    corners = [(0.0, 0.0), (end, 0.0), (end, 1.0), (0.0, 1.0)]
    chain = runs.write_chain(f"uniaxial_block/chain-{end:g}", corners)
    sets = {"Soil profile/block/Polygon":
            "; ".join(f"{x!r}, {y!r}" for x, y in corners),
            "Kinematics and mapping/Functions": functions,
            "Tractions/pull/Method": NAMES[method],
            "Output/Grid": "false", "Output/Interval": 0}
    if method in ("points", "surface"):
        sets["Tractions/pull/Surface file"] = chain
    run = runs.run(f"uniaxial_block/{functions}-{method}-{end:g}",
                   "uniaxial_block.prm", sets)
    points = run.points()
    return points["position"][:, 0], points["stress_xx"]


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers = {}
    columns = {key: [] for key in ("functions", "method", "end_m", "x_m",
                                   "sigma_xx_kPa")}
    figure, axes = plt.subplots(2, len(ENDS), figsize=(12, 6.5), sharey=True)
    for functions, method in CASES:
        for k, end in enumerate(ENDS):
            if method == "volume" and end == 4.7:
                continue  # 9 points of 0.522 m: cells more than full
            x, sigma = stress(runs, functions, method, end)
            for row in zip(x.tolist(), sigma.tolist()):
                for key, value in zip(columns, (functions, method, end, *row)):
                    columns[key].append(value)
            error = np.abs(sigma - 1.0)
            numbers[f"{functions} {method}, end {end:g} m"] = {
                "least": float(sigma.min()), "largest": float(sigma.max()),
                "largest error": float(error.max()),
                "share within 1 %": float((error < 0.01).mean())}
            axis = axes[int(functions == "GIMP"), k]
            label, colour, _ = METHODS[method]
            axis.plot(x, sigma, "o", markersize=3 if method != "points" else 5,
                      color=colour, label=label, alpha=0.8)
            axis.set_title(f"{'GIMP' if functions == 'GIMP' else 'MPM'}, "
                           f"end at {end:g} m", fontsize=9)
    for axis in axes[1]:
        axis.set_xlabel("x (m)")
    for axis in axes[:, 0]:
        axis.set_ylabel("$\\sigma_{xx}$ (kPa)")
        axis.legend(fontsize=7)
    figure.tight_layout()
    save_data("uniaxial_block", columns)
    save(figure, "uniaxial_block")
    save_numbers("uniaxial_block", numbers)


if __name__ == "__main__":
    main()
