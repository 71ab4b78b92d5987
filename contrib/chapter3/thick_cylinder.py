# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thick cylinder of parameters/chapter3/cylinder.prm: outline of a quarter,
and Lame's solution in plane strain."""

import numpy as np

A, B, PRESSURE, E, NU = 1.0, 2.0, 1.0, 1e6, 0.3
CHORDS = 180


def outline():
    angles = np.pi / 2 * np.arange(CHORDS + 1) / CHORDS
    arc = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    arc[0], arc[-1] = (1.0, 0.0), (0.0, 1.0)
    points = np.concatenate([B * arc, A * arc[::-1]])
    return [(float(round(x, 12)), float(round(y, 12))) for x, y in points]


def exact(x, nu=NU):
    """Radial displacement (m) and stress xx, yy, zz, xy (kPa) at places x."""
    mean = PRESSURE * A**2 / (B**2 - A**2)
    part = PRESSURE * A**2 * B**2 / (B**2 - A**2)
    r = np.hypot(x[:, 0], x[:, 1])
    u = (1 + nu) / E * ((1 - 2 * nu) * mean * r + part / r)
    radial, hoop = mean - part / r**2, mean + part / r**2
    c, s = x[:, 0] / r, x[:, 1] / r
    stress = np.stack([radial * c**2 + hoop * s**2,
                       radial * s**2 + hoop * c**2,
                       np.full_like(r, 2 * nu * mean),
                       (radial - hoop) * c * s], axis=1)
    return u[:, None] * np.stack([c, s], axis=1), stress
