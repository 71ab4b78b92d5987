#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/contact.md; runs the program.

    /usr/bin/python3 contrib/verification/contact.py [--waker build/bin/waker]
        [--only block,toe,pile]
"""

import math

import numpy as np
from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv
import friction_measures as measures

GRAVITY, TAN_SLOPE = 9.81, 0.5
ALONG = np.array([2.0, -1.0]) / math.sqrt(5.0)
BLOCK = "verification/block_on_slope.prm"
FRICTION = "Walls/slope/Friction coefficient"


def acceleration(mu):
    cosine = 1.0 / math.hypot(1.0, TAN_SLOPE)
    return GRAVITY * cosine * max(0.0, TAN_SLOPE - mu)


def block(work):
    """A block on a slope of 1 : 2, with friction above and below tan(beta)."""
    figure, axes = plt.subplots()
    columns = {name: [] for name in
               ("mu", "cell_m", "time_s", "way_m", "expected_m", "friction_kJ",
                "remainder_kJ")}
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
        friction = run.value("Friction on walls (kJ)", times)
        remainder = run.value("Energy remainder (kJ)", times)
        for row in zip(times, ways, expected, friction, remainder):
            for name, value in zip(columns, (mu, cell, *row)):
                columns[name].append(value)
        work_of_friction = (mu * 40.0 / math.hypot(1.0, TAN_SLOPE) * ways[-1])
        print("| %g | %g m | %.4f m | %.4f m | %+.2f %% | %.3f of %.3f kJ | "
              "%.2g kJ |"
              % (mu, cell, ways[-1], expected[-1],
                 100 * (ways[-1] / expected[-1] - 1) if expected[-1] else 0,
                 friction[-1], work_of_friction,
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


def toe(work):
    """The weak dyke on a fixed base and on ground with friction."""
    cases = [("fixed", "chapter5/dyke_weak.prm", {}, 0.25)]
    for angle in (30, 15):
        cases.append((f"ground, {angle}°", "verification/dyke_on_ground.prm",
                      {"Walls/ground/Friction angle": angle}, 0.25))
    figure, panels = plt.subplots(len(cases), 1, sharex=True,
                                  figsize=(7.5, 1.9 * len(cases)))
    names, columns = [], {name: [] for name in
                          ("time_s", "run_out_m", "tip_m", "highest_gap_m",
                           "flooding_s")}
    drawn = []
    for name, file, settings, cell in cases:
        run = work.run(name.split("°")[0].replace(", ", "-"), file,
                       {**settings, "Stop rules/On flooding": "false",
                        "Time stepping/End time": 9, "Output/Interval": 0.5})
        end = run.frames()[-1][0]
        points = run.points()
        rows = profile(points, cell)
        front = points["position"][:, 0].max() + 0.25 * cell
        beyond = rows[rows[:, 0] > 30.0]
        names.append(name)
        for key, value in zip(columns, (
                end, front - 30.0,
                rows[-1, 1], beyond[:, 1].max() if len(beyond) else 0.0,
                run["first_flooding_time"]
                if "first_flooding_time" in run.summary else math.nan)):
            columns[key].append(value)
        print("| %s | %.2f s | %.2f m | %.3f m | %.3f m |"
              % (name, end, front - 30.0, columns["tip_m"][-1],
                 columns["highest_gap_m"][-1]), flush=True)
        drawn.append((name, points))
    for axes, (name, points) in zip(np.atleast_1d(panels), drawn):
        draw_points(axes, points, points["plastic_strain"], cmap="viridis",
                    vmin=0.0, vmax=2.0)
        axes.axhline(0.0, color="k", linewidth=0.8)
        axes.set_xlim(10.0, 40.0)
        axes.set_title(name, fontsize=9, loc="left")
    np.atleast_1d(panels)[-1].set_xlabel("x (m)")
    figure.tight_layout()
    save(figure, "contact_toe")
    write_csv("contact_toe", {"base": names, **columns})


def pile(work):
    """The granular column on a base that only pushes."""
    columns = {name: [] for name in ("base", "front_m", "rms_mm")}
    for name, file, settings in (
            ("fixed", measures.COLUMN, {}),
            ("contact", "verification/granular_column_on_ground.prm", {})):
        run = work.run("pile-" + name, file, settings)
        off = measures.heights(run) - measures.MEASURED[:, 1]
        columns["base"].append(name)
        columns["front_m"].append(measures.front(run))
        columns["rms_mm"].append(1e3 * float(np.sqrt((off**2).mean())))
        print("| %s | %.3f m | %+.1f %% | %.1f mm |"
              % (name, columns["front_m"][-1],
                 100 * (columns["front_m"][-1] / 0.442 - 1),
                 columns["rms_mm"][-1]), flush=True)
    write_csv("contact_pile", columns)


def main():
    only = option("--only", "block,toe,pile").split(",")
    with workspace(__doc__) as work:
        for study in (block, toe, pile):
            if study.__name__ in only:
                study(work)


if __name__ == "__main__":
    main()
