#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/factor_of_safety.md: factors of safety
of the dyke of chapter 5 without softening, against slip circles.

    /usr/bin/python3 contrib/verification/factor_of_safety.py [--cells 0.25,0.125]
        [--only B-bar]

Cells of 0.25 m take some minutes, cells of 0.125 m half an hour. Factors that are in
doc/verification/data/factor_of_safety.csv for other cells, or without --only's
volumetric strain, stay there.
"""

import csv
import os

import numpy as np
from common import DATA, plt, save
from dyke_runs import option, workspace
import dyke_measures as measures

CASE = "verification/dyke_no_softening.prm"
STRENGTH = 13.0  # kPa
CREST = 5.0      # m
# Slip circles for 13 kPa, by H_i - h (m); None: no water.
INNER = 1.736
OUTER = {0.25: 2.67, 0.5: 2.36, 1.0: 1.93, 1.5: 1.64, 2.0: 1.445, None: 1.049}
# Volumetric strain, Young's modulus (kPa; a slip circle knows none) and reading,
# and the cells to show it with.
VARIANTS = {("standard", 1000, "displacement"): (0.25, 0.125),
            ("standard", 1000, "width or height"): (0.25,),
            ("B-bar", 1000, "displacement"): (0.25,),
            ("B-bar", 5000, "displacement"): (0.25, 0.125)}
COLUMNS = ("cell_m", "freeboard_m", "volumetric", "modulus_kPa", "reading",
           "circle", "factor", "slope")


def circle(freeboard):
    return min(INNER, OUTER[freeboard])


def factor(work, cell, freeboard, volumetric, modulus, reading):
    water = ({"Water/Side": "none"} if freeboard is None
             else {"Water/Level": CREST - freeboard})
    name = f"{cell}-{freeboard}-{volumetric}-{modulus}-{reading}".replace(" ", "-")
    # Two waves a step, at least; by width or height some never fail.
    step = 0.04 * cell * (0.5 if modulus > 2000 else 1.0)
    bracket = ((0.9, 2.2) if reading != "displacement"
               else (0.9 * circle(freeboard), 1.2 * circle(freeboard)))
    sets = {"Grid/Cell size": cell, "Time stepping/Time step": step,
            "Materials/clay/Young's modulus": modulus,
            **measures.strength(STRENGTH, STRENGTH), **water,
            "Strength reduction/Reading": reading,
            "Kinematics and mapping/Volumetric strain": volumetric,
            "Strength reduction/Lower factor": bracket[0],
            "Strength reduction/Upper factor": bracket[1]}
    result = work.factor_of_safety(name, CASE, sets)
    failure = result["failure"] or {}
    return result["factor_of_safety"], failure.get("slope") or ""


def known(path, cells, kinds):
    """Rows of the table that are not computed again."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return [row for row in csv.DictReader(file)
                if not (float(row["cell_m"]) in cells
                        and row["volumetric"] in kinds)]


def draw(rows):
    figure, axes = plt.subplots()
    freeboards = [f for f in OUTER if f is not None]
    axes.axhline(INNER, color="grey", linewidth=0.8)
    axes.plot(freeboards, [OUTER[f] for f in freeboards], color="grey",
              linewidth=0.8)
    axes.text(1.0, INNER + 0.02, "inner slope, slip circle", color="grey")
    axes.text(0.3, 2.5, "outer slope, slip circle", color="grey")
    for cell, variant, marker, colour in (
            (0.25, ("standard", 1000, "displacement"), "o", "C0"),
            (0.125, ("standard", 1000, "displacement"), "s", "C2"),
            (0.25, ("B-bar", 5000, "displacement"), "^", "C1"),
            (0.125, ("B-bar", 5000, "displacement"), "v", "C4"),
            (0.25, ("standard", 1000, "width or height"), "x", "C3")):
        volumetric, modulus, reading = variant
        chosen = [row for row in rows if float(row["cell_m"]) == cell
                  and row["reading"] == reading and row["freeboard_m"]
                  and row["volumetric"] == volumetric
                  and float(row["modulus_kPa"]) == modulus and row["factor"]]
        if chosen:
            axes.plot([float(row["freeboard_m"]) for row in chosen],
                      [float(row["factor"]) for row in chosen], marker,
                      color=colour, label=f"{volumetric}, E = {modulus} kPa, h = {cell:g} m, "
                      f"by {reading}")
    axes.set_xlabel("crest above the water, H_i − h (m)")
    axes.set_ylabel("factor of safety")
    axes.set_ylim(1.3, 2.7)
    axes.legend()
    save(figure, "factor_of_safety")


def main():
    cells = [float(cell) for cell in option("--cells", "0.25").split(",")]
    kinds = option("--only", "standard,B-bar").split(",")
    path = os.path.join(DATA, "factor_of_safety.csv")
    rows = known(path, cells, kinds)
    with workspace(__doc__) as work:
        for cell in cells:
            for (volumetric, modulus, reading), shown in VARIANTS.items():
                if cell not in shown or volumetric not in kinds:
                    continue
                print(f"| H_i − h (m) | circle | h = {cell:g} m, {volumetric}, "
                      f"E = {modulus} kPa, {reading} | difference | slope |\n|---|---|---|---|---|")
                for freeboard in OUTER:
                    value, slope = factor(work, cell, freeboard, volumetric,
                                          modulus, reading)
                    expected = circle(freeboard)
                    rows.append(dict(zip(COLUMNS, (
                        cell, "" if freeboard is None else freeboard,
                        volumetric, modulus, reading, expected,
                        "" if value is None else round(value, 4), slope))))
                    text = ("none below 2.2 | " if value is None else
                            f"{value:.3f} | {100 * (value / expected - 1):+.1f} %")
                    print(f"| {'no water' if freeboard is None else freeboard} "
                          f"| {expected} | {text} | {slope} |", flush=True)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(rows, key=lambda row: (
            float(row["cell_m"]), row["volumetric"],
            float(row["modulus_kPa"]), row["reading"],
            float(row["freeboard_m"] or np.inf))))
    draw(rows)


if __name__ == "__main__":
    main()
