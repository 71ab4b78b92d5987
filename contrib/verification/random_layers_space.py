#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of random layers in space, for doc/verification/random_layers.md: six
metres of the dyke, on cells of half a metre. Some minutes, and 5 GB; runs the program.

    /usr/bin/python3 contrib/verification/random_layers_space.py [--end 1]
        [--waker build/bin/waker]
"""

import os
import subprocess
import tempfile

import numpy as np
from common import ROOT, plt, save
from dyke_runs import draw_points, option
from random_layers import CASE, PEAT
from waker_case import Run

WIDTH = 6  # m
IN_SPACE = {
    "Dimension": 3, "Grid/Lower corner": "-20, -4, 0",
    "Grid/Upper corner": f"50, 5, {WIDTH}",
    "Boundary conditions/Names": "base, left side, right side, rear, near",
    "Boundary conditions/rear/Region": "back",
    "Boundary conditions/rear/Type": "roller",
    "Boundary conditions/near/Region": "front",
    "Boundary conditions/near/Type": "roller",
    "Output/Grid": "false", "Output/Interval": 0, "Output/Checkpoint interval": 0,
    **{f"Random fields/{name}/Scales of fluctuation": f"24, 1, {WIDTH}"
       for name in ("S", "POP", "phi", "cover")}}


def drawn_and_moved(waker, end):
    """Points at t = 0, and at the end."""
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        words = [waker, "run", CASE, "--realisation", "2", "--overwrite"]
        for key, value in {**IN_SPACE, "Time stepping/End time": end,
                           "Output/Directory": folder}.items():
            words += ["--set", f"{key}={value}"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        run = Run(folder)
        return run.points(0), run.points()


def main():
    end = option("--end", "1")
    waker = option("--waker", os.path.join(ROOT, "build", "bin", "waker"))
    start, points = drawn_and_moved(waker, end)
    x, y, z = start["position"].T
    soft = start["material"] >= PEAT
    S = start["strength_ratio"]
    moved = 1e3 * np.linalg.norm(points["displacement"], axis=1)
    figure, axes = plt.subplots(3, 1, figsize=(9, 5.2), sharex=True,
                                constrained_layout=True)
    for ax, at, across, values, label, high in (
            (axes[0], soft & (abs(z - 3.125) < 0.01), y, S, "S", 0.5),
            (axes[1], soft & (abs(y + 1.125) < 0.01), z, S, "S", 0.5),
            (axes[2], abs(y + 0.125) < 0.01, z, moved, "moved (mm)", None)):
        draw_points(ax, {"position": np.column_stack([x[at], across[at]])},
                    values[at], label, s=6, vmin=0.2 if high else 0, vmax=high,
                    cmap="viridis" if high else "magma")
        ax.set_ylim((-4.1, 0.2) if across is y else (0, WIDTH))
        if across is z:
            ax.set_ylabel("z (m)")
    for ax, title in zip(axes, ("z = 3.1 m", "y = -1.1 m, from above",
                                f"y = -0.1 m, from above, after {end} s")):
        ax.set_title(title, loc="left", fontsize=9)
    axes[2].set_xlabel("x (m)")
    save(figure, "random_layers_space")
    print(f"S from {S[soft].min():.3f} to {S[soft].max():.3f}; points moved by up to "
          f"{moved.max():.0f} mm")


if __name__ == "__main__":
    main()
