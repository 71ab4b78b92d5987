# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left of the dyke, and what that says about flooding, of any campaign;
figures 5.9, 5.10 and 5.14 are made of it."""

import matplotlib.pyplot as plt
import numpy as np

import figure_files as look
import store as campaign
from estimates import histogram, kind, mean_with_interval, proportion

SMALLEST_SCALE = 4.0  # m; below, the thesis finds too few failures (5.4.2)
PRINTED_MEANS = {4.0: 0.22, 48.0: 0.20}  # of H_r - h by theta_h, m (5.4.2)


def enough(scenarios):
    return [scenario for scenario in scenarios
            if scenario.scale_x > SMALLEST_SCALE - 1e-6]


def height_above_water(scenario):
    """H_r - h (m) of the dykes with a residual geometry."""
    kept = scenario.residual()
    return scenario["residual_height"][kept] - scenario.water_level


def residual_width(scenario):
    """W_r (m) of the same."""
    return scenario["residual_width"][scenario.residual()]


def bars(panels, columns, edges, colours):
    """Histograms (%) below each other, one panel per scenario; returns
    [(counts, shares), ...]."""
    results = []
    for panel, values, colour in zip(panels, columns, colours):
        counts, shares = histogram(values, edges)
        panel.bar(edges[:-1], shares, np.diff(edges), align="edge",
                  color=colour, edgecolor="white", linewidth=0.4)
        panel.set_xlim(edges[0], edges[-1])
        panel.tick_params(labelbottom=panel is panels[-1])
        panel.locator_params(axis="y", nbins=3)
        results.append((counts, shares))
    for panel in panels[1:]:
        panel.sharey(panels[0])
    panels[0].set_ylim(0.0, 1.1 * max(1.0, max(s.max() for _, s in results)))
    panels[len(panels) // 2].set_ylabel("share of these dykes (%)",
                                        y=0.5 if len(panels) % 2 else 1.1)
    return results


def name_panels(panels, labels, columns, outside=False):
    where = {"xy": (1.02, 0.5), "va": "center"} if outside else {
        "xy": (0.03, 0.92), "va": "top"}
    for panel, label, values in zip(panels, labels, columns):
        panel.annotate(f"{label}\n$n$ = {len(values)}", **where,
                       xycoords="axes fraction", fontsize=8,
                       annotation_clip=False)


def bins_to_rows(quantity, values, edges, results):
    return [[quantity, value, low, high, int(count), share]
            for value, (counts, shares) in zip(values, results)
            for low, high, count, share in
            zip(edges[:-1], edges[1:], counts, shares)]


def edges_of(values, step_of=20):
    """Edges of some `step_of` bins of a round width that hold the values."""
    values = np.asarray(values)
    values = values[np.isfinite(values)]
    low, high = ((float(values.min()), float(values.max())) if len(values)
                 else (0.0, 1.0))
    rough = max(high - low, 0.1) / step_of
    power = 10.0 ** np.floor(np.log10(rough))
    step = power * min(x for x in (1.0, 2.0, 5.0, 10.0)
                       if x * power >= rough * (1 - 1e-9))
    first, last = np.floor(low / step), np.floor(high / step) + 1
    return step * np.arange(first, last + 1)


def outcomes(panel, scenarios, labels, words):
    """Shares of the outcomes of each scenario, one bar each. `words` says what
    an outcome is called; None leaves it out where it never occurs. Returns rows
    (outcome, label, count, share)."""
    done, rows = np.zeros(len(scenarios)), []
    for code, name in enumerate(scenarios[0].store.outcomes):
        counts = np.array([(s["outcome"] == code).sum() for s in scenarios])
        shares = 100.0 * counts / [max(1, len(s.ran.nonzero()[0]))
                                   for s in scenarios]
        text, colour = words.get(name, (name, look.ORANGE))
        if name in ("stable", "initial failure", "flooding") or counts.any():
            panel.barh(range(len(scenarios)), shares, left=done, color=colour,
                       label=text, edgecolor="white", linewidth=0.5)
        elif name != "numerical failure":
            continue
        done += shares
        rows += [[name, label, int(count), share]
                 for label, count, share in zip(labels, counts, shares)]
    panel.set_yticks(range(len(labels)), labels)
    panel.set_xlabel("share of all realisations (%)")
    panel.grid(False)
    return rows


def figure_5_9(files, all_scenarios, thesis):
    scenarios = enough(all_scenarios)
    if not scenarios:
        return "no scale of fluctuation of 4 m or more"
    scales = [scenario.scale_x for scenario in scenarios]
    colours = look.sequence(len(scenarios))
    labels = [rf"$\theta_h$ = {scale:g} m" for scale in scales]
    tall = max(3.0, 1.0 + 0.8 * len(scenarios))  # inches
    figure = plt.figure(figsize=(10.0, tall))
    grid = figure.add_gridspec(len(scenarios), 3, hspace=0.02)
    left, middle = ([figure.add_subplot(grid[row, column])
                     for row in range(len(scenarios))] for column in (0, 1))
    counts_panel = figure.add_subplot(grid[:, 2])
    for letter, panel in zip("abc", (left[0], middle[0], counts_panel)):
        panel.set_title(f"({letter})")

    heights = [height_above_water(scenario) for scenario in scenarios]
    # Bins centred on 0, 0.025, ...: an untouched crest is in the one of 0.25.
    top = max([0.27] + [height.max() for height in heights if len(height)])
    edges = np.arange(-0.0125, top + 0.0374, 0.025)
    rows = bins_to_rows("residual_height_above_water", scales, edges,
                        bars(left, heights, edges, colours))
    name_panels(left, labels, heights)
    left[-1].set_xlabel("$H_r-h$ (m)")
    for panel, scale, height in zip(left, scales, heights):
        for mean, shape, where, lift, words in (
                (mean_with_interval(height)[0], "^", 0.02, 14, "mean"),
                (PRINTED_MEANS.get(scale) if thesis else None, "v", 0.98, 0,
                 "thesis")):
            if mean is not None and not np.isnan(mean):
                panel.plot(mean, where, marker=shape, color="black",
                           markersize=6, clip_on=False, zorder=6,
                           transform=panel.get_xaxis_transform())
                panel.annotate(f"{words} {mean:.2f}", (mean, where),
                               (-6, lift), xycoords=("data", "axes fraction"),
                               textcoords="offset points", fontsize=7,
                               ha="right",
                               va="bottom" if shape == "^" else "top")

    widths = [residual_width(scenario) for scenario in scenarios]
    edges = np.arange(0.0, 12.51, 0.5)
    rows += bins_to_rows("residual_width", scales, edges,
                         bars(middle, widths, edges, colours))
    middle[-1].set_xlabel("$W_r$ (m)"
                          + ("; grey: peaks of the thesis" if thesis else ""))
    for panel in middle if thesis else ():
        for low, high in ((2, 3), (4, 8)):
            panel.axvspan(low, high, color=look.GREY, alpha=0.15, linewidth=0)

    rows += [["realisations: " + name, scale, "", "", count, share]
             for name, scale, count, share in outcomes(
                 counts_panel, scenarios, [f"{s:g}" for s in scales],
                 {"stable": ("stable (left out)", "#DDDDDD"),
                  "initial failure": ("in (a) and (b)", look.BLUE),
                  "flooding": ("flooded (left out)", look.VERMILLION),
                  "numerical failure": ("numerical failure", "black")})]
    counts_panel.set_ylabel(r"$\theta_h$ (m)")
    counts_panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.7 / tall),
                        ncol=2, columnspacing=1.0)
    files.save(figure, "figure_5_09", look.stores_of(scenarios),
               ["quantity", "scale_m", "low", "high", "count", "share_percent"],
               rows, ["only dykes that failed and did not flood; means: "
                      + "; ".join(f"{s:g} m: {mean_with_interval(h)[0]:.4f} m"
                                  for s, h in zip(scales, heights) if len(h))])
    return None


def first_widths(scenarios):
    """(W_S1, flooded) of all realisations with a first slide, and how many
    initial failures have none."""
    widths, flooded, without = [], [], 0
    for scenario in scenarios:
        width = scenario["width_after_first_slide"]
        failed = scenario.counted & ~np.isnan(
            scenario.event_time("initial_failure"))
        known = failed & ~np.isnan(width)
        widths.append(width[known])
        flooded.append(scenario["outcome"][known] == campaign.FLOODING)
        without += int((failed & ~known).sum())
    return np.concatenate(widths), np.concatenate(flooded), without


def figure_5_10(files, all_scenarios):
    scenarios = enough(all_scenarios)
    if not scenarios:
        return "no scale of fluctuation of 4 m or more"
    scales = ", ".join(f"{s.scale_x:g}" for s in scenarios)
    return resistance(files, "figure_5_10", scenarios,
                      np.arange(0.0, 13.01, 1.0),
                      [f"scales of fluctuation together: {scales} m"])


def resistance(files, name, scenarios, edges=None, notes=()):
    """P(F|S1) by the width that the first slide left; all scenarios
    together."""
    widths, flooded, without = first_widths(scenarios)
    if len(widths) == 0:
        return "no initial failure"
    if edges is None:
        edges = edges_of(np.append(widths, 0.0), 10)
    figure, (panel,) = look.panels(1, 3.2, 5.2)
    panel.set_title("")
    rows = []
    for low, high in zip(edges[:-1], edges[1:]):
        inside = (widths >= low) & (widths < high)
        n, n_f = int(inside.sum()), int(flooded[inside].sum())
        estimate, lower, upper = proportion(n_f, n)
        rows.append([low, high, n, n_f, estimate, lower, upper,
                     kind(estimate)])
        if n == 0:
            continue
        panel.bar(low, estimate, high - low, align="edge", color=look.GREEN,
                  alpha=0.75, edgecolor="white")
        panel.vlines(0.5 * (low + high), lower, upper, color="black",
                     linewidth=1.0)
        panel.annotate(f"{n_f}\nof {n}", (0.5 * (low + high), 1.0), (0, 3),
                       ha="center", textcoords="offset points", fontsize=7,
                       annotation_clip=False)
    panel.set_ylim(0.0, 1.0)
    panel.set_xlim(edges[0], edges[-1])
    panel.set_xlabel("width after the initial failure, $W_{S_1}$ (m)")
    panel.set_ylabel("$P(F|S_1, W_{S_1})$")
    files.save(figure, name, look.stores_of(scenarios),
               ["width_low_m", "width_high_m", "n", "n_F", "P_F_given_S1",
                "low", "high", "kind"], rows,
               [*notes, f"initial failures without a first slide: {without}"])
    return None


def figure_5_14(files, scenarios):
    freeboards = [scenario.freeboard for scenario in scenarios]
    colours = look.sequence(len(scenarios))
    labels = [f"$H_i-h$ = {freeboard:g} m" for freeboard in freeboards]
    figure, axes = plt.subplots(len(scenarios), 2, squeeze=False,
                                figsize=(7.2, 1.0 + 0.8 * len(scenarios)))
    heights = [height_above_water(s) / s.freeboard for s in scenarios]
    widths = [residual_width(s) / s["initial_width"][s.residual()]
              for s in scenarios]
    rows = []
    for letter, column, columns, name, words in (
            ("a", axes[:, 0], heights, "height_over_initial",
             "$(H_r-h)/(H_i-h)$"),
            ("b", axes[:, 1], widths, "width_over_initial", "$W_r/W_i$")):
        column[0].set_title(f"({letter})")
        largest = max([1.0] + [c.max() for c in columns if len(c)])
        edges = np.arange(-0.05, largest + 0.1499, 0.1)  # 1 is a centre
        rows += bins_to_rows(name, freeboards, edges,
                             bars(column, columns, edges, colours))
        column[-1].set_xlabel(words)
        for panel in column:
            panel.axvline(1.0, color="black", linewidth=0.8, linestyle="--")
    name_panels(axes[:, 0], labels, heights)
    files.save(figure, "figure_5_14", look.stores_of(scenarios),
               ["quantity", "freeboard_m", "low", "high", "count",
                "share_percent"], rows,
               ["only dykes that failed and did not flood"])
    return None
