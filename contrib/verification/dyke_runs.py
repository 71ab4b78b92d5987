# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts on the dyke of chapter 5 have in common: they run the program
and measure with the modules of the case tests."""

import argparse
import csv
import os
import sys

import numpy as np
from common import DATA, ROOT

sys.path.insert(0, os.path.join(ROOT, "tests", "cases"))

# pylint: disable=wrong-import-position
from waker_case import Checks, Workspace  # noqa: E402,F401


def option(name, default):
    """Take a value off the command line."""
    if name not in sys.argv:
        return default
    at = sys.argv.index(name)
    value = sys.argv[at + 1]
    del sys.argv[at:at + 2]
    return value


def workspace(description):
    """A workspace made from the command line."""
    parser = argparse.ArgumentParser(
        description=description,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--waker",
                        default=os.path.join(ROOT, "build", "bin", "waker"),
                        help="the program (default: build/bin/waker)")
    parser.add_argument("--set", action="append", default=[],
                        metavar="SECTION/NAME=VALUE",
                        help="for every run")
    arguments = parser.parse_args()
    settings = dict(item.split("=", 1) for item in arguments.set)
    return Workspace(arguments.waker, ROOT, settings)


def write_csv(name, columns, digits=6):
    """doc/verification/data/<name>.csv from {column: values}."""
    os.makedirs(DATA, exist_ok=True)
    path = os.path.join(DATA, name + ".csv")
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        for row in zip(*columns.values()):
            writer.writerow([value if isinstance(value, str)
                             else f"{value:.{digits}g}" for value in row])
    print(os.path.relpath(path, ROOT))


def sampled(run, columns, step=0.05):
    """Columns of the statistics every `step` seconds, and at the end."""
    end = run["end_time"]
    times = np.append(np.arange(0, end, step), end)
    return times, {column: run.value(column, times) for column in columns}


def draw_points(axes, points, values, label=None, **options):
    """Material points coloured by values; labels a colour bar."""
    x = points["position"]
    options = {"s": 1.6, "marker": "s", "linewidths": 0, **options}
    drawn = axes.scatter(x[:, 0], x[:, 1], c=values, **options)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_ylim(-0.1, 5.5)
    axes.set_ylabel("y (m)")
    if label is not None:
        axes.figure.colorbar(drawn, ax=axes, label=label, pad=0.01,
                             fraction=0.02)
    return drawn
