# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of the block on a slope of 1 : 2.

Shared by contact.py here and in contrib/verification.
"""

import math

import numpy as np

CASE = "verification/block_on_slope.prm"
FRICTION = "Walls/slope/Friction coefficient"
GRAVITY, TAN_SLOPE = 9.81, 0.5
ALONG = np.array([2.0, -1.0]) / math.sqrt(5.0)


def acceleration(mu):
    """g (sin(beta) - mu cos(beta)), or 0."""
    cosine = 1.0 / math.hypot(1.0, TAN_SLOPE)
    return GRAVITY * cosine * max(0.0, TAN_SLOPE - mu)


def speed(run, times):
    """Of the block's centre of mass down the slope (m/s)."""
    momentum = np.array([run.value(f"Momentum {x} (kN s)", times)
                         for x in "xy"])
    return ALONG @ momentum / (20.0 * 2.0 / GRAVITY)


def way(run, time=None):
    """Of the block's centre of mass down the slope (m)."""
    start, points = run.points(0.0), run.points(time)
    moved = points["position"] - start["position"]
    return float(np.average(moved[:, :2] @ ALONG, weights=start["mass"]))


def fitted(run):
    """Acceleration (m/s^2) and speed at t = 0 (m/s) of a straight line through the speeds
    from 0.5 s on, when the shock of the start is over."""
    times = np.arange(0.5, 2.0, 0.01)
    return tuple(float(x) for x in np.polyfit(times, speed(run, times), 1))
