#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/crossing.md; runs the program.

    /usr/bin/python3 contrib/verification/crossing.py [--waker build/bin/waker]
"""

import argparse
import os
import sys
import tempfile

import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from cell_crossing import Crossing
from runs import statistics

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
waker = parser.parse_args().waker

runs = {}
with tempfile.TemporaryDirectory() as folder:
    def crossing(name, **sections):
        run = Crossing(waker, ROOT, folder, **sections)
        rows = statistics(folder)
        energy = rows["Kinetic energy (kJ)"] + rows["Elastic energy (kJ)"]
        print(f"{name}: error of the stress, rms {run.error():.5f}, largest "
              f"{run.largest_error():.5f}; energy at 5 s / start "
              f"{energy[-1] / energy[0]:.5f}")
        return run

    for functions in ("GIMP", "linear"):
        runs[functions] = crossing(
            functions, Kinematics_and_mapping={"Functions": functions})
    # Half the strain and half the cells: the points cross as many cells.
    crossing("GIMP, half the strain and half the cell size", velocity=0.05,
             Grid={"Cell size": 0.0625, "Upper corner": "25.25, 0.0625"},
             Soil_profile__bar={
                 "Polygon": "0, 0; 25, 0; 25, 0.0625; 0, 0.0625",
                 "Velocity": "0.05*sin(pi*x/50); 0"})

# The point nearest to the middle of the bar, and all points at 2.5 s.
gimp, linear = runs["GIMP"], runs["linear"]
point = np.argmin(np.abs(gimp.place - 12.5))
step = np.argmin(np.abs(gimp.time - 2.5))
order = np.argsort(gimp.place, kind="stable")[::2]  # one of two rows
np.savetxt(os.path.join(DATA, "crossing_history.csv"),
           np.column_stack((gimp.time, gimp.exact[:, point],
                            gimp.stress[:, point], linear.stress[:, point])),
           "%.6g", ",", comments="",
           header="time_s,exact_kPa,gimp_kPa,linear_kPa")
np.savetxt(os.path.join(DATA, "crossing_profile.csv"),
           np.column_stack((gimp.place[order], gimp.exact[step, order],
                            gimp.stress[step, order],
                            linear.stress[step, order])),
           "%.6g", ",", comments="",
           header="place_m,exact_kPa,gimp_kPa,linear_kPa")

figure, axes = plt.subplots(1, 2, figsize=(11, 3.8))
for axis, x, pick in ((axes[0], gimp.time, np.s_[:, point]),
                      (axes[1], gimp.place[order], np.s_[step, order])):
    axis.plot(x, linear.stress[pick], "C3-", linewidth=0.8,
              label="linear functions (MPM)")
    axis.plot(x, gimp.stress[pick], "C0-", linewidth=2, label="GIMP")
    axis.plot(x, gimp.exact[pick], "k--", linewidth=1, label="exact")
axes[0].set_xlabel("time (s)")
axes[0].set_ylabel("axial stress (kPa)")
axes[0].set_title(f"the point at {gimp.place[point]:.2f} m", fontsize=10)
axes[0].legend(fontsize=8)
axes[1].set_xlabel("place along the bar at the start (m)")
axes[1].set_title(f"all points at t = {gimp.time[step]:g} s", fontsize=10)
figure.tight_layout()
save(figure, "crossing")
