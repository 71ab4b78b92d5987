#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, data and numbers of doc/verification/random_layers.md: random fields of
several layers, measured on the points that the program writes at t = 0.

    /usr/bin/python3 contrib/verification/random_layers.py [--waker build/bin/waker]
        [--only moments|layers|measured|slides] [--campaign FOLDER]

Some minutes; `slides` reads the folder of `waker campaign dyke_random_layers.prm`.
"""

import csv
import os
import sys
import tempfile

import numpy as np
from common import ROOT, plt, read_csv, save
from dyke_runs import draw_points, option, write_csv

# pylint: disable=wrong-import-position
from program import Program  # noqa: E402
from waker_case import Run  # noqa: E402

CASE = os.path.join(ROOT, "parameters", "verification", "dyke_random_layers.prm")
CLAY, SAND, PEAT, ORGANIC = range(4)  # numbers of the materials
JOINT = -2.0  # m: peat above, organic clay below
THETA, SHARE = (24.0, 1.0), 0.75  # scales (m), local share
CELL = 0.25  # m, of the field
N = 150  # realisations
LIMITS = {PEAT: (0.36, 0.06), ORGANIC: (0.28, 0.02)}  # S: mean, deviation
POP = (15.0, 3.5)  # kPa
STIFF = {"Random fields/Names": "S, POP, phi, cover, E"}
STIFF.update({f"Random fields/E/{name}": value for name, value in {
    "Material": "organic clay", "Property": "Young's modulus",
    "Distribution": "lognormal", "Minimum": 500,
    "Coefficient of variation": 0.3, "Scales of fluctuation": "24, 1"}.items()})


class Drawn:
    """Points at t = 0 of n realisations: {field: array (n, points)}."""

    def __init__(self, program, n, settings=None):
        rows = []
        with tempfile.TemporaryDirectory(prefix="waker-") as folder:
            for i in range(n):
                words = ["run", CASE, "--realisation", str(i), "--overwrite"]
                for key, value in {
                        "Time stepping/End time": 0, "Output/Grid": "false",
                        "Output/Surface": "false", "Output/Directory": folder,
                        "Output/Checkpoint interval": 0, **(settings or {})}.items():
                    words += ["--set", f"{key}={value}"]
                program.run(words, check=True)
                rows.append(Run(folder).points())
        self.x, self.y = rows[0]["position"][:, :2].T
        self.material = rows[0]["material"]
        self.values = {key: np.array([row[key] for row in rows])
                       for key in rows[0] if rows[0][key].ndim == 1}

    def of(self, name, material):
        return self.values[name][:, self.material == material]

    def scores(self, name, moments):
        """Normal scores of a lognormal field, NaN where it is not."""
        result = np.full(self.values[name].shape, np.nan)
        for material, (mean, deviation) in moments.items():
            variance = np.log(1 + (deviation / mean)**2)
            result[:, self.material == material] = (
                np.log(self.of(name, material) / mean) + variance / 2
            ) / np.sqrt(variance)
        return result


def mean_and_error(per_realisation):
    return (per_realisation.mean(),
            per_realisation.std(ddof=1) / np.sqrt(len(per_realisation)))


def between_cells(dx, dy):
    """Correlation of averages over two cells, Markov (Vanmarcke 1983)."""
    # Distances within two cells have triangular densities.
    k = (np.arange(16) + 0.5) / 16 * 2 - 1
    u, v = np.meshgrid(k * CELL, k * CELL)
    weight = (1 - abs(u) / CELL) * (1 - abs(v) / CELL)

    def covariance(dx, dy):
        r = np.hypot((dx + u) / THETA[0], (dy + v) / THETA[1])
        return (weight * np.exp(-2 * r)).sum()
    return covariance(dx, dy) / covariance(0.0, 0.0)


def pairs(drawn, lag, layers):
    """Numbers of points `lag` above others in the same column, of (lower, upper)
    materials."""
    place = {(round(x, 3), round(y, 3)): i
             for i, (x, y) in enumerate(zip(drawn.x, drawn.y))
             if drawn.material[i] in layers}
    found = [(i, place[x, round(y + lag, 3)]) for (x, y), i in place.items()
             if (x, round(y + lag, 3)) in place]
    found = [(i, j) for i, j in found
             if (drawn.material[i], drawn.material[j]) == layers]
    return np.array(found).T if found else None


def correlation(a, b):
    """Of scores whose mean is 0 and variance 1, and its standard error."""
    return mean_and_error((a * b).mean(axis=1))


def moments(program):
    drawn = Drawn(program, N, STIFF)
    # By the mass that the points have, not by what is written of the field.
    gamma = 9.81 * drawn.of("mass", CLAY) / drawn.of("initial_volume", CLAY)
    print("unit weight by mass and as written: within %.1g"
          % abs(gamma / drawn.of("unit_weight", CLAY) - 1).max())
    rows = [("S, peat", drawn.of("strength_ratio", PEAT), 0.36, 0.06),
            ("S, organic clay", drawn.of("strength_ratio", ORGANIC), 0.28, 0.02),
            ("POP, peat (kPa)", drawn.of("POP", PEAT), *POP),
            ("POP, organic clay (kPa)", drawn.of("POP", ORGANIC), *POP),
            ("friction angle, sand (degrees)", drawn.of("friction_angle", SAND),
             30.0, 3.0),
            ("unit weight, clay (kN/m³)", gamma, 14.8, 0.74),
            ("Young's modulus, organic clay (kPa)", drawn.of("Young's_modulus", ORGANIC),
             2500.0, 750.0)]
    table = []
    for name, values, mean, deviation in rows:
        m, dm = mean_and_error(values.mean(axis=1))
        v, dv = mean_and_error(((values - mean)**2).mean(axis=1))
        table.append((name, mean, m, dm, deviation, np.sqrt(v),
                      dv / (2 * np.sqrt(v))))
        print("| %s | %g | %.4g ± %.2g | %g | %.3g ± %.2g |" % table[-1])
    write_csv("random_layers_moments", dict(zip(
        ("quantity", "mean", "obtained", "error", "deviation",
         "obtained_deviation", "error_of_it"), zip(*table))))
    print("unit weight within a realisation: largest difference %.2g"
          % np.ptp(gamma, axis=1).max())
    both = {PEAT: POP, ORGANIC: POP}
    a, b = drawn.scores("strength_ratio", LIMITS), drawn.scores("POP", both)
    soft = ~np.isnan(a[0])
    print("S and POP: correlation %.3f ± %.3f (0.3)"
          % correlation(a[:, soft], b[:, soft]))
    stress = drawn.values["initial_vertical_stress"]
    for material, m in ((PEAT, 0.9), (ORGANIC, 0.85)):
        s = stress[:, drawn.material == material]
        expected = drawn.of("strength_ratio", material) * s * (
            drawn.of("yield_stress", material) / s)**m
        print("s_u of material %d, from S, stress and yield stress: within %.1g"
              % (material, abs(drawn.of("undrained_shear_strength", material)
                               / expected - 1).max()))
    # Under the crest the clay is 1 m thick, on the foreland too; inside there is none.
    for x, thick in ((14.125, 1.0), (-10.125, 1.0), (40.125, 0.0)):
        q = np.flatnonzero((abs(drawn.x - x) < 1e-3) & (abs(drawn.y + 1.125) < 1e-3))[0]
        print("x = %g m, y = -1.125 m: d sigma_v / d gamma = %.4f m (%g)"
              % (x, np.polyfit(gamma[:, 0], stress[:, q], 1)[0], thick))
    lags, table = np.arange(0.25, 2.01, 0.25), []
    for lag in lags:
        row = [lag, 1 - SHARE + SHARE * between_cells(0.0, lag)]
        for layers in ((PEAT, PEAT), (ORGANIC, ORGANIC), (ORGANIC, PEAT)):
            found = pairs(drawn, lag, layers)
            row += correlation(a[:, found[0]], a[:, found[1]]) if found is not None \
                else (np.nan, np.nan)
        table.append(row)
    write_csv("random_layers_through", dict(zip(
        ("lag_m", "theory", "peat", "error_peat", "organic", "error_organic",
         "across", "error_across"), zip(*table))))


def layers(program):
    """A field of S for each layer, independent or correlated."""
    own = {"Random fields/Names": "S, deeper", "Random fields/S/Material": "peat"}
    own.update({f"Random fields/deeper/{name}": value for name, value in {
        "Material": "organic clay", "Property": "strength ratio",
        "Standard deviation": 0.02, "Distribution": "lognormal",
        "Local share": 0.75, "Scales of fluctuation": "24, 1"}.items()})
    columns = {}
    for name, text in (("independent", ""), ("correlated", "S, deeper: 0.6")):
        drawn = Drawn(program, N, {**own, "Random fields/Correlations": text})
        a = drawn.scores("strength_ratio", LIMITS)
        table = []
        for lag in np.arange(0.25, 2.01, 0.25):
            i, j = pairs(drawn, lag, (ORGANIC, PEAT))
            table.append((lag, *correlation(a[:, i], a[:, j])))
        columns["lag_m"], columns[name], columns["error_" + name] = zip(*table)
    write_csv("random_layers_own", columns)


def measured(program):
    """One sounding through both layers at x = 20.125 m."""
    y = np.arange(-3.875, 0, 0.25)
    target = np.where(y > JOINT, 0.36 - 0.05 * np.cos(3 * y), 0.28 + 0.02 * np.sin(2 * y))
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        name = os.path.join(folder, "sounding.csv")
        np.savetxt(name, np.column_stack([np.full_like(y, 20.125), y, target]),
                   delimiter=",")
        drawn = Drawn(program, N, {
            "Random fields/Names": "S", "Random fields/Correlations": "",
            "Random fields/S/Measurements": name})
    S = drawn.values["strength_ratio"]
    off = 0.0
    for yo, value in zip(y, target):
        q = np.flatnonzero((abs(drawn.x - 20.125) < 1e-3) & (abs(drawn.y - yo) < 1e-3))[0]
        off = max(off, abs(S[:, q] - value).max())
    print("measured cells: largest difference %.1g of %d realisations" % (off, N))
    scores = drawn.scores("strength_ratio", LIMITS)
    cov = np.vectorize(lambda dx, dy: 1 - SHARE + SHARE * between_cells(dx, dy))
    c_oo = cov(0.0, y[:, None] - y)
    table = []
    for x in 20.125 + np.array([0, 0.5, 1, 2, 3, 4, 6, 8, 12, 16, 20, 24]):
        for at in (-1.125, -3.125):
            q = np.flatnonzero((abs(drawn.x - x) < 1e-3) & (abs(drawn.y - at) < 1e-3))[0]
            c = cov(x - 20.125, at - y)
            table.append((x, at, scores[:, q].std(ddof=1),
                          np.sqrt(max(0.0, 1 - c @ np.linalg.solve(c_oo, c)))))
    write_csv("random_layers_measured", dict(zip(
        ("x_m", "y_m", "deviation", "theory"), zip(*table))))
    figure, ax = plt.subplots(figsize=(9, 2.4))
    draw_points(ax, {"position": np.column_stack([drawn.x, drawn.y])},
                np.where(np.isnan(scores[1]), np.nan, S[1]), "S", vmin=0.2, vmax=0.45, s=5)
    ax.axvline(20.125, color="k", linewidth=0.6)
    ax.set(xlabel="x (m)", ylim=(-4.1, 4.2))
    save(figure, "random_layers_field")


def slides(folder):
    with open(os.path.join(folder, "report", "realisations.csv"),
              encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    slid = [float(row["inner_slide_time"]) > 0 for row in rows]
    columns = {name: [float(row[f"field_{name}"]) for row in rows]
               for name in ("S_average_score", "S_mean", "POP_average_score",
                            "POP_mean", "phi_mean", "cover_mean")}
    write_csv("random_layers_slides", {"slid": [float(s) for s in slid], **columns})
    slid = np.array(slid)
    for name, values in columns.items():
        values = np.array(values)
        low = np.argsort(values)[:len(values) // 4]
        print("%s: %.4g of those that slide, %.4g of all; of the lowest quarter %d of %d"
              % (name, values[slid].mean(), values.mean(), slid[low].sum(), len(low)))
    print("averages of S: mean %.3f, deviation %.3f; correlation with that of POP %.3f"
          % (np.mean(columns["S_average_score"]), np.std(columns["S_average_score"]),
             np.corrcoef(columns["S_average_score"], columns["POP_average_score"])[0, 1]))


def draw():
    """random_layers.png from the data."""
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.6), constrained_layout=True)
    data, own = read_csv("random_layers_through"), read_csv("random_layers_own")
    lag = data["lag_m"]
    axes[0].plot(lag, data["theory"], "k", label="theory")
    for name, colour in (("peat", "C0"), ("organic", "C1"), ("across", "C2")):
        axes[0].errorbar(lag, data[name], data["error_" + name], fmt="o", ms=3,
                         color=colour, label={"across": "across the joint"}.get(
                             name, "in the " + name.replace("organic", "organic clay")))
    for name, factor, colour in (("independent", 0.0, "C3"), ("correlated", 0.6, "C4")):
        axes[0].plot(lag, factor * np.array(data["theory"]), colour, linewidth=0.8)
        axes[0].errorbar(lag, own[name], own["error_" + name], fmt="s", ms=3,
                         color=colour, label=f"across, own fields, {name}")
    axes[0].set(xlabel="vertical lag (m)", ylabel="correlation of scores of S",
                ylim=(-0.15, 1.05))
    axes[0].legend(fontsize=7)
    data = {key: np.array(values)
            for key, values in read_csv("random_layers_measured").items()}
    for y, colour in ((-1.125, "C0"), (-3.125, "C1")):
        at = data["y_m"] == y
        axes[1].plot(data["x_m"][at] - 20.125, data["theory"][at], colour)
        axes[1].plot(data["x_m"][at] - 20.125, data["deviation"][at], "o", ms=4,
                     color=colour, label=f"y = {y:g} m")
    axes[1].set(xlabel="distance from the sounding (m)",
                ylabel="deviation of the score")
    axes[1].legend(fontsize=8)
    data = {key: np.array(values)
            for key, values in read_csv("random_layers_slides").items()}
    for slid, colour, label in ((0, "C7", "stands"), (1, "C3", "slides")):
        at = data["slid"] == slid
        axes[2].plot(data["S_mean"][at], data["POP_mean"][at], "o", ms=4, color=colour,
                     label=label)
    axes[2].set(xlabel="mean S of the soft layers", ylabel="mean POP (kPa)")
    axes[2].legend(fontsize=8)
    save(figure, "random_layers")


def main():
    only = option("--only", "")
    waker = option("--waker", os.path.join(ROOT, "build", "bin", "waker"))
    campaign = option("--campaign", os.path.join(ROOT, "output", "dyke_random_layers"))
    if len(sys.argv) > 1:
        sys.exit(__doc__)
    with Program(waker) as program:
        for part in (moments, layers, measured):
            if only in ("", part.__name__):
                part(program)
    if only in ("", "slides"):
        slides(campaign)
    draw()


if __name__ == "__main__":
    main()
