#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Soil with friction: slopes, one with water in it, and a footing against published
numbers; --long: on finer cells, a dyke over sand with a head of its own, soil that keeps
its water, and a pile of bars that spreads
(doc/verification/mohr_coulomb.md, pore_water.md, pore_pressure.md).

usage: mohr_coulomb.py WAKER SOURCE_DIRECTORY [--long]
"""

import sys

import numpy as np
from friction_measures import (ACADS, COLUMN, DRAWDOWN, FOOTING, HALF_WIDTH,
                               HEAD_LINES, MEASURED, SLOPE, SOFTENING, SUCTION,
                               UNDRAINED, WALLS, front, heights, load, n_c,
                               n_c_undrained, rankine, wall_force)
from waker_case import Checks, workspace_of_arguments

COARSE = {"Grid/Cell size": 1, "Time stepping/Time step": 0.02}


def bracket(low, high):
    return {"Strength reduction/Lower factor": low,
            "Strength reduction/Upper factor": high}


def pile(checks, work):
    run = work.run("pile", COLUMN)
    off = heights(run) - MEASURED[:, 1]
    rms = float(np.sqrt((off**2).mean()))
    checks.below("pile: height against the experiment, rms (m)", rms, 0.004)
    # A trail thinner than a cell runs ahead of the bars (aimed at: 1.08).
    checks.between("  front over the measured one, as before",
                   front(run) / 0.442, 1.08, 1.18)
    # The control: bars of 30 degrees are others.
    other = work.run("steep", COLUMN, {"Materials/bars/Friction angle": 30})
    off = heights(other) - MEASURED[:, 1]
    checks.above("  rms with 30 degrees (m)",
                 float(np.sqrt((off**2).mean())), 0.006)
    checks.below("  front with 30 degrees", front(other) / 0.442, 0.92)


def slopes(checks, work):
    result = work.factor_of_safety("slope", SLOPE, bracket(1.36, 1.44))
    factor = result["factor_of_safety"]
    checks.between("slope of 1:2: factor of safety (finite elements: 1.4), "
                   "as before", factor, 1.395, 1.411)
    checks.equal("  slope that slides", result["failure"]["slope"], "inner")
    acads = work.factor_of_safety("acads", ACADS, bracket(0.96, 1.02))[
        "factor_of_safety"]
    checks.between("ACADS 1(a): factor over Bishop's", acads / 0.987, 0.97, 1.03)
    checks.between("  as before", acads, 0.983, 0.999)
    lowered = work.factor_of_safety("lowered", DRAWDOWN, bracket(1.28, 1.36))
    checks.between("water 7 m below the crest: factor (finite elements: 1.3), "
                   "as before", lowered["factor_of_safety"], 1.311, 1.331)


def coarse_slopes(checks, work):
    # The law's tangent is unsymmetric: with double mapping, too, Newton finds
    # the same.
    factors = [work.factor_of_safety(
        kind, SLOPE, {"Newton/Tangent": kind, **COARSE,
                      **bracket(1.3, 1.6)})["factor_of_safety"]
        for kind in ("consistent", "double mapping")]
    checks.between("slope of 1:2 on coarse cells: factor of safety", factors[0],
                   1.42, 1.46)
    # Within the width of the search's bracket.
    checks.between("  with double mapping", factors[1] - factors[0],
                   -0.012, 0.012)
    acads = work.factor_of_safety("acads", ACADS, {**COARSE, **bracket(0.98, 1.06)})
    checks.between("ACADS 1(a) on coarse cells (Bishop: 0.987)",
                   acads["factor_of_safety"], 1.0, 1.04)
    # Water in the ground and outside, and half the weight without either.
    under = work.factor_of_safety("under", DRAWDOWN, {
        **COARSE, **bracket(1.8, 2.1), "Tractions/reservoir/Level": 10,
        "Pore water/Phreatic line": "-1, 10; 47, 10"})
    light = work.factor_of_safety("light", DRAWDOWN, {
        **COARSE, **bracket(1.8, 2.1), "Materials/soil/Unit weight": 10,
        "Tractions/Names": "", "Pore water/Phreatic line": ""})
    checks.between("under water over buoyant weight",
                   under["factor_of_safety"] / light["factor_of_safety"],
                   0.97, 1.03)
    checks.between("  as before", under["factor_of_safety"], 1.92, 1.99)


def heads(checks, work):
    # What the water in the sand does; narrow brackets, for the sake of time.
    factors = [work.factor_of_safety(name.replace(" ", "-"), HEAD_LINES, {
        **bracket(low, low + 0.08), **sets})["factor_of_safety"]
        for name, low, sets in (
            ("1.2 m", 1.41, {}),
            ("0 m", 1.69, {"Head lines/aquifer/Line": "-12, 3; 0, 3; 28, 0; 48, 0"}),
            ("none", 1.65, {"Head lines/Names": "", "Reference lines/Names": ""}))]
    checks.between("dyke over sand with a head of 1.2 m at the toe: factor, as before",
                   factors[0], 1.435, 1.475)
    checks.between("  over that with the head at the ground", factors[0] / factors[1],
                   0.8, 0.9)
    checks.between("  over that with the phreatic line alone", factors[0] / factors[2],
                   0.82, 0.9)


def softening_and_suction(checks, work):
    """Coarse: each between what it must lie between."""
    def factor(case, low, high, more):
        return work.factor_of_safety("coarse", case, {
            **COARSE, **bracket(low, high), **more})["factor_of_safety"]

    soft = factor(SOFTENING, 1.2, 1.5, {})
    checks.between("slope that softens: factor of safety, as before", soft, 1.32, 1.35)
    checks.below("  over that of the peak strength",
                 soft / factor(SLOPE, 1.3, 1.6, {}), 0.95)
    checks.above("  over that of the residual strength", soft / factor(SLOPE, 0.8, 1.1, {
        "Materials/soil/Cohesion": 5, "Materials/soil/Friction angle": 16}), 1.2)
    # Suction all over is a cohesion of s tan(phi); within the width of two brackets.
    dry = {"Pore water/Phreatic line": "", "Pore water/Largest suction": 0}
    suction = factor(SUCTION, 1.1, 1.4, {})
    checks.between("slope with suction: factor less that with the cohesion it is worth",
                   suction - factor(SUCTION, 1.1, 1.4, {
                       **dry, "Materials/soil/Cohesion": 3 + 10 * np.tan(np.radians(19.6))}),
                   -0.02, 0.02)
    # The control: without suction.
    checks.above("  over that without suction",
                 suction / factor(SUCTION, 0.8, 1.2, dry), 1.15)


def footing(checks, work):
    run = work.run("footing", FOOTING, {"Time stepping/Time step": 2,
                                        "Material points/Points per direction": 2})
    checks.equal("footing: steps that did not converge",
                 run["unconverged_steps"], 0)
    over = float(load(run)[-1]) / n_c(20.0)
    checks.between("  load over N_c c of a footing half a cell wider",
                   over / (1.0 + 0.0625 / HALF_WIDTH), 1.0, 1.15)
    checks.between("  load over N_c c, as before", over, 1.255, 1.263)


def footings(checks, work):
    for angle in 20.0, 30.0:
        errors = [float(load(work.run(f"footing-{angle}-{cell}", FOOTING, {
            "Materials/soil/Friction angle": angle, "Grid/Cell size": cell,
            "Time stepping/End time": 30}))[-1]) / n_c(angle) - 1
            for cell in (0.25, 0.125)]
        checks.between(f"footing, {angle:g} degrees, one point a cell: load over N_c c - 1 "
                       "on cells of an eighth", errors[1], 0.0, 0.05)
        checks.between("  over that on cells of a quarter", errors[1] / errors[0], 0.45, 0.75)


def undrained_footing(checks, work):
    # s' takes a share of the load by the stiffness of the water: another N_c, by a
    # closed form. Of two stiffnesses on the same cells what the cells do falls out.
    stiffness = 2e6, 2e7
    over = [float(load(work.run(f"undrained-{k:g}", UNDRAINED, {
        "Grid/Cell size": 0.25, "Materials/soil/Pore fluid stiffness": k}))[-1])
        / n_c_undrained(k) for k in stiffness]
    checks.between("undrained footing: load over the closed form of its K_f", over[0],
                   1.0, 1.15)
    checks.between("  as before", over[0], 1.104, 1.114)
    checks.between("  that with ten times K_f over it", over[1] / over[0], 0.99, 1.01)
    checks.above("  the two closed forms over each other",
                 n_c_undrained(stiffness[0]) / n_c_undrained(stiffness[1]), 1.03)


def single_points(checks, work):
    # One point a cell: no two of a cell want different changes of volume.
    loads = load(work.run("single", FOOTING, {
        "Material points/Points per direction": 1, "Time stepping/Time step": 2,
        "Time stepping/End time": 16}))
    over = float(loads[-1]) / n_c(20.0)
    checks.between("footing, one point a cell: load over N_c c", over, 1.0, 1.05)
    checks.between("  as before", over, 1.041, 1.0435)
    checks.below("  growth over the last third", float(loads[-1] / loads[len(loads) * 2 // 3])
                 - 1.0, 0.002)


def walls(checks, work):
    for name, (case, rate) in WALLS.items():
        force = wall_force(work.run(name, case), rate)
        checks.between(f"{name} earth pressure over Rankine's",
                       float(force[-1]) / rankine(name), 1.0 - 1e-4, 1.0 + 1e-4)
    # On a base that holds the soil the wedge has to shear off it.
    held = work.run("held", WALLS["passive"][0], {
        "Boundary conditions/base/Type": "fixed", "Time stepping/End time": 25})
    checks.between("  passive, on a fixed base, coarse",
                   float(wall_force(held, WALLS["passive"][1])[-1]) / rankine("passive"),
                   1.0, 1.04)
    # The control: half the friction is another force.
    other = work.run("other", WALLS["passive"][0],
                     {"Materials/soil/Friction angle": 15})
    checks.below("  passive, 15 degrees, over that of 30",
                 float(wall_force(other, WALLS["passive"][1])[-1]) / rankine("passive"),
                 0.7)


def main():
    parts = (coarse_slopes, single_points, walls)
    if "--long" in sys.argv:
        sys.argv.remove("--long")
        parts = (slopes, heads, softening_and_suction, footing, footings,
                 undrained_footing, pile)
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        for part in parts:
            part(checks, work)
    checks.finish()


if __name__ == "__main__":
    main()
