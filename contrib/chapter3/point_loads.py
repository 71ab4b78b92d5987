#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point loads: a bar, exactly, and Flamant's half-space
(doc/verification/point_loads.md)."""

import numpy as np
from common import Runs, parse_arguments, plt, save, save_data, save_numbers

FORCE = 1.0                 # kN/m
SIZES = (0.5, 0.25, 0.125)  # m
RANGES = ((1.0, 2.0), (2.0, 4.0))  # of the distance from the load, m


def bar_error(runs):
    """Largest error of the points' displacement beyond the load (m)."""
    points = runs.run("point_loads/bar", "point_load_bar.prm", {}).points()
    u = points["displacement"][:, 0]
    x = points["position"][:, 0] - u
    loaded = np.linalg.norm(points["load"], axis=1) > 0.0
    a = x[loaded].mean()
    exact = FORCE * a / (1000.0 * 0.5)
    return float(exact), float(np.abs(u[x > 2.3] - exact).max())


def half_space(runs, size):
    """Place, stress and Flamant's stress of the points: columns xx, yy, xy."""
    points = runs.run(f"point_loads/half-space-{size:g}", "half_space.prm", {
        "Grid/Cell size": size,
        "Point loads/force/From": f"{-size / 2!r}, {-size / 2!r}",
        "Point loads/force/To": f"{size / 2!r}, 0"}).points()
    position = points["position"][:, :2]
    radius = np.linalg.norm(position, axis=1)
    e = position / radius[:, None]
    sigma = 2.0 * FORCE / np.pi * e[:, 1] / radius
    exact = np.column_stack([sigma * e[:, 0]**2, sigma * e[:, 1]**2,
                             sigma * e[:, 0] * e[:, 1]])
    stress = np.column_stack([points["stress_" + c]
                              for c in ("xx", "yy", "xy")])
    return position, stress, exact


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers = {}
    exact, error = bar_error(runs)
    numbers["bar: displacement beyond the load (m), largest error"] = [
        round(exact, 7), float(f"{error:.2g}")]
    figure, axis = plt.subplots(figsize=(6.5, 4.0))
    columns = {key: [] for key in ("h_m", "depth_m", "sigma_yy_kPa",
                                   "flamant_kPa")}
    for size in SIZES:
        position, stress, exact = half_space(runs, size)
        radius = np.linalg.norm(position, axis=1)
        for inner, outer in RANGES:
            ring = (radius > inner) & (radius < outer)
            rms = np.sqrt(np.mean((stress - exact)[ring]**2)
                          / np.mean(exact[ring]**2))
            numbers[f"half-space, h = {size:g} m, rms error of stress, "
                    f"r = {inner:g} to {outer:g} m"] = round(float(rms), 4)
        column = ((position[:, 0] > 0.0) & (position[:, 0] < size / 2)
                  & (radius < 6.0))
        order = np.argsort(-position[column, 1])
        depth = -position[column, 1][order]
        axis.plot(depth, -stress[column, 1][order], "o", markersize=3,
                  label=f"h = {size:g} m")
        for key, values in zip(columns, (np.full(depth.size, size), depth,
                                         stress[column, 1][order],
                                         exact[column, 1][order])):
            columns[key] += values.tolist()
    depth = np.linspace(0.1, 6.0, 200)
    axis.plot(depth, 2.0 * FORCE / (np.pi * depth), "k-", linewidth=0.8,
              label="Flamant")
    axis.set_ylim(0.0, 3.0)
    axis.set_xlabel("depth below the load (m)")
    axis.set_ylabel("vertical compression (kPa)")
    axis.legend(fontsize=8)
    save(figure, "point_loads")
    save_data("point_loads", columns)
    save_numbers("point_loads", numbers)


if __name__ == "__main__":
    main()
