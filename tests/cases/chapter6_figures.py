#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and tables of chapter 6, from campaigns of a few realisations whose
numbers are known by hand.

    /usr/bin/python3 tests/cases/chapter6_figures.py WAKER SOURCE_DIRECTORY

The program itself is not needed: a script stands for `waker merge`.
"""

import csv
import json
import os
import stat
import subprocess
import sys
import tempfile

import numpy as np
from waker_case import Checks

HEAD = ("realisation", "outcome", "initial_height", "residual_height", "load",
        "relative_failure_volume", "retrogression_distance",
        "damaged_crest_width", "inner_slide_crest_cut", "n_masses",
        "first_mass_width", "n_masses_remnant", "n_masses_side",
        "n_masses_behind_centred", "n_masses_behind_off_centre",
        "unconverged_steps", "steps", "wall_time")
SECTIONS = ("comparison", "campaigns", "inherent", "stronger", "classes",
            "moves", "length", "figures", "pictures")
MERGE = """#!/bin/sh
[ "$1" = merge ] && mkdir "$2/report" && cp "$2/journal-00000.jsonl" \\
  "$2/report/realisations.csv"
"""


def row(number, load=None, outcome="initial failure", volume=0.4, back=1.0,
        width=None, masses=1, side=0, centred=0):
    return (number, outcome, 1.0, 1.0, load, volume, back, width, 1.5, masses,
            width, masses - 1 - side - centred if masses else 0, side, centred,
            0, 0, 1500, 2.0)


def campaign(path, rows, code="a", seed=1, report=True):
    os.makedirs(os.path.join(path, "report" if report else ""), exist_ok=True)
    with open(os.path.join(path, "campaign.json"), "w",
              encoding="utf-8") as file:
        json.dump({"hash": code, "seed": seed, "version": "0"}, file)
    with open(os.path.join(path, "report/realisations.csv" if report else
                           "journal-00000.jsonl"), "w", encoding="utf-8",
              newline="") as file:
        writer = csv.writer(file)
        writer.writerow(HEAD)
        writer.writerows([["nan" if x is None else x for x in r]
                          for r in rows])
    with open(os.path.join(path, "parameters.prm"), "w",
              encoding="utf-8"):
        pass
    return path


def call(source, folder, *words):
    page = os.path.join(folder, "page.md")
    with open(page, "w", encoding="utf-8") as file:
        file.write("before\n" + "".join(
            f"<!-- begin {name} -->\nformer text\n<!-- end {name} -->\n"
            for name in SECTIONS) + "after\n")
    done = subprocess.run(
        [sys.executable, os.path.join(source, "contrib/plots/chapter6.py"),
         os.path.join(folder, "data"), os.path.join(folder, "figures"),
         *words, "--page", page],
        capture_output=True, text=True, check=False)
    with open(page, encoding="utf-8") as file:
        return done, file.read()


def has(checks, what, page, line):
    checks.equal(what, [l for l in page.splitlines() if line in l] != [], True)


def check_readings(checks, source):
    """What is read of a history of the load, and of a table."""
    sys.path.insert(0, os.path.join(source, "contrib", "plots"))
    from chapter6_programmes import example_of, read_trend
    from estimates import mean_of_few, sign_test

    def example(*above, load):
        """`above`: for each step whether something sinks too fast."""
        above = np.array(above)
        return example_of(np.array([load]), np.where(above, 0.06, 0.01),
                          np.ones(len(above), dtype=bool))

    no, yes = [False], [True]
    for what, history, load, expected in (
            ("inherently unstable", no + 9 * yes, 0.04, 1),
            ("in one go", 9 * no + 9 * yes, 0.3, 2),
            ("short pauses", 2 * (no + 5 * yes) + no + 9 * yes, 0.3, 3),
            ("one short pause", no + 5 * yes + no + 9 * yes, 0.3, None),
            ("a long one", no + 25 * yes + no + 9 * yes, 0.3, 4)):
        checks.equal(f"example: {what}", example(*history, load=load), expected)
    checks.equal("trends of the parameter files",
                 [read_trend(a) for a in ("1", "4b", "4c")],
                 [(0.0, 3.6, 0.9), (3.0, 3.6, 0.9), (6.0, 3.6, 0.9)])
    # t of 7 degrees of freedom: 2.365 (tables); mean 4.5, deviation 2.449
    low, high = mean_of_few(np.arange(1, 9))[1:]
    checks.between("Student's interval of 1 to 8", high - low, 4.094, 4.097)
    # 2 / 2^9; 2 (1 + 5 + 10) / 2^5 is 1; 2 (1 + 4) / 2^4; nothing differs
    checks.equal("pairs: p", [sign_test(*pair) for pair in (
        (9, 0), (3, 2), (1, 3), (0, 0))], [2**-8, 1.0, 0.625, 1.0])


def check_extension(checks, path, plane):
    """Tables that are there, 40 realisations and a lost one, and later runs."""
    from chapter6_data import Set, take

    def later(rows, code):
        campaign(path("output-chapter6-analysis1-2d"), rows, code)
        said = take(path("output-chapter6-analysis1-2d"), path("data"))
        return said, Set(path("data/analysis1-2d.csv"))

    said, table = later(plane[:3], "a")
    checks.equal("fewer of the same campaign take nothing away", (
        said.endswith("3 realisations are in both, 0 of them differ"),
        len(table), table.hashes), (True, 40, ["a"]))
    with open(path("data/analysis1-2d.csv"), encoding="utf-8") as file:
        before = file.read()
    said, table = later([plane[0], row(1, 0.05), row(41, 0.2)], "a")
    with open(path("data/analysis1-2d.csv"), encoding="utf-8") as file:
        checks.equal("others of the same campaign are refused", (
            "left as it is; 1 of 2 realisations differ" in said,
            file.read() == before), (True, True))
    at_rest = row(39, 0.5, outcome="stable", masses=0)
    said, table = later([at_rest, row(41, 0.2), row(42, 0.3)], "other")
    checks.equal("one that stood, in both, does not show that they are the same", (
        "in place of another" in said, len(table)), (True, 3))
    later([at_rest, row(40, 0.3), row(41, 0.2)], "other")
    slower = [row(i, load)[:-1] + (9.0,) for i, load in ((41, 0.2), (42, 0.3))]
    said, table = later(slower + [row(43, 0.7), row(9, 0.1)], "later")
    checks.equal("one that slid does: extended, in the order of the numbers",
                 (table.numbers, table.hashes),
                 ([9, 39, 40, 41, 42, 43], ["other", "later"]))
    said, table = later(slower + [row(44, 0.7)], "later")
    checks.equal("and again by the second one", (len(table), table.hashes),
                 (7, ["other", "later"]))
    _, table = later([at_rest, row(45, 0.1)], "rest")
    checks.equal("one that stood does not", table.numbers, [39, 45])
    later([row(41, 0.2), row(42, 0.3)], "third")
    said, table = later([row(41, 0.2), row(42, 0.31)], "fourth")
    checks.equal("not if one differs", (
        "1 of them differ" in said, len(table), table.hashes),
        (True, 2, ["fourth"]))


def main():
    source = sys.argv[2]
    checks = Checks()
    check_readings(checks, source)
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        # 40 in plane strain: 8 bear 0.04 m, 4 0.06 m, the others 0.1 to 0.5 m;
        # one more was lost.
        loads = 8 * [0.04] + 4 * [0.06] + list(np.linspace(0.1, 0.5, 28))
        plane = [row(i, load, volume=0.6 if i < 10 else 0.4)
                 for i, load in enumerate(loads)]
        campaign(path("output-chapter6-analysis1-2d"),
                 plane + [row(40, None, "numerical failure")])
        # Own weight: 0 to 9 slide, the last of them in crumbs that the outcome
        # does not know; 10 moves, the others rest.
        campaign(path("weight1-2d"), [
            row(i, masses=2 if i < 10 else 0, outcome="initial failure"
                if i < 9 else "still moving" if i < 11 else "stable")
            for i in range(40)])
        campaign(path("analysis1"), [
            row(0, 0.02, width=4.0, masses=4, side=1, centred=2),
            row(20, 0.9, width=8.0, masses=3, side=1), row(30, 0.2, width=5.0)],
            report=False)
        campaign(path("analysis2b-2d"),
                 [row(i, load - 0.02) for i, load in enumerate(loads)], "b")
        campaign(path("analysis4c-2d"), plane[:5], "c", seed=2)
        os.makedirs(path("foundation-2d"))
        with open(path("foundation-2d/summary.json"), "w",
                  encoding="utf-8") as file:
            json.dump({"end_time": 15, "loads": [
                {"factor": 0.31, "stop_time": 1.1}], "sliding_masses": {
                    "relative_failure_volume": 0.4, "damaged_crest_width": None,
                    "retrogression_distance": 1.0625}}, file)
        with open(path("waker"), "w", encoding="utf-8") as file:
            file.write(MERGE)
        os.chmod(path("waker"), stat.S_IRWXU)
        names = ("output-chapter6-analysis1-2d", "weight1-2d", "analysis2b-2d",
                 "analysis4c-2d", "foundation-2d")
        done, _ = call(source, folder, path("analysis1"))
        checks.equal("not merged, and no program", (
            done.returncode, "no report" in done.stderr), (1, True))
        # A file that is there is not computed.
        os.makedirs(path("data"), exist_ok=True)
        with open(path("data/load_examples.csv"), "w",
                  encoding="utf-8") as file:
            file.write("# histories\nexample,realisation,time_s,load_m,"
                       "settlement_m,settlement_rate_m_per_s\n"
                       "1,0,0,0,0,0\n1,0,1,0.04,0.1,0.2\n")
        done, page = call(source, folder, *map(path, names), path("analysis1"),
                          "--waker", path("waker"))
        checks.equal("errors", done.stderr, "")
        checks.equal("the campaign that is not merged is left as it is",
                     sorted(os.listdir(path("analysis1"))),
                     ["campaign.json", "journal-00000.jsonl",
                      "parameters.prm"])
        figures = sorted(os.listdir(path("figures")))
        checks.equal("figures", figures, [
            f"figure_6_{n:02}.png" for n in (2, 3, 12, 13, 14, 15, 16, 24, 25)
        ] + ["pairs.png"])
        checks.equal("that are empty", [n for n in figures if os.path.getsize(
            path("figures/" + n)) < 8000], [])
        checks.equal("what is missing is said", sum(
            line in done.stdout.splitlines() for line in (
                "figure_6_02: drawn without example [2, 3, 4]",
                "figure_6_15: drawn without 2B in 3D",
                "figure_6_17: not drawn, only of 1 there are realisations")),
            3)
        has(checks, "and on the page", page, "A lower coefficient of "
            "variation. *Not run yet.*")
        has(checks, "a figure of it", page, "![6.16](figures/figure_6_16.png)")
        has(checks, "what to render", page, "under the load, widest first "
            "mass | no. 20, N = 3 | 0.90 |")
        checks.equal("the rest of the page", (page.startswith("before\n"),
                     page.endswith("after\n"), "former text" in page),
                     (True, True, False))
        has(checks, "first class: 12 of 40 (0.166 to 0.465, tables)", page,
            "fig. 6.12 | 3D 0.104, 2D 0.201 | 0.333 [0.0084, 0.906], 1 of 3 | "
            "0.3 [0.166, 0.465], 12 of 40 |")
        has(checks, "screen", page,
            "*not run yet* | 0.25 [0.127, 0.412], 10 of 40; the outcome of 9 is "
            "*initial failure* |")
        has(checks, "half the volume", page, "0.25 [0.127, 0.412], 10 of 40 |")
        for line in ("| slides | 8 | 2 | 0 | 10 |",
                     "| moves at the end, has not slid | 0 | 1 | 0 | 1 |",
                     "| at rest | 0 | 1 | 28 | 29 |",
                     "- The outcome is *initial failure* of 9 of the 10 that "
                     "slide, and of 0 of the 1 that move and have not slid.",
                     "0.05 m says the same as the screen of 38 of 40.",
                     "0.1 m says the same as the screen of 38 of 40."):
            has(checks, f"screen and load: {line[:40]}", page, line)
        # Twins bear 0.04 and 0.1 + 8, 18 times 0.4 / 27 m.
        has(checks, "pairs", page,
            "| 1: base case | 3 | 0.333 [0.0084, 0.906], 1 of 3 | 0.373")
        has(checks, "classes of 7.4: 5 masses after the first", page,
            "| 1: base case | 3 | 5 | 2 | 2 | 0 | 1 | 0.667 [0.0943, 0.992], "
            "2 of 3 | 0.333 [0.0084, 0.906], 1 of 3 |")
        has(checks, "the lower mean bears 0.02 m less", page,
            "| 2B: 3.4 kPa | 2D | 40 | down −0.02 [−0.02, −0.02] |")
        checks.equal("another seed has no pairs",
                     "| 4C: k = 6 kPa/m | 2D" in page, False)
        has(checks, "lost realisations are counted", page,
            "| 1: base case, 2D | 40 | 1 | 0 of 60000 | 2, 2 | `a`, seed 1 |")
        # (8 * 0.04 + 4 * 0.06 + 28 * 0.3) / 40
        has(checks, "mean strengths", page, "| *not run yet* | 0.22 against "
            "0.31, N = 40 |")

        check_extension(checks, path, plane)
    checks.finish()


if __name__ == "__main__":
    main()
