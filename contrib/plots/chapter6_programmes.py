# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 6.2, how the load grew in four realisations in plane strain, and figure
6.3, how the mean strength grows with depth."""

import csv
import os
import re
import subprocess
import tempfile

import numpy as np
from figure_files import BLUE, GREEN, ORANGE, VERMILLION, plt

PARAMETERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                          "..", "parameters", "chapter6")
EXAMPLES = "load_examples.csv"
COLUMNS = ("example", "realisation", "time_s", "load_m", "settlement_m",
           "settlement_rate_m_per_s")
TITLES = {1: "inherently unstable", 2: "failed in one go",
          3: "held for short, and on", 4: "held for longer, and on"}
COLOURS = {1: VERMILLION, 2: BLUE, 3: GREEN, 4: ORANGE}
TIME_STEP = 0.01  # s
HOLD_ABOVE = 0.05  # m/s, of the load programme
# An example's history ends at this settlement (m).
END = 0.12
# So many steps are skipped in the file; the thesis plots each tenth.
STRIDE = 2
MOST = 60


def pauses(rate, growing):
    """Of the time before the load is stopped: [(steps, largest rate)] of
    times above the limit after which it grew again."""
    found, start = [], None
    for i in np.flatnonzero(growing):
        if rate[i] > HOLD_ABOVE:
            start = i if start is None else start
        elif start is not None:
            found.append((i - start, rate[start:i].max()))
            start = None
    return found


def example_of(load, rate, growing):
    """The number of the example that a history is like, or None."""
    found = pauses(rate, growing)
    if not found:
        return 1 if load[-1] < 0.05 else 2
    if len(found) >= 2 and max(steps for steps, _ in found) <= 10:
        return 3
    if max(steps for steps, _ in found) >= 20:
        return 4
    return None


def statistics(path):
    with open(path, encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file
                 if line.startswith("#")]
    table = np.loadtxt(path)
    return lambda name: table[:, names.index(name)]


def find_examples(waker, data):
    """Computes realisations of analysis 1 in plane strain from 0 on until each
    of the four examples has been met, and puts the first of each in the data
    folder."""
    found = {}
    for realisation in range(MOST):
        with tempfile.TemporaryDirectory() as work:
            run = os.path.join(work, "run")
            changes = {"Cross-section": 4, "Time stepping/End time": 3,
                       "Output/Interval": 0, "Output/Directory": run}
            subprocess.run(
                [waker, "run", os.path.join(PARAMETERS, "analysis1.prm"),
                 "--realisation", str(realisation)]
                + [word for key, value in changes.items()
                   for word in ("--set", f"{key}={value}")],
                check=True, stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL)
            column = statistics(os.path.join(run, "statistics"))
            load = column("Load foundation (m)")
            rate = column("Largest settlement rate (m/s)")
            example = example_of(
                load, rate, column("Load foundation stopped") == 0)
            if example and example not in found:
                settlement = column("Largest settlement (m)")
                end = np.argmax(settlement > END)
                end = (end or len(settlement)) + 1
                found[example] = np.column_stack([
                    np.full(len(load), example),
                    np.full(len(load), realisation), column("Time (s)"), load,
                    settlement, rate])[:end:STRIDE]
        if len(found) == 4:
            break
    with open(os.path.join(data, EXAMPLES), "w", encoding="utf-8",
              newline="") as file:
        file.write("# analysis 1, Cross-section = 4, seed 1: each "
                   f"{STRIDE} steps until {END} m of settlement\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for example in sorted(found):
            writer.writerows([f"{x:.5g}" for x in row]
                             for row in found[example])
    return f"examples of figure 6.2: {sorted(found)}"


def examples(folder, data):
    """Figure 6.2; returns what is missing."""
    path = os.path.join(data, EXAMPLES)
    if not os.path.exists(path):
        return f"not drawn, no {EXAMPLES}: give --waker"
    table = np.genfromtxt(path, delimiter=",", skip_header=2)
    figure = plt.figure(figsize=(10, 3.4))
    grid = figure.add_gridspec(2, 3, height_ratios=(1, 0.08))
    axes = [figure.add_subplot(grid[0, k]) for k in range(3)]
    below = figure.add_subplot(grid[1, :])
    below.axis("off")
    total, step, time = axes
    for axis, letter in zip(axes, "abc"):
        axis.set_title(f"({letter})")
    for example in np.unique(table[:, 0]).astype(int):
        _, realisation, t, load, settlement, rate = table[
            table[:, 0] == example].T
        colour = COLOURS[example]
        for axis, x, y in ((total, settlement, load),
                           (step, TIME_STEP * 1e3 * rate, load),
                           (time, t, load)):
            axis.plot(x, y, "-", color=colour, linewidth=1.1)
            axis.plot(x[::10 // STRIDE], y[::10 // STRIDE], "o", color=colour,
                      markersize=3)
        time.plot([], [], "o-", color=colour, markersize=3, linewidth=1.1,
                  label=f"{example}: {TITLES[example]} "
                  f"(no. {int(realisation[0])})")
    total.set(xlim=(0, END), xlabel="largest settlement (m)",
              ylabel="load (m of soil)")
    total.axvline(0.1, color="black", linewidth=0.7, linestyle=":")
    step.set(xlim=(0, 1.5), xlabel="largest settlement in 0.01 s (mm)")
    step.axvline(1e3 * TIME_STEP * HOLD_ABOVE, color="black", linewidth=0.7,
                 linestyle=":")
    time.set(xlim=(0, None), xlabel="time (s)")
    for axis in axes:
        axis.set_ylim(0, 1.05 * table[:, 3].max())
    below.legend(*time.get_legend_handles_labels(), loc="center", ncol=4)
    figure.savefig(os.path.join(folder, "figure_6_02.png"))
    plt.close(figure)
    missing = sorted(set(TITLES) - set(table[:, 0].astype(int)))
    return f"drawn without example {missing}" if missing else None


def read_trend(analysis):
    """(k, mean at half the height, deviation or coefficient of variation) of a
    parameter file; kPa and m."""
    with open(os.path.join(PARAMETERS, f"analysis{analysis}.prm"),
              encoding="utf-8") as file:
        text = file.read()
    mean = float(re.search(r"Initial strength\s*=\s*([\d.]+)", text)[1])
    trend = re.search(r"set Mean\s*=\s*([\d.]+) \+ ([\d.]+)\*\(0.5 - y\)", text)
    if trend:
        deviation = float(re.search(r"Standard deviation\s*=\s*([\d.]+)  ",
                                    text)[1])
        return float(trend[2]), float(trend[1]), deviation
    variation = float(re.search(r"Coefficient of variation\s*=\s*([\d.]+)",
                                text)[1])
    return 0.0, mean, variation * mean


def trends(folder):
    """Figure 6.3, of the parameter files."""
    figure, axis = plt.subplots(figsize=(4.6, 3.8))
    height = np.linspace(0.0, 1.0, 51)
    for analysis, colour in (("1", BLUE), ("4b", GREEN), ("4c", VERMILLION)):
        k, middle, deviation = read_trend(analysis)
        mean = middle + k * (0.5 - height)
        axis.plot(mean, height - 1.0, color=colour,
                  label=f"k = {k:g} kPa/m")
        axis.fill_betweenx(height - 1.0, np.maximum(mean - deviation, 0.0),
                           mean + deviation, color=colour, alpha=0.15,
                           linewidth=0)
    axis.set(xlim=(0, 8), ylim=(-1, 0), ylabel="z (m)",
             xlabel="undrained shear strength (kPa): "
             "mean, and a standard deviation")
    axis.legend()
    figure.savefig(os.path.join(folder, "figure_6_03.png"))
    plt.close(figure)
