#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and figure of doc/verification/static_steps.md: the gravity step of the
slope of chapter 6 (parameters/chapter6/slope.prm) on cells of several sizes.

    static_steps.py run WAKER KIND CELL RANKS   one row; KIND is what it is called
    static_steps.py plot                        table and figure

KIND is "multigrid" or "diagonal". The latter is a program whose `patience` in
source/mechanics/system_operator.cc is 100000, the former one in which it is 0.
Rows are kept in doc/verification/data.
"""

import os
import re
import resource
import subprocess
import sys
import tempfile

from common import DATA, plt, save

ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1")
SLOPE = "parameters/chapter6/slope.prm"
GRAVITY = re.compile(r"after (\d+) solve\(s\), residual (\S+), (\d+) iterations")
FILE = os.path.join(DATA, "static_steps.csv")
HEAD = "kind,cells per m,ranks,equations,solves,iterations,CPU (s)"


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def one_run(waker, cells, n_ranks, has_stress):
    """What it says, and the processor time of all its ranks (s)."""
    start = processor_time()
    with tempfile.TemporaryDirectory() as work:
        words = [waker, "run", SLOPE]
        for setting in (f"Grid/Cell size={1. / cells:.15g}",
                        "Time stepping/End time=1e-9", "Time stepping/Time step=1e-9",
                        f"Gravity/Initial stress={str(has_stress).lower()}",
                        "Output/Interval=0", "Output/Checkpoint interval=0",
                        "Output/Top view=false", "Output/Directory=" + work + "/run"):
            words += ["--set", setting]
        if n_ranks > 1:
            words = ["mpirun", "-n", str(n_ranks)] + words
        done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True)
    return done.stdout + done.stderr, processor_time() - start


def equations(cells):
    """Of nodes above the base, and three for each: the body is 8 m long, its
    crest 2.5 m and 1 m high, on a slope in steps."""
    rows = sum(round(3.5 * cells) - row + 1 for row in range(1, cells + 1))
    return 3 * rows * (8 * cells + 1)


def run(waker, kind, cells, n_ranks):
    text, time = one_run(waker, cells, n_ranks, True)
    found = GRAVITY.search(text)
    if found is None:
        sys.exit(text[-2000:])
    time -= one_run(waker, cells, n_ranks, False)[1]
    row = (f"{kind},{cells},{n_ranks},{equations(cells)},{found[1]},{found[3]},"
           f"{time:.1f}")
    rows = []
    if os.path.exists(FILE):
        with open(FILE, encoding="utf-8") as file:
            rows = file.read().split("\n")[1:-1]
    key = row.split(",")[:3]
    rows = [r for r in rows if r.split(",")[:3] != key] + [row]
    rows.sort(key=lambda r: (r.split(",")[0], [int(w) for w in r.split(",")[1:3]]))
    with open(FILE, "w", encoding="utf-8") as file:
        file.write("\n".join([HEAD] + rows) + "\n")
    print(row)


def plot():
    with open(FILE, encoding="utf-8") as file:
        rows = [line.split(",") for line in file.read().split("\n")[1:-1]]
    figure, axes = plt.subplots(figsize=(6, 3.6))
    for kind in ("diagonal", "multigrid"):
        for n_ranks, style in (("1", "o-"), ("2", "x--")):
            chosen = [r for r in rows if r[0] == kind and r[2] == n_ranks]
            axes.loglog([float(r[3]) for r in chosen], [float(r[5]) for r in chosen],
                        style, label=f"{kind}, {n_ranks} rank(s)")
    axes.set_xlabel("equations")
    axes.set_ylabel("iterations of the gravity step")
    axes.legend()
    save(figure, "static_steps")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def main():
    if sys.argv[1:2] == ["plot"]:
        plot()
    elif sys.argv[1:2] == ["run"] and len(sys.argv) == 6:
        run(os.path.abspath(sys.argv[2]), sys.argv[3], int(sys.argv[4]),
            int(sys.argv[5]))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
