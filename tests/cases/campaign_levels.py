#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Levels are above any datum: a campaign of a dyke whose crest is at -1 m, and of
the same dyke 10 m higher. All results are the same but for the shift.

    campaign_levels.py WAKER SOURCE_DIRECTORY
"""

import csv
import json
import math
import os
import re
import sys
import tempfile

import h5py
import numpy as np
from campaign_case import TIMINGS, Campaign, Checks

# Columns of tables and variables of the store that are levels.
LEVELS = {"water_level", "crest_level", "base_level", "initial_height",
          "residual_height", "height_after_first_slide", "slide_height",
          "mass_y",
          "hydraulicload"}
# Names of the scenarios.
NAMES = {"value", "scenario_value", "scenario_hash", "hash"}
# Not the same: round-off decides whether a residual is just above a tolerance.
COUNTS = {"newton_iterations", "linear_iterations"}
LOW, N = -6.0, 5  # base, m; realisations of each level


def settings(base):
    corners = ((0, 0), (30, 0), (15, 5), (5, 5))
    return {
        "Grid/Lower corner": f"-6, {base:g}",
        "Grid/Upper corner": f"42, {base + 6:g}",
        "Soil profile/dyke/Polygon": "; ".join(
            f"{x:g}, {y + base:g}" for x, y in corners),
        "Sweep/Parameter": "Water/Level",
        "Sweep/Values": f"{base + 4.75:g}; {base + 3.0:g}",
        "Risk/Level distribution": "Gumbel",
        "Risk/Gumbel location": f"{base + 3.5:g}",
        "Risk/Gumbel scale": "0.4",
        "Risk/Allowed probability": "0.3",
        "Risk/Consequence": "1e8",
        # So that one iteration more or less is less than what is compared.
        "Newton/Tolerance": 1e-9,
        "Newton/Linear tolerance": 1e-6,
        "Newton/Maximum iterations": 30,
    }


def at_level(path, level, folder):
    """A copy of a file with another level: it must be right before the sweep."""
    with open(path, encoding="utf-8") as file:
        text, n = re.subn(r"(?m)^( *set Level *=).*", rf"\1 {level:g}", file.read())
    assert n == 1, f"{n} levels in {path}"
    with open(folder + ".prm", "w", encoding="utf-8") as file:
        file.write(text)
    return folder + ".prm"


def same(a, b, shift):
    """Equal numbers but for round-off, or equal texts."""
    try:
        a, b = float(a), float(b)
    except (TypeError, ValueError):
        return a == b
    if math.isnan(a) or math.isnan(b):
        return math.isnan(a) and math.isnan(b)
    return abs(a + shift - b) <= 1e-6 * max(1.0, abs(a))


def compare_tables(check, low, high, shift):
    names = sorted(os.listdir(os.path.join(low, "report")))
    n = 0
    for name in names:
        if not name.endswith(".csv"):
            continue
        rows = []
        for folder in (low, high):
            with open(os.path.join(folder, "report", name), encoding="utf-8",
                      newline="") as file:
                rows.append(list(csv.DictReader(file)))
        different = [
            f"{column}: {a[column]} and {b[column]}"
            for a, b in zip(*rows) for column in a
            if column not in {*NAMES, *COUNTS, *TIMINGS} and not same(
                a[column], b[column], shift if column in LEVELS else 0.0)]
        n += sum(len(row) for row in rows[0])
        check(len(rows[0]) == len(rows[1]) and not different, name,
              "; ".join(different[:3]))
    check(len(names) >= 15 and n > 1000, "tables that were compared",
          f"{len(names)}, {n} cells")


def compare_json(check, low, high, shift):
    reports = []
    for folder in (low, high):
        with open(os.path.join(folder, "report", "report.json"),
                  encoding="utf-8") as file:
            reports.append(json.load(file))
    different = []

    def visit(a, b, path, name):
        if isinstance(a, dict):
            for key in a:
                if key not in NAMES | {"machines", "notes"}:
                    visit(a[key], b[key], f"{path}/{key}", key)
        elif isinstance(a, list):
            for i, (x, y) in enumerate(zip(a, b)):
                visit(x, y, f"{path}/{i}", name)
        elif not same(a, b, shift if name in LEVELS else 0.0):
            different.append(f"{path}: {a} and {b}")

    visit(*reports, "", "")
    check(not different, "report.json", "; ".join(different[:3]))
    first = reports[0]["scenarios"][0]
    check(first["crest_level"] == -1.0, "crest at -1 m", first["crest_level"])
    check(first["water_level"] == -1.25, "water at -1.25 m",
          first["water_level"])
    p = reports[0]["yearly"]["P_level_above_the_crest"]
    right = 1 - math.exp(-math.exp(-(-1.0 - (LOW + 3.5)) / 0.4))
    check(abs(p - right) < 1e-12, "water above the crest", f"{p}, {right}")
    check(reports[0]["yearly"]["P_F"]["high"] > 0.0, "P(F) per year")


def compare_stores(check, low, high, shift):
    with h5py.File(os.path.join(low, "results.h5")) as a, \
            h5py.File(os.path.join(high, "results.h5")) as b:
        different = []
        for name in a:
            if name in {*NAMES, *COUNTS, *TIMINGS}:
                continue
            x, y = a[name][()], b[name][()]
            if x.shape != y.shape or not np.allclose(
                    x + (shift if name in LEVELS else 0.0), y, rtol=1e-6,
                    atol=1e-6, equal_nan=True):
                different.append(name)
        check(set(a) == set(b) and not different, "results.h5",
              " ".join(different))
        outcomes = a["outcome"][()]
    check(len(np.unique(outcomes)) > 1, "dykes that stand, and others",
          outcomes.tolist())


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    check, shift = Checks(), 10.0
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        folders = []
        for name, base in (("low", LOW), ("high", LOW + shift)):
            folders.append(os.path.join(folder, name))
            campaign = Campaign(sys.argv[1], sys.argv[2], folders[-1], N,
                                set=settings(base))
            campaign.file = at_level(campaign.file, base + 4.75, folders[-1])
            campaign.run()
            text = campaign.call("status")
            check("Per year" in text and "macro-instability" in text,
                  f"{name}: years and verdicts on the screen")
        compare_tables(check, *folders, shift)
        compare_json(check, *folders, shift)
        compare_stores(check, *folders, shift)
    check.exit()


if __name__ == "__main__":
    main()
