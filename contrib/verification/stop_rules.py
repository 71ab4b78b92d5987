#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the stop rules change outcomes? Runs the first realisations of the base case
twice: as they are, and to 40 s of simulated time whether they are at rest or not
(flooding ends a run in both). Every outcome must be the same.

usage: stop_rules.py [--waker PATH] [--source DIR] [-n 200] [--ranks 2]
                     [--data FILE.csv] [--folder DIR]
"""
import argparse
import csv
import glob
import json
import os
import subprocess
import sys
import tempfile


def records(folder):
    """Records of a campaign by number of the realisation."""
    found = {}
    for path in sorted(glob.glob(os.path.join(folder, "journal-*.jsonl"))):
        with open(path, encoding="utf-8") as lines:
            for line in lines:
                record = json.loads(line)
                if "realisation" in record:
                    found[record["realisation"]] = record
    return found


def campaign(options, folder, sets):
    command = [options.waker, "campaign",
               os.path.join(options.source, "parameters/chapter5/analysis1.prm"),
               "--chunk", "1/1"]
    if options.ranks > 1:
        command = ["mpirun", "-n", str(options.ranks)] + command
    for name, value in {"Campaign/Realisations": options.n,
                        "Output/Directory": folder, **sets}.items():
        command += ["--set", f"{name}={value}"]
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1")
    subprocess.run(command, check=True, env=environment,
                   stdout=subprocess.DEVNULL)
    return records(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    here = os.path.dirname(os.path.dirname(os.path.dirname(
        os.path.abspath(__file__))))
    parser.add_argument("--source", default=here)
    parser.add_argument("--waker", default=os.path.join(here, "build/bin/waker"))
    parser.add_argument("-n", type=int, default=200)
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--data")
    parser.add_argument("--reference", metavar="DIR", help="a campaign of the "
                        "base case with at least so many realisations, instead "
                        "of the first of the two")
    parser.add_argument("--folder", help="keep the campaigns, and go on with "
                        "those that are there")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="waker-") as temporary:
        folder = options.folder or temporary
        stopped = (records(options.reference) if options.reference else
                   campaign(options, os.path.join(folder, "stopped"), {}))
        to_the_end = campaign(options, os.path.join(folder, "to-the-end"),
                              {"Stop rules/At rest": "false"})

    rows, different = [], []
    for i in range(options.n):
        a, b = stopped[i], to_the_end[i]
        if a["outcome"] != b["outcome"]:
            different.append(i)
        rows.append([i, a["outcome"], b["outcome"], a["end_time"],
                     b["end_time"], a["residual_width"], b["residual_width"],
                     a["steps"], b["steps"]])
    if options.data:
        with open(options.data, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["realisation", "outcome", "outcome to the end",
                             "end time (s)", "end time to the end (s)",
                             "W (m)", "W to the end (m)", "steps",
                             "steps to the end"])
            for row in rows:
                writer.writerow([round(x, 3) if isinstance(x, float) else x
                                 for x in row])

    moved = max(abs(row[5] - row[6]) for row in rows)
    print(f"{options.n} realisations: {len(different)} outcomes differ "
          f"{different if different else ''}; largest difference of the residual "
          f"width {moved:.3f} m; steps {sum(r[7] for r in rows)} and "
          f"{sum(r[8] for r in rows)}")
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
