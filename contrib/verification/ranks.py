#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and figure of doc/verification/ranks.md: one realisation of the slope of
chapter 6 (parameters/chapter6/slope.prm) on several ranks.

    ranks.py time WAKER [CELL SIZE [ROUNDS]]   two ranks against two runs side by side
    ranks.py count WAKER              what ranks tell each other, on 2, 4 and 8
    ranks.py surface WAKER            what is done for each facet by all
    ranks.py imbalance WAKER          a slide on two ranks, by when points are dealt out anew
    ranks.py flight WAKER             the same of a block that flies from one to the other
    ranks.py pairs WAKER SOURCE [ROUNDS]  one rank, against an earlier version built there
    ranks.py model                    fit, table and figure

`time` needs two idle cores. Results are kept in doc/verification/data.
"""

import os
import re
import subprocess
import sys
import tempfile

import numpy as np
from common import DATA, plt, read_csv, save
from dyke_runs import write_csv

ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1",
                   OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1")
SLOPE = "parameters/chapter6/slope.prm"
SENT = re.compile(r"(\d+) ranks; in a step the first one sent (\S+) messages with "
                  r"(\S+) kB, and took part in (\S+) sums")
TIME = re.compile(r"unconverged, (\S+) s,")
POINTS = {0.25: 12416, 0.125: 99328, 0.0625: 794624}

# A cluster of today: seconds a message and a stage of a sum, seconds a byte.
LATENCY, STAGE, PER_BYTE = 2e-6, 2e-6, 1. / 5e9
# Of what a rank does with the facets of the whole surface, as perf names it.
OF_SURFACE = ("tell_all", "measure_dyke", "make_facet", "Section", "Triangle")
FACET = 88.  # bytes that go to all


def command(waker, cell, n_steps, folder, n_ranks=1):
    words = [waker, "run", SLOPE, "--set", f"Grid/Cell size={cell}",
             "--set", f"Time stepping/End time={0.01 * n_steps}",
             "--set", "Gravity/Initial stress=false",
             "--set", "Output/Interval=100",
             "--set", "Output/Checkpoint interval=1e6",
             "--set", "Output/Directory=" + folder]
    if n_ranks > 1:
        words = ["mpirun", "-n", str(n_ranks)] + words
    return words


def loop_time(commands):
    """Of the loop over steps, as the runs say it (s): the longest."""
    running = [subprocess.Popen(words, env=ENVIRONMENT, stdout=subprocess.PIPE,
                                text=True) for words in commands]
    found = [TIME.search(process.communicate()[0]) for process in running]
    if not all(found):
        sys.exit("a run has failed")
    return max(float(match[1]) for match in found)


def measure_time(waker, cell, rounds):
    """Steps only: the difference of a longer and a shorter run; in turn."""
    few, many = (20, 80) if cell > 0.1 else (3, 13)
    ones, twos = [], []
    for k in range(rounds):
        side, shared = [], []
        for n_steps in (few, many):
            with tempfile.TemporaryDirectory() as work:
                side.append(loop_time([command(waker, cell, n_steps, work + "/a"),
                                       command(waker, cell, n_steps, work + "/b")]))
                shared.append(loop_time([command(waker, cell, n_steps, work + "/c", 2)]))
        steps = many - few
        ones.append((side[1] - side[0]) / steps)
        twos.append((shared[1] - shared[0]) / steps)
        print(f"cells of {cell} m: a step takes {ones[-1]:.3f} s side by side, "
              f"{twos[-1]:.3f} s on two ranks: efficiency {ones[-1] / (2. * twos[-1]):.3f}",
              flush=True)
    efficiency = np.array(ones) / (2. * np.array(twos))
    append("ranks_time", 1, {"cell size (m)": cell,
                             "side by side (s)": float(np.median(ones)),
                             "two ranks (s)": float(np.median(twos)),
                             "rounds": float(rounds),
                             "efficiency": float(np.median(efficiency)),
                             "lowest": float(min(efficiency)),
                             "highest": float(max(efficiency))})


PAIRS = {
    "dyke": ["parameters/chapter5/dyke_weak.prm", "Output/Interval=0"],
    "slope, 0.25 m": [SLOPE, "Grid/Cell size=0.25", "Time stepping/End time=0.6",
                      "Materials/clay/Initial strength=2"],
    "slope, 0.125 m": [SLOPE, "Time stepping/End time=0.2"]}


def pairs(waker, before, rounds):
    """One rank: the loop over steps of this program and of an earlier one, whose
    source folder is given, in turn; who is first changes each time."""
    rows = {"case": [], "before (s)": [], "now (s)": []}
    for name, (file, *settings) in PAIRS.items():
        if file == SLOPE:
            settings += ["Gravity/Initial stress=false", "Output/Interval=100",
                         "Output/Checkpoint interval=1e6"]
        for k in range(rounds):
            times = {}
            for folder in ((before, "."), (".", before))[k % 2]:
                program = waker if folder == "." else f"{before}/build/bin/waker"
                with tempfile.TemporaryDirectory() as work:
                    words = [program, "run", os.path.join(folder, file)]
                    for setting in settings + [f"Output/Directory={work}/run"]:
                        words += ["--set", setting]
                    times[folder] = loop_time([words])
            rows["case"].append(name)
            rows["before (s)"].append(times[before])
            rows["now (s)"].append(times["."])
        last = slice(-rounds, None)
        ratio = np.array(rows["now (s)"][last]) / np.array(rows["before (s)"][last])
        print(f"{name}: {np.median(ratio):.3f} ({min(ratio):.2f} to {max(ratio):.2f})")
    write_csv("ranks_pairs", rows)


def append(name, n_keys, row):
    """A row of a table, {column: number}; it replaces that with the same keys."""
    columns = list(row)
    rows = []
    if os.path.exists(os.path.join(DATA, name + ".csv")):
        old = read_csv(name)
        n = len(next(iter(old.values())))
        rows = [list(values) for values in
                zip(*(old.get(c, [float("nan")] * n) for c in columns))]
    new = list(row.values())
    rows = sorted([r for r in rows if r[:n_keys] != new[:n_keys]] + [new])
    write_csv(name, {c: [r[k] for r in rows] for k, c in enumerate(columns)})


def count(waker):
    for cell, n_steps in ((0.25, 20), (0.125, 10)):
        for n_ranks in (2, 4, 8):
            with tempfile.TemporaryDirectory() as work:
                # Files ask for the places of all points, which steps do not.
                files = [word for name in ("Grid", "Surface", "Top view")
                         for word in ("--set", f"Output/{name}=false")]
                done = subprocess.run(
                    command(waker, cell, n_steps, work + "/run", n_ranks) + files,
                    env=ENVIRONMENT, capture_output=True, text=True)
            found = SENT.search(done.stdout)
            if found is None:
                sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
            numbers = [float(word) for word in found.groups()]
            print(cell, numbers)
            append("ranks_traffic", 2,
                   dict(zip(("points", "ranks", "messages", "kB", "sums"),
                            [float(POINTS[cell])] + numbers)))


LIMITS = (1.0, 1.02, 1.05, 1.1, 1.2, 1.5, 100.)


def imbalance(waker):
    """The slope with a fifth of its strength flows out of the parts it began in; a
    block flies from one rank's part to the other's."""
    for cell, n_steps in ((0.25, 300), (0.125, 120)):
        for limit in LIMITS:
            with tempfile.TemporaryDirectory() as work:
                seconds = loop_time([command(waker, cell, n_steps, work + "/run", 2) +
                                     ["--set", f"Ranks/Largest imbalance={limit}",
                                      "--set", "Materials/clay/Initial strength=0.7",
                                      "--set", "Materials/clay/Residual strength=0.5"]])
            print(f"cells of {cell} m, limit {limit}: {seconds / n_steps:.4f} s a step",
                  flush=True)
            append("ranks_imbalance", 2, {"cell size (m)": cell, "limit": limit,
                                          "step (s)": seconds / n_steps})
    flight(waker)


def flight(waker):
    """A block of 10,000 points."""
    cell, step, n_steps = 0.02, 0.0016, 300
    for limit in LIMITS:
        with tempfile.TemporaryDirectory() as work:
            words = ["mpirun", "-n", "2", waker, "run",
                     "parameters/verification/flying_block.prm"]
            for setting in (f"Grid/Cell size={cell}", f"Time stepping/Time step={step}",
                            f"Time stepping/End time={step * n_steps}",
                            "Newton/Tolerance=1e-3", "Newton/Linear tolerance=1e-2",
                            "Output/Interval=0", f"Output/Directory={work}/run",
                            f"Ranks/Largest imbalance={limit}"):
                words += ["--set", setting]
            seconds = loop_time([words])
        print(f"flying block, limit {limit}: {seconds / n_steps:.4f} s a step", flush=True)
        append("ranks_flight", 1, {"limit": limit, "step (s)": seconds / n_steps})


def surface(waker):
    """Seconds a step and facet on each of two ranks, by perf's samples."""
    cell, n_steps = 0.0625, 10
    with tempfile.TemporaryDirectory() as work:
        words = command(waker, cell, n_steps, work + "/run", 2)
        k = words.index(waker)
        # Of the first rank.
        words[k:k] = ["sh", "-c", 'if [ "$OMPI_COMM_WORLD_RANK" = 0 ]; then exec '
                      f'perf record -o {work}/perf -F 499 "$@"; else exec "$@"; fi',
                      "sh"]
        done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True)
        with open(work + "/run/solution/surface-00000.vtu", "rb") as file:
            n_facets = int(re.search(rb'NumberOfCells="(\d+)"', file.read(2000))[1])
        lines = subprocess.run(["perf", "report", "-i", work + "/perf", "--stdio",
                                "--percent-limit", "0", "-F", "sample,symbol"],
                               capture_output=True, text=True).stdout.splitlines()
    if TIME.search(done.stdout) is None:
        sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
    samples = 0
    for line in lines:
        found = re.match(r"\s*(\d+)\s+\[\.\]\s+(.*)", line)
        if found and any(word in found[2] for word in OF_SURFACE):
            samples += int(found[1])
    seconds = samples / 499. / n_steps / n_facets
    print(f"{n_facets} facets, {1e9 * seconds:.0f} ns each in a step")
    append("ranks_surface", 1, {"points": float(POINTS[cell]),
                                "facets": float(n_facets),
                                "ns a facet": 1e9 * seconds})


def model():
    traffic = {key: np.asarray(column) for key, column in
               read_csv("ranks_traffic").items()}
    points, ranks = traffic["points"], traffic["ranks"]
    # The first rank has one neighbour or a few; what it sends goes with the
    # surface of its part.
    surface = (points / ranks) ** (2. / 3.)
    per_surface = np.sum(surface * traffic["kB"]) / np.sum(surface ** 2)
    messages = float(np.max(traffic["messages"]))
    sums = float(np.mean(traffic["sums"]))
    print(f"{1e3 * per_surface:.0f} bytes a step for each (points of the rank)^(2/3), "
          f"up to {messages:.0f} messages and {sums:.0f} sums")
    for n, p, kB, fit in zip(points, ranks, traffic["kB"], per_surface * surface):
        print(f"{n:.0f} points, {p:.0f} ranks: {kB:.0f} kB, by the fit {fit:.0f} "
              f"({100 * (fit / kB - 1):+.0f} %)")
    times = read_csv("ranks_time")
    cell = 0.125
    k = list(times["cell size (m)"]).index(cell)
    per_point = times["side by side (s)"][k] / POINTS[cell]

    figure, axes = plt.subplots(figsize=(6, 3.6))
    facets = read_csv("ranks_surface")
    per_facet = facets["ns a facet"][0] * 1e-9 + FACET * PER_BYTE
    share = facets["facets"][0] / facets["points"][0] ** (2. / 3.)
    print("points, ranks: work, bytes, messages, sums, surface (ms); efficiency, and if "
          "all bytes and messages went while ranks work")
    for n in (99328, 794624, 1e7):
        def parts(p):
            """Seconds: own work, bytes, messages, sums, surface of the whole."""
            work = per_point * n / p
            if p == 1:
                return np.array([work, 0., 0., 0., 0.])
            return np.array([
                work,
                1e3 * per_surface * (n / p) ** (2. / 3.) * PER_BYTE,
                # A part in space has up to 26 others around it.
                messages * min(p - 1, 26) / 3. * LATENCY,
                sums * STAGE * np.log2(p),
                share * n ** (2. / 3.) * per_facet])

        def efficiency(p):
            return parts(p)[0] / parts(p).sum()

        many = 2 ** np.arange(0, 11)
        for p in (2, 16, 64, 256, 1024):
            t = parts(p)
            print(f"{n:.0f}, {p}: " + ", ".join(f"{1e3 * part:.3g}" for part in t)
                  + f"; {efficiency(p):.2f}, {t[0] / (t.sum() - t[1] - t[2]):.2f}")
        print(f"{n:.0f}: under 0.70 on "
              f"{next(p for p in range(2, 1025) if efficiency(p) < 0.7)} ranks")
        axes.semilogx(many, [efficiency(p) for p in many], marker="o", ms=3, base=2,
                      label=f"{n:.3g} points")
    axes.axhline(0.7, color="0.6", lw=0.8)
    axes.set_xlabel("ranks")
    axes.set_ylabel("efficiency")
    axes.legend()
    save(figure, "ranks_model")


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in ("time", "count", "surface", "imbalance",
                                                "flight", "pairs", "model"):
        sys.exit(__doc__)
    if sys.argv[1] == "model":
        model()
    elif sys.argv[1] == "count":
        count(sys.argv[2])
    elif sys.argv[1] == "pairs":
        pairs(sys.argv[2], sys.argv[3], int((sys.argv[4:5] or ["6"])[0]))
    elif sys.argv[1] == "flight":
        flight(sys.argv[2])
    elif sys.argv[1] == "surface":
        surface(sys.argv[2])
    elif sys.argv[1] == "imbalance":
        imbalance(sys.argv[2])
    else:
        measure_time(sys.argv[2], float((sys.argv[3:4] or ["0.125"])[0]),
                     int((sys.argv[4:5] or ["5"])[0]))


if __name__ == "__main__":
    main()
