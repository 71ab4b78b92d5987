#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One realisation on several ranks is the one on one rank: with tight tolerances
equal to 1e-10 after 20 steps, in the statistics and in all that a checkpoint has of
each material point.

usage: ranks.py WAKER SOURCE_DIRECTORY [UNIT_TESTS] [MODE] [--seed N] [CASE...]

The cases are in ranks_cases.py; without a name all of them, and what else there is.

--quick     what takes a minute
--few       a few steps, on coarser cells and resumed, of a program with assertions
            and sanitizers
--defaults  tolerances as users have them; and a dyke to its end
--kills     only the run that is killed

Also: a folder that a rank does not see; a run that is killed again and again, at
moments that a seed chooses, and goes on on another number of ranks;
one that ends by SIGTERM; one that fails in a step; files that ranks write together, and that cannot be written;
the unit tests of partition and exchange on three ranks.
"""
import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

import meshio
import numpy as np

import ranks_cases
import ranks_runs
from ranks_cases import cases
from ranks_compare import ENVIRONMENT, call, statistics
from ranks_kills import kill_and_resume, ranks_of

# Half the time of all unit tests of ranks: of each there are smaller ones, or a case.
SLOW = ("Ranks.ContourIsThatOfTheWhole", "Ranks.LevelsOnSeveralRanks")


def is_first(pid):
    with open(f"/proc/{pid}/environ", "rb") as file:
        return b"OMPI_COMM_WORLD_RANK=0" in file.read().split(b"\0")


def ends_cleanly(waker, source, to_all):
    """SIGTERM to all ranks, or to a later one alone: the run ends after a
    checkpoint, on all of them."""
    with tempfile.TemporaryDirectory() as work:
        folder = os.path.join(work, "out")
        words = ["mpirun", "-n", "2", waker, "run",
                 os.path.join(source, "parameters/chapter5/dyke_weak.prm"),
                 "--set", "Output/Directory=" + folder,
                 "--set", "Grid/Cell size=0.5",
                 "--set", "Output/Checkpoint interval=0.02"]
        process = subprocess.Popen(words, env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        while process.poll() is None:
            try:
                if len(statistics(folder)[1]) >= 3:
                    break
            except (OSError, ValueError):
                pass
            time.sleep(0.01)
        ranks = [rank for rank in ranks_of(process)
                 if to_all or not is_first(rank)]
        for rank in ranks:
            os.kill(rank, signal.SIGTERM)
        code = process.wait()
        with open(os.path.join(folder, "log.txt")) as file:
            log = file.read()
    print(f"SIGTERM to {len(ranks)} of 2 ranks: ends with {code}")
    return (len(ranks) == (2 if to_all else 1)
            and code == 128 + signal.SIGTERM and "Interrupted at t" in log)


def slope(waker, source, folder, n_ranks, *flags, before=(), **environment):
    """Of 12,544 points, without the initial stress: its sums depend on the ranks.
    `before`: words before those of the program."""
    words = [waker, "run",
             os.path.join(source, "parameters/chapter6/slope.prm"),
             "--set", "Output/Directory=" + folder, *flags]
    for setting in ("Grid/Cell size=0.25", "Gravity/Initial stress=false",
                    "Time stepping/End time=0.01", "Output/Interval=0.01"):
        words += ["--set", setting]
    if not before:
        return call(words, n_ranks, **environment)
    words = [*before, *words]
    if n_ranks > 1:
        words = ["mpirun", "-n", str(n_ranks)] + words
    return subprocess.run(words, env=dict(ENVIRONMENT, **environment),
                          capture_output=True, text=True)


def first_files(waker, source):
    """What ranks write together is what one writes, to the bit."""
    files = {}
    with tempfile.TemporaryDirectory() as work:
        for n in (1, 3):
            folder = os.path.join(work, str(n))
            done = slope(waker, source, folder, n)
            if done.returncode != 0:
                sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
            for series in ("particles", "top_view"):
                name = os.path.join(folder, "solution", series + "-00000.vtu")
                with open(name, "rb") as file:
                    files[n, series] = file.read()
            mesh = meshio.read(os.path.join(folder, "solution",
                                            "particles-00001.vtu"))
            if len(mesh.points) != 12544 or not np.array_equal(
                    mesh.point_data["id"], np.arange(12544)):
                sys.exit(f"{n} ranks: points have got lost in the file")
            left = [name for name in os.listdir(os.path.join(folder, "solution"))
                    if not name.endswith(".vtu")]
            if left:
                sys.exit(f"{n} ranks: left behind: {left}")
    same = all(files[1, series] == files[3, series]
               for series in ("particles", "top_view"))
    print(f"files of {', '.join(str(len(text)) for text in files.values())} bytes: "
          + ("the same on 1 and 3 ranks" if same else "DIFFER"))
    return same


def full_disk(waker, source):
    """Two ranks say what one says, once, end alike, and leave the same behind."""
    # Files of at most 50 kB. Memory that ranks share would be one, too.
    limited = ["sh", "-c", 'trap "" XFSZ; ulimit -f 100; exec "$@"', "sh"]
    ends = {}
    with tempfile.TemporaryDirectory() as work:
        folder = os.path.join(work, "out")
        for n in (1, 2):
            done = slope(waker, source, folder, n, "--overwrite", before=limited,
                         OMPI_MCA_btl="self,tcp", PMIX_MCA_gds="hash")
            lines = [line for line in done.stderr.split("\n") if folder in line
                     or "cannot be written" in line or line.startswith("allowed")]
            ends[n] = (done.returncode, lines,
                       sorted(os.listdir(os.path.join(folder, "solution"))))
    print("full disk:", ends[1])
    good = ends[1] == ends[2] and ends[1][0] == 4 and ends[1][2] == []
    if not good:
        print("on two ranks:", ends[2])
    return good and any("cannot be written" in line for line in ends[1][1])


def fails_alike(waker, source):
    """Soil that flies off the grid, which one rank alone sees, inside a step."""
    ends = {}
    with tempfile.TemporaryDirectory() as work:
        for n in (1, 3):
            folder = os.path.join(work, str(n))
            done = call([waker, "run",
                         os.path.join(source, "parameters", "verification",
                                      "flying_block.prm"),
                         "--set", "Time stepping/End time=20",
                         "--set", "Output/Directory=" + folder], n)
            with open(os.path.join(folder, "summary.json")) as file:
                summary = json.load(file)
            ends[n] = (done.returncode, summary["outcome"], summary["steps"],
                       # Several have left: of which each rank sees its own.
                       "left the background grid" in summary["stop_reason"])
        # The ranks have written the last good state: it fails again from there.
        done = call([waker, "run",
                     os.path.join(source, "parameters", "verification",
                                  "flying_block.prm"),
                     "--set", "Time stepping/End time=20",
                     "--set", "Output/Directory=" + folder, "--resume"], 2)
        again = done.returncode == 3 and "Resumed at t = " in done.stdout
    print("a failure in a step:", ends[1], "and from its checkpoint:", again)
    if ends[1] != ends[3]:
        print("on three ranks:", ends[3])
    return ends[1] == ends[3] and ends[1][0] == 3 and again


def sees_the_folder(waker, source):
    """A rank that does not see the output folder is found at the start."""
    file = os.path.join(source, "parameters", "verification", "flying_block.prm")
    with tempfile.TemporaryDirectory() as work:
        words = []
        for rank in "ab":  # each in a folder of its own, on its own machine, say
            os.mkdir(os.path.join(work, rank))
            words += (["mpirun"] if not words else [":"]) + [
                "-n", "1", "-wdir", os.path.join(work, rank), waker, "run", file,
                "--set", "Time stepping/End time=0.1",
                "--set", "Output/Directory=out"]
        done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True)
        good = (done.returncode == 2 and "'out/parameters.prm' is not seen by 1 of "
                "the 2 ranks" in done.stderr)
        if not good:
            print(done.returncode, done.stdout, done.stderr)
    print("a rank that does not see the folder:", "refused" if good else "NOT SEEN")
    return good


def is_killed(waker, source, few, seed):
    """The weak dyke."""
    case = cases["weak dyke"]
    counts = [3, 2] if few else [3, 2, 1, 4, 2, 3, 1, 2, 4, 3, 2]
    steps = 20 if few else 60
    with tempfile.TemporaryDirectory() as work:
        return kill_and_resume(waker, ranks_runs.path_of(source, case),
                               ranks_runs.case_settings(case, work, steps), work,
                               counts, steps, seed)


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("waker", type=os.path.abspath)
    parser.add_argument("source", type=os.path.abspath)
    parser.add_argument("rest", nargs="*", metavar="[UNIT_TESTS] [CASE...]")
    for mode in ("quick", "few", "defaults", "kills"):
        parser.add_argument("--" + mode, action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_intermixed_args()
    given.unit_tests = None
    if given.rest and given.rest[0] not in cases and os.path.exists(given.rest[0]):
        given.unit_tests = os.path.abspath(given.rest.pop(0))
    unknown = [name for name in given.rest if name not in cases]
    if unknown:
        parser.error(f"no such case: {unknown}")
    return given


def main():
    given = arguments()
    waker, source, rest = given.waker, given.source, given.rest
    os.chdir(source)  # files name others from there
    # MPI keeps what it has.
    ENVIRONMENT.setdefault("ASAN_OPTIONS", "detect_leaks=0")
    bad = 0
    if given.unit_tests:
        done = call([given.unit_tests, "--gtest_brief=1", "--gtest_filter=Ranks.*"
                     + (f"-{':'.join(SLOW)}" if given.quick else "")], 3)
        if done.returncode != 0:
            print(done.stdout + done.stderr)
            bad += 1
        bad += not ends_cleanly(waker, source, to_all=True)
        bad += not ends_cleanly(waker, source, to_all=False)
        bad += not first_files(waker, source)
        bad += not full_disk(waker, source)
        bad += not fails_alike(waker, source)
        bad += not sees_the_folder(waker, source)
    whole = not (rest or given.quick or given.few or given.defaults or given.kills)
    if given.few:
        for name in rest or cases:
            bad += not ranks_runs.few_steps(waker, source, name)
    elif not given.defaults and not given.kills:
        for name in rest or (ranks_cases.quick if given.quick else cases):
            counts = (ranks_cases.quick if given.quick and name in ranks_cases.quick
                      else {name: cases[name].ranks})[name]
            bad += ranks_runs.tight_runs(waker, source, name, counts)
    if whole or given.quick or given.kills:
        bad += not is_killed(waker, source, given.quick, given.seed)
    if whole or given.defaults:
        for name in rest or ranks_cases.at_defaults:
            bad += ranks_runs.with_defaults(waker, source, name)
        bad += ranks_runs.to_the_end(waker, source)
    if bad:
        sys.exit(f"{bad} of the checks have failed")


if __name__ == "__main__":
    main()
