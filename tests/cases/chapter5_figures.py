#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 5.5 to 5.14, the comparison and the export of outcomes, from stores
of a few realisations whose numbers are known by hand.

    /usr/bin/python3 tests/cases/chapter5_figures.py WAKER SOURCE_DIRECTORY [other]

"other": instead, what is drawn of another dyke, and of any campaign. The program
itself is not needed: fake_waker.py stands for it.
"""

import csv
import os
import subprocess
import sys
import tempfile

import numpy as np

from synthetic_store import write_store
from waker_case import Checks

STABLE, INITIAL, FLOODING, NUMERICAL = range(4)
NONE, ONLY, RETROGRESSIVE, HORIZONTAL, OUTER = range(5)


def dyke(outcome, kind=NONE, s1=None, flood=None, width=11.0, height=5.0,
         first=None, slides=0, thesis=True):
    """What a store holds of one realisation."""
    values = {"outcome": outcome, "failure_class": kind, "n_slides": slides,
              "attempts": 1, "initial_width": 11.0, "initial_height": 5.0,
              "residual_width": width, "residual_height": height,
              "wall_time": 2.0}
    if s1 is not None:
        values["initial_failure_time"] = s1
        if thesis:
            values["initial_failure_time_thesis"] = s1
        values["width_after_first_slide"] = first
    if flood is not None:
        values["flooding_time"] = flood
    return values


# 10 that count, 5 failed, 2 of them flooded; one more failed numerically.
BASE = {
    **{i: dyke(STABLE) for i in range(5)},
    5: dyke(INITIAL, ONLY, 3.5, None, 8.2, 5.0, 8.2, 1),
    6: dyke(INITIAL, ONLY, 3.0, None, 6.2, 4.99, 6.2, 1),
    7: dyke(INITIAL, RETROGRESSIVE, 2.5, None, 2.4, 4.85, 6.3, 2),
    8: dyke(FLOODING, RETROGRESSIVE, 4.0, 8.0, 0.0, 4.74, 6.4, 3),
    9: dyke(FLOODING, HORIZONTAL, 2.0, 5.0, 0.0, 4.74, 5.5, 2),
    11: dyke(NUMERICAL, NONE),
}
FEW = {i: dyke(STABLE) for i in range(4)}
ONE_OF_FOUR = {**FEW, 3: dyke(INITIAL, ONLY, 3.2, None, 5.2, 5.0, 5.2, 1)}
OUTWARDS = {**FEW,
            2: dyke(INITIAL, OUTER, 2.2, None, 14.3, 4.5, 14.3, 1, False),
            3: dyke(INITIAL, ONLY, 3.2, None, 5.5, 3.5, 5.5, 1)}


def read(folder, name):
    """(rows as dictionaries, comment lines)"""
    with open(os.path.join(folder, name + ".csv"), encoding="utf-8") as file:
        lines = file.readlines()
    comments = [line for line in lines if line.startswith("#")]
    return list(csv.DictReader(lines[len(comments):])), comments


def pick(rows, **conditions):
    return [row for row in rows
            if all(row[key] == value for key, value in conditions.items())]


def only(rows, **conditions):
    found = pick(rows, **conditions)
    if len(found) != 1:
        print(f"FAIL | {len(found)} rows with {conditions}")
        sys.exit(1)
    return found[0]


def number(row, key):
    return float(row[key])


def run(source, script, *words):
    done = subprocess.run(
        [sys.executable, os.path.join(source, "contrib", "plots", script),
         *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{script} ended with {done.returncode}\n{done.stdout}"
                 f"{done.stderr}")
    return done


def check_probabilities(checks, folder):
    rows, comments = read(folder, "figure_5_06")
    checks.equal("5.6: numerical failures are said", "1 more" in comments[-1],
                 True)
    for event, time, expected in (("S1", "1.9", 0.0), ("S1", "2", 0.1),
                                  ("S1", "3", 0.3), ("S1", "5", 0.5),
                                  ("F", "4.9", 0.0), ("F", "8", 0.2)):
        row = only(rows, event=event, kind="before", time_s=time)
        checks.equal(f"5.6: P({event}) before {time} s",
                     number(row, "probability"), expected)
    checks.equal("5.6: COV of the points beside it", number(only(
        rows, event="S1, points", kind="before", time_s="10"),
        "probability"), 0.25)
    # Clopper & Pearson 1934: tables for 5 of 10 and 2 of 10
    row = only(rows, event="S1", kind="before", time_s="10")
    checks.between("5.6: 5 of 10, low", number(row, "low"), 0.1870, 0.1872)
    checks.between("5.6: 5 of 10, high", number(row, "high"), 0.8128, 0.8130)
    row = only(rows, event="F", kind="before", time_s="10")
    checks.between("5.6: 2 of 10, low", number(row, "low"), 0.0251, 0.0253)
    checks.between("5.6: 2 of 10, high", number(row, "high"), 0.5560, 0.5562)
    row = only(rows, event="S1", kind="in bin", time_s="2.5")
    checks.equal("5.6: share in 2.5 to 3 s", number(row, "probability"), 0.1)

    rows, _ = read(folder, "figure_5_08")
    row = only(rows, scale_m="24", quantity="F_given_S1")
    checks.equal("5.8: the larger base case stands in for its equal",
                 (row["count"], row["n"]), ("2", "5"))
    row = only(rows, scale_m="2", quantity="F_given_S1")
    checks.equal("5.8: no failure gives no estimate",
                 (row["estimate"], row["low"], row["high"]), ("", "0", "1"))
    row = only(rows, scale_m="48", quantity="S1")
    checks.equal("5.8: theta_h = 48 m", number(row, "estimate"), 0.25)
    rows, _ = read(folder, "figure_5_07")
    row = only(rows, event="S1", scale_m="48", time_s="3.2")
    checks.equal("5.7: theta_h = 48 m, 3.2 s", number(row, "probability"),
                 0.25)

    rows, _ = read(folder, "figure_5_13")
    for name, expected in (("S1", "2"), ("S1_thesis", "1"), ("F", "0")):
        checks.equal(f"5.13: {name} at 2 m",
                     only(rows, freeboard_m="2", quantity=name)["count"],
                     expected)
    rows, _ = read(folder, "figure_5_12")
    row = only(rows, event="S1", freeboard_m="2", time_s="2.5")
    checks.equal("5.12: 2 m, 2.5 s", number(row, "probability"), 0.25)


def check_geometry(checks, folder):
    rows, comments = read(folder, "figure_5_09")
    checks.equal("5.9: only scales of 4 m and more",
                 sorted({row["scale_m"] for row in rows}, key=float),
                 ["24", "48"])
    heights = pick(rows, quantity="residual_height_above_water", scale_m="24")
    full = [row for row in heights if number(row, "count") > 0]
    checks.equal("5.9: 0.1 m and 0.25 m above the water",
                 [(row["low"], row["count"]) for row in full],
                 [("0.0875", "1"), ("0.2375", "2")])
    # (0.25 + 0.24 + 0.10) / 3
    checks.equal("5.9: mean of H_r - h",
                 "24 m: 0.1967 m" in comments[-1], True)
    widths = pick(rows, quantity="residual_width", scale_m="24")
    checks.equal("5.9: widths of dykes that stand",
                 [row["low"] for row in widths if number(row, "count") > 0],
                 ["2", "6", "8"])
    row = only(rows, quantity="realisations: numerical failure", scale_m="24")
    checks.equal("5.9: numerical failures", row["count"], "1")

    rows, _ = read(folder, "figure_5_10")
    row = only(rows, width_low_m="6")
    checks.equal("5.10: W_S1 6 to 7 m", (row["n"], row["n_F"]), ("3", "1"))
    row = only(rows, width_low_m="5")  # 5.5 m of the base case, 5.2 m at 48 m
    checks.equal("5.10: W_S1 5 to 6 m", (row["n"], row["n_F"]), ("2", "1"))

    rows, _ = read(folder, "figure_5_14")
    wide = [row for row in pick(rows, quantity="width_over_initial",
                                freeboard_m="2") if number(row, "count") > 0]
    checks.equal("5.14: W_r / W_i of 0.5 and 1.3",
                 [(row["low"], row["share_percent"]) for row in wide],
                 [("0.45", "50"), ("1.25", "50")])
    high = [row["low"] for row in pick(rows, quantity="height_over_initial",
                                       freeboard_m="2")
            if number(row, "count") > 0]
    checks.equal("5.14: (H_r - h) / (H_i - h) of 0.25 and 0.75", len(high), 2)


def check_realisations(checks, folder):
    rows, _ = read(folder, "figure_5_05")
    checks.equal("5.5: realisations that were chosen",
                 [(row["panel"], row["realisation"]) for row in rows],
                 list(zip("abcdef", "065789")))
    checks.between("5.5: (b) begins above the base at",
                   number(rows[1], "initiation_height_m"), 1.2, 1.7, "m")
    rows, _ = read(folder, "figure_5_11")
    checks.equal("5.11: outer slope at the lowest water",
                 (rows[0]["scenario"], rows[0]["realisation"]), ("2", "2"))


def check_fragility_line(checks, source):
    """The caption of fragility.png and where its line is broken."""
    sys.path.insert(0, os.path.join(source, "contrib", "plots"))
    from fragility_figure import estimated_only, undecided

    rows = [{"n": "15", "n_undecided": "15", "n_S1_not_final": "0"},
            {"n": "90", "n_undecided": "16", "n_S1_not_final": "2"}]
    checks.equal("fragility: how many are undecided",
                 undecided(rows).split(":")[0],
                 "31 of 136 undecided, 2 initial failures not final")
    checks.equal("fragility: all are decided",
                 undecided([{"n": "9", "n_undecided": "0",
                             "n_S1_not_final": "0"}]), "")
    fine = np.linspace(3.0, 4.5, 7)
    line = estimated_only(fine, fine, np.array([3.0, 3.5, 4.0, 4.5]), np.array(
        ["upper bound", "estimate", "estimate", "lower bound"]))
    checks.equal("fragility: the line beside bounds", list(np.isnan(line)),
                 [True, True, False, False, False, True, True])


def check_other_dyke(checks, source, folder, thesis):
    """What the thesis prints is not drawn beside another dyke; figures of any
    campaign have levels above datum."""
    other = os.path.join(folder, "other")
    shift = lambda i: {**i, "residual_height": i["residual_height"] - 6.0,
                       "initial_height": -1.0}
    write_store(other, [
        {"value": str(level), "water_level": level, "crest_level": -1.0,
         "realisations": {k: shift(v) for k, v in some.items()}}
        for level, some in ((-1.25, BASE), (-3.0, FEW))],
        swept="Water/Level", parameters=thesis.replace(
            "Initial strength  = 13", "Initial strength  = 6.5"))
    table = subprocess.run(
        [sys.executable, os.path.join(source, "contrib", "plots",
                                      "chapter5_table.py"),
         "--analysis3", other], capture_output=True, text=True, check=False)
    checks.equal("another dyke: no table", (table.returncode,
                 "Initial strength is 6.5" in table.stderr), (1, True))

    done = run(source, "campaign.py", other)
    checks.equal("campaign.py: what is not drawn", done.stderr.strip(),
                 "figure fragility is not drawn: needs report/fragility.csv "
                 "with two water levels: waker merge")
    figures = os.path.join(other, "figures")
    names = sorted(os.path.splitext(name)[0] for name in os.listdir(figures)
                   if name.endswith(".png"))
    checks.equal("campaign.py: figures", names,
                 ["convergence_0", "convergence_1", "outcomes",
                  "probabilities", "probability_time", "residual_height",
                  "residual_width", "resistance_width"])
    rows, _ = read(figures, "probabilities")
    row = only(rows, water_level_m="-1.25", quantity="S1")
    checks.equal("campaign.py: P(S1) at -1.25 m",
                 (row["count"], row["n"], row["kind"]), ("5", "10", "estimate"))
    row = only(rows, water_level_m="-3", quantity="F")
    checks.equal("campaign.py: none flooded at -3 m is a bound",
                 (row["estimate"], row["kind"]), ("0", "upper bound"))
    rows, _ = read(figures, "residual_height")
    full = [row for row in pick(rows, water_level_m="-1.25")
            if number(row, "count") > 0]
    checks.equal("campaign.py: heights are above datum",
                 [(row["low"], row["count"]) for row in full],
                 [("-1.16", "1"), ("-1.02", "1"), ("-1", "1")])
    rows, _ = read(figures, "outcomes")
    checks.equal("campaign.py: numerical failures", only(
        rows, outcome="numerical failure", water_level_m="-1.25")["count"],
                 "1")

    # A report that counts otherwise is noticed; what is missing is said.
    os.makedirs(os.path.join(other, "report"))
    with open(os.path.join(other, "report", "probabilities.csv"), "w",
              encoding="utf-8") as file:
        file.write("scenario,value,P_F,P_F_low,P_F_high\n"
                   "0,-1.25,0.0,0.0,0.602365\n1,-3,0.0,0.0,0.602365\n")
    done = run(source, "chapter5.py", "--analysis3", other, "--output",
               os.path.join(folder, "out3"))
    checks.equal("another dyke: no star, and a line that says so",
                 done.stderr.count("not a campaign of the thesis (Materials/"
                                   "clay/Initial strength is 6.5, not 13): its "
                                   "numbers are left out"), 1)
    checks.equal("warnings about the report",
                 done.stderr.count("report has P_F"), 1)
    checks.equal("what is not drawn",
                 sorted(line.split(" is ")[0] for line in
                        done.stderr.splitlines()
                        if line.startswith("figure")),
                 ["figure 5.10", "figure 5.11", "figure 5.5", "figure 5.6",
                  "figure 5.7, 5.8", "figure 5.9"])


def check_export(checks, source, folder):
    path = os.path.join(folder, "new", "folder", "outcomes.csv")
    run(source, "export_outcomes.py", os.path.join(folder, "analysis1"), path)
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    checks.equal("export: version and parameters in the head",
                 "0123456789abcdef" in lines[0], True)
    checks.equal("export: a flood", "0,9,2,2,,,5,0,4.74,3" in lines, True)
    checks.equal("export: a stable one", "0,0,0,,,,,11,5,0" in lines, True)
    check_export_again(checks, source, folder, path)
    many = os.path.join(folder, "many")
    write_store(many, [
        {"value": "a", "realisations": {i: dyke(STABLE) for i in range(60000)}},
        {"value": "b", "realisations": {0: dyke(STABLE)}}], swept="Water/Level")
    run(source, "export_outcomes.py", many, os.path.join(folder, "many.csv"))
    written = sorted(name for name in os.listdir(folder)
                     if name.startswith("many-"))
    checks.equal("export: more than a megabyte is cut", written,
                 ["many-0a.csv", "many-0b.csv", "many-1.csv"])
    sizes = [os.path.getsize(os.path.join(folder, name)) for name in written]
    checks.below("export: largest piece", max(sizes), 999999, "bytes")
    n = 0
    for name in written:
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            n += sum(line[0].isdigit() for line in file)
    checks.equal("export: no line lost", n, 60001)


def check_export_again(checks, source, folder, path):
    """What is there of the same hash is compared, and only extended."""
    def export(name, realisations):
        write_store(os.path.join(folder, name),
                    [{"hash": "b", "realisations": realisations}])
        return subprocess.run(
            [sys.executable, os.path.join(
                source, "contrib", "plots", "export_outcomes.py"),
             os.path.join(folder, name), path],
            capture_output=True, text=True, check=False)

    def n_lines():
        with open(path, encoding="utf-8") as file:
            return sum(line[0].isdigit() for line in file)

    done = export("longer", {**BASE, 10: dyke(STABLE)})
    checks.equal("export: a longer one extends it",
                 ("0 of 11 outcomes differ" in done.stdout, n_lines()),
                 (True, 12))
    done = export("shorter", {**BASE, 9: dyke(STABLE), 0: dyke(STABLE)})
    checks.equal("export: a shorter one is refused",
                 (done.returncode, "has 12 realisations" in done.stderr,
                  n_lines()), (1, True, 12))
    checks.equal("export: differences are counted",
                 "1 of 11 outcomes differ" in done.stderr, True)


def check_table(checks, source, folder, analyses):
    page = os.path.join(folder, "page.md")
    with open(page, "w", encoding="utf-8") as file:
        file.write("before\n<!-- begin comparison -->\nold\n"
                   "<!-- end comparison -->\nbetween\n"
                   "<!-- begin campaigns -->\n<!-- end campaigns -->\nafter\n")
    points = os.path.join(folder, "points")
    with open(os.path.join(folder, "analysis1", "parameters.prm"),
              encoding="utf-8") as file:
        thesis = file.read()
    write_store(points, [{"hash": "c", "realisations": ONE_OF_FOUR}],
                parameters=thesis, machines=[
        {"host": "node7", "processor": "P 1", "cores": 8, "version": "0.0.0",
         "compiler": "c++", "build_flags": "Fast", "journals": 1,
         "start": "2025-01-31T12:00:00Z", "realisations": 4,
         "wall_time": 7200.0}])
    words = [*analyses, "--analysis1-points", points, "--page", page]
    run(source, "chapter5_table.py", *words)
    run(source, "chapter5_table.py", *words)  # as often as one likes
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for words, expected in (
            ("the prose stays", "\nbetween\n<!-- begin"),
            ("P(S1)", "about 0.12 | 0.500 | 0.187 to 0.813 | 5 of 10 |"),
            ("P(F|S1)", "0.75 | 0.400 | 0.053 to 0.853 | 2 of 5 |"),
            ("largest drop", "0.300 at 24 m"),
            ("mean height at 48 m", "0.20 m | 0.250 m"),
            ("per core-hour", "| 2.000 | 1800 |"),
            ("points", "P(S₁), COV of the points | 5.4.1, fig. 5.6 | "
                       "about 0.12 | 0.250 | 0.006 to 0.806 | 1 of 4 |"),
            ("P(F), points", "P(F), COV of the points"),
            ("P(F|S1), points", "| 0.000 | 0.000 to 0.975 | 0 of 1 |"),
            ("machine", "| 1, points | node7: P 1 | 8 | c++, Fast | "
                        "2025-01-31T12:00:00Z | 4 | 2.00 |"),
            ("no machine", "| 1 | unknown: unknown | unknown | unknown, "
                           "unknown | unknown | 11 | 0.01 |")):
        checks.equal(f"table: {words}", expected in text, True)
    checks.equal("table: replaced", "\nold\n" in text, False)


def main():
    if len(sys.argv) < 3:
        sys.exit(f"usage: {sys.argv[0]} WAKER SOURCE_DIRECTORY")
    source, checks = os.path.abspath(sys.argv[2]), Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        path = lambda name: os.path.join(folder, name)
        with open(os.path.join(source, "parameters", "chapter5",
                               "analysis1.prm"), encoding="utf-8") as file:
            thesis = file.read()
        if "other" in sys.argv[3:]:
            check_other_dyke(checks, source, folder, thesis)
            checks.finish()
        write_store(path("analysis1"), [{"hash": "b", "realisations": BASE}],
                    parameters=thesis)
        write_store(path("analysis2"), [
            {"value": "48", "scale_x": 48.0, "realisations": ONE_OF_FOUR},
            {"value": "2", "scale_x": 2.0, "realisations": FEW},
            {"value": "24", "scale_x": 24.0, "hash": "b",
             "realisations": {i: BASE[i] for i in (0, 1)}}],
            swept="Random fields/strength/Scales of fluctuation",
            parameters=thesis)
        write_store(path("analysis3"), [
            {"value": "4.75", "water_level": 4.75, "realisations": ONE_OF_FOUR},
            {"value": "4", "water_level": 4.0, "realisations": ONE_OF_FOUR},
            {"value": "3", "water_level": 3.0, "realisations": OUTWARDS}],
            swept="Water/Level", parameters=thesis)
        analyses = [word for n in (1, 2, 3)
                    for word in (f"--analysis{n}", path(f"analysis{n}"))]

        write_store(path("base_points"),
                    [{"hash": "c", "realisations": ONE_OF_FOUR}],
                    parameters=thesis)
        done = run(source, "chapter5.py", *analyses, "--analysis1-points",
                   path("base_points"), "--output", path("out"),
                   "--waker", os.path.join(os.path.dirname(
                       os.path.abspath(__file__)), "fake_waker.py"))
        checks.equal("nothing to complain about", done.stderr, "")
        small = [f"figure_5_{i:02}{ending}" for i in range(5, 15)
                 for ending in (".png", ".pdf", ".csv")
                 if not os.path.exists(path(f"out/figure_5_{i:02}{ending}"))
                 or os.path.getsize(path(f"out/figure_5_{i:02}{ending}"))
                 < (100 if ending == ".csv" else 8000)]
        checks.equal("files that are missing or empty", small, [])
        check_probabilities(checks, path("out"))
        check_geometry(checks, path("out"))
        check_realisations(checks, path("out"))

        check_fragility_line(checks, source)
        check_table(checks, source, folder, analyses)
        check_export(checks, source, folder)
    checks.finish()


if __name__ == "__main__":
    main()
