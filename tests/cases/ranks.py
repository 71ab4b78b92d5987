#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One realisation on several ranks is the one on one rank: with tight tolerances
equal to 1e-10 after 20 steps, in the statistics and in each material point.

usage: ranks.py WAKER SOURCE_DIRECTORY [CASE]
"""
import glob
import os
import subprocess
import sys
import tempfile

import meshio
import numpy as np

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
                0.01, (2, 3)),
    "pore water": ("verification/dyke_rising_line.prm", [], 0.01, (2, 3)),
    "slice": ("verification/dyke_slice.prm", ["Grid/Cell size=0.5"], 0.01,
              (2, 3)),
    "friction": ("verification/granular_column.prm", [], None, (3,)),
}
n_steps = 20


def run(waker, file, settings, folder, n_ranks):
    words = [waker, "run", file, "--set", "Output/Directory=" + folder]
    for setting in settings:
        words += ["--set", setting]
    if n_ranks > 1:
        words = ["mpirun", "-n", str(n_ranks)] + words
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1",
                       OMP_NUM_THREADS="1")
    done = subprocess.run(words, env=environment, capture_output=True, text=True)
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
    skip = ("iterations", "Residual", "Wall", "Linear", "remainder", "Remainder")
    energy = max(np.abs(a[:, i]).max() for i, name in enumerate(names)
                 if "kJ" in name) if any("kJ" in n for n in names) else 0.
    for i, name in enumerate(names):
        if any(word in name for word in skip):
            continue
        d = difference(a[:, i], b[:, i])
        if "kJ" in name and energy > 0.:
            d = np.abs(a[:, i] - b[:, i]).max() / energy
        worst = max(worst, (d, name))
    p, q = last_points(one), last_points(many)
    for name in p:
        worst = max(worst, (difference(p[name], q[name]), "point " + name))
    return worst


def main():
    waker, source = os.path.abspath(sys.argv[1]), sys.argv[2]
    chosen = sys.argv[3:] or list(cases)
    bad = 0
    for name in chosen:
        file, settings, step, ranks = cases[name]
        settings = settings + tight
        if step is not None:
            settings += [f"Time stepping/Time step={step}",
                         f"Time stepping/End time={n_steps * step}",
                         f"Output/Interval={n_steps * step}"]
        with tempfile.TemporaryDirectory() as work:
            path = os.path.join(source, "parameters", file)
            one = os.path.join(work, "one")
            run(waker, path, settings, one, 1)
            for n in ranks:
                many = os.path.join(work, str(n))
                run(waker, path, settings, many, n)
                d, where = compare(one, many)
                print(f"{name}, {n} ranks: {d:.1e} ({where})")
                if not d < 1e-10:
                    bad += 1
    if bad:
        sys.exit(f"{bad} of the runs differ by more than 1e-10")


if __name__ == "__main__":
    main()
