#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tractions against the internal force, as chapter 3 of the thesis compares
them: the bars of figures 3.3 to 3.7 at some places on the grid, and the stress
in a block under traction.

    /usr/bin/python3 tests/cases/chapter3_bars.py WAKER SOURCE_DIRECTORY
"""

import os
import sys
import tempfile
import types

import numpy as np
import program
from waker_case import Checks

# All are nodal forces over the load: single precision of the files.
ROUND_OFF = 2e-6


def check_bar(checks, runs):
    import bar_1d
    common = ["points", "nodes", "surface"]
    for offset in (0.0, 0.3, 0.5, 0.77):
        _, mpm = bar_1d.evaluate(runs, "bar_1d_mpm.prm", common + ["volume"],
                                 offset)
        _, gimp = bar_1d.evaluate(runs, "bar_1d.prm", common + ["contour"],
                                  offset)
        where = f"bar at {offset} m"
        checks.below(f"{where}, MPM: volume", mpm["volume"], ROUND_OFF)
        checks.below(f"{where}, GIMP: contour", gimp["contour"], ROUND_OFF)
        checks.below(f"{where}, GIMP: surface", gimp["surface"], ROUND_OFF)
        # MPM feels an end of the bar where the volume of the points in its
        # cell ends: 0.5 m each.
        end = offset % 1.0
        volume = 0.5 if 0.25 < end <= 0.75 else 0.0 if end <= 0.25 else 1.0
        for name, value, place, felt in (
                ("MPM: surface", mpm["surface"], end, volume),
                ("MPM: points", mpm["points"], end + 0.25, volume),
                ("GIMP: nodes", gimp["nodes"], 0.0, end),
                ("GIMP: points", gimp["points"], end + 0.25, end)):
            expected = np.abs(hats(place) - hats(felt)).sum()
            checks.between(f"{where}, {name}", value, expected - ROUND_OFF,
                           expected + ROUND_OFF)


def hats(x):
    """What a unit force at x gives to the nodes at 0, 1 and 2 m."""
    return np.maximum(1 - np.abs(x - np.arange(3)), 0)


def check_inclined_bar(checks, runs):
    import inclined_bar
    # Means over ten places, of a calculation by hand (a page of Python) that
    # over fifty places gives the 2.12 and 1.30 %, 0.88 and 0.50 %, 4.87 and
    # 2.98 % of the table.
    expected = {0.5: (2.042, 1.295), 0.25: (0.8661, 0.4985),
                1.0: (4.729, 2.985)}
    largest = {0.5: (2.778, 1.389), 0.25: (1.389, 0.694), 1.0: (8.333, 4.167)}
    for tangent, means in expected.items():
        errors = [inclined_bar.evaluate(runs, tangent, k / 10, detected=False)
                  for k in range(10)]
        values = inclined_bar.statistics(errors)
        for axis, mean, most in zip("xy", means, largest[tangent]):
            checks.between(f"tan {tangent}: surface, mean E_F{axis}",
                           values["surface"]["mean " + axis], 0.999 * mean,
                           1.001 * mean, "%")
            checks.between(f"tan {tangent}: surface, largest E_F{axis}",
                           values["surface"]["max " + axis], 0.999 * most,
                           1.001 * most, "%")
            checks.below(f"tan {tangent}: contour, largest E_F{axis}",
                         values["contour"]["max " + axis], 1e-3, "%")
            if tangent == 0.5:
                checks.between(f"points, mean E_F{axis}",
                               values["points"]["mean " + axis], 40, 60, "%")
                checks.between(f"nodes, mean E_F{axis}",
                               values["nodes"]["mean " + axis], 80, 120, "%")


def check_block(checks, runs):
    import uniaxial_block
    for functions, method, end in (("GIMP", "contour", 4.7),
                                   ("GIMP", "surface", 4.7),
                                   ("linear", "volume", 4.5),
                                   ("linear", "surface", 5.0)):
        _, sigma = uniaxial_block.stress(runs, functions, method, end)
        checks.below(f"block to {end} m, {functions}, {method}: largest error",
                     np.abs(sigma - 1).max(), 1e-5, "kPa")
    x, sigma = uniaxial_block.stress(runs, "linear", "points", 5.0)
    checks.below("loads on points: sigma_xx - 0.75 in the loaded cell",
                 np.abs(sigma[x > 4] - 0.75).max(), 1e-5, "kPa")
    checks.below("sigma_xx - 1 elsewhere", np.abs(sigma[x < 4] - 1).max(), 1e-5,
                 "kPa")


def main():
    waker, source = sys.argv[1:3]
    sys.path.insert(0, os.path.join(source, "contrib", "chapter3"))
    from common import Runs
    class ServedRuns(Runs):
        def call(self, arguments):
            return program.shared(waker).run(arguments)

    checks = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        runs = ServedRuns(types.SimpleNamespace(waker=waker, runs=folder,
                                                again=False))
        check_bar(checks, runs)
        check_inclined_bar(checks, runs)
        check_block(checks, runs)
    checks.finish()


if __name__ == "__main__":
    main()
