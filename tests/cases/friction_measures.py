# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of the cases with friction, and what others found.

Shared by mohr_coulomb.py here and in contrib/verification.
"""

import math

import numpy as np

SLOPE = "verification/slope_friction.prm"
SOFTENING = "verification/slope_softening.prm"
SUCTION = "verification/slope_suction.prm"
DRAWDOWN = "verification/slope_drawdown.prm"
ACADS = "verification/slope_acads.prm"
HEAD_LINES = "verification/dyke_head_lines.prm"
FOOTING = "verification/strip_footing_friction.prm"
UNDRAINED = "verification/strip_footing_undrained.prm"
COLUMN = "verification/granular_column.prm"
COLUMN_ON_GROUND = "verification/granular_column_on_ground.prm"
SOIL = "Materials/soil/"
COHESION, HALF_WIDTH, RATE = 10.0, 0.5, 0.0005  # kPa, m, m per s

# Surface of the pile at rest (m), Bui et al. 2008.
MEASURED = np.array([(0.100, 0.0776), (0.160, 0.0616), (0.200, 0.0474),
                     (0.241, 0.0348), (0.302, 0.0215), (0.362, 0.0109),
                     (0.402, 0.0037), (0.442, 0.0015)])


def n_c(angle):
    """Prandtl's factor of the cohesion."""
    phi = math.radians(angle)
    return (math.exp(math.pi * math.tan(phi))
            * math.tan(math.pi / 4 + phi / 2)**2 - 1) / math.tan(phi)


def n_c_undrained(stiffness, angle=20.0, modulus=1e5, poisson=0.3):
    """The same of the undrained footing by the stiffness of its water (kPa).

    With psi = 0 volume changes elastically: of the mean of the largest and the smallest
    stress, s, the grains get s' = s (K' + G/3)/(K' + G/3 + K_f) in plane strain. Strength
    c cos(phi) + s' sin(phi) is then Mohr-Coulomb's in total stress, with an angle.
    """
    shear = modulus / (2 * (1 + poisson))
    grains = modulus / (3 * (1 - 2 * poisson)) + shear / 3
    phi = math.radians(angle)
    total = math.asin(math.sin(phi) * grains / (grains + stiffness))
    return n_c(math.degrees(total)) * math.cos(phi) / math.cos(total)


def load(run):
    """Load over cohesion and half the width, by step."""
    settlement = RATE * run.statistics["Time (s)"]
    return (np.diff(run.statistics["Work of the supports (kJ)"])
            / np.diff(settlement) / COHESION / HALF_WIDTH)


def heights(run, width=0.008):
    """Height of the soil (m) in columns around the measured places."""
    points = run.points()
    x = points["position"][:, 0]
    return np.array([points["volume"][np.abs(x - at) < width / 2].sum() / width
                     for at, _ in MEASURED])


def front(run, height=0.0015, width=0.008):
    """How far (m) the soil reaches with this height, without a gap."""
    points = run.points()
    edges = np.arange(0.2, 0.6, width)
    there, _ = np.histogram(points["position"][:, 0], edges,
                            weights=points["volume"])
    middle = 0.5 * (edges[1:] + edges[:-1])
    end = np.nonzero(there / width < height)[0][0]
    return float(np.interp(height, [there[end] / width, there[end - 1] / width],
                           [middle[end], middle[end - 1]]))


def measured_front(height):
    """The same of the experiment."""
    return float(np.interp(-height, -MEASURED[:, 1], MEASURED[:, 0]))


# Case, and how fast the wall moves into the soil (m per s).
WALLS = {"passive": ("verification/wall_passive.prm", 0.002),
         "active": ("verification/wall_active.prm", -0.0002)}


def rankine(wall):
    """Force on the wall of the cases above (kN/m)."""
    weight, height, cohesion, angle = 18.0, 2.0, 2.0, 30.0
    sign = 1 if wall == "passive" else -1
    k = math.tan(math.radians(45 + sign * angle / 2))**2
    return (weight * height**2 * k / 2
            + sign * 2 * cohesion * height * math.sqrt(k))


def wall_force(run, rate):
    """Force on the wall, by step (kN/m)."""
    moved = rate * run.statistics["Time (s)"]
    return np.diff(run.statistics["Work of the supports (kJ)"]) / np.diff(moved)
