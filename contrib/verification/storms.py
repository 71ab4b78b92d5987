#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and numbers of doc/verification/storms.md: dykes in a storm of hours.

    /usr/bin/python3 contrib/verification/storms.py [PART ...]

Parts (default: all): storm (pictures), steps (their lengths), dynamic (the same in compressed time, all
of it in short steps), fall (drawdown), path (a rise against a level that always was).
"""

import re
import sys

import numpy as np
from common import plt, save
from dyke_runs import draw_points, workspace, write_csv

CASE = "verification/dyke_storm.prm"
STORM = [(0, 3), (3600, 1.5), (14400, 4.6), (21600, 3)]  # s, m
WIDE = {"Soil profile/dyke/Polygon": "0, 0; 35, 0; 20, 5; 10, 5"}
# Coarse, and as near to failure.
COARSE = {"Grid/Cell size": 0.5, "Materials/clay/Initial strength": 9.4,
          "Materials/clay/Residual strength": 3.62, "Output/Interval": 0}


def level(time, storm):
    return np.interp(time, *np.transpose(storm))


def rise(storm, factor=1.0):
    """Water/Rise over 1.5 m, the time divided by a factor."""
    return ", ".join(f"{t / factor:g}: {y - 1.5:g}" for t, y in storm)


def events(run, storm, factor=1.0):
    """Time in the storm (s) and level (m) of slide and flooding."""
    slide = run["initial_failure_time_displacement"]
    flood = run["flooding_time"]
    result = []
    for time in (slide, flood):
        time = np.nan if time is None else time * factor
        result += [time, level(time, storm) if np.isfinite(time) else np.nan]
    return result


def tell(name, run, storm=None, factor=1.0):
    values = events(run, storm or STORM, factor)
    print(f"  {name}: {run['outcome']}, slide {values[0]:.0f} s at {values[1]:.3f} m, "
          f"flooding {values[2]:.0f} s at {values[3]:.3f} m; H {run['residual_height']:.2f} m, "
          f"{run['steps']} steps, {run['long_steps']} long, {run['motions']} motions, "
          f"{run['wall_time']:.0f} s", flush=True)
    return values


def picture(axes, run, time, storm):
    time = run.frame(time)[0]
    points = run.points(time)
    draw_points(axes, points, points["plastic_strain"], cmap="viridis", vmin=0,
                vmax=1, s=1.2)
    y = level(time, storm)
    top = run.surface(time).reshape(-1, 2)
    crest = top[np.argmax(top[:, 1]), 0]
    wet = top[(top[:, 1] < y) & (top[:, 0] < crest), 0].max()
    axes.fill_between([-8, wet], 0, y, color="tab:blue", alpha=0.25, zorder=0)
    axes.axhline(4.6, color="tab:red", linewidth=0.6, linestyle=":")
    axes.set(xlim=(-4, 36), ylim=(-0.1, 5.6), ylabel="")
    axes.set_title(f"{time / 3600:.2f} h, water at {y:.2f} m", loc="left", fontsize=8)
    axes.tick_params(labelsize=7)


def storm(work):
    """Two dykes in the storm of the example."""
    figure, axes = plt.subplots(5, 2, figsize=(10, 7),
                                gridspec_kw={"height_ratios": [1, 1, 1, 1, 1.6]})
    columns = {"dyke": [], "time_s": [], "level_m": [], "H_m": [], "W_m": [], "dt_s": []}
    for k, (name, sets) in enumerate((("crest 5 m", {}), ("crest 10 m", WIDE))):
        run = work.run(f"storm{k}", CASE, sets)
        tell(name, run)
        for axis, time in zip(axes[:4, k], (0, 2400, 12000, None if k == 0 else 14400)):
            picture(axis, run, time, STORM)
        rows = run.statistics
        time = rows["Time (s)"]
        axis = axes[4, k]
        axis.plot(time / 3600, level(time, STORM), color="tab:blue", label="water")
        axis.plot(time / 3600, rows["Dyke height H (m)"], color="k", label="H")
        axis.set(xlabel="hours", ylabel="m", xlim=(0, 6), ylim=(1, 5.5))
        axis.legend(fontsize=7, loc="lower right")
        axes[0, k].set_title(name + "; " + axes[0, k].get_title(loc="left"), loc="left",
                             fontsize=8)
        # All long steps, and of the short ones every tenth.
        keep = (rows["Time step (s)"] > 0.02) | (np.arange(len(time)) % 10 == 0)
        columns["dyke"] += [name] * int(keep.sum())
        for key, values in (("time_s", time), ("level_m", level(time, STORM)),
                            ("H_m", rows["Dyke height H (m)"]),
                            ("W_m", rows["Dyke width W (m)"]),
                            ("dt_s", rows["Time step (s)"])):
            columns[key] += list(values[keep])
        work_of_weight = rows["Potential energy released (kJ)"]
        print(f"    energy: remainder {rows['Energy remainder (kJ)'][-1]:.2f} kJ, "
              f"released {work_of_weight[-1]:.1f} kJ, "
              f"lost in mapping {rows['Mapping loss (kJ)'][-1]:.2f} kJ")
    figure.tight_layout()
    save(figure, "storms")
    write_csv("storms", columns, digits=8)


def steps(work):
    """The lengths of long and short steps."""
    time = "Time stepping/"
    variants = {"as it is": {},
                "Longest step 150 s, Largest rise 0.025 m":
                    {time + "Longest step": 150, time + "Largest rise": 0.025},
                "Largest rise 0.1 m": {time + "Largest rise": 0.1},
                "Largest displacement 0.005 m": {time + "Largest displacement": 0.005},
                "Largest displacement 0.02 m": {time + "Largest displacement": 0.02},
                "Time step 0.005 s": {time + "Time step": 0.005},
                "Tolerance 1e-5": {"Newton/Tolerance": 1e-5}}
    rows = {"variant": [], "slide_s": [], "slide_level_m": [], "flooding_s": [],
            "flooding_level_m": [], "H_m": []}
    for k, (name, sets) in enumerate(variants.items()):
        run = work.run(f"steps{k}", CASE, {**COARSE, **sets})
        values = tell(name, run)
        for key, value in zip(rows, [name, *values, run["residual_height"]]):
            rows[key].append(value)
    write_csv("storms_steps", rows, digits=8)


def dynamic(work):
    """All in short steps, the storm compressed."""
    rows = {"scheme": [], "factor": [], "slide_s": [], "slide_level_m": [],
            "flooding_s": [], "flooding_level_m": []}
    for k, factor in enumerate((1, 10, 20, 50, 100, 200)):
        sets = dict(COARSE)
        if factor > 1:
            sets.update({"Time stepping/Scheme": "Newmark",
                         "Time stepping/End time": 21600 / factor,
                         "Water/Rise": rise(STORM, factor)})
        run = work.run(f"dynamic{k}", CASE, sets)
        name = "long steps" if factor == 1 else "Newmark"
        values = tell(f"{name}, time divided by {factor}", run, factor=factor)
        for key, value in zip(rows, [name, factor, *values]):
            rows[key].append(value)
    write_csv("storms_dynamic", rows, digits=8)


def fall(work):
    """Water that only falls, fast and slowly, in steps of any kind."""
    rows = {"hours": [], "slide_s": [], "slide_level_m": []}
    for hours in (1, 6, 24):
        falls = [(0, 3), (hours * 3600, 1)]
        run = work.run(f"fall{hours}", CASE, {
            **COARSE, "Water/Level": 1.5, "Water/Rise": rise(falls),
            "Time stepping/End time": hours * 3600})
        values = tell(f"fall of 2 m in {hours} h", run, falls)
        print(f"    slope: {run['slope']}")
        for key, value in zip(rows, [hours, *values[:2]]):
            rows[key].append(value)
    write_csv("storms_fall", rows, digits=8)


def difference(a, b, away):
    """rms of the stresses' differences over that of the stress."""
    names = ("stress_xx", "stress_yy", "stress_xy")
    return np.sqrt(sum(np.sum((a[s][away] - b[s][away])**2) for s in names)
                   / sum(np.sum(b[s][away]**2) for s in names))


def path(work):
    """A level that was reached slowly, and one that always was."""
    rows = {"case": [], "difference": [], "of_the_change": [], "displacement_m": []}
    rest = {"Time stepping/Scheme": "quasi-static at rest", "Newton/Tolerance": 1e-5,
            "Output/Interval": 0, "Stop rules/At rest": "false"}
    clay = {**COARSE, **rest}
    yields = {**clay, "Materials/clay/Initial strength": 9.6,
              "Materials/clay/Residual strength": 9.6,
              "Materials/clay/Softening modulus": 0}
    cases = {
        "elastic clay, 3 to 4.5 m": (CASE, {**clay, "Materials/clay/Initial strength": 100},
                                     3, 4.5, 3600),
        "elastic clay, ten times as stiff":
            (CASE, {**clay, "Materials/clay/Initial strength": 100,
                    "Materials/clay/Young's modulus": 10000}, 3, 4.5, 3600),
        "clay that yields, 3 to 4.5 m": (CASE, yields, 3, 4.5, 3600)}
    for name, (file, sets, low, high, end) in cases.items():
        ends = {}
        base = 1.5
        for kind, text in (("rose", f"0: {low - base}, {end}: {high - base}"),
                           ("stood", f"{high - base}"), ("low", f"{low - base}")):
            run = work.run(re.sub(r"\W", "_", name) + kind, file, {
                **sets, "Water/Rise": text, "Time stepping/End time": end})
            tell(f"{name}, {kind}", run, [(0, low), (end, high)])
            ends[kind] = run.points()
        x0 = ends["stood"]["position"] - ends["stood"]["displacement"]
        x, y = x0[:, 0], x0[:, 1]
        surface = np.minimum(np.minimum(x / 2, (30 - x) / 3), 5)
        away = y < surface - 1
        d = difference(ends["rose"], ends["stood"], away)
        whole = difference(ends["low"], ends["stood"], away)
        moved = np.linalg.norm(ends["rose"]["displacement"], axis=1).max()
        print(f"  {name}: {100 * d:.3f} % of {100 * whole:.1f} %, {away.sum()} points, "
              f"moved {moved:.4f} m")
        for key, value in zip(rows, [name, d, whole, moved]):
            rows[key].append(value)
    write_csv("storms_path", rows)


PARTS = {"storm": storm, "steps": steps, "dynamic": dynamic, "fall": fall, "path": path}


def main():
    parts = [word for word in sys.argv[1:] if word in PARTS]
    for word in parts:
        sys.argv.remove(word)
    with workspace(__doc__) as work:
        for part in parts or PARTS:
            print(part, flush=True)
            PARTS[part](work)


if __name__ == "__main__":
    main()
