#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/pore_pressure.md; runs the program.

    /usr/bin/python3 contrib/verification/pore_pressure.py [--waker build/bin/waker]
        [heads] [delay] [traffic] [undrained]
"""

import argparse
import os

import numpy as np
from common import ROOT, plt, save
from dyke_runs import Workspace, write_csv
from friction_measures import load, n_c_undrained

HEADS = "verification/dyke_head_lines.prm"
DELAY = "verification/dyke_delay.prm"
TRAFFIC = "verification/dyke_traffic.prm"
UNDRAINED = "verification/strip_footing_undrained.prm"


def bracket(low, high):
    return {"Strength reduction/Lower factor": low,
            "Strength reduction/Upper factor": high}


def factor(work, name, case, settings):
    return work.factor_of_safety(name, case, settings)["factor_of_safety"]


def heads(work):
    """Factor of safety by the head in the sand inside, beside none."""
    line = "-12, 3; 0, 3; 28, {0:g}; 48, {1:g}"
    rows = [(float("nan"), factor(work, "none", HEADS, {
        "Head lines/Names": "", "Reference lines/Names": ""}))]
    for head in (0.0, 0.6, 1.2, 1.7):
        rows.append((head, factor(work, f"head-{head}", HEADS, {
            "Head lines/aquifer/Line": line.format(head, 0.5 * head)})))
    for head, value in rows:
        print("| %g m | %.3f |" % (head, value), flush=True)
    write_csv("pore_pressure_heads",
              dict(zip(("head_at_inner_toe_m", "factor"), zip(*rows))))


def arrived(time, delay_there=4.0, rate=0.2, end=10.0):
    """What of a level that rises by rate (m/s) until `end` (s) has arrived."""
    rise = min(time, end)
    lag = delay_there * (1.0 - np.exp(-rise / delay_there))
    level = rate * (rise - lag)
    left = (rate * end - level) * np.exp(-max(time - end, 0) / delay_there)
    return rate * end - left if time > end else level


def height(x, level):
    """The line inside the crest by the level at the inner edge of the outer
    slope, x = 12 m."""
    return np.interp(level, (0, 2, 4), (0, 2 * 16 / 22, 4)) * (28 - x) / 16


def delay(work):
    """Pore pressure in the middle of the dyke, beside the closed form."""
    run = work.run("delay", DELAY, {"Output/Interval": 0.5})
    at_once = work.run("at-once", DELAY, {"Pore water/Delay": 0,
                                          "Output/Interval": 0.5})
    points = run.points(0.0)["position"]
    middle = np.argmin(np.hypot(points[:, 0] - 14.0, points[:, 1] - 0.3))
    rows = []
    for time, _ in run.frames():
        frame = run.points(time)
        x, y = frame["position"][middle][:2]
        # Between the places of the table, 0 and 28 m, what has arrived is
        # straight.
        level = 1.0 + 0.2 * min(time, 10.0) * 16 / 28 + arrived(time) * 12 / 28
        early = at_once.points(min(time, at_once["end_time"]))
        rows.append((time, level, 10.0 * (height(x, level) - y),
                     float(frame["pore_pressure"][middle]),
                     float(early["pore_pressure"][middle])))
    for row in rows[::8]:
        print("| %g s | %.3f m | %.2f | %.2f | %.2f |" % row, flush=True)
    print("largest difference %.2g kPa" % max(abs(r[2] - r[3]) for r in rows))
    write_csv("pore_pressure_delay",
              dict(zip(("time_s", "level_m", "closed_form_kPa", "delayed_kPa",
                        "at_once_kPa"), zip(*rows))))
    figure, axes = plt.subplots()
    times = [row[0] for row in rows]
    axes.plot(times, [row[4] for row in rows], "-", color="0.6",
              label="at once")
    axes.plot(times, [row[2] for row in rows], "k--", label="closed form")
    axes.plot(times, [row[3] for row in rows], "o", markersize=3,
              label="with a delay")
    axes.set_xlabel("t (s)")
    axes.set_ylabel("pore pressure in the middle of the dyke (kPa)")
    axes.legend()
    save(figure, "pore_pressure_delay")


def traffic(work):
    rows = []
    for name, settings in (
            ("no traffic", {"Tractions/Names": ""}),
            ("0", {"Tractions/traffic/Consolidation": 0}),
            ("0.1 in the dyke, 0 below", {}),
            ("1", {"Tractions/traffic/Consolidation": 1}),
            ("not asked", {"Tractions/traffic/Consolidation": "",
                           "Tractions/traffic/Spread": 0})):
        rows.append((name, factor(work, name.replace(" ", "-"), TRAFFIC, {
            **bracket(0.9, 1.4), **settings})))
        print("| %s | %.3f |" % rows[-1], flush=True)
    write_csv("pore_pressure_traffic",
              dict(zip(("consolidation", "factor"), zip(*rows))))


def undrained(work):
    """Load over settlement of the footing, beside the closed forms: of soil that keeps
    its volume, (2 + pi) c cos phi, and of this stiffness of the water."""
    figure, axes = plt.subplots()
    limit = (2 + np.pi) * np.cos(np.radians(20.0))
    rows = []
    for h, points, stiffness in (
            (0.25, 1, 2e6), (0.25, 1, 2e7), (0.25, 2, 2e6), (0.125, 1, 2e6),
            (0.125, 1, 2e7), (0.125, 2, 2e6), (0.0625, 1, 2e6)):
        run = work.run(f"undrained-{h}-{points}-{stiffness:g}", UNDRAINED, {
            "Grid/Cell size": h, "Output/Interval": 0,
            "Material points/Points per direction": points,
            "Materials/soil/Pore fluid stiffness": stiffness})
        over = load(run)
        rows.append((h, points**2, stiffness, float(over[-1]),
                     float(over[-1]) / limit - 1,
                     float(over[-1]) / n_c_undrained(stiffness) - 1,
                     run["unconverged_steps"], len(over)))
        print("| %g m | %g | %g | %.2f c | %+.3f | %+.3f | %d | %d |" % rows[-1],
              flush=True)
        if stiffness == 2e6:
            axes.plot(0.5 * run.statistics["Time (s)"][1:], over,
                      "-" if points == 1 else "--",
                      label=f"h = {h:g} m, {points**2} a cell")
        write_csv("pore_pressure_footing", dict(zip(
            ("cell_m", "points_a_cell", "pore_fluid_stiffness_kPa", "load_over_c",
             "above_incompressible", "above_closed_form", "halvings", "steps"),
            zip(*rows))))
    axes.axhline(limit, color="k", linestyle="--",
                 label=r"$(2 + \pi)\,\cos\varphi$")
    axes.axhline(n_c_undrained(2e6), color="k", linestyle=":", label="with K_f")
    axes.set_xlabel("settlement (mm)")
    axes.set_ylabel("load over c")
    axes.legend(fontsize=7)
    save(figure, "pore_pressure_footing")


def main():
    parts = {"heads": heads, "delay": delay, "traffic": traffic,
             "undrained": undrained}
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"))
    parser.add_argument("parts", nargs="*", default=list(parts))
    arguments = parser.parse_args()
    with Workspace(arguments.waker, ROOT) as work:
        for part in arguments.parts:
            parts[part](work)


if __name__ == "__main__":
    main()
