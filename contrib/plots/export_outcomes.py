#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the outcome of every realisation of a campaign as a small CSV.

    /usr/bin/python3 contrib/plots/export_outcomes.py DIR OUT.csv

DIR is the folder of a campaign after `waker merge`. Version, seed and parameter
hash are in comment lines, so that a later run of the same parameters can extend
the table. Numbers have three decimals; an event that did not occur leaves its
field empty. If OUT.csv would be larger than a megabyte, each scenario gets a
file of its own, OUT-0.csv, OUT-1.csv and so on, and a scenario that is still too
large is cut into OUT-0a.csv, OUT-0b.csv.
"""

import argparse
import os
import string

import numpy as np

from store import Store

LIMIT = 1_000_000  # bytes
COLUMNS = ("scenario", "realisation", "outcome", "initial_failure_time",
           "flooding_time", "residual_width", "residual_height", "class")
NOTES = (
    "outcome: 0 stable, 1 initial failure, 2 flooding, 3 numerical failure",
    "class: 0 none, 1 initial only, 2 retrogressive, 3 horizontal, 4 outer",
    "times in s, width and height in m",
)


def short(x):
    """Three decimals without zeros at the end; empty for NaN."""
    if np.isnan(x):
        return ""
    text = f"{x:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def lines_of(scenario):
    columns = [scenario[name] for name in
               ("outcome", "initial_failure_time", "flooding_time",
                "residual_width", "residual_height", "failure_class")]
    for number, outcome, s1, flood, width, height, kind in zip(
            scenario.realisation, *columns):
        yield (f"{scenario.index},{number},{outcome},{short(s1)},"
               f"{short(flood)},{short(width)},{short(height)},{kind}\n")


def head(store, scenarios):
    lines = [f"# {store.describe()}\n"]
    swept = store.attribute("swept_parameter")
    for scenario in scenarios:
        value = f"{swept} = {scenario.value}, " if swept else ""
        lines.append(f"# scenario {scenario.index}: {value}"
                     f"hash {scenario.hash}\n")
    return "".join(lines + [f"# {note}\n" for note in NOTES]
                   + [",".join(COLUMNS) + "\n"])


def pieces(lines, size):
    """Cut lists of lines at a number of bytes (the text is ASCII)."""
    piece, length = [], 0
    for line in lines:
        if piece and length + len(line) > size:
            yield piece
            piece, length = [], 0
        piece.append(line)
        length += len(line)
    yield piece


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    print(f"{path}: {os.path.getsize(path)} bytes")


def export(store, path):
    """Returns the paths that were written."""
    whole = head(store, store.scenarios) + "".join(
        line for scenario in store.scenarios for line in lines_of(scenario))
    if len(whole.encode()) < LIMIT:
        write(path, whole)
        return [path]
    stem, ending = os.path.splitext(path)
    written = []
    for scenario in store.scenarios:
        top = head(store, [scenario])
        parts = list(pieces(lines_of(scenario),
                            LIMIT - len(top.encode()) - 1))
        if len(parts) > 26:
            raise SystemExit(f"{path}: scenario {scenario.index} has more than "
                             "26 MB")
        for letter, part in zip(string.ascii_lowercase, parts):
            name = (f"{stem}-{scenario.index}"
                    f"{letter if len(parts) > 1 else ''}{ending}")
            write(name, top + "".join(part))
            written.append(name)
    return written


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("campaign", metavar="DIR")
    parser.add_argument("output", metavar="OUT.csv")
    arguments = parser.parse_args()
    export(Store(arguments.campaign), arguments.output)


if __name__ == "__main__":
    main()
