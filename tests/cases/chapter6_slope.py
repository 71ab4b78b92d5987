#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slope of chapter 6 in 3D under its own weight, coarse: its points, that it
stands with the mean strength, and slides with a third of it, out of the box: on
cells of 0.5 m; "fine": of 0.25 m, and nothing else.

usage: chapter6_slope.py WAKER SOURCE_DIRECTORY [fine]
"""

import numpy as np
from waker_case import Checks, workspace_of_arguments

SLOPE, DYKE = "chapter6/slope.prm", "chapter6/dyke_3d.prm"
COARSE = {"Grid/Cell size": 0.25}


def weight(points, cell, stairs):
    """Volume of the points per cell, sorted: 8 whole ones, or 6 on the slope."""
    place = np.floor(points["position"] / cell + 1e-9).astype(int)
    _, count = np.unique(place, axis=0, return_counts=True)
    return sorted(set(count)), np.sum(count == (6 if stairs else 8))


def stands(work, checks):
    run = work.run("stands", SLOPE, COARSE)
    checks.equal("mean strength: outcome", run["outcome"], "stable")
    checks.equal("steps that did not converge", run["unconverged_steps"], 0)
    points = run.points(0)
    kinds, on_slope = weight(points, 0.25, True)
    checks.equal("points of a cell", kinds, [6, 8])
    checks.equal("cells on the slope", int(on_slope), 4 * 32)
    checks.equal("points", len(points["id"]), 12544)
    moved = np.linalg.norm(run.points()["displacement"], axis=1)
    checks.between("largest displacement, at the toe (mm)", 1e3 * moved.max(),
                   0.5, 10)
    checks.between("as before", 1e3 * moved.max(), 3.3, 4.0)
    rows = run.statistics
    checks.equal("points that left", rows["Mass out (Mg)"][-1], 0)
    checks.below("largest remainder of the momentum (kN s)",
                 np.abs(rows["Momentum remainder y (kN s)"]).max(), 1e-2)


def settles(work, checks):
    """Elastic, the rest of the weight, 1 %, moves the crest by 1 % of a confined
    column's settlement gamma H^2 / (2 M), more or less as it bounces."""
    run = work.run("settles", SLOPE, {**COARSE,
                                      "Materials/clay/Initial strength": 1000})
    points = run.points()
    place = points["position"]
    crest = (place[:, 1] > 0.8) & (place[:, 0] < 2) & (np.abs(place[:, 2] - 4) < 3)
    settlement = -points["displacement"][crest, 1] / (0.01 * 20 / (2 * 3793.1))
    checks.equal("points of the crest", int(crest.sum()), 2 * 16 * 48)
    checks.between("settlement of the crest by the last hundredth, mean",
                   settlement.mean(), 0.2, 2.5)
    checks.between("  as before", settlement.mean(), 2.27, 2.30)
    checks.below("  largest", settlement.max(), 5)


def slides(work, checks, cell, low, high):
    """@param low, high: of what has moved in the middle by that at the ends, today"""
    run = work.run("slides", SLOPE, {
        "Grid/Cell size": cell, "Materials/clay/Initial strength": 1.2,
        "Time stepping/End time": 3, "Newton/Tolerance": 1e-6,
        "Newton/Linear tolerance": 1e-4})
    checks.equal("a third of the strength: outcome", run["outcome"][:7], "initial")
    checks.equal("steps that did not converge", run["unconverged_steps"], 0)
    rows = run.statistics
    checks.above("mass that left (Mg)", rows["Mass out (Mg)"][-1], 0.01)
    checks.below("largest remainder of the mass (Mg)",
                 np.abs(rows["Mass remainder (Mg)"]).max(), 1e-10)
    momentum = np.abs(rows["Momentum x (kN s)"]).max()
    checks.above("momentum reaches (kN s)", momentum, 1)
    for axis in "xyz":
        checks.below(f"largest remainder of the momentum along {axis}, of it",
                     np.abs(rows[f"Momentum remainder {axis} (kN s)"]).max()
                     / momentum, 1e-3)
    # Symmetric about z = 4 m, and held at the ends.
    points = run.points()
    moved = np.linalg.norm(points["displacement"], axis=1)
    z = points["position"][:, 2] - points["displacement"][:, 2]
    checks.between("mean place of what has moved (m)",
                   np.average(z, weights=moved), 3.9, 4.1)
    checks.above("moved in the middle over moved at the ends",
                 moved[np.abs(z - 4) < 0.5].mean()
                 / moved[np.abs(z - 4) > 3.75].mean(), 1.5)
    checks.between("  as before", moved[np.abs(z - 4) < 0.5].mean()
                   / moved[np.abs(z - 4) > 3.75].mean(), low, high)


def dyke(work, checks):
    run = work.run("dyke", DYKE, {"Time stepping/End time": 0.1,
                                  "Soil profile/dyke/Top":
                                  work.source + "/parameters/chapter6/dyke_3d.csv"})
    checks.equal("dyke from a height map: steps that did not converge",
                 run["unconverged_steps"], 0)
    points = run.points(0)
    crest = points["position"][:, 1] > 2.5
    z = points["position"][crest, 2]
    checks.above("no crest above 2.5 m in the dip", np.abs(z - 4).min(), 0.2)
    # Its highest points are half a point below the table, all along it.
    x, y, z = points["position"].T
    table = np.genfromtxt(work.source + "/parameters/chapter6/dyke_3d.csv",
                          delimiter=",", comments="#", skip_header=3)
    middle = table[table[:, 0] == 6]
    size = np.cbrt(points["volume"].max())
    layer = np.floor(z / size).astype(int)
    away = [y[(layer == k) & (x > 5.25) & (x < 6.75)].max() + size / 2
            - np.interp((k + 0.5) * size, middle[:, 1], middle[:, 2])
            for k in np.unique(layer)]
    checks.above("places along the crest", len(away), 20)
    checks.below("  the crest less the table, largest (points)",
                 np.abs(away).max() / size, 0.5)


def main():
    work, words = workspace_of_arguments()
    checks = Checks()
    with work:
        if "fine" in words:
            slides(work, checks, 0.25, 2.7, 2.8)
        else:
            stands(work, checks)
            settles(work, checks)
            slides(work, checks, 0.5, 4.4, 4.5)
            dyke(work, checks)
    checks.finish()


if __name__ == "__main__":
    main()
