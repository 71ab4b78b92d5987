#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probabilities on cells of 0.5, 0.25 and 0.125 m, for doc/verification/mesh.md:
the same realisations of one random field, with softening as it is, scaled by
the cell size, and nonlocal.

    /usr/bin/python3 contrib/verification/mesh_campaigns.py [--results FOLDER]

It takes about an hour on one core. FOLDER keeps the campaigns; those that are
finished there are only read.
"""

import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np
from common import ROOT, plt, save
from dyke_runs import option, write_csv

sys.path.insert(0, os.path.join(ROOT, "contrib", "plots"))

# pylint: disable=wrong-import-position
from estimates import clopper_pearson  # noqa: E402

FILE = os.path.join(ROOT, "parameters", "verification", "dyke_cells.prm")
WAKER = option("--waker", os.path.join(ROOT, "build", "bin", "waker"))
# Cell size (m): realisations, a prefix of one series.
CELLS = {0.5: 300, 0.25: 300, 0.125: 100}
CLAY = "Materials/clay/"
KINDS = {
    "as it is": {CLAY + "Softening length": 0},
    "scaled": {CLAY + "Softening length": 0.25},
    # doc/verification/nonlocal.md: the same factor of safety on 0.25 m.
    "nonlocal": {CLAY + "Regularisation": "nonlocal",
                 CLAY + "Averaging length": 0.5,
                 CLAY + "Softening modulus": -300},
}


def name_of(kind, cell):
    # On cells as long as the softening length nothing is scaled.
    shared = cell == 0.25 and kind in ("as it is", "scaled")
    return f"{'local' if shared else kind.replace(' ', '_')}_{cell}"


def results(folder, kind, cell, n):
    """Times of initial failure and flooding (s), NaN where there is none."""
    path = os.path.join(folder, name_of(kind, cell))
    file = os.path.join(path, "results.h5")
    if not os.path.exists(file):
        settings = {"Grid/Cell size": cell, "Campaign/Realisations": n,
                    "Output/Directory": path, **KINDS[kind]}
        words = [WAKER, "campaign", FILE]
        for key, value in settings.items():
            words += ["--set", f"{key}={value}"]
        if os.path.exists(path):
            words.append("--resume")
        subprocess.run(words, check=True)
    with h5py.File(file) as store:
        n_done = len(store["realisation"][:])
        if not np.array_equal(store["realisation"][:], np.arange(n_done)):
            sys.exit(f"{file}: not the realisations from 0 on")
        if n_done < n:
            print(f"{name_of(kind, cell)}: {n_done} of {n}")
        times = [np.where(store[key][0, :] >= 0., store[key][0, :], np.nan)
                 for key in ("initial_failure_time",
                             "initial_failure_time_displacement",
                             "flooding_time")]
    # A slide is what either reading sees.
    return np.fmin(times[0], times[1]), times[2]


def share(flags):
    """Count, probability and its 95 % interval."""
    count, n = int(flags.sum()), len(flags)
    low, high = clopper_pearson(count, n)
    return count, n, count / n, low, high


def main(folder):
    all_times = {(kind, cell): results(folder, kind, cell, n)
                 for kind in KINDS for cell, n in CELLS.items()}

    # On the finest cells there may be fewer.
    n_paired = min(len(times[0]) for times in all_times.values())
    table = {key: [] for key in ("softening", "h_m", "n", "n_S1", "P_S1",
                                 "P_S1_low", "P_S1_high", "n_F", "P_F",
                                 "P_F_low", "P_F_high")}
    for (kind, cell), (slide, flood) in all_times.items():
        for n in sorted({len(slide), n_paired}, reverse=True):
            table["softening"].append(kind)
            table["h_m"].append(cell)
            table["n"].append(n)
            for key, times in (("S1", slide), ("F", flood)):
                count, _, p, low, high = share(~np.isnan(times[:n]))
                table["n_" + key].append(count)
                for end, value in (("", p), ("_low", low), ("_high", high)):
                    table["P_" + key + end].append(value)
    write_csv("mesh_probabilities", table, digits=4)

    n = max(CELLS.values())
    columns = {"realisation": list(range(n))}
    for (kind, cell), times in all_times.items():
        for key, values in zip(("slide", "flooding"), times):
            padded = np.full(n, np.nan)
            padded[:len(values)] = values
            columns[f"{key}_s {kind} {cell:g} m"] = padded
    write_csv("mesh_realisations", columns, digits=5)

    # How many realisations do the same on two meshes?
    for kind in KINDS:
        for coarse, fine in ((0.5, 0.25), (0.25, 0.125)):
            n = min(len(all_times[kind, cell][1]) for cell in (coarse, fine))
            a, b = (~np.isnan(all_times[kind, cell][1][:n])
                    for cell in (coarse, fine))
            print(f"{kind}, {coarse:g} and {fine:g} m: of {n} flood on both "
                  f"{(a & b).sum()}, on the coarse alone {(a & ~b).sum()}, on "
                  f"the fine alone {(~a & b).sum()}")

    figure, axes = plt.subplots(1, 2, sharey=True, figsize=(8., 3.8))
    marks = {"as it is": "o", "scaled": "s", "nonlocal": "^"}
    for axis, key, index in zip(axes, ("P(S1)", "P(F)"), (0, 1)):
        for k, kind in enumerate(KINDS):
            for paired, colour in ((False, f"C{k}"), (True, f"C{k}")):
                cells, values = [], []
                for cell in CELLS:
                    times = all_times[kind, cell][index]
                    n = n_paired if paired else len(times)
                    cells.append(cell * (0.96 + 0.04 * k))
                    values.append(share(~np.isnan(times[:n]))[2:])
                p, low, high = np.array(values).T
                if paired:
                    axis.plot(cells, p, ":", color=colour, lw=1.)
                else:
                    axis.errorbar(cells, p, [p - low, high - p], color=colour,
                                  marker=marks[kind], capsize=3, label=kind)
        axis.set_xscale("log")
        axis.set_xticks(list(CELLS), [f"{cell:g}" for cell in CELLS])
        axis.minorticks_off()
        axis.set_xlabel("cell size h (m)")
        axis.set_title(key)
    axes[0].set_ylabel("probability")
    axes[0].set_ylim(0., None)
    axes[0].legend(title="softening")
    save(figure, "mesh_probabilities")


kept = option("--results", None)
if kept:
    main(kept)
else:
    with tempfile.TemporaryDirectory() as work:
        main(work)
