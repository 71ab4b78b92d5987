#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/strength_from_stress.md; runs the
program for some minutes.

    /usr/bin/python3 contrib/verification/strength_from_stress.py [--waker ...]
"""

import numpy as np
from common import plt, save
from dyke_runs import draw_points, workspace, write_csv

CASE = "verification/dyke_shansep.prm"
LEVELS = (0.5, 1.5, 2.5, 3.0, 3.5)  # m; the first one is that of a usual day
DAILY = "-20, 0.5; 1.5, 0.5; 28, -0.3; 50, -0.3"


def line(level):
    """From the water on the outer slope, 1:3, down to the inner toe."""
    if level == LEVELS[0]:
        return DAILY
    return f"-20, {level:g}; {3 * level:g}, {level:g}; 28, 0; 50, 0"


def factors(work):
    rows = []
    for level in LEVELS:
        result = work.factor_of_safety(f"level {level:g}", CASE, {
            "Water/Level": level, "Pore water/Phreatic line": line(level),
            "Strength reduction/Tolerance": 0.02})
        rows.append((level, result["highest_stable_factor"],
                     result["lowest_failed_factor"]))
        print("| %g | %.3f | %.3f |" % rows[-1], flush=True)
    return rows


def draw_strengths(work):
    """s_u and OCR at the start, of high water and of a usual day."""
    figure, axes = plt.subplots(3, 1, figsize=(9, 6.5), sharex=True)
    strengths = []
    for ax, level in zip(axes, (LEVELS[0], LEVELS[-1])):
        points = work.run(f"start {level:g}", CASE, {
            "Water/Level": level, "Pore water/Phreatic line": line(level),
            "Time stepping/End time": 0}).points(0)
        strengths.append(points["undrained_shear_strength"])
        draw_points(ax, points, strengths[-1], "s_u (kPa)", vmin=0, vmax=25)
        ax.set_title(f"water at {level:g} m", loc="left", fontsize=9)
    draw_points(axes[2], points, strengths[1] / strengths[0],
                "s_u now / of a day", vmin=0.6, vmax=1, cmap="magma")
    for ax in axes:
        ax.set_ylim(-4.1, 4.5)
    axes[2].set_xlabel("x (m)")
    save(figure, "strength_from_stress")
    return strengths


def main():
    with workspace(__doc__) as work:
        daily, high = draw_strengths(work)
        print("s_u of a day: %.3g to %.3g kPa; now %.3g to %.3g of it"
              % (daily.min(), daily.max(), np.min(high / daily),
                 np.max(high / daily)))
        rows = factors(work)
    write_csv("strength_from_stress",
              dict(zip(("level_m", "stable", "fails"), zip(*rows))))


if __name__ == "__main__":
    main()
