# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading the store of a campaign: results.h5 and report/ in its folder, both
written by `waker merge`.

A Scenario gives its quantities as arrays over the realisations that have been
run, in the order of their numbers:

    base = Store("output-analysis1").scenarios[0]
    (base["outcome"] == FLOODING).mean()
"""

import csv
import json
import os
import sys

import h5py
import numpy as np

from estimates import proportion

# Flags of "outcome" and "failure_class" in the store.
(STABLE, INITIAL_FAILURE, FLOODING, NUMERICAL_FAILURE, STILL_MOVING,
 LOADS_CHANGE, STOPPED_BY_BOX) = range(7)
(NONE, INITIAL_ONLY, RETROGRESSIVE, HORIZONTAL, OUTER, SETTLED,
 OVERFLOW) = range(7)
OUTCOMES = ("stable", "initial failure", "flooding", "numerical failure",
            "still moving", "loads still change", "stopped by the box")
CLASSES = ("none", "initial only", "retrogressive", "horizontal", "outer",
           "settled", "overflow")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class Scenario:
    """One value of the swept parameter: n realisations that have been run."""

    def __init__(self, store, index):
        self.store, self.index = store, index
        file = store.file
        self.value = text(file["scenario_value"][index])
        self.hash = text(file["scenario_hash"][index])
        self.water_level = float(file["water_level"][index])  # m
        self.crest_level = float(file["crest_level"][index])  # m
        self.scale_x = float(file["scale_x"][index])  # theta_h, m
        self.scale_y = float(file["scale_y"][index])  # theta_v, m
        self.ran = file["outcome"][index, :] >= 0
        self.realisation = file["realisation"][:][self.ran]
        self._values = {}

    def __getitem__(self, name):
        """A quantity: array of n, or of n x slides."""
        if name not in self._values:
            self._values[name] = self.store.file[name][self.index][self.ran]
        return self._values[name]

    @property
    def freeboard(self):
        """H_i - h of the drawn profile (m)."""
        return self.crest_level - self.water_level

    @property
    def counted(self):
        """True where a realisation takes part in the probabilities: of a
        numerical failure, or of a dyke that was still moving, nobody knows
        whether it would have failed; they are counted apart."""
        return self["outcome"] <= FLOODING

    @property
    def n(self):
        return int(self.counted.sum())

    @property
    def n_numerical_failures(self):
        return int((self["outcome"] == NUMERICAL_FAILURE).sum())

    @property
    def n_undecided(self):
        return int((self["outcome"] > NUMERICAL_FAILURE).sum())

    def event_time(self, event):
        """Time (s) of "initial_failure" in any reading, of one of them,
        "initial_failure_geometry", "_thesis" or "_displacement", of an
        "inner_slide" or "outer_slide" by displacement, or of "flooding"; NaN
        where it did not occur."""
        names = {"initial_failure": ("initial_failure_time",
                                     "initial_failure_time_displacement"),
                 "initial_failure_geometry": ("initial_failure_time",),
                 "initial_failure_thesis": ("initial_failure_time_thesis",),
                 "initial_failure_displacement": (
                     "initial_failure_time_displacement",),
                 "inner_slide": ("inner_slide_time",),
                 "outer_slide": ("outer_slide_time",),
                 "flooding": ("flooding_time",)}[event]
        times = np.full(len(self.realisation), np.nan)
        for name in names:  # stores of version 0.1 have no displacement
            if name in self.store.file:
                times = np.fmin(times, self[name])
        return times

    def times(self, event):
        """event_time() of those that count and in which it occurred."""
        times = self.event_time(event)[self.counted]
        return times[~np.isnan(times)]

    def probabilities(self):
        """{"S1": ..., ...}, each (estimate, low, high, count, of how many) with
        the 95 % interval. S1 is an initial failure in any reading;
        F_given_S1_thesis is that of the failures in the thesis's."""
        events = {"S1": "initial_failure",
                  "S1_geometry": "initial_failure_geometry",
                  "S1_thesis": "initial_failure_thesis",
                  "S1_displacement": "initial_failure_displacement",
                  "inner_slide": "inner_slide", "outer_slide": "outer_slide",
                  "F": "flooding"}
        counts = {name: len(self.times(event))
                  for name, event in events.items()}
        rows = {name: (count, self.n) for name, count in counts.items()}
        floods = self.event_time("flooding") >= 0  # also over dykes without S1
        for name in ("S1", "S1_thesis"):
            fails = self.event_time(events[name]) >= 0
            rows["F_given_" + name] = (int((fails & floods & self.counted)
                                           .sum()), counts[name])
        return {name: proportion(count, n) + (count, n)
                for name, (count, n) in rows.items()}

    def residual(self):
        """True for the dykes with a residual geometry: failed, not flooded."""
        return self["outcome"] == INITIAL_FAILURE


class Store:
    """The folder of a campaign. `outcomes` are the names of its outcomes, by
    number."""

    def __init__(self, folder):
        self.folder = folder
        path = os.path.join(folder, "results.h5")
        if not os.path.exists(path):
            sys.exit(f"{path}: no such file; first: waker merge {folder}")
        self.file = h5py.File(path, "r")
        schema = int(self.file.attrs["schema_version"])
        if schema != 1:
            sys.exit(f"{path}: schema version {schema}; known: 1")
        flags = self.file["outcome"].attrs.get("flag_meanings")
        self.outcomes = (tuple(word.replace("_", " ")
                               for word in text(flags).split())
                         if flags is not None else OUTCOMES)
        self.scenarios = [Scenario(self, index)
                          for index in range(len(self.file["scenario_value"]))]
        self.check_report()

    def attribute(self, name):
        return text(self.file.attrs[name])

    def machines(self):
        """What computed the realisations: dictionaries with host, processor,
        cores, version, compiler, build_flags, start, journals, realisations
        and wall_time (s, summed). Empty in a store of an earlier version."""
        return (json.loads(self.attribute("machines"))
                if "machines" in self.file.attrs else [])

    def describe(self):
        """One line for the head of a CSV file."""
        return (f"Waker {self.attribute('version')}, parameters "
                f"{self.attribute('parameters_hash')}, seed "
                f"{self.attribute('seed')}")

    def report(self, name):
        """Rows of report/<name>.csv as dictionaries; empty if there is none."""
        path = os.path.join(self.folder, "report", name + ".csv")
        if not os.path.exists(path):
            return []
        with open(path, encoding="utf-8", newline="") as file:
            lines = [line for line in file if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def report_json(self):
        path = os.path.join(self.folder, "report", "report.json")
        if not os.path.exists(path):
            return {}
        with open(path, encoding="utf-8") as file:
            return json.load(file)

    def check_report(self):
        """Two programs count the same things: say so if they differ."""
        for row in self.report("probabilities"):
            scenario = self.scenarios[int(row["scenario"])]
            ours = scenario.probabilities()
            for name, expected in ours.items():
                key = "P_" + name
                if key not in row:
                    continue
                given = [row[key], row[key + "_low"], row[key + "_high"]]
                given = [float(x) if x not in ("", "null") else np.nan
                         for x in given]
                if not np.allclose(given, expected[:3], atol=2e-4,
                                   equal_nan=True):
                    print(f"warning: {self.folder}: scenario {row['scenario']}:"
                          f" report has {key} = {given}, the store gives "
                          f"{list(expected[:3])}", file=sys.stderr)


def with_base_case(scenarios, base):
    """The scenarios of a sweep, with the base case of analysis 1 in place of
    the same one (same hash) if that has fewer realisations."""
    if base is None:
        return list(scenarios)
    return [base if scenario.hash == base.hash and base.n > scenario.n
            else scenario for scenario in scenarios]
