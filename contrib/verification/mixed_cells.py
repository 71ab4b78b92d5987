#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/mixed_cells.md; runs the program.

    /usr/bin/python3 contrib/verification/mixed_cells.py [--waker build/bin/waker]
"""

import argparse
import os
import sys

import numpy as np
from common import DATA, ROOT, plt, save

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from waker_case import Workspace

CASE = "verification/mixed_cells.prm"
HEIGHT, UNIT_WEIGHT = 6., 15.
JOINTS = [3., 3.125, 3.25, 3.375]
# A static step in which each point keeps its own stiffness, as the gravity step
# had it up to version 0.1.
OWN_STIFFNESS = {
    "Gravity/Initial stress": "false", "Time stepping/Scheme": "quasi-static",
    "Time stepping/Load duration": 1, "Time stepping/Time step": 1,
    "Time stepping/Move points": "false", "Time stepping/Ghost stiffness": 0,
    "Newton/Tolerance": 1e-8, "Kinematics and mapping/Objective rate": "false",
    "Materials/stiff/Model": "linear elastic",
    "Materials/soft/Model": "linear elastic"}
IN_BALANCE = {"Time stepping/End time": 0}


def layers(joint):
    return {"Soil profile/lower/Polygon": f"0, 0; 3, 0; 3, {joint}; 0, {joint}",
            "Soil profile/upper/Polygon":
                f"0, {joint}; 3, {joint}; 3, 6; 0, 6"}


def profile(points):
    """Height, vertical and deviatoric stress of each point, and its error."""
    y = points["position"][:, 1] - (points["displacement"][:, 1]
                                    if "displacement" in points else 0.)
    overburden = -UNIT_WEIGHT * (HEIGHT - y)
    return y, points["stress_yy"], points["stress_yy"] - overburden, points


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--waker", default=os.path.join(ROOT, "build/bin/waker"))
    waker = parser.parse_args().waker
    rows, shown = [], {}
    with Workspace(waker, ROOT) as work:
        for joint in JOINTS:
            for name, settings in (("own stiffness", OWN_STIFFNESS),
                                   ("one stiffness", IN_BALANCE)):
                run = work.run(f"{name} {joint}", CASE,
                               {**layers(joint), **settings})
                shown[name, joint] = profile(run.points())
            rest = work.run(f"rest {joint}", CASE, layers(joint)).points()
            rows.append((joint,
                         np.abs(shown["own stiffness", joint][2]).max(),
                         np.abs(shown["one stiffness", joint][2]).max(),
                         shown["own stiffness", joint][3][
                             "deviatoric_stress"].max(),
                         shown["one stiffness", joint][3][
                             "deviatoric_stress"].max(),
                         rest["plastic_strain"].max(),
                         np.abs(rest["displacement"]).max()))
    header = ("joint_m,error_own_stiffness_kPa,error_one_stiffness_kPa,"
              "deviatoric_own_kPa,deviatoric_one_kPa,plastic_strain_at_rest,"
              "displacement_at_rest_m")
    np.savetxt(os.path.join(DATA, "mixed_cells.csv"), rows, "%.5g", ",",
               comments="", header=header)
    print(header)
    for row in rows:
        print(",".join(f"{value:.4g}" for value in row))

    figure, axes = plt.subplots(1, 2, figsize=(9, 4), sharey=True)
    for axis, joint in zip(axes, (3., 3.25)):
        for name, style in (("own stiffness", "C3s"), ("one stiffness", "C0o")):
            y, stress, _, _ = shown[name, joint]
            axis.plot(stress, y, style, markersize=4, label=name + " per point"
                      if name.startswith("own") else name + " per mixed cell")
        axis.plot([-UNIT_WEIGHT * HEIGHT, 0], [0, HEIGHT], "k-", linewidth=0.8,
                  label="weight above")
        axis.axhline(joint, color="k", linestyle=":", linewidth=0.8)
        axis.set_xlabel("vertical stress (kPa)")
        axis.set_title("joint on a line of the grid" if joint == 3.
                       else "joint in the middle of a cell", fontsize=10)
    axes[0].set_ylabel("height (m)")
    axes[0].legend(fontsize=8)
    save(figure, "mixed_cells")


if __name__ == "__main__":
    main()
