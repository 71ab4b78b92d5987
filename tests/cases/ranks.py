#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One realisation on several ranks is the one on one rank: with tolerances of
1e-12 equal to 1e-10 after 20 steps, in the statistics and in each material point.
Where single points depend on the tolerance itself, the limit is what ten times of it
changes on one rank.

usage: ranks.py WAKER SOURCE_DIRECTORY [UNIT_TESTS] [CASE...]

Also: a folder that a rank does not see; a run that is killed again and again and goes on on another number of ranks;
one that ends by SIGTERM; one that fails in a step; files that ranks write together, and that cannot be written;
the unit tests of partition and exchange on three ranks.
"""
import glob
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

import meshio
import numpy as np

import program

tight = ["Newton/Tolerance=1e-12", "Newton/Linear tolerance=1e-12",
         "Newton/Maximum iterations=50", "Newton/Maximum linear iterations=5000",
         "Gravity/Tolerance=1e-12"]
# Name: file, settings, time step (s), ranks.
cases = {
    "weak dyke": ("chapter5/dyke_weak.prm", ["Grid/Cell size=0.5",
                                             "Time stepping/Ramp duration=0"],
                  0.01, (2, 3, 4)),
    "contour": ("chapter5/dyke_weak.prm", ["Grid/Cell size=0.5",
                                           "Surface/Method=contour",
                                           "Time stepping/Ramp duration=0"],
                0.01, (3,)),
    "explicit": ("chapter5/dyke_weak.prm", ["Grid/Cell size=0.5",
                                            "Time stepping/Scheme=explicit",
                                            "Time stepping/Ramp duration=0"],
                 0.0056, (3,)),  # it takes its own, of 0.005 s
    "springs": ("chapter5/dyke_weak.prm",
                ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0",
                 "Boundary conditions/left side/Method=penalty"], 0.01, (3,)),
    "double mapping": ("chapter5/dyke_weak.prm",
                       ["Grid/Cell size=0.5", "Newton/Tangent=double mapping",
                        "Kinematics and mapping/Volumetric strain=B-bar",
                        "Newton/Maximum iterations=500",
                        "Time stepping/Ramp duration=0"], 0.01, (3,)),
    "nonlocal": ("chapter5/dyke_weak.prm",
                 ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0",
                  "Materials/clay/Regularisation=nonlocal",
                  "Materials/clay/Averaging length=1"], 0.01, (3,)),
    # Its reach is ten cells.
    "nonlocal far": ("chapter5/dyke_weak.prm",
                     ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0",
                      "Materials/clay/Regularisation=nonlocal",
                      "Materials/clay/Averaging length=2"], 0.01, (4,)),
    "pore water": ("verification/dyke_rising_line.prm",
                   ["Kinematics and mapping/Volumetric strain=standard",
                    "Time stepping/Ramp duration=0",
                    "Gravity/Initial share=0.9"], 0.01, (3,)),
    "slice": ("verification/dyke_slice.prm", ["Grid/Cell size=0.5"], 0.01, (3,)),
    "water in space": ("chapter6/dyke_3d.prm",
                       ["Time stepping/Ramp duration=0",
                        "Gravity/Initial share=0.9"], 0.01, (3,)),
    "contour in space": ("chapter6/dyke_3d.prm",
                         ["Surface/Method=contour", "Surface/Prismatic=false",
                          "Time stepping/Ramp duration=0",
                          "Gravity/Initial share=0.9"], 0.01, (3,)),
    "contour of slice": ("verification/dyke_slice.prm",
                         ["Grid/Cell size=0.5", "Surface/Method=contour"], 0.01,
                         (3,)),
    "flow": ("chapter3/flow.prm", [], 0.01, (3,)),
    "wall": ("chapter3/inclined_wall.prm", [], 0.02, (3,)),
    "friction": ("verification/dyke_on_ground.prm", [], 0.01, (3,)),
    "load programme": ("chapter6/drawdown_2d.prm",
                       ["Load programmes/drawdown/Start time=0",
                        "Load programmes/drawdown/Rate=-3"], 0.01, (3,)),
    "carried surface": ("chapter3/submerged_slope.prm",
                        ["Grid/Cell size=0.5", "Random fields/Names=",
                         "Time stepping/Ramp duration=0",
                         "Gravity/Initial share=0.9"], 0.01, (3,)),
    "tractions": ("chapter3/inclined_bar_3d.prm", [], 0.01, (3,)),
    "all methods": ("chapter3/bar_1d_mpm.prm", [], 0.01, (3,)),
    # Fixed and updated points, and a pressure that rides on points.
    "points": ("chapter3/inclined_bar.prm",
               ["Tractions/top/Method=updated points",
                "Tractions/end/Method=updated points",
                "Tractions/contour/Follows=soil"], 0.01, (3,)),
    "points in space": ("chapter3/inclined_bar_3d.prm",
                        ["Tractions/top/Method=updated points",
                         "Tractions/end/Method=updated points",
                         "Tractions/contour/Follows=soil"], 0.01, (3,)),
    "detected": ("chapter3/inclined_bar_detected.prm", [], 0.01, (3,)),
    "point load": ("chapter3/cantilever.prm", ["Newton/Tolerance=1e-11"], 0.02,
                   (3,)),
    "rising water": ("chapter3/rising_water.prm", [], 0.5, (3,)),
    "foundation": ("chapter6/foundation_2d.prm",
                   ["Load programmes/foundation/Mass=with mass",
                    "Load programmes/foundation/Start time=0"], 0.01, (3,)),
    # Dealt out anew twice.
    "flying block": ("verification/flying_block.prm", [], 0.008, (4,), 60),
    # Not dealt out anew: it leaves ranks empty.
    "empty ranks": ("verification/flying_block.prm",
                    ["Surface/Method=contour", "Ranks/Largest imbalance=1000"],
                    0.008, (4,), 60),
    # Nothing holds it along x: the long step finds no balance.
    "no balance": ("chapter5/dyke_weak.prm",
                   ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0",
                    "Boundary conditions/Names=base",
                    "Boundary conditions/base/Type=roller",
                    "Gravity/Initial stress=false",
                    "Time stepping/Scheme=quasi-static at rest"], 0.01, (3,)),
    # Asked for the places of all points at its start, then not for 40 steps.
    "copy that goes": ("chapter5/dyke_weak.prm",
                       ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0",
                        "Sliding masses/Watch=true",
                        "Sliding masses/Displacement=0.05"], 0.01, (3,), 60),
    "slope": ("chapter6/slope.prm", ["Grid/Cell size=0.25"], 0.01, (3, 4)),
}
# Half the time of all unit tests of ranks: of each there are smaller ones, or a case.
slow = ("Ranks.ContourIsThatOfTheWhole", "Ranks.LevelsOnSeveralRanks")
n_steps = 20  # if the case does not say
# Single points on a loose surface depend on the tolerance itself.
depend_on_tolerance = ("water in space", "contour in space", "friction",
                       "load programme", "slope")


ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1")


def call(words, n_ranks, **environment):
    environment = dict(ENVIRONMENT, **environment)
    if n_ranks == 1:
        return program.shared(words[0]).run(words[1:], env=environment)
    return subprocess.run(["mpirun", "-n", str(n_ranks)] + words, env=environment,
                          capture_output=True, text=True)


def run(waker, file, settings, folder, n_ranks, *flags):
    words = [waker, "run", file, "--set", "Output/Directory=" + folder, *flags]
    for setting in settings:
        words += ["--set", setting]
    done = call(words, n_ranks)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}\nends with {done.returncode}:\n"
                 + done.stdout[-2000:] + done.stderr[-2000:])


def statistics(folder):
    names, rows = [], []
    with open(os.path.join(folder, "statistics")) as file:
        for line in file:
            if line.startswith("#"):
                names.append(line.split(":", 1)[1].strip())
            else:
                rows.append([float(word) for word in line.split()])
    return names, np.array(rows)


def last_points(folder):
    files = sorted(glob.glob(os.path.join(folder, "**", "particles*.vtu"),
                             recursive=True))
    mesh = meshio.read(files[-1])
    fields = {name: np.asarray(values, dtype=float)
              for name, values in mesh.point_data.items()}
    fields["position"] = np.asarray(mesh.points)
    return fields


def difference(a, b):
    scale = np.abs(a).max()
    if scale == 0.:
        return np.abs(b).max()
    return np.abs(a - b).max() / scale


def compare(one, many):
    """Largest difference, relative to the column's or field's largest value."""
    worst = (0., "")
    names, a = statistics(one)
    _, b = statistics(many)
    if a.shape != b.shape:
        sys.exit(f"{one}: {a.shape} rows and columns, {many}: {b.shape}")
    # Iterations are no result; differences of large numbers have the round-off
    # of those.
    # Where a least height is may be any of several places.
    skip = ("iterations", "Residual", "Wall", "Linear", "remainder", "Remainder",
            "z of ")
    # A column is as exact as the largest of its unit: what is zero by symmetry is
    # round-off of what is not.
    scales = {}
    for i, name in enumerate(names):
        unit = name[name.rfind("("):] if "(" in name else name
        scales[unit] = max(scales.get(unit, 0.), np.nanmax(np.abs(a[:, i]),
                                                           initial=0.))
    for i, name in enumerate(names):
        if any(word in name for word in skip):
            continue
        scale = scales[name[name.rfind("("):] if "(" in name else name]
        both = np.isnan(a[:, i]) & np.isnan(b[:, i])
        d = np.where(both, 0., np.abs(a[:, i] - b[:, i]))
        d = np.max(np.where(np.isnan(d), np.inf, d), initial=0.)
        worst = max(worst, (d / (scale if scale > 0. else 1.), name))
    p, q = last_points(one), last_points(many)
    # Shear stresses of a slice that moves in its plane are round-off.
    stress = max((np.abs(p[name]).max() for name in p if name.startswith("stress")),
                 default=0.)
    for name in p:
        d = difference(p[name], q[name])
        if name.startswith("stress") and stress > 0.:
            d = np.abs(p[name] - q[name]).max() / stress
        worst = max(worst, (d, "point " + name))
    # Positions alone are written in double precision.
    way = np.abs(p["displacement"]).max() if "displacement" in p else 0.
    if way > 1e-6:
        d = np.abs(p["position"] - q["position"]).max() / way
        worst = max(worst, (d, "way of points"))
    return worst


def ranks_of(process):
    """The ranks that an mpirun has started."""
    return [int(word) for word in
            subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True,
                           text=True).stdout.split()]


def kill_all(process):
    """By SIGKILL, and wait: a rank that is left would still have the folder."""
    ranks = ranks_of(process)
    for pid in ranks + [process.pid]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    while any(os.path.exists(f"/proc/{pid}/exe") for pid in ranks):
        time.sleep(0.01)


def kill_and_resume(waker, path, settings, one, many, counts):
    """Each but the last of these numbers of ranks is killed after some steps.
    `one`: the folder of the run on one."""
    # Each step a checkpoint: what a kill leaves behind is that of some step.
    settings = settings + ["Output/Checkpoint interval=1e-6"]
    n_killed = 0
    for k, n in enumerate(counts[:-1]):
        words = ["mpirun", "-n", str(n), waker, "run", path, "--set",
                 "Output/Directory=" + many]
        for setting in settings:
            words += ["--set", setting]
        # Killed before its first checkpoint it begins anew.
        if os.path.isdir(many):
            words.append("--resume" if glob.glob(
                os.path.join(many, "checkpoints", "*.bin")) else "--overwrite")
        enough = (k + 1) * n_steps // len(counts)
        process = subprocess.Popen(words, env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL,
                                   start_new_session=True)
        while process.poll() is None:
            try:
                if len(statistics(many)[1]) >= enough:
                    kill_all(process)
            except (OSError, ValueError, IndexError):
                pass
            time.sleep(0.01)
        n_killed += process.returncode != 0
    run(waker, path, settings, many, counts[-1], "--resume")
    d, where = compare(one, many)
    print(f"on {counts} ranks, {n_killed} times killed: {d:.1e} ({where})")
    return d < 1e-10 and n_killed > 0


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


def main():
    waker, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    rest = sys.argv[3:]
    if rest and rest[0] not in cases:
        rest[0] = os.path.abspath(rest[0])
    os.chdir(source)  # files name others from there
    bad = 0
    if rest and rest[0] not in cases:
        unit_tests = rest.pop(0)
        done = call([unit_tests, "--gtest_brief=1", "--gtest_filter=Ranks.*"
                     + (f"-{':'.join(slow)}" if rest else "")], 3)
        if done.returncode != 0:
            print(done.stdout + done.stderr)
            bad += 1
        bad += not ends_cleanly(waker, source, to_all=True)
        bad += not ends_cleanly(waker, source, to_all=False)
        bad += not first_files(waker, source)
        bad += not full_disk(waker, source)
        bad += not fails_alike(waker, source)
        bad += not sees_the_folder(waker, source)
    for name in rest or cases:
        file, settings, step, ranks, *steps = cases[name]
        if rest:  # two cores are soon too few
            ranks = [n for n in ranks if n <= 3]
        end = (steps[0] if steps else n_steps) * step
        names = {setting.partition("=")[0] for setting in settings}
        settings = [setting for setting in tight
                    if setting.partition("=")[0] not in names] + settings
        settings += [f"Time stepping/Time step={step}",
                     f"Time stepping/End time={end}",
                     f"Output/Interval={end}"]
        path = os.path.join(source, "parameters", file)
        with tempfile.TemporaryDirectory() as work:
            one = os.path.join(work, "one")
            run(waker, path, settings, one, 1)
            limit = 1e-10
            if name in depend_on_tolerance:
                looser = os.path.join(work, "looser")
                run(waker, path, [s.replace("Newton/Tolerance=1e-12",
                                            "Newton/Tolerance=1e-11")
                                  for s in settings], looser, 1)
                limit = compare(one, looser)[0]
            for n in ranks:
                many = os.path.join(work, str(n))
                run(waker, path, settings, many, n)
                d, where = compare(one, many)
                print(f"{name}, {n} ranks: {d:.1e} ({where}), at most {limit:.1e}",
                      flush=True)
                bad += not d < limit
            if name == "weak dyke":
                bad += not kill_and_resume(waker, path, settings, one,
                                           os.path.join(work, "resumed"),
                                           [3, 2] if rest else
                                           [3, 2, 1, 4, 2, 3, 1, 2, 4, 3, 2])
    if bad:
        sys.exit(f"{bad} of the checks have failed")


if __name__ == "__main__":
    main()
