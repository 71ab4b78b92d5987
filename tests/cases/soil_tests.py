#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Soil in the laboratory and at rest against closed forms: triaxial compression, simple
shear, a table of shear strength by normal stress, level ground with K0 and a table of
undrained strength by vertical stress (doc/verification/mohr_coulomb.md,
initial_stress.md, strength_from_stress.md).

usage: soil_tests.py WAKER SOURCE_DIRECTORY
"""

import math

import numpy as np
from waker_case import Checks, workspace_of_arguments

TRIAXIAL = "verification/triaxial_compression.prm"
SHEAR = "verification/simple_shear.prm"
TABLE = "verification/shear_strength_table.prm"
GROUND = "verification/level_ground_k0.prm"
ANGLE, COHESION, PRESSURE, YOUNGS = math.radians(30), 5.0, 100.0, 20000.0
ROUND_OFF = 1e-6


def histories(run, component, rate):
    """Strain, and the least and the largest of a stress (kPa), by frame."""
    rows = []
    for time, _ in run.frames():
        values = run.points(time)["stress_" + component]
        rows.append((rate * time, values.min(), values.max()))
    return np.array(rows)


def furthest(found, exact):
    """The largest difference of both ends from the closed form, relative."""
    return float(np.abs(found[:, 1:] / np.asarray(exact)[:, None] - 1).max())


def triaxial(checks, work):
    run = work.run("triaxial", TRIAXIAL)
    checks.equal("triaxial: steps that did not converge", run["unconverged_steps"], 0)
    axial = histories(run, "yy", 0.0005)
    tangent = math.tan(math.pi / 4 + ANGLE / 2)
    largest = PRESSURE * tangent**2 + 2 * COHESION * tangent
    exact = -np.minimum(PRESSURE + YOUNGS * axial[:, 0], largest)
    checks.between("  failure in closed form (kPa)", largest, 317.3, 317.4)
    checks.between("  frames before and after failure",
                   int((exact > -largest).sum()), 3, len(exact) - 3)
    checks.below("  axial stress against it, relative",
                 furthest(axial, exact), ROUND_OFF)
    for side in "xx", "zz":
        cell = histories(run, side, 0.0005)
        checks.below("  cell pressure likewise",
                     furthest(cell, np.full(len(cell), -PRESSURE)), ROUND_OFF)
    # The control: another angle is another strength.
    other = work.run("weak", TRIAXIAL, {"Materials/soil/Friction angle": 25})
    checks.below("  axial stress with 25 degrees over that with 30",
                 histories(other, "yy", 1)[-1, 1] / axial[-1, 1], 0.85)


def shear(checks, work):
    run = work.run("shear", SHEAR)
    found = histories(run, "xy", 0.0005)
    modulus = YOUNGS / 2.6
    strength = COHESION * math.cos(ANGLE) + PRESSURE * math.sin(ANGLE)
    exact = np.minimum(modulus * found[:, 0], strength)
    checks.between("simple shear: strength in closed form (kPa)", strength, 54.3, 54.4)
    checks.below("  shear stress against it, relative",
                 furthest(found[1:], exact[1:]), ROUND_OFF)
    # The control: dilatant soil at constant height is pressed together.
    other = work.run("dilatant", SHEAR, {"Materials/soil/Dilatancy angle": 10})
    checks.above("  with psi = 10 degrees: stronger",
                 histories(other, "xy", 1)[-1, 1] / strength, 1.2)


def table(checks, work):
    entries = [(0, 2), (20, 16), (100, 50), (200, 80)]
    for pressure, segment in (100.0, 1), (15.0, 0):
        run = work.run(f"table-{pressure}", TABLE, {
            "Soil profile/sample/Initial stress":
                f"-{pressure}; -{pressure}; -{pressure}; 0"})
        (low, at_low), (high, at_high) = entries[segment:segment + 2]
        slope = (at_high - at_low) / (high - low)
        sine = slope / math.sqrt(1 + slope**2)
        cohesion = at_low - slope * low
        strength = cohesion * sine / slope + pressure * sine
        normal = pressure - strength * sine
        checks.between(f"table, {pressure:g} kPa: normal stress in closed form (kPa)",
                       normal, low, high)
        checks.below("  shear strength against it, relative",
                     abs(histories(run, "xy", 1)[-1, 1] / strength - 1), ROUND_OFF)


def ground(checks, work):
    run = work.run("ground", GROUND)
    end = run.points()
    y = end["position"][:, 1]
    sand = end["material"] == 0
    vertical = np.where(y > 4, 17 * (6 - y),
                        np.where(y > 3, 34 + 10 * (4 - y), 44 + 6 * (3 - y)))
    pressure = np.maximum(10 * (4 - y), 0)
    k0 = np.where(sand, 1 - math.sin(math.radians(33)), 0.65)
    water = np.where(sand, 0, pressure)  # the clay has total stress
    checks.equal("level ground: points of both", [int(sand.sum()), int((~sand).sum())],
                 [192, 192])
    checks.below("  it stays (m)", float(np.abs(end["displacement"]).max()), 1e-9)
    for component, exact in (("yy", vertical), ("xx", k0 * vertical),
                             ("zz", k0 * vertical)):
        off = end["stress_" + component] + exact + water
        checks.below(f"  stress {component} against the closed form (kPa)",
                     float(np.abs(off).max()), 1e-5)
    strength = end["undrained_shear_strength"][~sand]
    exact = np.interp(vertical[~sand], [40, 50, 60, 80], [9, 11, 15, 21])
    checks.below("  s_u against the table, relative",
                 float(np.abs(strength / exact - 1).max()), ROUND_OFF)
    checks.between("  from end to end (kPa)", float(strength.max() - strength.min()),
                   5.2, 5.8)


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        triaxial(checks, work)
        shear(checks, work)
        table(checks, work)
        ground(checks, work)
    checks.finish()


if __name__ == "__main__":
    main()
