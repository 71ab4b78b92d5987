#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Water that rises over an elastic slope (parameters/chapter3/rising_water.prm):
the reaction follows the level, and the work of the loads is what is stored.

    /usr/bin/python3 tests/cases/rising_water.py WAKER SOURCE_DIR

Quasi-static, and with Newmark's scheme and its inertia.
"""

import os
import sys
import tempfile

import numpy as np
from runs import Check, run, statistics

GAMMA = 10.0
WEIGHT = 20.0 * (16 * 2 + 6 * 4 + 4 * 4 / 2)  # kN/m


def ground(x):
    """Height of the slope (m)."""
    return np.interp(x, [0, 6, 10, 16], [6, 6, 2, 2])


def water_weight(level):
    """Weight of the water above the slope (kN/m)."""
    x = (np.arange(16000) + 0.5) / 1000
    return GAMMA * 16 * np.maximum(level - ground(x), 0).mean()


def test(check, name, data, tolerance, rise_tolerance):
    level = np.interp(data["Time (s)"], [0, 20], [3, 8])
    reaction = data["Reaction y (kN)"][1:]
    expected = WEIGHT + np.array([water_weight(h) for h in level[1:]])
    # The soil settles by about a centimetre and makes room for more water: up
    # to 0.1 %. With inertia it swings about that.
    check(f"{name}: reaction / weight of soil and water, lowest",
          (reaction / expected).min(), 1 - tolerance, 1 + tolerance)
    check(f"{name}: the same, highest", (reaction / expected).max(),
          1 - tolerance, 1 + tolerance)
    check(f"{name}: rise of the reaction / of the water's weight",
          (reaction[-1] - reaction[0]) / (expected[-1] - expected[0]),
          1 - rise_tolerance, 1 + rise_tolerance)

    elastic = data["Elastic energy (kJ)"]
    stored = (elastic[-1] - elastic[0] + data["Kinetic energy (kJ)"][-1]
              + data["Plastic dissipation (kJ)"][-1])
    work = (data["Work of the water (kJ)"][-1]
            + data["Potential energy released (kJ)"][-1]
            + data["Work of the supports (kJ)"][-1])
    loss = data["Mapping loss (kJ)"][-1]
    scale = data["Work of the water (kJ)"][-1]
    print(f"{name}: work {work:.5f}, stored {stored:.5f}, lost {loss:.5f} kJ/m")
    check(f"{name}: (work - stored - lost) / work of the water",
          (work - stored - loss) / scale, -6e-4, 6e-4)
    return work, stored, loss, scale


def main():
    waker, source = sys.argv[1:3]
    case = os.path.join(source, "parameters/chapter3/rising_water.prm")
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        run(waker, case, os.path.join(folder, "a"))
        work, stored, loss, scale = test(
            check, "quasi-static", statistics(os.path.join(folder, "a")), 0.001,
            0.005)
        check("quasi-static: lost / work of the water", loss / scale,
              -1e-3, 1e-3)
        run(waker, case, os.path.join(folder, "b"),
            Time_stepping={"Scheme": "Newmark", "Time step": 0.02})
        work_2, _, _, _ = test(
            check, "Newmark", statistics(os.path.join(folder, "b")), 0.01, 0.015)
        check("Newmark: work / that of the quasi-static run",
              work_2 / work, 0.99, 1.01)
    check.exit()


if __name__ == "__main__":
    main()
