#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slope of chapter 6 in plane strain under a foundation load that grows until it
fails, and with water that falls: rules, balances, and today's loads
(doc/verification/load_programmes.md).

usage: load_programmes.py WAKER SOURCE_DIRECTORY [SECTION/NAME=VALUE ...]
"""

import numpy as np
from waker_case import Checks, workspace_of_arguments

LOAD = "Load programmes/foundation/"


def follows_the_rules(checks, name, run, load, rate, limit, start=0.):
    """Each row of the statistics against the one before."""
    table = run.statistics
    time, factor = table["Time (s)"], table[load]
    held = table[load.rsplit(" (", 1)[0] + " held"]
    stopped = table[load.rsplit(" (", 1)[0] + " stopped"]
    grows = (held[:-1] == 0) & (stopped[:-1] == 0) & (time[:-1] >= start - 1e-9)
    expected = np.where(grows, rate * np.diff(time), 0)
    checks.below(f"{name}: growth in a step", np.abs(np.diff(factor)
                                                     - expected).max(), 1e-12)
    fast = table["Largest settlement rate (m/s)"] > limit
    checks.equal(f"{name}: held where it moves, before it is stopped",
                 bool(np.all(held[stopped == 0] == (
                     fast & (time >= start - 1e-9))[stopped == 0])), True)
    checks.above(f"{name}: steps held", int(held.sum()), 10)
    first = int(np.argmax(stopped))
    settlement = table["Largest settlement (m)"]
    checks.equal(f"{name}: stopped by the settlement",
                 bool(settlement[first - 1] <= 0.1 < settlement[first]
                      and np.all(stopped[first:] == 1)), True)
    end = run["loads"][0]
    checks.below(f"{name}: the ultimate load of the summary",
                 abs(end["factor"] - factor[first]), 1e-12)
    checks.below(f"{name}: and its time", abs(end["stop_time"] - time[first]),
                 1e-9)


def remainder(run):
    """The largest energy remainder, as a share of the work of weight and load."""
    table = run.statistics
    work = (table["Potential energy released (kJ)"]
            + table["Work of the water (kJ)"]).max()
    return np.abs(table["Energy remainder (kJ)"]).max() / work


def balances(checks, name, run):
    table = run.statistics
    # Met: 0.5 to 1.1 %, the most by weight without mass, which falls fastest.
    checks.below(f"{name}: largest energy remainder, of the work",
                 remainder(run), 0.03)
    checks.below(f"{name}: mass remainder",
                 np.abs(table["Mass remainder (Mg)"]).max(), 1e-11, "Mg")
    momentum = np.abs(table["Momentum y (kN s)"]).max()
    checks.below(f"{name}: momentum remainder y, of the momentum",
                 np.abs(table["Momentum remainder y (kN s)"]).max() / momentum,
                 0.02)


with workspace_of_arguments()[0] as work:
    checks = Checks()
    loads = {}
    for points in ("top", "column"):
        for mass in ("weight alone", "with mass"):
            name = f"{points}, {mass}"
            run = work.run("slope", "chapter6/foundation_2d.prm", {
                LOAD + "Points": points, LOAD + "Mass": mass,
                "Time stepping/End time": 3, "Output/Interval": 0})
            follows_the_rules(checks, name, run, "Load foundation (m)", 0.5,
                              0.05)
            balances(checks, name, run)
            loads[name] = run["loads"][0]["factor"]
            cut = run["inner_slide"]["crest_cut"]
            # Behind the edge at 2.5 m, at the rear edge of the load, 1.5 m.
            checks.between(f"{name}: leaves the crest at x", cut, 1.25, 1.75,
                           "m")
    # What is left is the method's: of second order in the step.
    coarse, fine = (remainder(work.run("step", "chapter6/foundation_2d.prm", {
        "Time stepping/Time step": dt, "Time stepping/End time": 3,
        "Output/Interval": 0})) for dt in (0.01, 0.005))
    checks.below("energy remainder by half the step, by that of the whole",
                 fine / coarse, 0.5)
    # Crumbs of soil cost energy: not with B-bar where soil fills the cells.
    # Met: 0.1 %.
    filled = remainder(work.run("filled", "chapter6/foundation_2d.prm", {
        "Kinematics and mapping/Volumetric strain": "B-bar",
        "Time stepping/End time": 3, "Output/Interval": 0}))
    checks.below("energy remainder with B-bar in filled cells, of the work",
                 filled, 0.004)
    # Wide: the thesis's deterministic 2D load lies in its range; as before.
    checks.between("ultimate load", loads["top, weight alone"], 0., 0.6, "m")
    checks.between("as before", loads["top, weight alone"], 0.27, 0.30, "m")
    # In the column half of it hardly drives the slide; inertia hardly counts.
    checks.between("as before: column", loads["column, weight alone"], 0.58,
                   0.64, "m")
    for points in ("top", "column"):
        checks.between(f"{points}: with mass by weight alone",
                       loads[f"{points}, with mass"]
                       / loads[f"{points}, weight alone"], 0.98, 1.05)
    strip = work.run("strip", "chapter6/foundation_2d.prm", {
        "Tractions/Names": "strip", "Tractions/strip/Kind": "vector",
        "Tractions/strip/Value": "0; -20",
        "Tractions/strip/From": "1.5, 0.9", "Tractions/strip/To": "2, 1.1",
        LOAD + "Drives": "traction", LOAD + "Load": "strip",
        LOAD + "From": "", LOAD + "To": "",
        "Time stepping/End time": 3, "Output/Interval": 0})
    checks.between("weight on top by a traction on the strip",
                   loads["top, weight alone"] / strip["loads"][0]["factor"],
                   0.95, 1.06)

    fall = work.run("fall", "chapter6/drawdown_2d.prm", {"Output/Interval": 0})
    follows_the_rules(checks, "drawdown", fall, "Load drawdown (m)", -0.2,
                      0.05, start=1.)
    checks.between("drawdown at which the slope fails",
                   fall["loads"][0]["factor"], -0.9, -0.05, "m")
    checks.finish()
