#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Half of the dyke of chapter 5 in 3D, coarse, with water and a weak lens at the plane
of symmetry: it slides there first; the width is that of its narrowest section; mass,
energy and momentum are closed.

usage: half_dyke.py WAKER SOURCE_DIRECTORY
"""

import numpy as np
from waker_case import Checks, workspace_of_arguments

COARSE = {"Grid/Cell size": 0.5, "Time stepping/End time": 2.0,
          "Output/Interval": 0.5}


LENGTH = 10.0  # m
WEIGHT = 1000 * 1.52905 * 9.81  # kN, of 1000 m^3


def momentum(checks, rows):
    """P = int F dt: weight, water and reactions, under the ramp of one second."""
    time = rows["Time (s)"][1:]
    ramp = np.minimum(time, 1)
    for axis, limit in (("x", 0.6), ("y", 0.8), ("z", 0.3)):
        force = rows[f"Reaction {axis} (kN)"][1:]
        if axis != "z":
            force = force + LENGTH * rows[f"Water force {axis} (kN)"][1:]
        if axis == "y":
            force = force - WEIGHT
        force = ramp * force
        steps = 0.5 * (force[1:] + force[:-1]) * np.diff(time)
        moved = rows[f"Momentum {axis} (kN s)"][1:]
        checks.below(f"momentum {axis} less what the forces gave (kN s)",
                     np.abs(moved[1:] - moved[0] - np.cumsum(steps)).max(),
                     limit)
        checks.above("  while it reaches", np.abs(moved).max(), 5 * limit)


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace:
        run = workspace.run("half", "chapter6/half_dyke.prm", COARSE)
        rows = run.statistics
        checks.equal("steps that did not converge", run["unconverged_steps"], 0)

        masses = run["sliding_masses"]["masses"]
        checks.above("sliding masses", len(masses), 1)
        first = masses[0]
        checks.equal("the first begins at the plane of symmetry, z (m)",
                     first["z_from"], 0)
        checks.between("  and ends at z (m)", first["z_to"], 3, 6)
        widths = [mass["z_to"] for mass in masses[:2]]
        checks.above("the second is wider (m)", widths[1], widths[0] + 1)

        # The slide takes width away where it is.
        width, place = rows["Dyke width W (m)"], rows["z of W (m)"]
        checks.above("width at the start (m)", width[0], 10.9)
        checks.below("  at the end", width[-1], width[0] - 0.5)
        checks.below("  of the section at z (m)", place[-1], 4)
        points = run.points()
        deep = np.linalg.norm(points["displacement"], axis=1)
        z = points["position"][:, 2]
        checks.above("displacement beside the plane of symmetry by that at the "
                     "far end", deep[z < 1].max() / deep[z > 9].max(), 2)

        checks.equal("points", len(points["id"]), 64800)
        dissipation = rows["Plastic dissipation (kJ)"][-1]
        checks.below("remainder of the energy, by the dissipation",
                     np.abs(rows["Energy remainder (kJ)"]).max() / dissipation,
                     0.05)
        momentum(checks, rows)
    checks.finish()


if __name__ == "__main__":
    main()
