# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the program on a case and read what it wrote.

Shared by the drivers in this folder (arguments: the waker program and the
source directory) and by the scripts in contrib/verification.
"""

import json
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import meshio
import numpy as np

import program
import runs


class Run:
    """The folder of a run."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self._statistics = None

    def __getitem__(self, key):
        """A value of summary.json; None where it is null."""
        return self.summary[key]

    @property
    def statistics(self):
        """{"Time (s)": array, ...}, one entry a step."""
        if self._statistics is None:
            self._statistics = runs.statistics(self.folder)
        return self._statistics

    def value(self, column, time):
        """A column of the statistics at a time (s), linear between steps."""
        return np.interp(time, self.statistics["Time (s)"],
                         self.statistics[column])

    def frames(self, name="particles"):
        """[(time, path), ...] of particles.pvd, surface.pvd or grid.pvd."""
        root = ElementTree.parse(os.path.join(self.folder, name + ".pvd"))
        return [(float(entry.get("timestep")),
                 os.path.join(self.folder, entry.get("file")))
                for entry in root.getroot().iter("DataSet")]

    def frame(self, time=None, name="particles"):
        """(time, path) of the frame nearest to a time; None: the last one."""
        frames = self.frames(name)
        if time is None:
            return frames[-1]
        return min(frames, key=lambda frame: abs(frame[0] - time))

    def points(self, time=None):
        """The material points as arrays, "position" among them."""
        return read_points(self.frame(time)[1])

    def surface(self, time=None):
        """Segments (n, 2, 2) of the detected surface, without the base."""
        mesh = meshio.read(self.frame(time, "surface")[1])
        lines = mesh.get_cells_type("line")
        keep = ((mesh.point_data["chain"].ravel()[lines[:, 0]] >= 0)
                & (mesh.points[lines][:, :, 1].max(axis=1) > 1e-9))
        return mesh.points[lines[keep]][:, :, :2]


def read_points(path):
    mesh = meshio.read(path)
    fields = {name: np.squeeze(values)
              for name, values in mesh.point_data.items()}
    fields["position"] = mesh.points
    order = np.argsort(fields["id"])
    return {name: values[order] for name, values in fields.items()}


class Workspace:
    """Runs cases in a folder, by default one that vanishes afterwards."""

    # Neither grids nor checkpoints are looked at.
    quiet = {"Output/Grid": "false", "Output/Checkpoint interval": 0}

    def __init__(self, waker, source, settings=None, folder=None):
        self.waker = os.path.abspath(waker)
        self.source = os.path.abspath(source)
        self.settings = settings or {}
        self.folder = folder
        self._temporary = None

    def __enter__(self):
        if self.folder is None:
            self._temporary = tempfile.TemporaryDirectory(prefix="waker-")
            self.folder = self._temporary.name
        return self

    def __exit__(self, *_):
        if self._temporary is not None:
            self._temporary.cleanup()

    def call(self, command, name, file, settings):
        """Run parameters/<file> into a folder of that name."""
        folder = os.path.join(self.folder, name)
        values = {**self.quiet, **settings, **self.settings,
                  "Output/Directory": folder}
        arguments = [self.waker, command,
                     os.path.join(self.source, "parameters", file),
                     "--overwrite"]
        for key, value in values.items():
            arguments += ["--set", f"{key}={value}"]
        # Anything but 0 ends the test; 3: a step did not converge.
        program.shared(self.waker).run(arguments[1:], check=True)
        return folder

    def run(self, name, file, sets=None):
        """waker run with the settings {"Section/Name": value}."""
        return Run(self.call("run", name, file, sets or {}))

    def factor_of_safety(self, name, file, sets=None):
        """waker strength-reduction: what strength_reduction.json holds."""
        folder = self.call("strength-reduction", name, file, sets or {})
        path = os.path.join(folder, "strength_reduction.json")
        with open(path, encoding="utf-8") as file_:
            return json.load(file_)


class Checks:
    """Compares numbers with what is expected, and prints both."""

    def __init__(self):
        self.made = 0
        self.failed = 0

    def _print(self, good, what, expected, obtained):
        self.made += 1
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'} | {what} | {expected} | "
              f"{obtained}", flush=True)

    def between(self, what, value, low, high, unit=""):
        good = value is not None and low <= value <= high
        text = "none" if value is None else f"{value:.4g} {unit}".strip()
        self._print(good, what, f"{low:g} to {high:g} {unit}".strip(), text)

    def below(self, what, value, limit, unit=""):
        good = value is not None and value <= limit
        text = "none" if value is None else f"{value:.4g} {unit}".strip()
        self._print(good, what, f"at most {limit:g} {unit}".strip(), text)

    def above(self, what, value, limit, unit=""):
        good = value is not None and value >= limit
        text = "none" if value is None else f"{value:.4g} {unit}".strip()
        self._print(good, what, f"at least {limit:g} {unit}".strip(), text)

    def equal(self, what, value, expected):
        self._print(value == expected, what, expected, value)

    def finish(self):
        if self.made == 0:
            sys.exit("nothing was checked")
        sys.exit(1 if self.failed else 0)


def workspace_of_arguments():
    """Workspace and further words of a driver:
    WAKER SOURCE_DIRECTORY [WORD ...] [SECTION/NAME=VALUE ...]."""
    if len(sys.argv) < 3:
        sys.exit(f"usage: {sys.argv[0]} WAKER SOURCE_DIRECTORY [WORD ...] "
                 "[SECTION/NAME=VALUE ...]")
    further = sys.argv[3:]
    settings = dict(item.split("=", 1) for item in further if "=" in item)
    words = [item for item in further if "=" not in item]
    return Workspace(sys.argv[1], sys.argv[2], settings), words
