#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/contact.md; runs the program.

    /usr/bin/python3 contrib/verification/contact.py [--waker build/bin/waker]
        [--only block,toe,toe_cells] [--cells 0.5,0.25]
"""

import math

import numpy as np
from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv
from block_measures import (CASE, FRICTION, TAN_SLOPE, acceleration, fitted, speed,
                            way)
from toe_measures import (END, HELD, ON_GROUND, cells, cells_on_ground, fronts,
                          profile)


def block(work):
    """A block on a slope of 1 : 2, with friction above and below tan(beta)."""
    figure, axes = plt.subplots()
    columns = {name: [] for name in
               ("mu", "cell_m", "time_s", "way_m", "expected_m", "speed_m_s",
                "friction_kJ", "remainder_kJ")}
    for mu, cell in ((0.0, 0.25), (0.3, 0.5), (0.3, 0.25), (0.3, 0.125),
                     (0.45, 0.25), (0.6, 0.25)):
        run = work.run(f"block-{mu}-{cell}", CASE,
                       {FRICTION: mu, "Grid/Cell size": cell,
                        "Time stepping/Time step": 0.02 * cell,
                        "Gravity/Initial stress":
                            "true" if mu > TAN_SLOPE else "false"})
        times = [time for time, _ in run.frames()]
        ways = [way(run, time) for time in times]
        expected = [0.5 * acceleration(mu) * time**2 for time in times]
        speeds = speed(run, times)
        slope = fitted(run)
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


def cells_on_rough(size):
    """Of ground that sticks: the time step of held nodes."""
    return {**cells_on_ground(size), **cells(size)}


BASES = [
    ("held at nodes", HELD, cells, {}),
    ("rough wall", ON_GROUND, cells_on_rough,
     {"Walls/ground/Type": "rough", "Walls/ground/Friction angle": 0,
      "Gravity/Tolerance": 1e-4}),
    ("friction 30°", ON_GROUND, cells_on_ground, {}),
    ("friction 20°", ON_GROUND, cells_on_ground,
     {"Walls/ground/Friction angle": 20}),
]
WIDTH, HEIGHT = "Dyke width W (m)", "Dyke height H (m)"


def first_time(run, column, limit):
    """When a column first falls below a limit (s), nan if never."""
    below = run.statistics[column] < limit
    return float(run.statistics["Time (s)"][below][0]) if below.any() \
        else math.nan


def toe_run(work, base, cell):
    name, file, grid, settings = base
    return work.run(f"{name}-{cell:g}".replace(" ", "-").replace("°", ""), file,
                    {**END, **grid(cell), "Time stepping/End time": 9,
                     "Output/Interval": 0.5, **settings})


def toe(work):
    """The weak dyke on bases that hold it and on ground with friction: where
    its inner toe is, and how high above the ground (m)."""
    cell = 0.25
    figure, panels = plt.subplots(len(BASES), 1, sharex=True,
                                  figsize=(7.5, 1.9 * len(BASES)))
    columns = {name: [] for name in
               ("base", "time_s", "front_m", "ground_front_m", "base_slip_m",
                "crest_m", "width_below_10_m_s", "flooding_s")}
    for base, axes in zip(BASES, panels):
        name, run = base[0], toe_run(work, base, cell)
        start = run.points(0.0)
        order = np.argsort(start["id"])
        lowest = order[(start["position"][order, 1] < 0.3 * cell) &
                       (np.abs(start["position"][order, 0] - 25.0) < 1.0)]
        for time, _ in run.frames():
            points = run.points(time)
            by_id = {k: i for i, k in enumerate(points["id"])}
            moved = [points["position"][by_id[start["id"][i]], 0] -
                     start["position"][i, 0] for i in lowest]
            for key, value in zip(columns, (
                    name, time, *fronts(profile(points, cell), cell)[:2],
                    float(np.mean(moved)),
                    float(run.value(HEIGHT, [time])[0]),
                    first_time(run, WIDTH, 10.0),
                    first_time(run, WIDTH, 1e-9))):
                columns[key].append(value)
        first = columns["base"].index(name)
        print("| %s | %s |" % (name, " | ".join(
            "%.2f m" % columns["base_slip_m"][first + k] for k in (6, 12, 18))),
              flush=True)
        draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                    vmin=0.0, vmax=2.0)
        axes.axhline(0.0, color="k", linewidth=0.8)
        axes.set_xlim(10.0, 40.0)
        axes.set_title(name, fontsize=9, loc="left")
    panels[-1].set_xlabel("x (m)")
    figure.tight_layout()
    save(figure, "contact_toe")
    write_csv("contact_toe", columns)


def toe_cells(work, sizes):
    """The same on cells of other sizes: the table."""
    rows = []
    for cell in sizes:
        for base in BASES:
            run = toe_run(work, base, cell)
            at = [fronts(profile(run.points(time), cell), cell)
                  for time in (3, 6, 9)]
            rows.append((base[0], cell, first_time(run, WIDTH, 10.0),
                         first_time(run, WIDTH, 1e-9), at[0][0], at[1][0],
                         *at[2], float(run.value(HEIGHT, [9])[0])))
            print("| %s | %g m | %.2f s | %.2f s | %.1f m | %.1f m | %.1f m | "
                  "%.1f m | %.2f m | %.2f m |" % rows[-1], flush=True)
    write_csv("contact_toe_cells", dict(zip(
        ("base", "cell_m", "width_below_10_m_s", "flooding_s", "front_3_s_m",
         "front_6_s_m", "front_9_s_m", "ground_front_9_s_m", "tip_9_s_m",
         "crest_9_s_m"), zip(*rows))), digits=4)


def main():
    only = option("--only", "block,toe,toe_cells").split(",")
    sizes = [float(c) for c in option("--cells", "0.5,0.25").split(",")]
    with workspace(__doc__) as work:
        for study in (block, toe):
            if study.__name__ in only:
                study(work)
        if "toe_cells" in only:
            toe_cells(work, sizes)


if __name__ == "__main__":
    main()
