#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Put our numbers beside every number that the thesis prints.

    /usr/bin/python3 contrib/plots/chapter5_table.py --analysis1 DIR \\
        --analysis2 DIR --analysis3 DIR [--analysis1-points DIR] \\
        [--page doc/results/chapter5/README.md]

--analysis1-points is analysis 1 with `Statistics of = points`. Campaigns of another
dyke than the thesis's are refused. The script writes the tables between the lines `<!-- begin NAME -->` and `<!-- end NAME -->`
of the page (names: comparison, campaigns); the rest of the page stays. Without
--page it prints them.
"""

import argparse
import sys

import numpy as np

from page import rewrite
from store import Store
from thesis_numbers import POINTS, Stores
from thesis_parameters import differences
from thesis_table import ROWS

PENDING = "*not run yet*"


def comparison(stores):
    chosen = Stores(stores)
    lines = []
    for title, entries in ROWS:
        lines += ["", f"### {title}", "",
                  "| what | where | the thesis | ours | 95 % interval | N |",
                  "|---|---|---|---|---|---|"]
        for entry in entries:
            if entry.ours is None:
                cells = (entry.instead, "", "")
            else:
                cells = entry.ours(chosen) or (PENDING, "", "")
            lines.append("| " + " | ".join(
                (entry.what, entry.where, entry.printed, *cells)) + " |")
    return "\n".join(lines[1:])


def campaigns(stores):
    lines = ["| analysis | scenario | N | failed numerically | wall time of a "
             "realisation (s) | per core-hour | Waker | parameters |",
             "|---|---|---|---|---|---|---|---|"]
    for number, store in stores.items():
        for scenario in store.scenarios:
            seconds = np.nanmean(scenario["wall_time"]) if len(
                scenario.realisation) else np.nan
            rate = "–" if np.isnan(seconds) else f"{3600 / seconds:.0f}"
            name = f"θ_h = {scenario.scale_x:g} m, H_i − h = " \
                   f"{scenario.freeboard:g} m"
            lines.append(
                f"| {number} | {name} | {scenario.n} | "
                f"{scenario.n_numerical_failures} | {seconds:.3f} | {rate} | "
                f"{store.attribute('version')} | `{scenario.hash[:16]}` |")
    return "\n".join(lines + machines(stores)) if stores else PENDING


def core_hours(seconds):
    return f"{seconds / 3600:.2f}"


def machines(stores):
    """What computed them, and for how long. One process uses one core, so the
    sum of wall times is core time; that of the whole campaign on the clock is
    not recorded."""
    lines = ["", "| analysis | machine | cores | build | begun (UTC) | "
             "realisations | core hours |", "|---|---|---|---|---|---|---|"]
    for number, store in stores.items():
        entries = store.machines()
        if not entries:
            wall = sum(np.nansum(s["wall_time"]) for s in store.scenarios)
            n = sum(len(s.realisation) for s in store.scenarios)
            entries = [{"realisations": n, "wall_time": wall}]
        for entry in entries:
            get = lambda key: entry.get(key, "unknown") or "unknown"
            lines.append(
                f"| {number} | {get('host')}: {get('processor')} | "
                f"{get('cores')} | {get('compiler')}, {get('build_flags')} | "
                f"{get('start')} | {entry['realisations']} | "
                f"{core_hours(entry['wall_time'])} |")
    return lines


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    for number in (1, 2, 3, "1-points"):
        parser.add_argument(f"--analysis{number}", metavar="DIR")
    parser.add_argument("--page", metavar="MARKDOWN")
    arguments = parser.parse_args()
    folders = {1: arguments.analysis1, POINTS: arguments.analysis1_points,
               2: arguments.analysis2, 3: arguments.analysis3}
    stores = {number: Store(folder) for number, folder in folders.items()
              if folder}
    for number, store in stores.items():
        found = differences(store, 1 if number == POINTS else number)
        if found:
            sys.exit(f"{store.folder}: not a campaign of the thesis: "
                     + "; ".join(found))
    tables = {"comparison": comparison(stores), "campaigns": campaigns(stores)}
    if not arguments.page:
        print("\n\n".join(tables.values()))
        return
    rewrite(arguments.page, tables)
    print(arguments.page)


if __name__ == "__main__":
    main()
