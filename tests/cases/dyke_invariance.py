#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same dyke mirrored, shifted by parts of a cell, as a slice in 3D, with half
the time step and half the tolerance (doc/verification/invariance.md).

    /usr/bin/python3 tests/cases/dyke_invariance.py WAKER SOURCE_DIRECTORY [fine]

On cells of 0.5 m, where it takes 9 kPa to fail; "fine": on 0.25 m with 10 kPa.
"""

import dyke_measures as measures
import numpy as np
from waker_case import Checks, workspace_of_arguments

WEAK = "chapter5/dyke_weak.prm"
MIRRORED = "verification/dyke_mirrored.prm"
SLICE = "verification/dyke_slice.prm"

# Range of the detected height of a flat face, in cells
# (doc/verification/proximity_field.md): no width is known better.
DETECTION = 0.095 + 0.071


def variants(cell, fine):
    """{name: (file, settings)}"""
    cases = {"mirrored": (MIRRORED, {})}
    for part in (0.12, 0.28, 0.5, 0.68, 0.84) if fine else (0.28, 0.68):
        cases[f"shifted by {part:g} h"] = (
            WEAK, measures.polygon(lambda x, s=part * cell: x + s))
    cases["half the time step"] = (WEAK, {"Time stepping/Time step": 0.005})
    cases["half the tolerance"] = (WEAK, {"Newton/Tolerance": 0.0005})
    cases["a tenth of the tolerance"] = (WEAK, {"Newton/Tolerance": 0.0001})
    cases["slice in 3D"] = (
        SLICE, {"Grid/Cell size": cell,
                "Grid/Upper corner": f"42, 6, {cell}"})
    return cases


def width_difference(run, other, until):
    """Largest difference of the change of W before a time (m)."""
    times = np.arange(0, until, 0.01)
    a, b = (r.value("Dyke width W (m)", times) - r["initial_width"]
            for r in (run, other))
    return np.abs(a - b).max()


def compare(checks, name, base, other, cell):
    difference = width_difference(base, other,
                                  0.9 * base["initial_failure_time"])
    # Only a shift changes the points: by up to 4 % in the times. Half the time
    # step and a tenth of the tolerance change them by 0.7 %, W by 6 mm.
    shifted = name.startswith("shifted")
    times = 0.05 if shifted else 0.015
    checks.below(f"{name}: W before failure differs by", difference,
                 DETECTION * cell if shifted else 0.02, "m")
    ratios = {}
    for key in ("initial_failure_time", "flooding_time"):
        ratios[key] = (other[key] or 0) / base[key]
        checks.between(f"{name}: {key} / that of the dyke", ratios[key],
                       1 - times, 1 + times)
    return difference, ratios


def check_mirrored(checks, work, settings):
    """Solved tightly, so that what Newton leaves over does not magnify round-off,
    both are the same up to flooding."""
    tight = {**settings, "Newton/Tolerance": 1e-8}
    runs = [work.run(name, file, tight)
            for name, file in (("left", WEAK), ("right", MIRRORED))]
    checks.equal("mirrored, tolerance 1e-8: steps", runs[1]["steps"],
                 runs[0]["steps"])
    worst = 0.0
    for column in ("Dyke width W (m)", "Dyke height H (m)",
                   "Potential energy released (kJ)",
                   "Plastic dissipation (kJ)", "Work of the water (kJ)"):
        a, b = (run.value(column, runs[0].statistics["Time (s)"])
                for run in runs)
        worst = max(worst, np.abs(a - b).max() / np.abs(a).max())
    # 3e-15 today: round-off, and what it grows to.
    checks.below("mirrored, tolerance 1e-8: W, H and energies up to flooding "
                 "differ by", worst, 1e-9, "of their largest values")


def main():
    checks = Checks()
    workspace, words = workspace_of_arguments()
    fine = "fine" in words
    cell = 0.25 if fine else 0.5
    settings = {"Output/Interval": 0, "Output/Surface": "false",
                **measures.strength(10, 3.85)}
    if not fine:
        settings.update(measures.COARSE)
    with workspace as work:
        base = work.run("base", WEAK, settings)
        print(f"       initial failure {base['initial_failure_time']:.3f} s, "
              f"flooding {base['flooding_time']:.3f} s")
        for name, (file, changes) in variants(cell, fine).items():
            other = work.run("other", file, {**settings, **changes})
            compare(checks, name, base, other, cell)
        check_mirrored(checks, work, settings)
    checks.finish()


if __name__ == "__main__":
    main()
