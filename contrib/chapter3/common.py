# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the studies of chapter 3 have in common: running the program, reading
nodal forces, writing figures with their data.

A run is kept in a folder and is not repeated: a study that was interrupted goes
on where it stopped. A changed program, parameter file or setting makes it run
again; `--again` repeats everything.
"""

import argparse
import csv
import hashlib
import json
import os
import shutil
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
PARAMETERS = os.path.join(ROOT, "parameters", "chapter3")
RESULTS = os.path.join(ROOT, "doc", "results", "chapter3")

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))
from waker_case import Run, read_points  # noqa: F401

plt.rcParams.update({
    "figure.dpi": 110, "savefig.dpi": 110, "axes.grid": True,
    "grid.alpha": 0.3, "font.size": 9, "legend.frameon": False,
})

# How the methods are named and drawn in every figure: thesis, section 3.3.
METHODS = {
    "points": ("surface points, $F_{mp}$", "C3", "--"),
    "nodes": ("surface nodes, $F_{nodes}$", "C1", ":"),
    "surface": ("exact surface, $F_{surface}$", "C2", "-."),
    "detected": ("proximity field", "C4", (0, (1, 1))),
    "volume": ("volume, $F_{volume}$", "C0", "-"),
    "contour": ("contour, $F_{GIMP}$", "C0", "-"),
}


class Failed(Exception):
    """The program ended with a numerical failure (exit code 3)."""


class Runs:
    """Runs of the program, each in a folder of its own below `folder`."""

    def __init__(self, arguments):
        self.waker = os.path.abspath(arguments.waker)
        self.folder = os.path.abspath(arguments.runs)
        self.again = arguments.again
        with open(self.waker, "rb") as stream:
            self.program = hashlib.sha256(stream.read()).hexdigest()
        os.makedirs(self.folder, exist_ok=True)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write_chain(self, name, corners):
        """A closed chain as a file for a user surface: its path."""
        path = self.path(name + ".txt")
        lines = [f"{x!r} {y!r}" for x, y in list(corners) + [corners[0]]]
        write_text(path, "\n".join(lines) + "\n")
        return path

    def call(self, arguments):
        # MPI looks for no other processes: a run starts in half the time.
        environment = dict(os.environ, OMPI_MCA_ess_singleton_isolated="1")
        return subprocess.run([self.waker, *arguments], capture_output=True,
                              text=True, env=environment, check=False)

    def run(self, name, file, sets, options=(), may_fail=False):
        """waker run of parameters/chapter3/<file> with {"Section/Name": value}
        into the folder `name`, unless that has been done."""
        folder = self.path(name)
        arguments = ["run", os.path.join(PARAMETERS, file), *options]
        values = {"Output/Checkpoint interval": 0, **sets}
        for key, value in values.items():
            arguments += ["--set", f"{key}={value}"]
        with open(arguments[1], encoding="utf-8") as stream:
            inputs = {"arguments": arguments, "file": stream.read(),
                      "program": self.program}
        stamp = os.path.join(folder, "inputs.json")
        if not self.again and os.path.exists(stamp):
            with open(stamp, encoding="utf-8") as stream:
                if json.load(stream) == inputs:
                    return Run(folder)
        shutil.rmtree(folder, ignore_errors=True)
        done = self.call([*arguments, "--set", f"Output/Directory={folder}"])
        if done.returncode != 0 and not (may_fail and done.returncode == 3):
            sys.exit(f"{self.waker} {' '.join(arguments)}\nended with "
                     f"{done.returncode}:\n{done.stdout}{done.stderr}")
        write_text(stamp, json.dumps(inputs))
        return Run(folder)


class Nodes:
    """The nodes of a grid file: `position` and one array per field. The files
    hold fields in single precision: 6e-8 of the value is round-off."""

    def __init__(self, run, time=None):
        mesh = meshio.read(run.frame(time, "grid")[1])
        # The file repeats a node in each of its cells.
        keys = np.round(mesh.points * 1e6).astype(np.int64)
        _, first = np.unique(keys, axis=0, return_index=True)
        self.position = mesh.points[first]
        self.fields = {name: np.squeeze(values)[first]
                       for name, values in mesh.point_data.items()}
        self.active = self.fields["mass"] > 0.0

    def __getitem__(self, name):
        return self.fields[name]

    def force(self, method):
        return self.fields["force_" + method]

    def at(self, name, x, y, component=0):
        """A component of a field at the node (x, y); 0 outside the file."""
        place = np.flatnonzero((abs(self.position[:, 0] - x) < 1e-6)
                               & (abs(self.position[:, 1] - y) < 1e-6))
        return self.fields[name][place[0], component] if place.size else 0.0


def write_text(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    temporary = path + ".tmp"
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)


def save_data(name, columns):
    """Write {column: values} as figures/<name>.csv."""
    path = os.path.join(RESULTS, "figures", name + ".csv")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        for row in zip(*columns.values()):
            writer.writerow([f"{value:.6g}" if isinstance(value, float)
                             else value for value in row])
    return path


def save(figure, name):
    path = os.path.join(RESULTS, "figures", name + ".png")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    print("   ", os.path.relpath(path, ROOT), flush=True)


def save_numbers(study, numbers):
    """Keep what the table of the page is made of: numbers/<study>.json."""
    path = os.path.join(RESULTS, "numbers", study + ".json")
    write_text(path, json.dumps(numbers, indent=1) + "\n")
    for key, value in numbers.items():
        print(f"    {key}: {value}", flush=True)


def load_numbers(study):
    path = os.path.join(RESULTS, "numbers", study + ".json")
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def parse_arguments(description):
    """--waker, --runs and --again, which every study has."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"),
                        help="the program (default: %(default)s)")
    parser.add_argument("--runs", default="chapter3-runs",
                        help="folder for the runs (default: %(default)s)")
    parser.add_argument("--again", action="store_true",
                        help="repeat runs that are there")
    return parser.parse_args()
