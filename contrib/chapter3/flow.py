#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflow and outflow: the balances of mass and momentum
(doc/verification/flow.md)."""

import numpy as np
from common import Runs, parse_arguments, plt, save, save_data, save_numbers

RATE = 0.5 * 1.0 * 18.0 / 9.81  # Mg/s through the mouth
TOLERANCES = (1e-3, 1e-5, 1e-8)


def largest(values):
    return float(f"{np.abs(values).max():.2g}")


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers, columns = {}, {}
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.8))
    for tolerance in TOLERANCES:
        rows = runs.run(f"flow/{tolerance:g}", "flow.prm", {
            "Newton/Tolerance": tolerance, "Output/Interval": 0}).statistics
        time = rows["Time (s)"]
        remainder = np.hypot(rows["Momentum remainder x (kN s)"],
                             rows["Momentum remainder y (kN s)"])
        axes[1].semilogy(time[1:], np.maximum(remainder[1:], 1e-12),
                         label=f"Newton tolerance {tolerance:g}")
        name = f"tolerance {tolerance:g}: "
        numbers[name + "largest mass remainder (Mg)"] = largest(
            rows["Mass remainder (Mg)"])
        numbers[name + "largest momentum remainder (kN s)"] = largest(remainder)
        numbers[name + "energy remainder at the end (kJ)"] = round(
            float(rows["Energy remainder (kJ)"][-1]), 5)
        columns["time_s"] = time.tolist()
        columns[f"momentum_remainder_kNs_{tolerance:g}"] = remainder.tolist()
    for key, column in (("mass_Mg", "Mass (Mg)"), ("in_Mg", "Mass in (Mg)"),
                        ("out_Mg", "Mass out (Mg)")):
        columns[key] = rows[column].tolist()
        axes[0].plot(time, rows[column], label=column)
    full = time > 14.0
    numbers["mass in the grid, 14 to 20 s: least, largest (Mg)"] = [
        round(float(rows["Mass (Mg)"][full].min()), 3),
        round(float(rows["Mass (Mg)"][full].max()), 3)]
    fit = np.polyfit(time[full], rows["Mass out (Mg)"][full], 1)[0]
    numbers["rate of mass out, 14 to 20 s, over the rate in"] = round(
        float(fit / RATE), 4)
    numbers["momentum in the grid at the end (kN s)"] = round(
        float(rows["Momentum x (kN s)"][-1]), 4)
    axes[0].set_ylabel("mass (Mg)")
    axes[1].set_ylabel("momentum remainder (kN s)")
    for axis in axes:
        axis.set_xlabel("time (s)")
        axis.legend(fontsize=8)
    save(figure, "flow")
    save_data("flow", columns)
    save_numbers("flow", numbers)


if __name__ == "__main__":
    main()
