# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of slopes that water flows through, and its closed form.

Shared by seeping_slope.py here and in contrib/verification.
"""

import math

import numpy as np

KINKED = "verification/slope_seeping.prm"
LONG = "verification/slope_seepage_parallel.prm"
# Buoyant weight and the seepage force instead of water in the ground.
BUOYANT = {"Pore water/Phreatic line": "", "Materials/soil/Unit weight": 10,
           "Point loads/seepage/Force": "500, 0"}
AT_START = {"Time stepping/End time": 0}
# The long slope without its reference lines: hydrostatic below the ground.
HYDROSTATIC = {"Reference lines/Names": "", "Head lines/Names": ""}
SLOPE, WEIGHT, WATER, ANGLE = 0.25, 20.0, 10.0, 35.0  # -, kN/m^3, degrees
COMPONENTS = ("xx", "yy", "zz", "xy")


def difference(one, other, depth=0.0):
    """Root mean square of the difference of the stresses of two runs at the start,
    over that of the stress, at points deeper than `depth` (m)."""
    stresses = []
    for run in one, other:
        points = run.points(0.0)
        stresses.append(np.array([points["stress_" + c] for c in COMPONENTS]))
    x, y = points["position"][:, 0], points["position"][:, 1]
    deep = np.where(x < 12, 10, 10 - (x - 12) / 2) - y > depth
    off = ((stresses[0] - stresses[1])**2).sum(axis=0)[deep]
    return float(np.sqrt(off.mean() / (stresses[1]**2).sum(axis=0)[deep].mean()))


def mobilised(run):
    """Factor of safety of the long slope, without cohesion, from the sums of normal and
    shear stress on planes along it, in its middle."""
    points = run.points(0.0)
    x, y = points["position"][:, 0], points["position"][:, 1]
    z = 28 - SLOPE * x - y
    cosine = 1 / math.sqrt(1 + SLOPE**2)
    sine = SLOPE * cosine
    xx, yy, xy = (points["stress_" + c] for c in ("xx", "yy", "xy"))
    normal = sine**2 * xx + cosine**2 * yy + 2 * sine * cosine * xy
    shear = sine * cosine * (xx - yy) + (cosine**2 - sine**2) * xy
    middle = (np.abs(x - 48) < 12) & (z > 0.75) & (z < 3.25)
    return float(math.tan(math.radians(ANGLE)) * -normal[middle].sum()
                 / np.abs(shear[middle]).sum())


def closed_form(is_parallel):
    """The same of a slope without ends: flow along it, or heads that fall along x."""
    cosine_square = 1 / (1 + SLOPE**2)
    share = WATER / WEIGHT / (1 if is_parallel else cosine_square)
    return (1 - share) * math.tan(math.radians(ANGLE)) / SLOPE
