#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw what a campaign says, of any dyke.

    /usr/bin/python3 contrib/plots/campaign.py DIR [--output DIR/figures]

DIR is the folder of a campaign after `waker merge`. Levels and heights are in m
above the datum of the parameter file. Each figure comes as PNG, PDF and CSV (the
numbers that it shows):

  probability_time    before a time t (one campaign, or a line for each value)
  convergence         after n realisations, of each scenario
  probabilities       against the value that is swept
  fragility           against the water level, if that is swept
  outcomes            shares of how they ended
  residual_height     level of the highest point that is left
  residual_width      width at the water level that is left
  resistance_width    P(F|S1) by the width that the first slide left

Where no event was counted there is no estimate: a hollow triangle shows the
bound. Figures with the numbers of the thesis: contrib/plots/chapter5.py.
"""

import argparse
import os
import sys

import numpy as np

import fragility_figure
import geometry_figures as geometry
import probability_figures as probability
import figure_files as look
from store import Store


def axis_of(store):
    """What the store's scenarios differ in."""
    parameter = store.attribute("swept_parameter")
    scenarios = store.scenarios
    if parameter == "Water/Level":
        return probability.Axis(
            "water level $h$ (m above datum)", "$h$ (m above datum)",
            "water_level_m", [s.water_level for s in scenarios])
    short = parameter.split("/")[-1] or "campaign"
    if short == "Scales of fluctuation":
        scales = [s.scale_x for s in scenarios]
        if len(set(scales)) == len(scales) and min(scales) > 0.0:
            return probability.Axis(
                "horizontal scale of fluctuation (m)", r"$\theta_h$ (m)",
                "scale_m", scales, True)
    try:
        values = [float(s.value) for s in scenarios]
        if len(set(values)) == len(values):
            return probability.Axis(short, short, "value", values)
    except ValueError:
        pass
    return probability.Axis(short, short, "scenario",
                            list(range(len(scenarios))),
                            texts=[s.value or "all" for s in scenarios])


def convergence(files, scenarios):
    missing = []
    for scenario in scenarios:
        name = ("convergence" if len(scenarios) == 1
                else f"convergence_{scenario.index}")
        reason = probability.convergence(files, name, scenario)
        if reason:
            missing.append(f"scenario {scenario.index}: {reason}")
    return "; ".join(missing) or None


def draw_outcomes(files, scenarios, labels, axis):
    figure, (panel,) = look.panels(
        1, 1.6 + 0.3 * len(scenarios), 6.4)
    panel.set_title("")
    rows = geometry.outcomes(
        panel, scenarios, labels,
        {"stable": ("stable", "#DDDDDD"),
         "initial failure": ("slid, stands", look.BLUE),
         "flooding": ("flooded", look.VERMILLION),
         "numerical failure": ("numerical failure", "black")})
    panel.set_ylabel(axis.title if len(scenarios) > 1 else "")
    panel.legend(loc="lower center", bbox_to_anchor=(0.5, 1.02), ncol=4)
    files.save(figure, "outcomes", look.stores_of(scenarios),
               ["outcome", axis.column, "count", "share_percent"], rows)


def residual(files, name, scenarios, labels, axis, values, quantity, marks):
    """Histograms of what is left of the dykes that slid and stand, one below
    the other. `marks`: [(words, colour, value of each scenario), ...]."""
    columns = [values(scenario) for scenario in scenarios]
    if not any(len(column) for column in columns):
        return "no dyke that slid and stands"
    # Marks of panels with a bar must be seen; others may lie outside.
    edges = geometry.edges_of(np.concatenate(columns + [
        np.array([value for value, column in zip(of_each, columns)
                  if len(column)]) for *_, of_each in marks]))
    figure, axes = look.plt.subplots(
        len(scenarios), 1, squeeze=False, sharex=True,
        figsize=(6.4, 1.6 + 0.8 * len(scenarios)))
    panels = axes[:, 0]
    results = geometry.bars(panels, columns, edges,
                            look.sequence(len(scenarios)))
    for words, colour, of_each in marks:
        for panel, value in zip(panels, of_each):
            if edges[0] <= value <= edges[-1]:
                panel.axvline(value, color=colour, linestyle="--",
                              linewidth=1.2, label=words)
    entries = {words: line for panel in panels
               for line, words in zip(*panel.get_legend_handles_labels())}
    if entries:
        panels[0].legend(entries.values(), entries.keys(), ncol=2,
                         loc="lower center", bbox_to_anchor=(0.5, 1.02))
    geometry.name_panels(
        panels, labels if len(scenarios) > 1 else ["slid, stands"], columns,
        outside=True)
    panels[-1].set_xlabel(quantity)
    files.save(figure, name, look.stores_of(scenarios),
               ["quantity", axis.column, "low", "high", "count",
                "share_percent"],
               geometry.bins_to_rows(name, axis.values, edges, results),
               ["only dykes that slid and did not flood"])
    return None


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--output", metavar="DIR",
                        help="default: figures/ in the campaign's folder")
    arguments = parser.parse_args()
    store = Store(arguments.folder)
    files = look.FigureFiles(arguments.output
                             or os.path.join(arguments.folder, "figures"))
    axis = axis_of(store)
    scenarios = [s for s in store.scenarios if s.n > 0]
    if not scenarios:
        sys.exit(f"{arguments.folder}: no realisation that counts")
    order = sorted(range(len(store.scenarios)), key=lambda i: axis.values[i])
    order = [i for i in order if store.scenarios[i].n > 0]
    scenarios = [store.scenarios[i] for i in order]
    axis.texts = [axis.texts[i] for i in order] if axis.texts else []
    axis.values = [axis.values[i] for i in order]
    labels = [axis.text(i) for i in range(len(scenarios))]

    missing = {}
    if len(scenarios) == 1:
        probability.in_time(files, "probability_time", scenarios[0])
    else:
        probability.against_time(files, "probability_time", scenarios, axis)
    missing["convergence"] = convergence(files, scenarios)
    probability.against_value(files, "probabilities", scenarios, axis)
    if axis.column == "water_level_m":
        missing["fragility"] = fragility_figure.fragility(files, "fragility",
                                                          store)
    draw_outcomes(files, scenarios, labels, axis)
    missing["residual_height"] = residual(
        files, "residual_height", scenarios, labels, axis,
        lambda s: s["residual_height"][s.residual()],
        "highest point that is left (m above datum)",
        [("water level", look.BLUE, [s.water_level for s in scenarios]),
         ("crest as drawn", look.GREY, [s.crest_level for s in scenarios])])
    missing["residual_width"] = residual(
        files, "residual_width", scenarios, labels, axis,
        geometry.residual_width, "width at the water level that is left (m)",
        [("width at first (mean)", look.GREY,
          [float(np.nanmean(s["initial_width"])) for s in scenarios])])
    missing["resistance_width"] = geometry.resistance(
        files, "resistance_width", scenarios)
    for name, reason in missing.items():
        if reason:
            print(f"figure {name} is not drawn: {reason}", file=sys.stderr)


if __name__ == "__main__":
    main()
