# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs on several ranks, and the difference of two of them. Shared by the scripts
that show that one realisation on several ranks is that on one."""
import glob
import json
import os
import struct
import subprocess
import sys

import meshio
import numpy as np
import program

ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1",
                   OPENBLAS_NUM_THREADS="1",
                   # Other tests run beside, on the same cores.
                   OMPI_MCA_hwloc_base_binding_policy="none")
# Fields in the files of points are in single precision: a number may round to the
# one beside it, however small the difference.
SINGLE = 2.**-23


def call(words, n_ranks, **environment):
    environment = dict(ENVIRONMENT, **environment)
    if n_ranks == 1:
        return program.shared(words[0]).run(words[1:], env=environment)
    return subprocess.run(["mpirun", "-n", str(n_ranks)] + words, env=environment,
                          capture_output=True, text=True)


def command(waker, file, settings, folder, *flags):
    words = [waker, "run", file, "--set", "Output/Directory=" + folder, *flags]
    for setting in settings:
        words += ["--set", setting]
    return words


def run(waker, file, settings, folder, n_ranks, *flags):
    """What it says."""
    words = command(waker, file, settings, folder, *flags)
    done = call(words, n_ranks)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}\nends with {done.returncode}:\n"
                 + done.stdout[-2000:] + done.stderr[-2000:])
    return done.stdout + done.stderr


def summary(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


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


def state(folder, n):
    """Arrays of the n points in the newest checkpoint, in double precision, in the
    order of MaterialPoints::for_each_array()."""
    newest, content = -1, b""
    for name in glob.glob(os.path.join(folder, "checkpoints", "*.bin")):
        with open(name, "rb") as file:
            data = file.read()
        step = struct.unpack_from("<Q", data, 24)[0]
        if step > newest:
            newest, content = step, data
    if newest < 0:
        sys.exit(f"{folder}: no checkpoint")
    at = 32
    for _ in range(3):  # hash of the case, program, what is no array
        at, last = (at + 8 + struct.unpack_from("<Q", content, at)[0], at + 8)
    record, content = content[last:at], content[at:]
    # The sizes of arrays: those to the stress have a value for each point.
    place = record.find(struct.pack("<10Q", *[n] * 10))
    if place < 0:
        sys.exit(f"{folder}: the checkpoint has not {n} points")
    sizes = struct.unpack_from(
        f"<{struct.unpack_from('<Q', record, place - 8)[0]}Q", record, place)
    for dim in (2, 3):
        widths = [8, 4, 8, 8] + [8 * dim] * 5 + [48, 8 * dim, 8 * dim,
                                                 8 * dim * dim]
        widths += [8] * (len(sizes) - len(widths))
        if sum(size * width for size, width in zip(sizes, widths)) == len(content):
            break
    else:
        sys.exit(f"{folder}: arrays of other sizes in the checkpoint")
    names = ["id", "material", "mass", "volume", "half size", "position",
             "initial position", "velocity", "acceleration", "stress", "load",
             "initial half size", "deformation"]
    names += [f"scalar {i}" for i in range(len(sizes) - len(names))]
    kinds = {"id": "<u8", "material": "<u4"}
    arrays, at = {"step": np.array([newest])}, 0
    for name, size, width in zip(names, sizes, widths):
        arrays[name] = np.frombuffer(content, kinds.get(name, "<f8"),
                                     size * width // (4 if width == 4 else 8), at)
        at += size * width
    return arrays


def largest(a, b):
    """Largest difference; infinite if there is no number in one of them only."""
    if a.shape != b.shape:
        return np.inf
    a, b = a.astype(float), b.astype(float)
    same = (a == b) | (np.isnan(a) & np.isnan(b))
    d = np.where(same, 0., np.abs(a - b))
    return np.max(np.where(np.isnan(d), np.inf, d), initial=0.)


def difference(a, b):
    scale = np.nanmax(np.abs(a.astype(float)), initial=0.)
    return largest(a, b) / (scale if scale > 0. else 1.)


def compare_statistics(one, many):
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
        column = np.abs(a[:, i])
        scales[unit] = max(scales.get(unit, 0.),
                           np.max(column[np.isfinite(column)], initial=0.))
    # Forces, say, that balance on every node: there is nothing but round-off.
    scales = {unit: 1. if scale < 1e-11 else scale for unit, scale in scales.items()}
    for i, name in enumerate(names):
        if any(word in name for word in skip):
            continue
        scale = scales[name[name.rfind("("):] if "(" in name else name]
        # Not a number, or infinite, on both or on none.
        same = (a[:, i] == b[:, i]) | (np.isnan(a[:, i]) & np.isnan(b[:, i]))
        both = np.isfinite(a[:, i]) & np.isfinite(b[:, i])
        d = np.where(same, 0., np.inf)
        d[both] = np.abs(a[both, i] - b[both, i])
        d = np.max(d, initial=0.)
        worst = max(worst, (d / scale, name))
    return worst


def compare_files(one, many):
    """Of the fields in the last files of the points, as a share of the largest."""
    worst = (0., "")
    p, q = last_points(one), last_points(many)
    if set(p) != set(q):
        sys.exit(f"{one}: fields {sorted(p)}, {many}: {sorted(q)}")
    # Shear stresses of a slice that moves in its plane are round-off.
    stress = max((np.abs(p[name]).max() for name in p if name.startswith("stress")),
                 default=0.)
    for name in p:
        d = difference(p[name], q[name])
        if name.startswith("stress") and stress > 0.:
            d = largest(p[name], q[name]) / stress
        worst = max(worst, (d, "field " + name))
    return worst


def compare_output(one, many):
    """What a run writes for others: its statistics, and fields as files have them."""
    return max(compare_statistics(one, many), compare_files(one, many))


def compare(one, many):
    """Largest difference of columns and points, relative to the column's or field's
    largest value."""
    worst = compare_statistics(one, many)
    in_files = compare_files(one, many)
    if not in_files[0] <= 1.01 * SINGLE:
        worst = max(worst, in_files)
    n = len(last_points(one)["position"])
    p, q = state(one, n), state(many, n)
    if set(p) != set(q):
        sys.exit(f"{one}: arrays {sorted(p)}, {many}: {sorted(q)}")
    # Accelerations are differences of velocities over a step, and as exact as those.
    names, rows = statistics(one)
    step = rows[-1, names.index("Time step (s)")]
    for name in p:
        d = difference(p[name], q[name])
        if name == "acceleration" and d > 0.:
            d *= np.abs(p[name]).max() / max(np.abs(p[name]).max(),
                                             np.abs(p["velocity"]).max() / step)
        worst = max(worst, (d, "points' " + name))
    # On the scale of the way that points have gone, not of the grid, if round-off of
    # the place is less than 1e-10 of it.
    way = np.abs(p["position"] - p["initial position"]).max()
    if 1e-10 * way > 4. * np.finfo(float).eps * np.abs(p["position"]).max():
        d = largest(p["position"], q["position"]) / way
        worst = max(worst, (d, "way of points"))
    return worst
