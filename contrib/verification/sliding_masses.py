#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/sliding_masses.md; runs the program.

    /usr/bin/python3 contrib/verification/sliding_masses.py [--waker PROGRAM]
"""

import argparse
import os
import sys
import tempfile

import h5py
import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from waker_case import Workspace

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
arguments = parser.parse_args()

FILE = "chapter5/dyke_weak.prm"
with tempfile.TemporaryDirectory() as folder, \
        Workspace(arguments.waker, ROOT, folder=folder) as workspace:
    run = workspace.run("run", FILE)
    sliding = run["sliding_masses"]
    points = run.points()
    rows = {name: run.statistics[name] for name in (
        "Time (s)", "Dyke width W (m)", "Dyke height H (m)",
        "Relative failure volume", "Retrogression distance (m)")}
    # The same dyke as a campaign of one: its slides by W and H.
    campaign = workspace.call("campaign", "campaign", FILE,
                              {"Campaign/Realisations": 1})
    with h5py.File(os.path.join(campaign, "results.h5")) as store:
        slides = [[float(store[name][0, 0, k]) for name in (
            "slide_start", "slide_end", "slide_width", "slide_height")]
            for k in range(int(store["n_slides"][0, 0]))]
        n_masses = int(store["n_masses"][0, 0])

masses = sliding["masses"]
assert n_masses == len(masses), "a run and its record differ"
with open(os.path.join(DATA, "sliding_masses.csv"), "w",
          encoding="utf-8") as file:
    file.write("mass,time_s,volume_m2,x_m,y_m,x_from_m,x_to_m\n")
    for k, mass in enumerate(masses):
        file.write(f"{k + 1}," + ",".join(f"{mass[key]:.5g}" for key in (
            "time", "volume", "x", "y", "x_from", "x_to")) + "\n")
for k, mass in enumerate(masses):
    print(f"mass {k + 1}: t = {mass['time']:.2f} s, {mass['volume']:.2f} m^2, "
          f"x from {mass['x_from']:.2f} to {mass['x_to']:.2f} m")
print(f"relative failure volume {sliding['relative_failure_volume']:.3f}, "
      f"retrogression {sliding['retrogression_distance']:.2f} m")
for start, end, width, height in slides:
    print(f"slide by W and H: {start:.2f} to {end:.2f} s, then W = {width:.2f} "
          f"m, H = {height:.2f} m")

figure, axes = plt.subplots(3, 1, figsize=(9, 9),
                            gridspec_kw={"height_ratios": (1, 1, 1.1)})
colours = plt.get_cmap("tab20")(np.arange(len(masses) + 1) % 20)
colours[0] = (0.75, 0.75, 0.75, 1)
order = points["slide"].astype(int)
start = points["position"] - points["displacement"]
for axis, place, title in (
        (axes[0], start, "where they came from"),
        (axes[1], points["position"], f"at t = {run['end_time']:.2f} s")):
    axis.scatter(place[:, 0], place[:, 1], s=2, c=colours[order],
                 linewidths=0)
    axis.set_aspect("equal")
    axis.set_xlim(-3, 42)
    axis.set_ylabel("y (m)")
    axis.set_title(f"stable soil (grey) and sliding masses, {title}",
                   fontsize=10)
axes[2].plot(rows["Time (s)"], rows["Dyke width W (m)"], "C0", label="W (m)")
axes[2].plot(rows["Time (s)"], 2 * rows["Dyke height H (m)"], "C1",
             label="2 H (m)")
axes[2].plot(rows["Time (s)"], 10 * rows["Relative failure volume"], "k",
             label="10 times the relative failure volume")
for k, mass in enumerate(masses):
    axes[2].axvline(mass["time"], color=colours[k + 1], linewidth=1)
for start_time, end_time, _, _ in slides:
    axes[2].axvspan(start_time, end_time, color="C0", alpha=0.15, linewidth=0)
axes[2].set_xlabel("time (s); lines: masses break loose; shaded: slides by W "
                   "and H")
axes[2].legend(fontsize=8)
figure.tight_layout()
save(figure, "sliding_masses")
