#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/momentum.md; runs the program.

    /usr/bin/python3 contrib/verification/momentum.py [--waker build/bin/waker]
"""

import argparse
import os
import sys
import tempfile

import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from momentum_balance import SETTINGS, WEIGHT, Balance

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
waker = parser.parse_args().waker

runs = {}
with tempfile.TemporaryDirectory() as folder:
    for name, (tolerance, sections) in SETTINGS.items():
        runs[name] = Balance(waker, ROOT, folder, **sections)
        print(f"{name}: {len(runs[name].dt)} steps, largest |dP/dt - F| / "
              f"weight {runs[name].largest_error():.2e} (tolerance "
              f"{tolerance:g}, round-off of the file "
              f"{runs[name].round_off / WEIGHT:.1e})")

shown = runs["tolerance 1e-8"]
np.savetxt(os.path.join(DATA, "momentum.csv"),
           np.column_stack([shown.time[1:]] +
                           [getattr(shown, what)[axis] for axis in "xy"
                            for what in ("rate", "force", "error")]),
           "%.6g", ",", comments="",
           header="time_s," + ",".join(f"{what}_{axis}_kN" for axis in "xy"
                                       for what in ("rate", "force", "error")))

figure, axes = plt.subplots(1, 2, figsize=(11, 3.8))
for axis, colour in (("x", "C0"), ("y", "C3")):
    axes[0].plot(shown.time[1:], shown.rate[axis], colour, linewidth=2,
                 label=f"dP/dt, {axis}")
    axes[0].plot(shown.time[1:], shown.force[axis], "k--", linewidth=0.8)
axes[0].plot([], [], "k--", linewidth=0.8,
             label="weight + water + reaction")
axes[0].set_xlabel("time (s)")
axes[0].set_ylabel("force (kN)")
axes[0].set_title("a coarse, weak dyke until it floods", fontsize=10)
axes[0].legend(fontsize=8)
for name, run in runs.items():
    error = np.maximum(run.error["x"], run.error["y"]) / WEIGHT
    axes[1].semilogy(run.time[1:], np.maximum(error, 1e-13), linewidth=0.8,
                     label=name)
axes[1].set_ylim(1e-13, 1e-1)
axes[1].set_xlabel("time (s)")
axes[1].set_ylabel("|dP/dt - F| / weight")
axes[1].set_title("what is left", fontsize=10)
axes[1].legend(fontsize=8, ncol=2, loc="upper left")
figure.tight_layout()
save(figure, "momentum")
