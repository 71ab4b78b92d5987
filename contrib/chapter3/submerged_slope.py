#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 3.15 to 3.18: the submerged slope with fixed point loads, and with the
pressure on the proximity field and on the contour."""

import os

import numpy as np
from common import (Nodes, ROOT, Runs, parse_arguments, plt, save, save_data,
                    save_numbers)

LEVEL, TOP, WATER, SOIL, CELL = 20.0, 16.25, 10.0, 20.0, 0.5
RUNS = {"points": ("fixed points", "contour"),
        "proximity field": ("proximity field", "proximity field"),
        "contour": ("contour", "contour")}
COLOURS = {"points": "C3", "proximity field": "C4", "contour": "C0"}
# Windows of the figures, x and y (m): the gentle part, and the crest.
PLACES = {"A": ((40.0, 46.0), (-0.2, 2.2)), "B": ((15.5, 24.0), (11.5, 16.8))}
# Where the roughness is measured: x from, to (m), cosine of the slope.
REGIONS = {"flat top": (3.0, 19.0, 1.0), "45 degrees": (21.5, 32.5, 0.5**0.5),
           "gentle part": (36.5, 49.0, 8 / 65**0.5)}


def ground(x):
    return np.interp(x, [0, 20, 34, 52], [TOP, TOP, 2.25, 0.0])


def cell_means(points, field):
    """Centroid, mean and depth of the points of each cell. Linear functions
    give the points of a cell nearly the same strain, so a stress that grows
    with depth is a staircase; its means are not."""
    cells = np.floor(points["position"][:, :2] / CELL + 1e-9).astype(int)
    _, cell = np.unique(cells, axis=0, return_inverse=True)
    cell = cell.ravel()
    volume = np.bincount(cell, points["volume"])

    def mean(values):
        return np.bincount(cell, points["volume"] * values) / volume

    x, y = (mean(points["position"][:, d]) for d in range(2))
    return x, y, mean(points[field])


def roughness(points, region, field="mean_stress"):
    """Rms residual (kPa) of the cells at the surface against a quadratic in x
    and y through those within 2.5 m of it, fitted in windows of 4 m; and as a
    share of the mean there."""
    begin, end, cosine = REGIONS[region]
    x, y, values = cell_means(points, field)
    depth = (ground(x) - y) * cosine
    residuals, fits = [], []
    for left in np.arange(begin, end - 3.0, 1.0):
        near = (x >= left) & (x < left + 4) & (depth < 2.5)
        X, Y = x[near] - left - 2, y[near] - y[near].mean()
        basis = np.stack([np.ones_like(X), X, Y, X * X, X * Y, Y * Y], axis=1)
        fit = basis @ np.linalg.lstsq(basis, values[near], rcond=None)[0]
        middle = (abs(X) <= 0.5) & (depth[near] < 0.5)
        residuals.append((values[near] - fit)[middle])
        fits.append(fit[middle])
    rms = np.sqrt(np.mean(np.concatenate(residuals)**2))
    return float(rms), float(rms / np.mean(np.concatenate(fits)))


def error_of_vertical_stress(points):
    """Rms error (kPa) of the vertical stress in the cells of the upper metre
    of the flat top away from its edge, where it is the weight of the water and
    the soil above; and as a share of it."""
    x, y, stress = cell_means(points, "stress_yy")
    upper = (x < 15.0) & (TOP - y < 1.0)
    exact = -WATER * (LEVEL - TOP) - SOIL * (TOP - y[upper])
    rms = np.sqrt(np.mean((stress[upper] - exact)**2))
    return float(rms), float(rms / np.mean(np.abs(exact)))


def cover_of(points, chosen):
    """Height of soil (m) above each chosen point: up to the highest point that
    lies within 0.25 m of it in the horizontal."""
    x = points["position"]
    return np.array([x[abs(x[:, 0] - px) < 0.25, 1].max() - py
                     for px, py in x[chosen, :2]])


OUTLINE = {
    "Tractions/water/Surface file": os.path.join(
        ROOT, "parameters", "chapter3", "submerged_slope.txt"),
    # Not base and left side.
    "Tractions/water/Facing": "1, 2", "Tractions/water/Opening": 80}


def run_all(runs):
    result = {}
    for name, (method, surface) in RUNS.items():
        sets = {"Tractions/water/Method": method, "Surface/Method": surface}
        if method == "fixed points":
            sets.update(OUTLINE)
        if name == "proximity field":
            # The least that keeps load from nodes with next to no mass, see
            # supports(). The contour needs no such rule.
            sets["Tractions/water/Minimum support"] = 0.001
        result[name] = runs.run(
            "submerged_slope/" + name.replace(" ", "-"), "submerged_slope.prm",
            sets, options=("--realisation", "0"), may_fail=True)
        print("   ", name, "ends at", result[name].frames()[-1][0], "s:",
              result[name]["outcome"], flush=True)
    return result


def supports(runs):
    """What the least mass of a node that carries load does to the proximity
    field's load: {share of a full mass: [roughness at 45 degrees (kPa), time at
    which the run ended (s)]}."""
    result = {}
    for support in (0.0, 0.001, 0.005, 0.02):
        run = runs.run(f"submerged_slope/support-{support:g}",
                       "submerged_slope.prm",
                       {"Tractions/water/Method": "proximity field",
                        "Surface/Method": "proximity field",
                        "Tractions/water/Minimum support": support,
                        "Time stepping/End time": 1},
                       options=("--realisation", "0"), may_fail=True)
        result[f"{support:g}"] = [roughness(run.points(0.0), "45 degrees")[0],
                                  float(run.frames()[-1][0])]
    return result


def in_window(x, place):
    (x0, x1), (y0, y1) = PLACES[place]
    return (x[:, 0] > x0) & (x[:, 0] < x1) & (x[:, 1] > y0) & (x[:, 1] < y1)


def draw_surface(axis, run, time, **style):
    for segment in run.surface(time):
        axis.plot(*segment.T, **{"color": "black", "linewidth": 0.8, **style})


def draw_forces(all_runs):
    """Figure 3.15: vertical nodal force of the water at B."""
    figure, axes = plt.subplots(1, 3, figsize=(13, 4), sharey=True)
    columns = {"method": [], "x_m": [], "y_m": [], "force_y_kN": []}
    for axis, (name, run) in zip(axes, all_runs.items()):
        nodes = Nodes(run, 0.0)
        here = in_window(nodes.position, "B")
        x = nodes.position[here]
        force = nodes["force_water"][here, 1]
        picture = axis.scatter(x[:, 0], x[:, 1], c=force, s=46, marker="s",
                               cmap="viridis", vmin=-25, vmax=0)
        draw_surface(axis, run, 0.0, color="red")
        axis.set_title(name)
        for row in zip([name] * here.sum(), *x[:, :2].T.tolist(),
                       force.tolist()):
            for key, value in zip(columns, row):
                columns[key].append(value)
    finish_windows(axes, "B")
    figure.colorbar(picture, ax=axes, label="vertical nodal force (kN)")
    save_data("figure_3_15", columns)
    save(figure, "figure_3_15")


def finish_windows(axes, place):
    for axis in axes:
        axis.set_xlim(*PLACES[place][0])
        axis.set_ylim(*PLACES[place][1])
        axis.set_aspect("equal")
        axis.set_xlabel("x (m)")


def draw_stresses(all_runs, field, name):
    """Figures 3.16 and 3.17: a stress of the points at A and B."""
    figure, axes = plt.subplots(2, 3, figsize=(13, 6),
                                height_ratios=(1, 2))
    columns = {"place": [], "method": [], "x_m": [], "y_m": [], field: []}
    for row, place in zip(axes, PLACES):
        for axis, (method, run) in zip(row, all_runs.items()):
            points = run.points(0.0)
            x = points["position"]
            here = in_window(x, place)
            values = points[field][here]
            if method == "points":
                limits = np.percentile(values, (2, 98))
            picture = axis.scatter(x[here, 0], x[here, 1], c=values, s=16,
                                   cmap="viridis", vmin=limits[0],
                                   vmax=limits[1])
            draw_surface(axis, run, 0.0, color="red")
            axis.set_title(f"{place}, {method}", fontsize=9)
            for entry in zip([place] * here.sum(), [method] * here.sum(),
                             *x[here, :2].T.tolist(), values.tolist()):
                for key, value in zip(columns, entry):
                    columns[key].append(value)
        finish_windows(row, place)
        figure.colorbar(picture, ax=row, shrink=0.8,
                        label=field.replace("_", " ") + " (kPa)")
    save_data(name, columns)
    save(figure, name)


def draw_failure(all_runs, times=(2.0, 4.5, 7.0)):
    """Figure 3.18: the slide, by deviatoric stress."""
    figure, axes = plt.subplots(len(times), 3, figsize=(14, 1.9 * len(times)),
                             sharex=True, sharey=True, layout="constrained")
    for column, (name, run) in zip(axes.T, all_runs.items()):
        for axis, wanted in zip(column, times):
            time = run.frame(wanted)[0]
            points = run.points(time)
            x = points["position"]
            picture = axis.scatter(x[:, 0], x[:, 1], s=1.2, vmin=0, vmax=60,
                                   c=points["deviatoric_stress"],
                                   cmap="viridis")
            draw_surface(axis, run, time)
            axis.set_title(f"{name}, {time:.1f} s", fontsize=9)
            axis.set_aspect("equal")
            axis.set_xlim(5, 60)
            axis.set_ylim(0, 18)
    figure.colorbar(picture, ax=axes, shrink=0.5,
                    label="deviatoric stress (kPa)")
    save(figure, "figure_3_18")


def histories(all_runs):
    """How far the slide is, by frame: largest displacement, moved area."""
    columns = {"method": [], "time_s": [], "largest_displacement_m": [],
               "area_moved_m2": [], "mean_displacement_m": []}
    for name, run in all_runs.items():
        for time, _ in run.frames():
            points = run.points(time)
            moved = np.hypot(*points["displacement"][:, :2].T)
            for key, value in zip(columns, (
                    name, time, float(moved.max()),
                    float(points["volume"][moved > 0.5].sum()),
                    float((moved * points["volume"]).sum()
                          / points["volume"].sum()))):
                columns[key].append(value)
    save_data("figure_3_18", columns)
    return columns


def inside_loads(run):
    """By frame: how much soil lies above the points that carry load (m)."""
    columns = {"time_s": [], "loaded_points": [], "mean_cover_m": [],
               "largest_cover_m": [], "under_more_than_a_cell": []}
    for time, _ in run.frames():
        points = run.points(time)
        loaded = np.flatnonzero(np.hypot(points["load_water_x"],
                                         points["load_water_y"]) > 0)
        cover = cover_of(points, loaded)
        for key, value in zip(columns, (
                time, int(loaded.size), float(cover.mean()),
                float(cover.max()), int((cover > CELL).sum()))):
            columns[key].append(value)
    save_data("submerged_slope_point_loads", columns)
    return columns


LABELS = {"largest_displacement_m": "largest displacement (m)",
          "area_moved_m2": "area moved more than 0.5 m (m²)",
          "mean_displacement_m": "mean displacement (m)"}


def value_at(history, name, key, time):
    rows = [i for i, n in enumerate(history["method"]) if n == name]
    times = [history["time_s"][i] for i in rows]
    return float(np.interp(time, times, [history[key][i] for i in rows]))


def initial_stress(run):
    points = run.points(0.0)
    entry = {"points": int(points["id"].size)}
    (entry["vertical stress of the flat top, rms error (kPa)"],
     entry["the same as a share"]) = error_of_vertical_stress(points)
    for region in REGIONS:
        (entry[f"mean stress, {region}, roughness (kPa)"],
         entry[f"mean stress, {region}, as a share"]) = \
            roughness(points, region)
        entry[f"deviatoric stress, {region}, roughness (kPa)"] = \
            roughness(points, region, "deviatoric_stress")[0]
    return entry


def main():
    runs = Runs(parse_arguments(__doc__))
    all_runs = run_all(runs)
    numbers = {}
    for name, run in all_runs.items():
        entry = initial_stress(run)
        entry["end (s)"] = float(run.frames()[-1][0])
        numbers[name] = entry
    updated = runs.run("submerged_slope/updated-points", "submerged_slope.prm",
                       {"Tractions/water/Method": "updated points"},
                       options=("--realisation", "0"))
    numbers["updated points"] = {
        **initial_stress(updated), "end (s)": float(updated.frames()[-1][0])}
    history = histories({**all_runs, "updated points": updated})
    for name, run in {**all_runs, "updated points": updated}.items():
        for time in (2.0, 4.5, 7.0):
            if time <= run.frames()[-1][0] + 1e-9:
                for key, label in LABELS.items():
                    numbers[name][f"{label} at {time:g} s"] = value_at(
                        history, name, key, time)
    loads = inside_loads(all_runs["points"])
    for i, time in enumerate(loads["time_s"]):
        if i in (0, len(loads["time_s"]) - 1) or abs(time - 4.5) < 1e-9:
            numbers["points"][f"loads at {time:.2f} s"] = {
                key: values[i] for key, values in loads.items()}
    numbers["exact surface, at the start"] = initial_stress(runs.run(
        "submerged_slope/surface", "submerged_slope.prm",
        {"Tractions/water/Method": "user surface", "Time stepping/End time": 0,
         **OUTLINE}, options=("--realisation", "0")))
    numbers["minimum support"] = supports(runs)
    draw_forces(all_runs)
    draw_stresses(all_runs, "mean_stress", "figure_3_16")
    draw_stresses(all_runs, "deviatoric_stress", "figure_3_17")
    draw_failure(all_runs)
    save_numbers("submerged_slope", numbers)


if __name__ == "__main__":
    main()
