#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar whose points move across cells: its stress oscillates with linear
functions (standard MPM) and not with GIMP (doc/verification/crossing.md).

    /usr/bin/python3 tests/cases/cell_crossing.py WAKER SOURCE_DIR
"""

import os
import sys
import tempfile

import numpy as np
from runs import Check, particles, run

OMEGA = np.pi * 10 / 50  # rad/s, of the first mode


class Crossing:
    """A run of crossing.prm, and its stress beside the exact one."""

    def __init__(self, waker, source, folder, velocity=0.1, **sections):
        """`velocity` (m/s) is that of the tip at the start, as the .prm has
        it."""
        case = os.path.join(source, "parameters", "verification",
                            "crossing.prm")
        run(waker, case, folder, **sections)
        times, stresses = [], []
        for time, mesh in particles(folder):
            times.append(time)
            stresses.append(mesh.point_data["stress_xx"].ravel())
            if time == 0.0:
                self.place = mesh.points[:, 0].copy()
        self.time, self.stress = np.array(times), np.array(stresses)
        # E v0 / c times the first mode: 1 kPa with the tip at 0.1 m/s.
        self.peak = 10 * velocity
        self.exact = self.peak * np.outer(np.sin(OMEGA * self.time),
                                          np.cos(np.pi * self.place / 50))

    def error(self):
        """Root mean square over points and times, relative to that of the
        exact stress."""
        return np.sqrt(np.mean((self.stress - self.exact)**2) /
                       np.mean(self.exact**2))

    def largest_error(self):
        """Relative to the largest exact stress."""
        return np.abs(self.stress - self.exact).max() / self.peak


def main(waker, source):
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        gimp = Crossing(waker, source, folder)
        linear = Crossing(waker, source, folder,
                          Kinematics_and_mapping={"Functions": "linear"})
    check("GIMP: error of the stress, rms", gimp.error(), 0, 0.02)
    check("GIMP: largest error of the stress", gimp.largest_error(), 0, 0.02)
    # 0.39 and 1.05: cells are crossed, or the two checks above prove nothing.
    check("linear functions: error of the stress, rms", linear.error(), 0.3,
          0.5)
    check("linear functions: largest error of the stress",
          linear.largest_error(), 0.8, 1.3)
    check.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
