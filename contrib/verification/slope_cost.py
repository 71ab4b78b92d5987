#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cost of the slope of chapter 6 against its size: slopes of 1 to 64 m at one cell
size, too weak for their weight, 20 steps each. Writes data/slope_cost.csv and
figures/slope_cost.png. A few minutes of a core that has nothing else to do.

    /usr/bin/python3 contrib/verification/slope_cost.py [WAKER]
"""

import csv
import os
import re
import subprocess
import sys
import tempfile
import threading
import time

from common import DATA, plt, save

LENGTHS = [1, 2, 4, 8, 16, 32, 64]  # m
STEPS = 20


class Memory(threading.Thread):
    """The largest RssAnon of a process (kB), looked at ten times a second."""

    def __init__(self, pid):
        super().__init__(daemon=True)
        self.path, self.largest = f"/proc/{pid}/status", 0
        self.start()

    def run(self):
        try:
            while True:
                with open(self.path, encoding="utf-8") as file:
                    found = re.search(r"RssAnon:\s+(\d+)", file.read())
                if found:
                    self.largest = max(self.largest, int(found.group(1)))
                time.sleep(0.1)
        except OSError:
            pass  # it has ended


def measure(waker, length, folder):
    """Points, us per point and step, bytes per point."""
    settings = {"Grid/Upper corner": f"6, 1.5, {length}",
                "Boundary conditions/far end/To": f"3.5, 10, {length}",
                "Boundary conditions/behind the rear/To":
                f"-0.001, 10, {length + 10}",
                "Materials/clay/Initial strength": 2.5,
                "Time stepping/End time": 0.01 * STEPS,
                "Output/Interval": 0, "Output/Checkpoint interval": 0,
                "Output/Directory": folder}
    command = [waker, "run", "parameters/chapter6/slope.prm", "--overwrite"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    with subprocess.Popen(command, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True) as process:
        memory = Memory(process.pid)
        text = process.stdout.read()
    if process.returncode:
        sys.exit(text)
    n_points = int(re.search(r"points\s+(\d+)", text).group(1))
    cost = float(re.search(r"([\d.]+) us per point and step", text).group(1))
    return n_points, cost, 1024 * memory.largest / n_points


def main():
    waker = sys.argv[1] if len(sys.argv) > 1 else "build/bin/waker"
    table = os.path.join(DATA, "slope_cost.csv")
    with tempfile.TemporaryDirectory() as folder, \
            open(table, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["length_m", "points", "us_per_point_and_step",
                         "bytes_per_point"])
        rows = []
        for length in LENGTHS:
            row = (length, *measure(waker, length, os.path.join(folder, "run")))
            rows.append(row)
            writer.writerow([row[0], row[1], f"{row[2]:.3g}", f"{row[3]:.0f}"])
            print(*row, flush=True)
    costs = [row[2] for row in rows]
    print(f"largest by smallest cost: {max(costs) / min(costs):.2f}")
    figure, axes = plt.subplots(figsize=(5, 3))
    axes.semilogx([row[1] for row in rows], costs, "o-")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("material points")
    axes.set_ylabel("µs per point and step")
    save(figure, "slope_cost")


if __name__ == "__main__":
    main()
