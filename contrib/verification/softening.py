#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/softening.md: the dyke of chapter 5 with
softening: strengths around failure, factor of safety, and the blocks into which
the failed mass breaks.

    /usr/bin/python3 contrib/verification/softening.py
"""

from common import plt, save
from dyke_runs import draw_points, sampled, workspace, write_csv
import dyke_measures as measures

C_I, C_R = 10.0, 3.85
WIDTH, HEIGHT = "Dyke width W (m)", "Dyke height H (m)"


def text(value):
    return "none" if value is None else f"{value:.2f}"


with workspace(__doc__) as work:
    print("| c_i (kPa) | outcome | initial failure (s) | flooding (s) |")
    for c in (13, 11, 10.5, 10.1):
        run = work.run("run", "chapter5/dyke.prm",
                       {"Output/Interval": 0,
                        **measures.strength(c, c / 2.6)})
        print(f"| {c} | {run['outcome']} | "
              f"{text(run['initial_failure_time'])} | "
              f"{text(run['flooding_time'])} |", flush=True)
    # Without the stop rule of rest: does what is at rest stay there?
    print("| c_i (kPa) | tolerance | initial failure within 40 s |")
    for c in (10.02, 10.04, 10.06, 10.08, 10.1):
        for tolerance in (1e-3, 1e-4):
            run = work.run("run", "chapter5/dyke.prm",
                           {"Output/Interval": 0, "Output/Surface": "false",
                            "Stop rules/At rest": "false",
                            "Stop rules/On initial failure": "true",
                            "Newton/Tolerance": tolerance,
                            **measures.strength(c, c / 2.6)})
            print(f"| {c} | {tolerance} | "
                  f"{text(run['initial_failure_time'])} |", flush=True)
    result = work.factor_of_safety("fos", "chapter5/dyke_fos.prm")
    print(f"factor of safety {result['factor_of_safety']:.3f}: stable at "
          f"{result['highest_stable_factor']:.4f}, fails at "
          f"{result['lowest_failed_factor']:.4f}; {result['trials']} trials")

    run = work.run("weak", "chapter5/dyke_weak.prm", {"Output/Interval": 0.25})
    print(f"| 10 | {run['outcome']} | {text(run['initial_failure_time'])} | "
          f"{text(run['flooding_time'])} |")
    times, columns = sampled(run, [WIDTH, HEIGHT])
    write_csv("softening", {"time_s": times, "W_m": columns[WIDTH],
                            "H_m": columns[HEIGHT]})

    angles = {"time_s": [], "blocks": [], "angle_degrees": []}
    for time, _ in run.frames():
        blocks = measures.Blocks(run.points(time), C_I, C_R)
        band = blocks.band_before_toe()
        if band is not None:
            for key, value in zip(angles, (time, len(blocks) - 1, band[1])):
                angles[key].append(value)
            print(f"t = {time:.2f} s: band at {band[1]:.1f} degrees over "
                  f"{len(band[0])} rows of cells; parts of "
                  + ", ".join(f"{area:.1f}" for area in blocks.areas)
                  + " m^2")
    write_csv("softening_band", angles, 4)

    figure, axes = plt.subplots(3, 1, figsize=(10, 7.6))
    for ax, time in zip(axes, (4.5, None)):
        points = run.points(time)
        draw_points(ax, points, points["undrained_shear_strength"],
                    "strength (kPa)", cmap="viridis")
        for segment in run.surface(time):
            ax.plot(segment[:, 0], segment[:, 1], color="red", linewidth=0.8)
        ax.plot([-6, 36], [0, 0], color="black", linewidth=2)
        ax.set_xlim(-4, 35)
        ax.set_title(f"t = {run.frame(time)[0]:.2f} s", fontsize=10)
        if time is not None:
            middle, angle = measures.Blocks(points, C_I, C_R).band_before_toe()
            ax.plot(*middle.T, color="red", linewidth=2)
            ax.annotate(f"{angle:.0f}°", middle.mean(axis=0) + (0.8, -0.7),
                        fontsize=12)
    axes[2].plot(times, columns[WIDTH], label="width W")
    axes[2].plot(times, columns[HEIGHT], label="height H")
    axes[2].axvspan(2.5, 4.5, color="grey", alpha=0.2,
                    label="expected start of failure")
    axes[2].set_xlabel("time (s)")
    axes[2].set_ylabel("(m)")
    axes[2].legend(loc="lower left")
    figure.tight_layout()
    save(figure, "softening")
