#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time of a step with friction and water in the ground, and with nonlocal softening,
against a step of clay: the tables of doc/verification/performance.md ("Friction and
water in the ground"). Runs the program, all cases in turn.

    /usr/bin/python3 contrib/verification/laws_time.py [--rounds 5]
        [--waker build/bin/waker]

User time of whole runs less that of runs of one step: medians of the rounds. Some
ten minutes on an idle core.
"""

import os
import resource
import subprocess

import numpy as np
from dyke_runs import option, workspace, write_csv
from waker_case import Run

PLANE, SPACE = "chapter5/dyke_weak.prm", "chapter6/slope.prm"
CONTOUR = {"Surface/Method": "contour"}


def drained(cohesion, angle, line):
    """Friction, and the phreatic line in the ground: settings."""
    return {"Materials/clay/Model": "Mohr-Coulomb",
            "Materials/clay/Cohesion": cohesion,
            "Materials/clay/Friction angle": angle,
            "Pore water/Phreatic line": line,
            "Water/Minimum support": 0}


DYKE_LINE = "-6, 4.75; 5, 4.75; 30, 0; 42, 0"
SLOPE_LINE = "0, 0.5; 6, 0.5"
COARSE = {"Grid/Cell size": 0.25}
SLIDES = {**COARSE, "Materials/clay/Initial strength": 2}


def nonlocal_(length):
    """Softening with an averaging length (m): settings."""
    return {"Materials/clay/Regularisation": "nonlocal",
            "Materials/clay/Averaging length": length}


# Name: file, settings, end, and whose step it is measured by.
CASES = {
    "plane: clay, first 2 s": (PLANE, CONTOUR, 2., None),
    "plane: clay, until it floods": (PLANE, CONTOUR, None, None),
    "plane: nonlocal clay, l = 0.5 m, first 2 s":
        (PLANE, {**CONTOUR, **nonlocal_(0.5)}, 2., "plane: clay, first 2 s"),
    "plane: drained, 4 kPa and 12 degrees, stands, first 2 s":
        (PLANE, {**CONTOUR, **drained(4, 12, DYKE_LINE)}, 2., "plane: clay, first 2 s"),
    "plane: drained, 2 kPa and 8 degrees, first 2 s":
        (PLANE, {**CONTOUR, **drained(2, 8, DYKE_LINE)}, 2., "plane: clay, first 2 s"),
    "plane: drained, 2 kPa and 8 degrees, until it floods":
        (PLANE, {**CONTOUR, **drained(2, 8, DYKE_LINE)}, None,
         "plane: clay, until it floods"),
    "space: clay of 2 kPa, first 1 s": (SPACE, SLIDES, 1., None),
    "space: nonlocal clay, l = 0.25 m, first 1 s":
        (SPACE, {**SLIDES, **nonlocal_(0.25)}, 1., "space: clay of 2 kPa, first 1 s"),
    "space: nonlocal clay, l = 0.5 m, first 1 s":
        (SPACE, {**SLIDES, **nonlocal_(0.5)}, 1., "space: clay of 2 kPa, first 1 s"),
    "space: drained, 4 kPa and 25 degrees, stands, first 1 s":
        (SPACE, {**COARSE, **drained(4, 25, SLOPE_LINE)}, 1.,
         "space: clay of 2 kPa, first 1 s"),
    "space: drained, 0.5 kPa and 15 degrees, first 1 s":
        (SPACE, {**COARSE, **drained(0.5, 15, SLOPE_LINE)}, 1.,
         "space: clay of 2 kPa, first 1 s"),
}


def cpu(work, name, file, settings):
    """User time of a run (s), and its folder. A process of its own: those of the fork
    server, which the tests use, are not counted."""
    folder = os.path.join(work.folder, name)
    words = [work.waker, "run", os.path.join(work.source, "parameters", file),
             "--overwrite"]
    for key, value in {**work.quiet, **settings, **work.settings,
                       "Output/Directory": folder}.items():
        words += ["--set", f"{key}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(words, stdout=subprocess.DEVNULL, check=True,
                   env=dict(os.environ, OMP_NUM_THREADS="1"))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, Run(folder)


def main():
    rounds = int(option("--rounds", "5"))
    seconds = {name: [] for name in CASES}
    counts = {}
    with workspace(__doc__) as work:
        for k in range(rounds):
            for name, (file, settings, end, _) in CASES.items():
                quiet = {"Output/Interval": 0, **settings}
                one, first = cpu(work, "one", file,
                                 {**quiet, "Time stepping/End time": 0.01})
                if end is not None:
                    quiet["Time stepping/End time"] = end
                many, run = cpu(work, "many", file, quiet)
                seconds[name].append((many - one) / (run["steps"] - first["steps"]))
                counts[name] = (run["steps"],
                                run["newton_iterations"] / run["steps"],
                                run["unconverged_steps"])
            print(f"round {k + 1} of {rounds}", flush=True)

    step = {name: float(np.median(values)) for name, values in seconds.items()}
    ratio = {}
    print("| | steps | Newton, per step | ms per step, lowest to highest | "
          "of a step of clay |\n|---|---|---|---|---|")
    for name, values in seconds.items():
        ratio[name] = float(np.median(np.array(values) /
                                      seconds[CASES[name][3] or name]))
        print(f"| {name} | {counts[name][0]} | {counts[name][1]:.2f} | "
              f"{1e3 * step[name]:.2f} ({1e3 * min(values):.2f} to "
              f"{1e3 * max(values):.2f}) | {ratio[name]:.2f} |")
    write_csv("laws_time", {
        "case": list(CASES),
        "steps": [float(counts[name][0]) for name in CASES],
        "newton iterations a step": [counts[name][1] for name in CASES],
        "unconverged steps": [float(counts[name][2]) for name in CASES],
        "ms a step": [1e3 * step[name] for name in CASES],
        "lowest": [1e3 * min(seconds[name]) for name in CASES],
        "highest": [1e3 * max(seconds[name]) for name in CASES],
        "of a step of clay": [ratio[name] for name in CASES]})


if __name__ == "__main__":
    main()
