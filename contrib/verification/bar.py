#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/bar.md; runs the program.

    /usr/bin/python3 contrib/verification/bar.py [--waker build/bin/waker]
"""

import argparse
import csv
import os
import sys
import tempfile

import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from bar_vibration import (AMPLITUDE, LENGTH, OMEGA, Vibration,
                           predicted_error, predicted_loss, self_convergence)


def write_csv(name, names, columns):
    with open(os.path.join(DATA, name + ".csv"), "w", encoding="utf-8",
              newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        writer.writerows([f"{value:.6g}" if isinstance(value, float) else value
                          for value in row] for row in zip(*columns))


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
waker = parser.parse_args().waker
folder = tempfile.TemporaryDirectory()


def bar(cells, functions="GIMP", dt=0.0125, **sections):
    return Vibration(waker, ROOT, cells, folder.name,
                     Kinematics_and_mapping={"Functions": functions},
                     Time_stepping={"Time step": dt}, **sections)


# The velocity and the energy of the two cases.
runs = {cells: bar(cells) for cells in (13, 25)}
times = np.arange(0.0, 100.01, 0.5)
exact = AMPLITUDE * np.cos(OMEGA * times)
energy = {cells: np.interp(times, run.time, run.energy)
          for cells, run in runs.items()}
write_csv("bar_history",
          ["time_s", "exact_m_per_s", "cells13_m_per_s", "cells25_m_per_s",
           "cells13_energy", "cells25_energy"],
          [times, exact, runs[13].at(times), runs[25].at(times), energy[13],
           energy[25]])
for cells, run in runs.items():
    print(f"{cells} cells: frequency {100 * run.error:+.3f} %, amplitude "
          f"{run.amplitude:.6f} m/s, energy: end {run.energy[-1]:.5f}, lowest "
          f"{run.energy.min():.5f}")

# What the time step does to frequency and energy.
rows = []
for cells in (13, 25):
    for functions in ("GIMP", "linear"):
        for dt in (0.1, 0.05, 0.025, 0.0125):
            run = bar(cells, functions, dt)
            h = LENGTH / cells
            rows.append((cells, functions, dt, run.error, predicted_error(h, dt),
                         run.loss, predicted_loss(h, dt, 100)))
# The same bar with its free end in the middle of a cell: 12.5 cells.
inside = {"Grid": {"Cell size": 2, "Upper corner": "28, 2"},
          "Soil_profile__bar": {"Polygon": "0, 0; 25, 0; 25, 2; 0, 2"}}
for functions in ("GIMP", "linear"):
    for dt in (0.1, 0.05, 0.025, 0.0125):
        run = bar(13, functions, dt, **inside)
        rows.append((12.5, functions, dt, run.error, predicted_error(2, dt),
                     run.loss, predicted_loss(2, dt, 100)))
names = ["cells", "functions", "time_step_s", "frequency_error",
         "predicted_error", "mapping_loss", "predicted_loss"]
write_csv("bar_time_step", names, zip(*rows))
for row in rows:
    print("{:4g} cells {:6} dt {:<6g} frequency {:+.5f} (predicted {:+.5f}), "
          "loss {:.5f} ({:.5f})".format(*row))

# Order in the time step.
steps = (0.4, 0.2, 0.1, 0.05, 0.025)
differences = {
    functions: self_convergence(
        waker, ROOT, folder.name, steps,
        Kinematics_and_mapping={"Functions": functions})
    for functions in ("GIMP", "linear")}
write_csv("bar_order", ["time_step_s", "gimp_m_per_s", "linear_m_per_s"],
          [list(steps[:-1]), differences["GIMP"], differences["linear"]])
for functions, values in differences.items():
    print(f"{functions}: differences {values}, ratios "
          f"{values[:-1] / values[1:]}")

figure, axes = plt.subplots(1, 3, figsize=(13, 3.8))
fine = np.arange(80, 100, 0.02)
axes[0].plot(fine, AMPLITUDE * np.cos(OMEGA * fine), color="black", linewidth=1,
             label="exact")
axes[0].plot(runs[13].time, runs[13].velocity, "C1--", label="13 cells")
axes[0].plot(runs[25].time, runs[25].velocity, "C0:", label="25 cells")
axes[0].set_xlim(80, 100)
axes[0].set_ylim(-0.075, 0.095)
axes[0].set_xlabel("time (s)")
axes[0].set_ylabel("velocity of the centre of mass (m/s)")
axes[0].set_title("the last two of ten periods", fontsize=10)
axes[0].legend(ncol=3, loc="upper center", fontsize=8)
for cells, colour in ((13, "C1"), (25, "C0")):
    axes[1].plot(runs[cells].time, runs[cells].energy, colour,
                 label=f"{cells} cells")
axes[1].axhline(0.998, color="black", linestyle="--", linewidth=1)
axes[1].set_xlabel("time (s)")
axes[1].set_ylabel("kinetic + elastic energy / start")
axes[1].set_title("energy (dashed: limit)", fontsize=10)
axes[1].legend(fontsize=8)
for functions, marker in (("GIMP", "C0o-"), ("linear", "C3s--")):
    axes[2].loglog(steps[:-1], differences[functions], marker, label=functions)
axes[2].loglog(steps[:-1],
               differences["GIMP"][0] * (np.array(steps[:-1]) / steps[0])**2,
               color="black", linewidth=1, label="second order")
axes[2].set_xticks(steps[:-1], [f"{dt:g}" for dt in steps[:-1]])
axes[2].minorticks_off()
axes[2].set_xlabel("time step (s)")
axes[2].set_ylabel("difference to half the step, rms (m/s)")
axes[2].set_title("velocity over two periods, 25 cells", fontsize=10)
axes[2].legend(fontsize=8)
figure.tight_layout()
save(figure, "bar")
