#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/sliding_masses.md; runs the program.

    /usr/bin/python3 contrib/verification/sliding_masses.py [--waker PROGRAM]
        [--campaign FOLDER]
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
parser.add_argument("--campaign", help="folder of a campaign, to compare its "
                    "slides by W and H with its sliding masses")
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

masses = sliding["masses"]
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
if arguments.campaign:
    with h5py.File(os.path.join(arguments.campaign, "results.h5")) as store:
        for i, number in enumerate(store["realisation"]):
            print(f"realisation {number}:", ", ".join(
                f"{name} {store[name][0, i]:.4g}" for name in (
                    "n_slides", "n_masses", "n_masses_remnant",
                    "initial_failure_time", "first_mass_time",
                    "relative_failure_volume", "retrogression_distance")))

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
axes[2].set_xlabel("time (s); lines: masses break loose")
axes[2].legend(fontsize=8)
figure.tight_layout()
save(figure, "sliding_masses")
