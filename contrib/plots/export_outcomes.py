#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the outcome of every realisation of a campaign as a small CSV.

    /usr/bin/python3 contrib/plots/export_outcomes.py DIR OUT.csv

DIR is the folder of a campaign after `waker merge`. Version, seed and parameter
hash are in comment lines, so that a later run of the same parameters can extend
the table. Numbers have three decimals; an event that did not occur leaves its
field empty. Missing folders are made. A file of the same hash that is there is
compared with the new lines, and replaced unless it has more. If OUT.csv would be larger than a megabyte, each scenario gets a
file of its own, OUT-0.csv, OUT-1.csv and so on, and a scenario that is still too
large is cut into OUT-0a.csv, OUT-0b.csv.
"""

import argparse
import glob
import os
import re
import string
import sys

import numpy as np

from store import Store

LIMIT = 1_000_000  # bytes
COLUMNS = ("scenario", "realisation", "outcome", "initial_failure_time",
           "inner_slide_time", "outer_slide_time", "flooding_time",
           "residual_width", "residual_height", "class")
NOTES = (
    "outcome: 0 stable, 1 initial failure, 2 flooding, 3 numerical failure, "
    "4 still moving, 5 loads still change, 6 stopped by the box",
    "class: 0 none, 1 initial only, 2 retrogressive, 3 horizontal, 4 outer, "
    "5 settled, 6 overflow",
    "initial_failure_time: by width or height; inner_slide_time, "
    "outer_slide_time: by displacement",
    "times in s, width and height in m",
)


def short(x):
    """Three decimals without zeros at the end; empty for NaN."""
    if np.isnan(x):
        return ""
    text = f"{x:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def lines_of(scenario):
    # Stores of version 0.1 have no slides by displacement.
    floats = [scenario.event_time(name.removesuffix("_time"))
              if name.endswith("_slide_time") else scenario[name]
              for name in COLUMNS[3:-1]]
    for number, outcome, kind, *values in zip(
            scenario.realisation, scenario["outcome"],
            scenario["failure_class"], *floats):
        yield (f"{scenario.index},{number},{outcome},"
               f"{','.join(short(value) for value in values)},{kind}\n")


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


def outcomes(text):
    """(parameter hash, {(scenario, realisation): line}) of a table."""
    lines = text.splitlines()
    found = re.search(r"parameters (\S+), seed", lines[0] if lines else "")
    return found and found[1], {
        tuple(line.split(",", 2)[:2]): line for line in lines
        if line[:1].isdigit()}


def earlier(path, new_hash):
    """What is there of the same campaign: ({file}, {key: line})."""
    stem, ending = os.path.splitext(path)
    names, lines = set(), {}
    for name in [path] + glob.glob(f"{glob.escape(stem)}-[0-9]*{ending}"):
        if os.path.exists(name):
            with open(name, encoding="utf-8") as file:
                old_hash, old = outcomes(file.read())
            if old_hash == new_hash:
                names.add(name)
                lines.update(old)
    return names, lines


def compare(path, old, new):
    """Says how many outcomes differ from those in the files that are there. A
    table with more realisations of the same campaign is not replaced."""
    if not old:
        return
    both = old.keys() & new.keys()
    differ = sum(old[key] != new[key] for key in both)
    print(f"{path}: {differ} of {len(both)} outcomes differ from those in the "
          "file", file=sys.stderr if differ else sys.stdout)
    if len(old) > len(new):
        raise SystemExit(
            f"{path}: has {len(old)} realisations of the same campaign, the "
            f"store has {len(new)}; remove it to have it replaced")


def tables(store, path):
    """{path: text}"""
    whole = head(store, store.scenarios) + "".join(
        line for scenario in store.scenarios for line in lines_of(scenario))
    if len(whole.encode()) < LIMIT:
        return {path: whole}
    stem, ending = os.path.splitext(path)
    result = {}
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
            result[name] = top + "".join(part)
    return result


def export(store, path):
    """Returns the paths that were written."""
    written = tables(store, path)
    new = {}
    for text in written.values():
        new.update(outcomes(text)[1])
    names, old = earlier(path, store.attribute("parameters_hash"))
    compare(path, old, new)
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    for name, text in written.items():
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
        print(f"{name}: {os.path.getsize(name)} bytes")
    for name in names - written.keys():  # the table is cut in another way now
        os.remove(name)
    return list(written)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("campaign", metavar="DIR")
    parser.add_argument("output", metavar="OUT.csv")
    arguments = parser.parse_args()
    export(Store(arguments.campaign), arguments.output)


if __name__ == "__main__":
    main()
