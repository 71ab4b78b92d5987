# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probabilities against time and against the swept value, of any campaign;
figures 5.6, 5.7, 5.8, 5.12 and 5.13 are made of them. What the thesis prints is
drawn only if asked for (`thesis`)."""

from dataclasses import dataclass, field

import matplotlib.pyplot as plt
import numpy as np

import figure_files as look
from estimates import before, kind, proportion

EVENTS = (("initial_failure", "S1", "initial failure mechanism"),
          ("flooding", "F", "flooding"))
PRINTED_BASE = {"S1": 0.12, "F": 0.09, "F_given_S1": 0.75}  # section 5.4.1


@dataclass
class Axis:
    """What is swept: a value for each scenario."""
    label: str  # of the axis, with the unit
    title: str  # of a legend, short
    column: str  # of CSV files
    values: list
    logarithmic: bool = False
    texts: list = field(default_factory=list)  # instead of numbers

    def text(self, index):
        return self.texts[index] if self.texts else f"{self.values[index]:g}"


def last_event(scenarios):
    """End of the time axis (s): a whole 5 s after the last event, but not after
    all realisations have ended."""
    times = [scenario.times(event) for scenario in scenarios
             for event, _, _ in EVENTS]
    last = max((t.max() for t in times if len(t)), default=5.0)
    ended = max((scenario["end_time"].max() for scenario in scenarios
                 if len(scenario.realisation)), default=5.0)
    return min(5.0 * np.ceil((last + 0.5) / 5.0), max(ended, 0.1))


def time_axis(panel, end):
    panel.set_xlim(0.0, end)
    if end > 10.0:
        step = 5.0 * max(1, round(end / 50.0))
        panel.set_xticks(np.arange(0.0, end + 0.1, step))


def in_time(files, name_of_file, base, points=None, thesis=False):
    """Probability per half second, and before a given time; also with the
    statistics of points, if that campaign is given."""
    end, width = last_event([base] + ([points] if points else [])), 0.5
    edges = np.arange(0.0, end + width / 2, width)
    grid = np.arange(0.0, end + 0.05, 0.1)
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 4.6), sharex=True,
                                sharey="row",
                                gridspec_kw={"height_ratios": [1.5, 1]})
    rows = []
    for column, (event, name, words) in enumerate(EVENTS):
        style = look.S1 if name == "S1" else look.FLOOD
        times = base.times(event)
        estimate, low, high = before(times, base.n, grid)
        upper, lower = axes[:, column]
        upper.set_title(f"({'ab'[column]}) {words}")
        upper.fill_between(grid, low, high, color=style["color"], alpha=0.25,
                           linewidth=0, label="95 % interval")
        upper.plot(grid, estimate, color=style["color"],
                   label=f"before $t$, $N$ = {base.n}")
        if thesis:
            upper.axhline(PRINTED_BASE[name], color="black", linestyle="--",
                          linewidth=1.0,
                          label=f"thesis, all times: {PRINTED_BASE[name]:.2f}")
        if points:
            other = before(points.times(event), points.n, grid)
            upper.plot(grid, other[0], color=style["color"], linestyle=":",
                       label=f"COV of the points, $N$ = {points.n}")
            rows += [[name + ", points", "before", t, "", e, l, h]
                     for t, e, l, h in zip(grid, *other)]
        upper.legend(loc="lower right")
        counts, _ = np.histogram(times, edges)
        lower.bar(edges[:-1], counts / max(1, base.n), width, align="edge",
                  color=style["color"], edgecolor="white", linewidth=0.5)
        lower.set_xlabel("$t$ (s)")
        rows += [[name, "before", t, "", e, l, h]
                 for t, e, l, h in zip(grid, estimate, low, high)]
        rows += [[name, "in bin", a, b, *proportion(int(k), base.n)]
                 for a, b, k in zip(edges[:-1], edges[1:], counts)]
    axes[0, 0].set_ylabel("probability before $t$")
    axes[1, 0].set_ylabel(f"probability per {width:g} s")
    axes[0, 0].set_ylim(bottom=0.0)
    time_axis(axes[0, 0], end)
    files.save(figure, name_of_file,
               [base.store] + ([points.store] if points else []),
               ["event", "kind", "time_s", "until_s", "probability", "low",
                "high"], rows,
               [f"{base.n} realisations, {base.n_numerical_failures} more "
                "failed numerically"
                + (f", {base.n_undecided} are undecided" if base.n_undecided
                   else "")])


def against_time(files, name, scenarios, axis):
    """P(S1) and P(F) before a given time, a line per scenario."""
    end = last_event(scenarios)
    grid = np.arange(0.0, end + 0.05, 0.1)
    colours = look.sequence(len(scenarios))
    figure, axes = look.panels(2, 3.4, sharex=True, sharey=True)
    rows = []
    for panel, (event, short, words) in zip(axes, EVENTS):
        panel.set_title(panel.get_title(loc="left") + " " + words)
        for i, (colour, scenario) in enumerate(zip(colours, scenarios)):
            estimate, low, high = before(scenario.times(event), scenario.n,
                                         grid)
            panel.fill_between(grid, low, high, color=colour, alpha=0.15,
                               linewidth=0)
            panel.plot(grid, estimate, color=colour, label=axis.text(i))
            rows += [[short, axis.values[i], t, e, l, h] for t, e, l, h in
                     zip(grid, estimate, low, high)]
        panel.set_xlabel("$t$ (s)")
    axes[0].set_ylabel("probability before $t$")
    time_axis(axes[0], end)
    axes[0].set_ylim(bottom=0.0)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles[::-1], labels[::-1], loc="center left",
                  bbox_to_anchor=(1.0, 0.5),
                  title=f"{axis.title}\nband: 95 %")
    files.save(figure, name, look.stores_of(scenarios),
               ["event", axis.column, "time_s", "probability", "low",
                "high"], rows)


def error_bars(panel, x, results, shift=1.0, add=0.0, **style):
    """Estimates with their intervals, moved aside so that they do not hide
    each other. Where no event (nothing but events) was counted there is no
    estimate: a hollow triangle shows the bound."""
    x = np.asarray(x, dtype=float) * shift + add
    estimate, low, high = (np.array([r[i] for r in results]) for i in range(3))
    kinds = np.array([kind(value) for value in estimate])
    known = kinds == "estimate"
    panel.plot(x[known], estimate[known], markersize=5, **style)
    counted = kinds != "unknown"
    panel.vlines(x[counted], low[counted], high[counted],
                 color=style["color"], linewidth=1.2)
    for what, bound, marker in (("upper bound", high, "v"),
                                ("lower bound", low, "^")):
        chosen = kinds == what
        if chosen.any():
            panel.plot(x[chosen], bound[chosen], marker=marker, markersize=6,
                       linestyle="none", color=style["color"],
                       markerfacecolor="white", label=f"{style['label']}: "
                       f"{what} (95 %)")
    if (~counted).any():
        panel.vlines(x[~counted], 0, 1, color=style["color"], linestyle=":",
                     linewidth=1.2, label="no initial failure: unknown")


def against_value(files, name, scenarios, axis, printed=None):
    """P(S1), P(F) and P(F|S1) against the swept value; `printed` draws what
    the thesis prints."""
    figure, axes = look.panels(2, 3.2)
    values = axis.values
    results = [scenario.probabilities() for scenario in scenarios]
    get = lambda key: [result[key] for result in results]
    span = max(values) - min(values)
    aside = ({"shift": 1.03} if axis.logarithmic else {"add": 0.012 * span})
    error_bars(axes[0], values, get("S1"), **look.S1)
    error_bars(axes[0], values, get("F"), **aside, **look.FLOOD)
    thesis = [result["S1_thesis"] for result in results]
    if thesis != get("S1"):
        axes[0].plot(values, [r[0] for r in thesis], color=look.BLUE,
                     marker="o", markerfacecolor="white", linestyle=":",
                     linewidth=1.0, markersize=4, zorder=1.5,
                     label="$P(S_1)$ if only $W < W_i$ counts")
    error_bars(axes[1], values, get("F_given_S1"), **look.GIVEN)
    axes[0].set_ylabel("probability")
    axes[1].set_ylabel("$P(F|S_1)$")
    axes[1].set_ylim(-0.02, 1.02)
    if printed:
        printed(axes)
    for panel in axes:
        panel.set_xlabel(axis.label)
        if axis.logarithmic:
            panel.set_xscale("log", base=2)
            panel.set_xticks(values, [f"{value:g}" for value in values])
            panel.minorticks_off()
        if axis.texts:
            panel.set_xticks(values, axis.texts, rotation=30, ha="right")
        panel.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06),
                     ncol=2, columnspacing=1.0)
    axes[0].set_ylim(bottom=-0.004)
    rows = []
    for scenario, value, result in zip(scenarios, values, results):
        for key, (estimate, low, high, count, n) in result.items():
            rows.append([value, key, count, n, estimate, low, high,
                         kind(estimate)])
    files.save(figure, name, look.stores_of(scenarios),
               [axis.column, "quantity", "count", "n", "estimate", "low",
                "high", "kind"], rows)


def convergence(files, name, scenario):
    """P(S1) and P(F) after the first n realisations."""
    order = np.argsort(scenario.realisation)
    counted = order[scenario.counted[order]]
    if len(counted) == 0:
        return "no realisation that counts"
    chosen = np.unique(np.geomspace(1, len(counted), 200).astype(int))
    figure, (panel,) = look.panels(1, 3.0, 5.2)
    panel.set_title("")
    rows = []
    for event, short, _ in EVENTS:
        style = look.S1 if short == "S1" else look.FLOOD
        happened = np.cumsum(~np.isnan(scenario.event_time(event)[counted]))
        results = np.array([proportion(int(happened[n - 1]), int(n))
                            for n in chosen])
        panel.fill_between(chosen, results[:, 1], results[:, 2],
                           color=style["color"], alpha=0.2, linewidth=0)
        # no line where there is a bound but no estimate
        known = [kind(value) == "estimate" for value in results[:, 0]]
        panel.plot(chosen, np.where(known, results[:, 0], np.nan),
                   color=style["color"], label=style["label"] + ", 95 % band")
        rows += [[short, n, *result, kind(result[0])]
                 for n, result in zip(chosen, results)]
    panel.set_xscale("log")
    panel.set_xlim(chosen[0], max(2, chosen[-1]))
    panel.set_ylim(0.0, 1.02)
    panel.set_xlabel("realisations $n$")
    panel.set_ylabel("probability after $n$")
    panel.legend(loc="upper right")
    files.save(figure, name, [scenario.store],
               ["event", "n", "probability", "low", "high", "kind"], rows)
    return None


def printed_5_8(axes):
    style = dict(look.THESIS)
    axes[0].plot([24, 24], [PRINTED_BASE["S1"], PRINTED_BASE["F"]], **style)
    axes[1].plot([24], [PRINTED_BASE["F_given_S1"]], **style)
    # "from 0.9 at large ... to below 0.2 at small" scales (5.4.2, 5.5)
    axes[1].plot([48], [0.9], **dict(
        style, marker="p", label='thesis: "large" scales'))
    axes[1].hlines(0.2, 0.5, 2.0, color="black", linestyle="--", linewidth=1,
                   label="thesis: below this")


def printed_5_13(axes):
    axes[0].plot([0.25, 0.25], [PRINTED_BASE["S1"], PRINTED_BASE["F"]],
                 **look.THESIS)
    axes[1].plot([0.25], [PRINTED_BASE["F_given_S1"]], **look.THESIS)


def draw_scales(files, scenarios, thesis):
    """Figures 5.7 and 5.8."""
    axis = Axis(r"$\theta_h$ (m)", r"$\theta_h$ (m)", "scale_m",
                [scenario.scale_x for scenario in scenarios], True)
    against_time(files, "figure_5_07", scenarios, axis)
    against_value(files, "figure_5_08", scenarios, axis,
                  printed_5_8 if thesis else None)


def draw_water_levels(files, scenarios, thesis):
    """Figures 5.12 and 5.13, which count water from the crest as the thesis
    does; those of campaign.py have levels above datum."""
    axis = Axis("$H_i-h$ (m)", "$H_i-h$ (m)", "freeboard_m",
                [scenario.freeboard for scenario in scenarios])
    against_time(files, "figure_5_12", scenarios, axis)
    against_value(files, "figure_5_13", scenarios, axis,
                  printed_5_13 if thesis else None)
