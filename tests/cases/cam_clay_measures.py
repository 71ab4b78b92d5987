# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of the cases with modified Cam clay, and their closed forms.

Shared by cam_clay.py here and in contrib/verification.
"""

import math

import numpy as np

OEDOMETER = "verification/cam_clay_oedometer.prm"
FOOTING = "verification/cam_clay_footing.prm"
COMPRESSION, SWELLING, ANGLE = 0.1, 0.02, 25.0  # lambda*, kappa*, degrees
LAMBDA = 1 - SWELLING / COMPRESSION
PRESSURE, HALF_WIDTH, RATE = 50.0, 0.5, 0.001  # kPa, m, m per s
SHEAR_MODULUS = 15000.0  # kPa, in the oedometer

SINE = math.sin(math.radians(ANGLE))
TRIAXIAL = 6 * SINE / (3 - SINE)  # M


def rigid_k0():
    """K0 of virgin compression, were the soil rigid in shear."""
    eta = (math.sqrt(9 * LAMBDA**2 + 4 * TRIAXIAL**2) - 3 * LAMBDA) / 2
    return (3 - eta) / (3 + 2 * eta)


def stress_rate(stress):
    """d(p', q) by the volumetric strain of virgin oedometer compression."""
    p, q = stress
    eta = q / p
    per = (COMPRESSION - SWELLING) / (p + q**2 / (TRIAXIAL**2 * p))
    by_p = per * (1 - (eta / TRIAXIAL)**2)
    by_q = per * 2 * eta / TRIAXIAL**2
    flow = 2 * eta / (TRIAXIAL**2 - eta**2)
    return np.linalg.solve(
        [[SWELLING / p + by_p, by_q],
         [flow * by_p, 1 / (3 * SHEAR_MODULUS) + flow * by_q]], [1, 2 / 3])


def virgin_compression(strains, start=10.0, step=1e-5):
    """Vertical stress and K0 at the strains: the rates, integrated (RK4)."""
    stress, strain, found = np.array([start, 0.0]), 0.0, []
    for end in strains:
        n = max(int(round((end - strain) / step)), 0)
        for _ in range(n):
            h = (end - strain) / n
            one = stress_rate(stress)
            two = stress_rate(stress + h / 2 * one)
            three = stress_rate(stress + h / 2 * two)
            four = stress_rate(stress + h * three)
            stress = stress + h / 6 * (one + 2 * two + 2 * three + four)
        strain = end
        p, q = stress
        found.append((p + 2 * q / 3, (p - q / 3) / (p + 2 * q / 3)))
    return np.array(found)


def oedometer(run):
    """Strain, vertical stress and K0 of the frames."""
    rows = []
    for time, _ in run.frames():
        points = run.points(time)
        vertical = -points["stress_yy"].mean()
        rows.append((0.003 * time, vertical,
                     -points["stress_xx"].mean() / vertical))
    return np.array(rows)


def undrained_strength():
    """s_u in plane strain (kPa)."""
    return SINE * PRESSURE * 0.5**LAMBDA


def load(run):
    """Load over (2 + pi) s_u, by step."""
    settlement = RATE * run.statistics["Time (s)"]
    return (np.diff(run.statistics["Work of the supports (kJ)"])
            / np.diff(settlement) / HALF_WIDTH
            / ((2 + math.pi) * undrained_strength()))
