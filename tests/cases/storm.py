#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Storms of six hours on coarse cells: a slide in the ebb that floods in the rise, a dyke that slides
and holds, a drawdown; steps of other lengths change nothing, and a campaign says when.

    /usr/bin/python3 tests/cases/storm.py WAKER SOURCE_DIRECTORY
"""

import csv
import os

import numpy as np

import program
from waker_case import Checks, workspace_of_arguments

CASE = "verification/dyke_storm.prm"
COARSE = {"Grid/Cell size": 0.5, "Materials/clay/Initial strength": 9.4,
          "Materials/clay/Residual strength": 3.62, "Output/Interval": 0}
STORM = ((0, 3600, 14400, 21600), (3, 1.5, 4.6, 3))


def level(time, storm=STORM):
    return np.nan if time is None else np.interp(time, *storm)


def storms(work, checks):
    run = work.run("storm", CASE, COARSE)
    checks.equal("storm: outcome", run["outcome"], "flooding")
    checks.equal("  slope that slides", run["slope"], "outer")
    slide = run["initial_failure_time_displacement"]
    flood = run["flooding_time"]
    checks.between("  slide in the ebb", slide, 600, 3600, "s")
    checks.between("  flooding before the peak", flood, 9000, 14400, "s")
    checks.above("  crest above the water after the slide",
                 run.value("Dyke height H (m)", 6000) - level(6000), 1, "m")
    checks.below("  steps", run["steps"], 6000)
    checks.between("  share of the time in long steps",
                   run["time_at_rest"] / run["end_time"], 0.99, 0.9999)
    checks.between("  as before: level at the slide", level(slide), 2.0, 2.08, "m")
    rows = run.statistics
    checks.below("  energy: remainder by that released",
                 abs(rows["Energy remainder (kJ)"][-1]
                     / rows["Potential energy released (kJ)"][-1]), 5e-4)
    checks.above("  longest step", rows["Time step (s)"].max(), 100, "s")
    checks.below("  shortest", rows["Time step (s)"][1:].min(), 0.011, "s")

    fine = work.run("fine", CASE, {
        **COARSE, "Time stepping/Longest step": 150, "Time stepping/Largest rise": 0.025,
        "Time stepping/Largest displacement": 0.005})
    checks.equal("steps of half the length: outcome", fine["outcome"], "flooding")
    checks.below("  level at the slide, difference",
                 abs(level(fine["initial_failure_time_displacement"]) - level(slide)),
                 0.005, "m")
    checks.below("  level at flooding, difference",
                 abs(level(fine["flooding_time"]) - level(flood)), 0.02, "m")

    # Its end is soon after the slide.
    falls = ((0, 21600), (3, 1))
    fall = work.run("fall", CASE, {**COARSE, "Water/Rise": "0: 1.5, 21600: -0.5",
                                   "Time stepping/End time": 11000})
    checks.equal("drawdown: slope", fall["slope"], "outer")
    checks.below("  level at the slide, difference from the ebb",
                 abs(level(fall["initial_failure_time_displacement"], falls)
                     - level(slide)), 0.01, "m")

    holds = work.run("holds", CASE, {**COARSE, "Materials/clay/Initial strength": 11})
    checks.equal("stronger clay: outcome", holds["outcome"], "stable")
    checks.equal("  end", holds["end_time"], 21600)
    checks.equal("  motions", holds["motions"], 0)


def in_space(work, checks):
    """Long steps of a slice are those of the plane."""
    rise = {"Time stepping/Scheme": "quasi-static at rest", "Time stepping/End time": 1200,
            "Grid/Cell size": 0.5, "Water/Rise": "0: -1, 1200: 0", "Output/Interval": 0,
            "Materials/clay/Initial strength": 30, "Materials/clay/Residual strength": 30,
            "Newton/Tolerance": 1e-6}
    ends = {}
    for name, file in (("plane", "chapter5/dyke.prm"), ("slice", "verification/dyke_slice.prm")):
        run = work.run(name, file, rise)
        checks.equal(f"{name}: time in long steps", run["time_at_rest"], 1200)
        ends[name] = run.points()["displacement"][:, :2]
    largest = np.abs(ends["plane"]).max()
    checks.above("largest displacement", largest, 0.01, "m")
    checks.below("mean displacement, slice by plane, difference by the largest",
                 np.abs(ends["slice"].mean(axis=0) - ends["plane"].mean(axis=0)).max()
                 / largest, 0.01)


def campaign(work, checks):
    """On cells of 1 m; weaker clay, which on these stands as well."""
    folder = os.path.join(work.folder, "campaign")
    coarser = {"Grid/Cell size": 1, "Materials/clay/Initial strength": 8.5,
               "Materials/clay/Residual strength": 3.27, "Campaign/Realisations": 4,
               "Output/Directory": folder}
    file = os.path.join(work.source, "parameters", "verification",
                        "dyke_storm_campaign.prm")
    done = program.shared(work.waker).run(
        ["campaign", file,
         *(word for name, value in coarser.items() for word in ("--set", f"{name}={value}"))])
    checks.equal("campaign: exit code", done.returncode, 0)
    with open(os.path.join(folder, "report", "probability_time.csv"),
              encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    checks.equal("  realisations", int(rows[-1]["n"]), 4)
    # Of failed and standing dykes: met 3 of 4.
    checks.between("  failures", int(rows[-1]["n_S1"]), 1, 3)
    checks.between("  end of the table", float(rows[-1]["time"]), 5000, 21600, "s")
    checks.equal("  the report says when",
                 "time of initial failure, by the first of its readings: mean" in done.stdout, True)


def main():
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        storms(work, checks)
        in_space(work, checks)
        campaign(work, checks)
    checks.finish()


if __name__ == "__main__":
    main()
