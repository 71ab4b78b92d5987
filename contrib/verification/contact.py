#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/contact.md; runs the program.

    /usr/bin/python3 contrib/verification/contact.py [--waker build/bin/waker]
        [--only block,toe]
"""

import math

import numpy as np
from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv

GRAVITY, TAN_SLOPE = 9.81, 0.5
ALONG = np.array([2.0, -1.0]) / math.sqrt(5.0)
BLOCK = "verification/block_on_slope.prm"
FRICTION = "Walls/slope/Friction coefficient"


def acceleration(mu):
    cosine = 1.0 / math.hypot(1.0, TAN_SLOPE)
    return GRAVITY * cosine * max(0.0, TAN_SLOPE - mu)


def speed(run, times):
    """Of the block's centre of mass down the slope (m/s)."""
    momentum = np.array([run.value(f"Momentum {x} (kN s)", times)
                         for x in "xy"])
    return ALONG @ momentum / (20.0 * 2.0 / GRAVITY)


def block(work):
    """A block on a slope of 1 : 2, with friction above and below tan(beta)."""
    figure, axes = plt.subplots()
    columns = {name: [] for name in
               ("mu", "cell_m", "time_s", "way_m", "expected_m", "speed_m_s",
                "friction_kJ", "remainder_kJ")}
    for mu, cell in ((0.0, 0.25), (0.3, 0.5), (0.3, 0.25), (0.3, 0.125),
                     (0.45, 0.25), (0.6, 0.25)):
        run = work.run(f"block-{mu}-{cell}", BLOCK,
                       {FRICTION: mu, "Grid/Cell size": cell,
                        "Time stepping/Time step": 0.02 * cell,
                        "Gravity/Initial stress":
                            "true" if mu > TAN_SLOPE else "false"})
        start = run.points(0.0)
        times, ways = [], []
        for time, _ in run.frames():
            moved = run.points(time)["position"] - start["position"]
            times.append(time)
            ways.append(float(np.average(moved[:, :2] @ ALONG,
                                         weights=start["mass"])))
        expected = [0.5 * acceleration(mu) * time**2 for time in times]
        speeds = speed(run, times)
        later = np.arange(0.5, 2.0, 0.01)
        slope = np.polyfit(later, speed(run, later), 1)
        friction = run.value("Friction on walls (kJ)", times)
        remainder = run.value("Energy remainder (kJ)", times)
        for row in zip(times, ways, expected, speeds, friction, remainder):
            for name, value in zip(columns, (mu, cell, *row)):
                columns[name].append(value)
        work_of_friction = (mu * 40.0 / math.hypot(1.0, TAN_SLOPE) * ways[-1])
        print("| %g | %g m | %.4f m | %.4f m | %+.2f %% | %.4f m/s^2 | %+.2f %% "
              "| %.3f m/s | %.3f of %.3f kJ | %.2g kJ |"
              % (mu, cell, ways[-1], expected[-1],
                 100 * (ways[-1] / expected[-1] - 1) if expected[-1] else 0,
                 slope[0],
                 100 * (slope[0] / acceleration(mu) - 1) if expected[-1] else 0,
                 slope[1], friction[-1], work_of_friction,
                 np.abs(run.statistics["Energy remainder (kJ)"]).max()),
              flush=True)
        if cell == 0.25:
            axes.plot(times, ways, "o", label=f"μ = {mu:g}")
            fine = np.linspace(0.0, times[-1], 50)
            axes.plot(fine, 0.5 * acceleration(mu) * fine**2, "k-",
                      linewidth=0.8)
    axes.set_xlabel("time (s)")
    axes.set_ylabel("way down the slope (m)")
    axes.legend(title="lines: ½ g (sin β − μ cos β) t²")
    save(figure, "contact_block")
    write_csv("contact_block", columns)


def profile(points, cell):
    """Columns of half a cell: x, lowest and highest edge of the soil (m)."""
    x, y = points["position"][:, 0], points["position"][:, 1]
    edges = np.arange(15.0, 42.0, 0.5 * cell)
    rows = []
    for left, right in zip(edges[:-1], edges[1:]):
        inside = (x >= left) & (x < right)
        if inside.any():
            rows.append((0.5 * (left + right),
                         y[inside].min() - 0.25 * cell,
                         y[inside].max() + 0.25 * cell))
    return np.array(rows)


ON_GROUND = "verification/dyke_on_ground.prm"
BASES = [
    ("held at nodes", "chapter5/dyke_weak.prm", {}),
    ("rough wall", ON_GROUND, {"Walls/ground/Type": "rough",
                               "Walls/ground/Friction angle": 0,
                               "Gravity/Tolerance": 1e-4,
                               "Time stepping/Time step": 0.01}),
    ("friction 30°", ON_GROUND, {}),
    ("friction 20°", ON_GROUND, {"Walls/ground/Friction angle": 20}),
]


def first_time(run, column, limit):
    """When a column first falls below a limit (s), nan if never."""
    below = run.statistics[column] < limit
    return float(run.statistics["Time (s)"][below][0]) if below.any() \
        else math.nan


def toe(work):
    """The weak dyke on bases that hold it and on ground with friction: where
    its inner toe is, and how high above the ground (m)."""
    cell, width = 0.25, "Dyke width W (m)"
    figure, panels = plt.subplots(len(BASES), 1, sharex=True,
                                  figsize=(7.5, 1.9 * len(BASES)))
    columns = {name: [] for name in
               ("base", "time_s", "front_m", "ground_front_m", "base_slip_m",
                "crest_m", "width_below_10_m_s", "flooding_s")}
    for (name, file, settings), axes in zip(BASES, panels):
        run = work.run(name.replace(" ", "-").replace("°", ""), file,
                       {"Stop rules/On flooding": "false",
                        "Time stepping/End time": 9, "Output/Interval": 0.5,
                        **settings})
        start = run.points(0.0)
        order = np.argsort(start["id"])
        base = order[(start["position"][order, 1] < 0.3 * cell) &
                     (np.abs(start["position"][order, 0] - 25.0) < 1.0)]
        for time, _ in run.frames():
            points = run.points(time)
            rows = profile(points, cell)
            by_id = {k: i for i, k in enumerate(points["id"])}
            moved = [points["position"][by_id[start["id"][i]], 0] -
                     start["position"][i, 0] for i in base]
            for key, value in zip(columns, (
                    name, time, rows[-1, 0] + 0.25 * cell - 30.0,
                    rows[rows[:, 1] < 0.25 * cell][-1, 0] + 0.25 * cell - 30.0,
                    float(np.mean(moved)),
                    float(run.value("Dyke height H (m)", [time])[0]),
                    first_time(run, width, 10.0),
                    first_time(run, width, 1e-9))):
                columns[key].append(value)
        print("| %s | %.2f s | %.2f s | %s | %.2f m | %.2f m |" % (
            name, columns["width_below_10_m_s"][-1],
            columns["flooding_s"][-1],
            " | ".join("%.2f, %.2f, %.2f m" % tuple(
                run_value for run_value in (
                    columns[key][columns["base"].index(name) + k]
                    for key in ("front_m", "ground_front_m", "base_slip_m")))
                       for k in (6, 12, 18)),
            columns["crest_m"][-1], profile(points, cell)[-1, 1]), flush=True)
        draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                    vmin=0.0, vmax=2.0)
        axes.axhline(0.0, color="k", linewidth=0.8)
        axes.set_xlim(10.0, 40.0)
        axes.set_title(name, fontsize=9, loc="left")
    panels[-1].set_xlabel("x (m)")
    figure.tight_layout()
    save(figure, "contact_toe")
    write_csv("contact_toe", columns)


def main():
    only = option("--only", "block,toe").split(",")
    with workspace(__doc__) as work:
        for study in (block, toe):
            if study.__name__ in only:
                study(work)


if __name__ == "__main__":
    main()
