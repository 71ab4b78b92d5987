# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 6.12 to 6.17, 6.20 to 6.22, 6.24 and 6.25: distributions of load and
size of the failures of several analyses."""

import os

import numpy as np
from chapter6_data import ENOUGH, paired
from figure_files import BLUE, GREEN, VERMILLION, plt, sequence

# column: (name, edges of the bins). The thesis's first bin of the load is half
# as wide as the others, so that slopes that bear nothing lie at its centre.
QUANTITIES = {
    "load": ("ultimate load (m of soil)",
             np.array([0.0] + list(np.arange(0.1, 1.8, 0.2)))),
    "retrogression_distance": ("retrogression distance (m)",
                               np.arange(0.0, 2.8, 0.25)),
    "damaged_crest_width": ("damaged crest width (m)",
                            np.arange(0.0, 8.6, 0.5)),
    "relative_failure_volume": ("relative failure volume (-)",
                                np.arange(0.0, 1.01, 0.05)),
}
LAST = {"load": (-0.1, 1.5), "retrogression_distance": (0, 2.75),
        "damaged_crest_width": (0, 8.25), "relative_failure_volume": (0, 1)}
TWO = (BLUE, VERMILLION)
THREE = (BLUE, GREEN, VERMILLION)

# What the thesis prints of them: {panel's column: [(x, y in %, words)]} are
# stars, [(from, to, words)] of `ranges` brackets.
FIGURES = {
    "figure_6_12": (("1",), ("load",)),
    "figure_6_13": (("1",), ("retrogression_distance",)),
    "figure_6_14": (("1",), ("damaged_crest_width",
                             "relative_failure_volume")),
    "figure_6_15": (("1", "2b"), ("load", "retrogression_distance")),
    "figure_6_16": (("1", "2b"), ("damaged_crest_width",
                                  "relative_failure_volume")),
    "figure_6_17": (("1", "2c"), ("load", "damaged_crest_width")),
    "figure_6_20": (("3a", "1", "3c", "3d", "3e"), ("load",)),
    "figure_6_21": (("3a", "1", "3c", "3d", "3e"),
                    ("retrogression_distance",)),
    "figure_6_22": (("3a", "1", "3c", "3d", "3e"),
                    ("damaged_crest_width", "relative_failure_volume")),
    "figure_6_24": (("1", "4b", "4c"), ("load", "retrogression_distance")),
    "figure_6_25": (("1", "4b", "4c"), ("damaged_crest_width",
                                        "relative_failure_volume")),
}
STARS = {("figure_6_12", "load"): [(0.0, 10.4, "3D"), (0.0, 20.1, "2D")],
         ("figure_6_15", "load"): [(0.0, 10.4, "2A, 3D"),
                                   (0.0, 31.2, "2B, 3D")]}
RANGES = {("figure_6_12", "load"): [(0.4, 1.2, "3D"), (0.0, 0.6, "2D")],
          ("figure_6_14", "relative_failure_volume"): [
              (0.10, 0.35, "3D"), (0.30, 1.00, "2D")],
          ("figure_6_21", "retrogression_distance"): [
              (1.0, 1.5, "large peak")]}
LINES = {("figure_6_13", "retrogression_distance"): [
             (0.8, "inherent, 2D"), (2.5, "end of the domain")],
         ("figure_6_14", "damaged_crest_width"): [(4.2, "mean strengths")],
         ("figure_6_17", "damaged_crest_width"): [(4.25, "mean strengths")]}
SETS_NAME = {"1": "1", "2b": "2B", "2c": "2C", "3a": "3A", "3c": "3C",
             "3d": "3D", "3e": "3E", "4b": "4B", "4c": "4C"}
MEANING = {"2": {"1": "2A: 3.6 kPa", "2b": "2B: 3.4 kPa"},
           "17": {"1": "2A: COV 0.25", "2c": "2C: COV 0.1"},
           "3": {"3a": "ξ = 1", "1": "ξ = 5", "3c": "ξ = 10", "3d": "ξ = 20",
                 "3e": "ξ = 40"},
           "4": {"1": "k = 0", "4b": "k = 3 kPa/m", "4c": "k = 6 kPa/m"}}


def meaning(figure, analysis):
    number = int(figure[-2:])
    key = ("17" if number == 17 else "2" if number in (15, 16) else
           "3" if number in (20, 21, 22) else "4")
    return "" if number < 15 else MEANING[key][analysis]


def colours(n):
    return (BLUE,) if n == 1 else TWO if n == 2 else THREE if n == 3 else \
        list(sequence(n))


def values_of(s, column):
    values = s[column]
    return values[~np.isnan(values)]


def lines_of(axis, column, entries):
    """Shares (%) in bins; `entries`: [(set, colour, label)]."""
    edges = QUANTITIES[column][1]
    centres = 0.5 * (edges[1:] + edges[:-1])
    if column == "load":
        centres[0] = 0.0
    top = 0.0
    for s, colour, label in entries:
        values = np.minimum(values_of(s, column), edges[-1] - 1e-9)
        # A value on an edge belongs above it, also after round-off.
        counts, _ = np.histogram(values + 1e-9, edges)
        shares = 100.0 * counts / max(1, len(values))
        top = max(top, shares.max())
        plane = s.is_plane
        axis.plot(centres, shares, "--" if plane else "-", color=colour,
                  marker="o", markersize=4, linewidth=1.3,
                  markerfacecolor="white" if plane else colour,
                  label=f"{label}, N = {len(values)}")
    return top


def strip_of(axis, column, entries):
    """Each realisation of few as a dot, a row an analysis."""
    for row, (s, colour, _) in enumerate(entries):
        values = values_of(s, column)
        axis.plot(values, np.full(len(values), -row), "o", color=colour,
                  alpha=0.55, markersize=6, markeredgewidth=0)
        axis.plot(values.mean(), -row, "|", color=colour, markersize=13,
                  markeredgewidth=1.6)
    axis.set_yticks([-row for row in range(len(entries))],
                    [f"{', '.join(p.split(':')[0] for p in label.split(', '))}"
                     f" ({len(values_of(s, column))})"
                     for s, _, label in entries], fontsize=7)
    axis.set_ylim(-len(entries) + 0.4, 0.6)
    axis.grid(axis="y", visible=False)


def means_of(axis, column, sets, entries, row_of=None):
    """Triangles: the slope of mean strengths; on the axis or in the rows of the
    strip."""
    for k, (s, colour, _) in enumerate(entries):
        x = sets.deterministic(s.analysis, s.is_plane, column)
        if x is not None:
            axis.plot(x, 0 if row_of is None else row_of(k), "^",
                      color=colour, markersize=8, clip_on=False, zorder=4,
                      markeredgecolor="black", markeredgewidth=0.6)


def thesis_marks(axis, figure, column, top):
    """Stars, brackets and lines of what the thesis prints. The axis is
    made higher for brackets."""
    named = False

    def label():
        nonlocal named
        text = None if named else "printed in the thesis"
        named = True
        return text

    for x, y, words in STARS.get((figure, column), ()):
        axis.plot(x, y, "*", color="black", markersize=12,
                  markerfacecolor="none", zorder=5, linestyle="none",
                  clip_on=False, label=label())
        axis.annotate(words, (x, y), xytext=(8, -2), fontsize=7,
                      textcoords="offset points")
        top = max(top, y)
    for i, (low, high, words) in enumerate(RANGES.get((figure, column), ())):
        y = top * (1.12 + 0.11 * i)
        axis.plot([low, high], [y, y], "-|", color="black", linewidth=1,
                  markersize=7, label=label())
        axis.annotate(words, (0.5 * (low + high), y), xytext=(0, 2),
                      textcoords="offset points", fontsize=7, ha="center")
    for x, words in LINES.get((figure, column), ()):
        axis.axvline(x, color="black", linewidth=0.9, linestyle=":",
                     label=label())
        axis.annotate(words, (x, 0.55), xycoords=("data", "axes fraction"),
                      xytext=(-3, 0), textcoords="offset points",
                      rotation=90, fontsize=7, ha="right", va="center")
    n_ranges = len(RANGES.get((figure, column), ()))
    return top * (1.08 + 0.14 * n_ranges)


def draw(figure_name, sets, folder):
    """Returns a line that says what is not drawn, or None."""
    analyses, columns = FIGURES[figure_name]
    here = {name for name in analyses for plane in (False, True)
            if sets.analysis(name, plane) is not None}
    if len(here) < min(2, len(analyses)):
        return "not drawn, only of " + (", ".join(
            SETS_NAME[name] for name in sorted(here)) or "none") + \
            " there are realisations"
    palette = dict(zip(analyses, colours(len(analyses))))
    found = []
    for plane in (False, True):
        for name in analyses:
            s = sets.analysis(name, plane)
            if s is not None:
                label = meaning(figure_name, name)
                colour = palette[name]
                if len(analyses) == 1:
                    colour = VERMILLION if plane else BLUE
                found.append((s, colour, (label + ", " if label else "")
                              + ("2D" if plane else "3D")))
    panels = []
    for column in columns:
        entries = [e for e in found if len(values_of(e[0], column))]
        panels.append((column,
                       [e for e in entries if len(e[0]) >= ENOUGH],
                       [e for e in entries if len(e[0]) < ENOUGH]))
    with_curve = any(many for _, many, _ in panels)
    n_few = max(len(few) for _, _, few in panels)
    strip = 0.15 + 0.17 * n_few
    heights = [2.5, strip] if with_curve else [0.3, max(strip, 0.5)]
    figure = plt.figure(figsize=(7.6 if len(columns) > 1 else 5.4,
                                 sum(heights) + 0.6))
    grid = figure.add_gridspec(2, len(columns), height_ratios=heights)
    for k, (column, many, few) in enumerate(panels):
        below = figure.add_subplot(grid[1, k] if many and few else grid[:, k])
        above = figure.add_subplot(grid[0, k], sharex=below) \
            if many and few else below
        if len(columns) > 1:
            above.set_title(f"({'ab'[k]})")
        if many:
            top = lines_of(above, column, many)
            above.set_ylim(0, thesis_marks(above, figure_name, column, top))
            means_of(above, column, sets, many)
            above.plot([], [], "^", color="white", markersize=7,
                       markeredgecolor="black", markeredgewidth=0.6,
                       label="mean strengths")
            above.set_ylabel("share of the realisations (%)")
            marked = any((figure_name, column) in table
                         for table in (STARS, RANGES, LINES))
            if marked or not any(panel[1] for panel in panels[:k]):
                above.legend(fontsize=7)
        if many and few:
            above.tick_params(labelbottom=False)
        if few:
            strip_of(below, column, few)
            means_of(below, column, sets, few, lambda k: -k)
            if not many:
                thesis_marks(below, figure_name, column, 0.0)
                below.set_ylim(-len(few) + 0.4, 0.6)
        if not many and not few:
            below.text(0.5, 0.5, "in 3D only: not run yet", ha="center",
                       transform=below.transAxes, fontsize=8)
            below.set_yticks([])
        below.set_xlabel(QUANTITIES[column][0])
        low, high = LAST[column]
        shown = [values_of(e[0], column).max() for e in many + few]
        below.set_xlim(low, max([high] + [1.05 * x for x in shown]))
    figure.savefig(os.path.join(folder, figure_name + ".png"))
    plt.close(figure)
    wanted = [(name, plane) for name in analyses for plane in (False, True)]
    missing = [SETS_NAME[name] + (" in 2D" if plane else " in 3D")
               for name, plane in wanted if sets.analysis(name, plane) is None]
    return "drawn without " + ", ".join(missing) if missing else None


def draw_pairs(sets, folder):
    """Each realisation in 3D beside its twin in the plane."""
    found = []
    for space in sets:
        if space.is_plane or space.is_screen:
            continue
        plane = sets.get(space.name + "-2d")
        i, j = paired(space, plane)
        if len(i):
            found.append((space, space["load"][i], plane["load"][j]))
    if not found:
        return "not drawn, no realisations in 3D with a twin"
    figure, axis = plt.subplots(figsize=(4.6, 4.2))
    top = 0.0
    for (space, x, y), marker in zip(found, "osD^vP*X<"):
        axis.plot(y, x, marker, alpha=0.75, markersize=5,
                  label=f"{space.label}, N = {len(x)}")
        top = max(top, x.max(), y.max())
    axis.plot([0, 1.05 * top], [0, 1.05 * top], color="#666666", linewidth=0.8)
    axis.set(xlabel="ultimate load in plane strain (m)",
             ylabel="ultimate load in 3D (m)", aspect="equal",
             xlim=(-0.02 * top, 1.08 * top), ylim=(-0.02 * top, 1.08 * top))
    axis.legend(fontsize=7)
    figure.savefig(os.path.join(folder, "pairs.png"))
    plt.close(figure)
    return None
