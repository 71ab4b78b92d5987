#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data and numbers of "A dyke in space", doc/verification/three_dimensions.md, from the
folders of runs of parameters/chapter6/half_dyke.prm.

    /usr/bin/python3 contrib/verification/half_dyke.py NAME=FOLDER [NAME=FOLDER ...]

Writes doc/verification/data/half_dyke.csv: width and height, the places of their
sections, sliding masses, every 0.1 s and at the end; remainders are the largest so far.
"""

import json
import os
import sys

import numpy as np
from dyke_runs import write_csv

LENGTH = 10.0  # m
STEP = 0.1  # s, of the table


def read(folder):
    """{column: values} of the statistics, and the summary."""
    path = os.path.join(folder, "statistics")
    with open(path, encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file
                 if line.startswith("#")]
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return dict(zip(names, np.loadtxt(path).T)), summary


def weight(folder):
    """kN, of the mass that the log gives."""
    with open(os.path.join(folder, "log.txt"), encoding="utf-8") as file:
        words = next(line for line in file if "Mg" in line).split()
    return 9.81 * float(words[words.index("Mg,") - 1])


def momentum_remainder(rows, own_weight, axis):
    """Momentum less what weight, water and reactions gave under the ramp of one
    second (kN s), of each row."""
    time = rows["Time (s)"]
    force = rows[f"Reaction {axis} (kN)"]
    if axis != "z":
        force = force + LENGTH * rows[f"Water force {axis} (kN)"]
    if axis == "y":
        force = force - own_weight
    force = np.minimum(time, 1) * force
    given = np.cumsum(0.5 * (force[2:] + force[1:-1]) * np.diff(time[1:]))
    moved = rows[f"Momentum {axis} (kN s)"]
    return np.concatenate([[0, 0], moved[2:] - moved[1] - given])


def largest(values):
    """So far."""
    return np.maximum.accumulate(np.abs(values))


def main():
    columns = {key: [] for key in (
        "run", "time_s", "width_m", "z_of_width_m", "height_m", "z_of_height_m",
        "sliding_masses", "energy_remainder_kJ", "momentum_remainder_x_kNs",
        "momentum_remainder_y_kNs", "momentum_remainder_z_kNs")}
    for argument in sys.argv[1:]:
        name, folder = argument.split("=", 1)
        rows, summary = read(folder)
        own_weight, time = weight(folder), rows["Time (s)"]
        remainders = [largest(momentum_remainder(rows, own_weight, axis))
                      for axis in "xyz"]
        if summary["outcome"] == "flooding":
            # The water of the last row is that of after the flood.
            for remainder in remainders:
                remainder[-1] = remainder[-2]
        energy = largest(rows["Energy remainder (kJ)"])
        values = (time, rows["Dyke width W (m)"], rows["z of W (m)"],
                  rows["Dyke height H (m)"], rows["z of H (m)"],
                  rows["Sliding masses"], energy, *remainders)
        wanted = np.unique(np.append(
            [np.argmin(np.abs(time - t)) for t in np.arange(0, time[-1], STEP)],
            len(time) - 1))
        columns["run"] += [name] * len(wanted)
        for key, value in zip(list(columns)[1:], values):
            columns[key] += list(value[wanted])

        masses = summary["sliding_masses"]["masses"]
        print(f"{name}: {summary['outcome']} ({summary['stop_reason']}), "
              f"{summary['end_time']:.2f} s; W {summary['initial_width']:.2f} -> "
              f"{summary['residual_width']:.2f} m, H "
              f"{summary['residual_height']:.2f} m; {len(masses)} masses")
        for mass in masses[:3]:
            print(f"  {mass['time']:.2f} s: z from {mass['z_from']:.2f} to "
                  f"{mass['z_to']:.2f} m")
        place = rows["z of W (m)"]
        away = time[place > place[0]]
        print(f"  W at z = {place[0]:.3f} m" + (
            f", but from {away[0]:.2f} to {away[-1]:.2f} s at "
            f"{place.max():.3f} m" if len(away) else "") + "; W at 2 s "
            f"{rows['Dyke width W (m)'][np.argmin(np.abs(time - 2))]:.2f} m; "
            f"least H {np.nanmin(rows['Dyke height H (m)']):.3f} m")
        print("  momentum remainders " + " / ".join(
            f"{r[-1]:.2f}" for r in remainders) + " of " + " / ".join(
                f"{np.abs(rows[f'Momentum {a} (kN s)']).max():.0f}"
                for a in "xyz") + f" kN s; energy {energy[-1]:.2f} of "
            f"{rows['Plastic dissipation (kJ)'][-1]:.0f} kJ; "
            f"{summary['newton_iterations']} Newton iterations, "
            f"{summary['unconverged_steps']} unconverged")
    write_csv("half_dyke", columns)


if __name__ == "__main__":
    main()
