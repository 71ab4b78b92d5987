# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the case tests in Python have in common: run the program, read what it
wrote, count what is not as expected."""

import os
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

import program


def run(waker, case, directory, **sections):
    """Run a .prm file into `directory`. Further parameters by section:
    Newton={"Tolerance": 1e-8}; "_" in a section's name stands for a blank, "__"
    for "/"."""
    command = [waker, "run", case, "--overwrite",
               "--set", "Output/Directory=" + directory]
    for section, values in sections.items():
        path = section.replace("__", "/").replace("_", " ")
        for name, value in values.items():
            command += ["--set", f"{path}/{name}={value}"]
    # Anything but 0 ends the test; 3: a step did not converge.
    program.shared(waker).run(command[1:], check=True)


def statistics(directory):
    """{column: array over the steps} of the file `statistics`."""
    path = os.path.join(directory, "statistics")
    with open(path, encoding="utf-8") as file:
        names = [line.split(": ", 1)[1].strip()
                 for line in file if line.startswith("#")]
    rows = np.loadtxt(path, ndmin=2)
    return {name: rows[:, i] for i, name in enumerate(names)}


def particles(directory):
    """Yield (time, points of meshio) of particles.pvd. Points keep their
    order."""
    import meshio
    path = os.path.join(directory, "particles.pvd")
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        yield (float(entry.get("timestep")),
               meshio.read(os.path.join(directory, entry.get("file"))))


class Check:
    """Prints each number with its limits; exit code 1 if one is outside."""

    def __init__(self):
        self.made = 0
        self.failed = 0

    def __call__(self, what, value, low, high):
        good = low <= value <= high
        self.made += 1
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'} {what}: {value:.6g}"
              f" (from {low:.6g} to {high:.6g})")

    def exit(self):
        if self.made == 0:
            sys.exit("nothing was checked")
        sys.exit(1 if self.failed else 0)
