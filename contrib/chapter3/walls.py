#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls off the grid: a block squeezed between walls at any angle, and a strip
footing (doc/verification/walls.md)."""

import os
import re

import numpy as np
from common import (PARAMETERS, Runs, parse_arguments, plt, save, save_data,
                    save_numbers, write_text)

ANGLES = (0.0, 10.0, 20.0, 26.565, 30.0, 45.0)  # degrees
SIZES = (0.25, 0.125, 0.0625)                   # m
FACTORS = (1, 10, 100, 1000, 10000)
LENGTH, PUSH = 2.0, 0.002                       # m
MODULUS = 1000.0 / (1.0 - 0.3**2)               # kPa, plane strain
EXACT = MODULUS * PUSH / LENGTH                 # kPa
COHESION, HALF_WIDTH = 10.0, 0.5                # kPa, m
PRANDTL = 2.0 + np.pi
ON_GRID = {"Soil profile/ground/Polygon": "0, 0; 4, 0; 4, 2.5; 0, 2.5"}


def block(runs, angle, size, factor):
    """Error of the force on the end wall, and rms errors of the stress along the
    block: of all points, and of those a cell and more away from its sides."""
    turn = np.radians(angle)
    along = np.array([np.cos(turn), np.sin(turn)])
    across = np.array([-along[1], along[0]])

    def text(*corners):
        return "; ".join(f"{x!r}, {y!r}" for x, y in np.array(corners).tolist())

    sets = {
        "Grid/Cell size": size,
        "Soil profile/block/Polygon": text(0 * along, 2 * along,
                                           2 * along + across, across),
        "Walls/corner/Line": text(across, 0 * along, 2 * along),
        "Walls/face/Line": text(2 * along, 2 * along + across),
        "Walls/face/Displacement":
            "; ".join(f"{-PUSH * a!r}*t" for a in along.tolist()),
        "Walls/corner/Penalty factor": factor,
        "Walls/face/Penalty factor": factor,
        "Output/Grid": "false", "Output/Surface": "false",
    }
    run = runs.run(f"walls/block-{angle:g}-{size:g}-{factor:g}",
                   "inclined_wall.prm", sets)
    force = -sum(run.statistics[f"Wall face {axis} (kN)"][-1] * a
                 for axis, a in zip("xy", along))
    points = run.points()
    stress = -(points["stress_xx"] * along[0]**2
               + points["stress_yy"] * along[1]**2
               + 2.0 * points["stress_xy"] * along[0] * along[1])
    error = stress / EXACT - 1.0
    place = points["position"][:, :2]
    depth = np.min([place @ along, LENGTH - place @ along,
                    place @ across, 1.0 - place @ across], axis=0)

    def rms(values):
        return float(np.sqrt(np.mean(values**2)))

    return force / EXACT - 1.0, rms(error), rms(error[depth >= size])


def study_blocks(runs, numbers):
    rows = []
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.8))
    for angle in ANGLES:
        force, stress, inside = np.array([block(runs, angle, size, 100)
                                          for size in SIZES]).T
        for row in zip(SIZES, force, stress, inside):
            rows.append((angle, row[0], 100, *map(float, row[1:])))
        label = f"{angle:.3g}°"
        axes[0].loglog(SIZES, np.abs(force), "o-", label=label)
        axes[1].loglog(SIZES, inside, "o-", label=label)
        numbers[f"block at {angle:.3g} degrees, force - 1 at h = "
                "0.25, 0.125, 0.0625 m"] = [round(float(f), 5) for f in force]
        numbers[f"block at {angle:.3g} degrees, rms error of stress"] = [
            round(float(s), 5) for s in stress]
        numbers[f"block at {angle:.3g} degrees, the same inside"] = [
            round(float(s), 5) for s in inside]
    for factor in FACTORS:
        force, stress, inside = block(runs, 26.565, 0.125, factor)
        rows.append((26.565, 0.125, factor, float(force), stress, inside))
        numbers[f"block at 26.6 degrees, h = 0.125 m, penalty factor {factor}: "
                "force - 1, rms error of stress, the same inside"] = [
                    round(float(force), 5), round(stress, 5), round(inside, 5)]
    save_data("walls_block", dict(zip(
        ("angle_degrees", "h_m", "penalty_factor", "force_error",
         "stress_error_rms", "stress_error_rms_inside"), zip(*rows))))
    for axis, title in zip(axes, ("force on the wall, error",
                                  "stress of the points inside, rms error")):
        axis.loglog(SIZES, 0.06 * np.array(SIZES) / SIZES[0], "k--",
                    linewidth=0.8, label="first order")
        axis.set_xlabel("cell size (m)")
        axis.set_title(title)
        axis.legend(fontsize=7, ncol=2)
    save(figure, "walls_block")


def footing(runs, name, size, points, sets=None):
    run = runs.run(f"walls/footing-{name}", "footing.prm",
                   {"Grid/Cell size": size,
                    "Material points/Points per direction": points,
                    "Time stepping/Time step": 0.5,
                    "Output/Grid": "false", "Output/Interval": 0,
                    **(sets or {})})
    return run.statistics


def footing_by_nodes(runs):
    """The footing as a boundary condition of the grid's nodes."""
    with open(os.path.join(PARAMETERS, "footing.prm"), encoding="utf-8") as file:
        text = file.read()
    text, n = re.subn(r"\nsubsection Walls\n.*?\nend\n", "\n", text,
                      flags=re.DOTALL)
    assert n == 1
    names = "  set Names = base, sides, axis"
    assert names in text
    text = text.replace(names, names + """, footing
  subsection footing
    set Region       = box
    set From         = 0, 2.5
    set To           = 0.5, 2.5
    set Type         = prescribed
    set Displacement = 0; -0.001*t
  end""")
    path = runs.path("walls", "footing_by_nodes.prm")
    write_text(path, text)
    return path


def study_footing(runs, numbers):
    """Bearing capacity factor against settlement; the same footing by nodes
    of the grid."""
    figure, axis = plt.subplots(figsize=(6.5, 4.2))
    columns = {}
    for size, points in ((0.25, 2), (0.125, 2), (0.0625, 2), (0.0625, 1)):
        rows = footing(runs, f"{size:g}-{points}", size, points)
        settlement = rows["Time (s)"] * 1e-3
        factor = -rows["Wall footing y (kN)"] / (COHESION * HALF_WIDTH)
        label = f"h = {size:g} m, {points}$^2$ points per cell"
        axis.plot(1e3 * settlement, factor, label=label)
        columns["settlement_m"] = settlement.tolist()
        columns[f"factor_h{size:g}_{points}"] = factor.tolist()
        numbers[f"footing, h = {size:g} m, {points} points per direction: "
                "N_c at 10 and 20 mm"] = [
                    round(float(np.interp(s, settlement, factor)), 3)
                    for s in (0.01, 0.02)]
    # Elastic: the first step, 0.2 mm. The work of the only support that moves
    # tells its force.
    end = {"Time stepping/Time step": 0.2, "Time stepping/End time": 0.2}
    by_wall = footing(runs, "wall-on-grid", 0.125, 2, {
        **end, **ON_GRID, "Walls/footing/Line": "0.5, 2.5; 0, 2.5"})
    off_grid = footing(runs, "wall-off-grid", 0.125, 2, end)
    by_nodes = runs.run("walls/footing-nodes", footing_by_nodes(runs), {
        "Grid/Cell size": 0.125, "Output/Grid": "false", **end,
        **ON_GRID}).statistics
    for name, force in (
            ("nodes", -by_nodes["Work of the supports (kJ)"][-1] / 1e-4),
            ("a wall on a line of the grid",
             by_wall["Wall footing y (kN)"][-1]),
            ("a wall 0.03 m above it", off_grid["Wall footing y (kN)"][-1])):
        numbers[f"elastic footing by {name}: force at 0.2 mm (kN)"] = round(
            -float(force), 4)
    axis.axhline(PRANDTL, color="k", linewidth=0.8, linestyle="--",
                 label="$2 + \\pi$")
    axis.set_xlabel("settlement (mm)")
    axis.set_ylabel("force / (c B)")
    axis.legend(fontsize=8)
    save(figure, "walls_footing")
    save_data("walls_footing", columns)


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers = {}
    study_blocks(runs, numbers)
    study_footing(runs, numbers)
    save_numbers("walls", numbers)


if __name__ == "__main__":
    main()
