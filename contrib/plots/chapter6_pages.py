# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of the page of chapter 6 beside its tables: the figures that have been
drawn, and which realisations to render like the thesis's pictures."""

import os

import numpy as np
from chapter6_data import FIRST_CLASS

CAPTIONS = (
    (("figure_6_02",), "6.2", "Four realisations in plane strain, every tenth "
     "step marked: the lowest number that is inherently unstable; that is held "
     "once, when it fails; that is held for at most 0.1 s at a time, at least "
     "twice, and goes on; that is held for 0.2 s or more, and goes on. The "
     "last two are held for the first time within 0.1 s of the start. Dotted: "
     "the limits."),
    (("figure_6_03",), "6.3", "Mean strength with depth, a standard deviation "
     "beside it. With k = 6 kPa/m a fifth of the top layer of cells would "
     "be negative, and are cut off."),
    (("figure_6_12",), "6.12", "Ultimate load, base case."),
    (("figure_6_13",), "6.13", "Retrogression distance, base case."),
    (("figure_6_14",), "6.14", "Damaged width of the crest, relative failure "
     "volume, base case."),
    (("figure_6_15", "figure_6_16"), "6.15, 6.16", "A lower mean."),
    (("figure_6_17",), "6.17", "A lower coefficient of variation."),
    (("figure_6_20", "figure_6_21", "figure_6_22"), "6.20 to 6.22",
     "Horizontal scale of fluctuation, ξ = θ_h / θ_v."),
    (("figure_6_24", "figure_6_25"), "6.24, 6.25",
     "Strength that grows with depth."))


def figures(notes, folder):
    """Markdown; `notes` by figure say what is missing."""
    lines = []
    for names, number, words in CAPTIONS:
        drawn = [n for n in names
                 if not (notes.get(n) or "").startswith("not drawn")]
        if not drawn:
            lines += [f"**{number}** {words} *Not run yet.*", ""]
            continue
        missing = {(notes.get(n) or "").replace("drawn without", "Without")
                   for n in drawn} - {""}
        lines += [f"**{number}** {words} " + " ".join(
            f"{m}." for m in sorted(missing)), ""]
        lines = [line.rstrip() for line in lines]
        lines += [f"![{n[7:].replace('_', '.').replace('.0', '.')}]"
                  f"({os.path.join(folder, n)}.png)" for n in drawn] + [""]
    return "\n".join(lines[:-1])


def behind(s):
    return s["n_masses_behind_centred"] + s["n_masses_behind_off_centre"]


def side(s):
    return s["n_masses_side"]


def slides(s):
    return s["load"] < FIRST_CLASS - 1e-9


# Figure, analysis, what it shows, which are meant, and what is largest of these.
PICTURES = (
    ("6.4", "1", "bears less than 0.1 m, most masses after the first",
     slides, lambda s: s["n_masses"]),
    ("6.5", "1", "bears less than 0.1 m, smallest volume",
     slides, lambda s: -s["relative_failure_volume"]),
    ("6.7", "1", "under the load, most masses behind",
     lambda s: ~slides(s), behind),
    ("6.8", "1", "the largest load", lambda s: ~slides(s),
     lambda s: s["load"]),
    ("6.9a", "1", "under the load, widest first mass",
     lambda s: ~slides(s), lambda s: s["first_mass_width"]),
    ("6.9e", "1", "under the load, narrowest first mass",
     lambda s: ~slides(s), lambda s: -s["first_mass_width"]),
    ("6.10", "1", "under the load, most masses at the sides",
     lambda s: ~slides(s) & (side(s) > 0), side),
    ("6.11", "1", "under the load, masses behind, none at the sides, largest "
     "retrogression",
     lambda s: ~slides(s) & (side(s) == 0) & (behind(s) > 0),
     lambda s: s["retrogression_distance"]),
    ("6.18", "3a", "most masses", lambda s: s["n_masses"] > 0,
     lambda s: s["n_masses"]),
    ("6.19", "3e", "largest volume", lambda s: s["n_masses"] > 0,
     lambda s: s["relative_failure_volume"]),
    ("6.23", "4c", "largest retrogression", lambda s: s["n_masses"] > 0,
     lambda s: s["retrogression_distance"]),
    ("6.26", "4c", "smallest volume", lambda s: s["n_masses"] > 0,
     lambda s: -s["relative_failure_volume"]),
)


def pictures(sets):
    """Which realisation in 3D each rule chooses of those that there are."""
    lines = ["| like | analysis | rule | realisation | load (m) | volume (-) | "
             "retrogression (m) | crest width (m) |",
             "|---|---|---|---|---|---|---|---|"]
    for number, analysis, rule, chosen, key in PICTURES:
        s = sets.analysis(analysis)
        rows = np.flatnonzero(chosen(s)) if s is not None else []
        if not len(rows):
            lines.append(f"| {number} | {analysis.upper()} | {rule} | none of "
                         f"{0 if s is None else len(s)} | | | | |")
            continue
        i = rows[np.argmax(key(s)[rows])]  # the lowest number of equals
        values = " | ".join(f"{s[c][i]:.2f}" for c in (
            "load", "relative_failure_volume", "retrogression_distance",
            "damaged_crest_width"))
        lines.append(f"| {number} | {analysis.upper()} | {rule} | "
                     f"no. {s.numbers[i]}, N = {len(s)} | {values} |")
    return "\n".join(lines)
