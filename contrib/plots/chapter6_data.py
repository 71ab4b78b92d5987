# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outcomes of chapter 6: from folders of campaigns to tables, and back."""

import csv
import glob
import json
import os
import re
import shutil
import subprocess
import tempfile

import numpy as np

COLUMNS = ("realisation", "outcome", "end_time", "initial_height",
           "residual_height", "load", "load_stop_time",
           "relative_failure_volume", "retrogression_distance",
           "damaged_crest_width", "inner_slide_crest_cut", "n_masses",
           "first_mass_time", "first_mass_volume", "first_mass_width",
           "n_masses_remnant", "n_masses_side",
           "n_masses_behind_centred", "n_masses_behind_off_centre",
           "mean_strength", "unconverged_steps", "steps",
           "wall_time", "field_time")
# What says nothing of the slope.
TIMINGS = ("wall_time", "field_time")
DETERMINISTIC = "mean_strength.csv"
DETERMINISTIC_COLUMNS = ("name", "end_time", "load", "load_stop_time",
                         "relative_failure_volume", "retrogression_distance",
                         "damaged_crest_width")
# Load heights below this (m) are the first class of the thesis's histograms,
# "inherently unstable" there.
FIRST_CLASS = 0.1
# A crest that has sunk by more (m) is lost: Initial failure/Height loss.
HEIGHT_LOSS = 0.1
NAME = re.compile(r"(analysis|weight|length)\w+(-2d(-15s)?)?$")
# Fewer realisations than this show directions, not shares.
ENOUGH = 30

NAMES = {
    "1": "1: base case", "2b": "2B: 3.4 kPa", "2c": "2C: COV 0.1",
    "3a": "3A: θ_h = 0.25 m, ξ = 1", "3c": "3C: θ_h = 2.5 m, ξ = 10",
    "3d": "3D: θ_h = 5 m, ξ = 20", "3e": "3E: θ_h = 10 m, ξ = 40",
    "4b": "4B: k = 3 kPa/m", "4c": "4C: k = 6 kPa/m"}


def merged(folder, waker, work):
    """The folder, or, if its report is older than its journals or not there, a
    copy that the program has merged."""
    report = os.path.join(folder, "report", "realisations.csv")
    journals = glob.glob(os.path.join(folder, "journal-*.jsonl"))
    if os.path.exists(report) and all(
            os.path.getmtime(j) <= os.path.getmtime(report) for j in journals):
        return folder
    if not waker:
        if os.path.exists(report):
            return folder
        raise SystemExit(f"{folder}: no report; merge it, or give --waker")
    copy = os.path.join(work, os.path.basename(os.path.normpath(folder)))
    os.makedirs(copy)
    for name in ["campaign.json", "parameters.prm"]:
        shutil.copy(os.path.join(folder, name), copy)
    for journal in journals:
        shutil.copy(journal, copy)
    subprocess.run([waker, "merge", copy], check=True,
                   stdout=subprocess.DEVNULL)
    return copy


def take(folder, data, waker=None):
    """The columns of a campaign as a table in the data folder. A table that is
    there is extended by a campaign of the same hash if all realisations that are
    in both are equal, and else stays; or by another one (a later program has more
    parameters) if a realisation that slid is in both, too: slides are chaotic, and
    any difference shows. Else that campaign takes its place. Returns what was
    done."""
    name = os.path.basename(os.path.normpath(folder))
    name = name.replace("output-chapter6-", "")
    path = os.path.join(data, name + ".csv")
    if not NAME.match(name):
        return f"{folder}: no analysis of chapter 6 by its name: left out"
    with tempfile.TemporaryDirectory() as work:
        folder = merged(folder, waker, work)
        with open(os.path.join(folder, "campaign.json"),
                  encoding="utf-8") as file:
            campaign = json.load(file)
        with open(os.path.join(folder, "report", "realisations.csv"),
                  encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
    if not rows:
        return f"{folder}: no realisation is finished"
    columns = [c for c in COLUMNS if c in rows[0]]
    rows = [{c: row[c] if c == "outcome" else short(row[c]) for c in columns}
            for row in rows]
    head = [f"# campaign {campaign['hash']}, seed {campaign['seed']}, "
            f"Waker {campaign['version']}\n"]
    said = f"wrote {path}"
    if os.path.exists(path):
        old = Set(path)
        n_common, n_differ, any_slid = compare(old.all_rows, rows)
        known = campaign["hash"] in old.hashes
        if known and n_differ:
            return (f"{path}: left as it is; {n_differ} of {n_common} realisations "
                    f"differ in {folder}, which has the same hash: remove the "
                    "table to take them")
        if known or (old.seed == str(campaign["seed"])
                     and any_slid and n_differ == 0):
            said += (f": extended; {n_common} realisations are in both, "
                     f"{n_differ} of them differ")
            head = old.head + ([] if known else head)
            rows = list({int(row["realisation"]): row
                         for row in old.all_rows + rows}.values())
            rows.sort(key=lambda row: int(row["realisation"]))
        else:
            said += (f": in place of another campaign; {n_common} realisations "
                     f"are in both, {n_differ} of them differ")
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.writelines(head)
        writer = csv.DictWriter(file, columns, lineterminator="\n",
                                restval="", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
    return said


def compare(old, new):
    """(How many realisations are in both tables, how many of them differ in
    more than the time that they took, whether one of them slid.)"""
    lines = {row["realisation"]: row for row in old}
    both = [(lines[row["realisation"]], row) for row in new
            if row["realisation"] in lines]
    return len(both), sum(
        any(one.get(c, "") != row[c] for c in row if c not in TIMINGS)
        for one, row in both), any(
            float(row["n_masses"] or 0) > 0 for _, row in both)


def take_run(folder, data):
    """What a run of mean strengths (its folder: foundation, foundation-2d,
    foundation-2b-2d ...) came to, as a row of the data folder's list."""
    name = os.path.basename(os.path.normpath(folder))
    name = name.replace("output-chapter6-", "")
    if not name.startswith("foundation"):
        return f"{folder}: a run, but not of a foundation: left out"
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    masses = summary["sliding_masses"]
    values = {"name": name, "end_time": summary["end_time"],
              "load": summary["loads"][0]["factor"],
              "load_stop_time": summary["loads"][0]["stop_time"],
              **{key: masses[key] for key in DETERMINISTIC_COLUMNS
                 if key in masses}}
    path = os.path.join(data, DETERMINISTIC)
    rows = {row["name"]: row for row in read_runs(path)}
    rows[name] = {key: value if key == "name" else
                  "" if value is None else short(value)
                  for key, value in values.items()}
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, DETERMINISTIC_COLUMNS,
                                lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[key] for key in sorted(rows))
    return f"wrote {path}: {name}"


def read_runs(path):
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def short(text):
    """A number with six digits; nothing for NaN."""
    try:
        x = float(text)
    except ValueError:
        return ""
    return "" if np.isnan(x) else f"{x:.6g}"


class Set:
    """The realisations of one table that gave a result."""

    def __init__(self, path):
        self.name = os.path.splitext(os.path.basename(path))[0]
        with open(path, encoding="utf-8", newline="") as file:
            lines = file.readlines()
        self.head = [line for line in lines if line.startswith("# campaign")]
        found = [re.search(r"campaign (\S+), seed (\d+), Waker (\S+)", line)
                 for line in self.head]
        self.hashes = [f[1] for f in found]
        self.seed = found[0][2] if found else None
        self.all_rows = list(csv.DictReader(
            line for line in lines if not line.startswith("#")))
        self.rows = [r for r in self.all_rows
                     if r["outcome"] != "numerical failure"]
        self.numbers = [int(r["realisation"]) for r in self.rows]

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, column):
        return np.array([float(r[column]) if r.get(column) else np.nan
                         for r in self.rows])

    @property
    def n_lost(self):
        return len(self.all_rows) - len(self.rows)

    @property
    def is_plane(self):
        return "-2d" in self.name

    @property
    def is_screen(self):
        """Under its own weight alone."""
        return self.name.startswith(("weight", "length"))

    @property
    def analysis(self):
        """"1" of analysis1-2d, "2b" of weight2b."""
        return re.sub(r"^(analysis|weight)|-2d.*$", "", self.name)

    @property
    def label(self):
        if self.name.startswith("length"):
            return f"L = {self.name[len('length'):]} m, smooth ends"
        label = NAMES.get(self.analysis, self.analysis)
        return ("own weight, " if self.is_screen else "") + label + (
            ", to 15 s" if self.name.endswith("-15s") else "")

    @property
    def mask_fails(self):
        """Of a screen: slides under its own weight, that is a mass has been
        split off or the crest has sunk."""
        sunk = self["initial_height"] - self["residual_height"] > HEIGHT_LOSS
        flooded = np.array([r["outcome"] == "flooding" for r in self.rows])
        return (self["n_masses"] >= 1) | sunk | flooded

    @property
    def mask_outcome(self):
        """Has failed initially by its outcome: a body has moved that is larger
        than a share of the profile, which crumbs are not."""
        return np.array([r["outcome"] in ("initial failure", "flooding")
                         for r in self.rows])

    @property
    def mask_undecided(self):
        """Of a screen: has not slid and is not at rest at its end."""
        stable = np.array([r["outcome"] == "stable" for r in self.rows])
        return ~self.mask_fails & ~stable

    def of(self, numbers):
        """{realisation: row index}, of those numbers."""
        here = {number: i for i, number in enumerate(self.numbers)}
        return np.array([here[number] for number in numbers], dtype=int)


class Sets:
    """All tables of the data folder, by name."""

    def __init__(self, data):
        found = [Set(path) for path in sorted(glob.glob(os.path.join(
            data, "*.csv"))) if NAME.match(
                os.path.basename(path)[:-4])]
        self.by_name = {s.name: s for s in found if len(s)}
        self.runs = {row["name"]: row for row in read_runs(
            os.path.join(data, DETERMINISTIC))}

    def __iter__(self):
        return iter(self.by_name.values())

    def get(self, name):
        return self.by_name.get(name)

    def analysis(self, name, plane=False):
        return self.get(f"analysis{name}" + ("-2d" if plane else ""))

    def deterministic(self, name, plane, column):
        """Of the slope of mean strengths; None if it has not been run."""
        run = self.runs.get("foundation" + (f"-{name}" if name != "1" else "")
                            + ("-2d" if plane else ""), {})
        return float(run[column]) if run.get(column) else None

    def screen(self, name, plane=False):
        return self.get(f"weight{name}" + ("-2d" if plane else ""))


def paired(one, other):
    """Rows of both with the same realisation of the same field: (indices of
    one, indices of the other)."""
    if one is None or other is None or one.seed != other.seed:
        return np.array([], dtype=int), np.array([], dtype=int)
    both = sorted(set(one.numbers) & set(other.numbers))
    return one.of(both), other.of(both)
