# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the comparison, in the order of the thesis."""

import math

import numpy as np

import store as campaign
from thesis_numbers import (Entry, classes, initiation_by_side, largest_drop,
                            level_row, mean, mean_widths, modes, outer_share,
                            outer_slides, probability, quantiles,
                            residual_heights, scale_row, share_where, wide_floods, wider,
                            width_of_floods)

SOFTENING = "[softening](../../verification/softening.md)"


def stable_median(quantity, minus_water=False):
    def ours(stores):
        if stores.base is None:
            return None
        stable = stores.base["outcome"] == campaign.STABLE
        if not stable.any():
            return None
        values = stores.base[quantity][stable] - (
            stores.base.water_level if minus_water else 0.0)
        return (f"median {np.median(values):.3f} m",
                f"all within {values.min():.3f} to {values.max():.3f}",
                str(len(values)))
    return ours


def point_statistics(_):
    """P(c_i < 10 kPa) for N(13 kPa, 0.2), without any campaign."""
    return f"{0.5 * math.erfc(3.0 / 2.6 / math.sqrt(2.0)):.4f}", "exact", "–"


def event_tree(key):
    """Of the base case, from report.json."""
    def ours(stores):
        if stores.base is None:
            return None
        scenarios = stores.base.store.report_json().get("scenarios", [])
        if not scenarios:
            return None
        tree = scenarios[stores.base.index]["event_tree"]
        if tree[key] is None:
            return None
        direct = tree["direct"]
        return (f"{tree[key]:.4f}", f"direct count: {direct['low']:.3f} to "
                f"{direct['high']:.3f}", f"{direct['count']} of {direct['n']}")
    return ours


def small(scale):
    return scale < 2.0 + 1e-6


def failed(scenario):
    return scenario.counted & ~np.isnan(
        scenario.event_time("initial_failure_thesis"))


def between(first, last):
    def holds(scenario):
        times = scenario.event_time("initial_failure_thesis")
        return (times >= first) & (times <= last)
    return holds


def largest_scale(stores):
    return stores.scales[-1] if stores.scales else None


def points(stores):
    return stores.points


def lowest_water(stores):
    return stores.levels[-1] if stores.levels else None


ROWS = [
    ("Chapter 4: risk framework", [
        Entry("(4.8)", "share of P_s for all calculated categories", "0.7",
              instead="the rest of the default below"),
        Entry("(4.8)", "share of P_s kept for what is not calculated", "30 %",
              instead="0.30, default of the section `Risk`"),
        Entry("(4.9)", "w of macro-instability", "0.04",
              instead="0.04, default of the section `Risk`"),
        Entry("(4.22)", "P(not F₀): water below the intact crest", "1",
              instead="holds: every water level of table 5.2 is lower"),
    ]),
    ("4.4: separate mechanisms, fed with the slides of the base case", [
        Entry("(4.23)", "P(F) by the event tree", "(no number)",
              event_tree("probability")),
        Entry("(4.25)", "P(F) by the critical path alone", "(no number)",
              event_tree("critical_path")),
    ]),
    ("5.3: set-up", [
        Entry("5.3", "realisations per analysis", "10 000",
              lambda stores: stores.base and (str(stores.base.n), "",
                                              str(stores.base.n))),
    ]),
    ("5.4.1: analysis 1, the base case", [
        Entry("5.4.1, fig. 5.6", "P(S₁)", "about 0.12", probability("S1")),
        Entry("5.4.1, fig. 5.6", "P(S₁), COV of the points",
              "about 0.12", probability("S1", points)),
        Entry("5.4.1, (5.1)", "P(S₁) in the thesis's reading, W < W_i",
              "about 0.12", probability("S1_thesis")),
        Entry("5.4.1", "P(S₁) by width or height", "about 0.12",
              probability("S1_geometry")),
        Entry("5.4.1", "P(S₁) by displacement", "about 0.12",
              probability("S1_displacement")),
        Entry("5.4.1, fig. 5.6", "P(F)", "about 0.09", probability("F")),
        Entry("5.4.1, fig. 5.6", "P(F), COV of the points",
              "about 0.09", probability("F", points)),
        Entry("5.4.1, 5.5", "P(F\\|S₁)", "0.75", probability("F_given_S1")),
        Entry("5.4.1, 5.5", "P(F\\|S₁) in the thesis's reading of S₁", "0.75",
              probability("F_given_S1_thesis")),
        Entry("5.4.1, 5.5", "P(F\\|S₁), COV of the points",
              "0.75", probability("F_given_S1", points)),
        Entry("ch. 5 abstract, 5.4.1, 5.5, 7.4",
              "reduction 1 − P(F\\|S₁), layered soil", "25 % (7.4: below 25 %)",
              probability("F_given_S1", complement=True)),
        Entry("5.4.1, fig. 5.5a", "without any failure", "by far most",
              share_where(lambda s: s["outcome"] == campaign.STABLE)),
        Entry("fig. 5.5b, c; 7.4", "initial failure only, without flooding",
              "a class of its own", classes("initial only", False)),
        Entry("fig. 5.2a", "one slide that floods at once", "(no number)",
              classes("initial only", True)),
        Entry("fig. 5.5d; 7.4", "retrogressive without flooding",
              "a class of its own", classes("retrogressive", False)),
        Entry("fig. 5.5e; 7.4", "retrogressive with flooding",
              "a class of its own", classes("retrogressive", True)),
        Entry("fig. 5.5f; 7.4", "horizontal slide with flooding",
              "a class of its own", classes("horizontal", True)),
        Entry("5.4.1, fig. 5.5b", "height of the weak layer above the base",
              "about 1.5 m", instead="fig. 5.5 (b), `initiation_height_m` of "
              "[figure_5_05.csv](figures/figure_5_05.csv)"),
        Entry("5.4.1", "angle between the blocks of the failed mass",
              "about 45°", instead="43° to 50°, " + SOFTENING),
        Entry("5.4.1", "mean dyke, 13 and 5 kPa", "no failure",
              instead="stable, " + SOFTENING),
        Entry("5.4.1", "factor of safety of the mean dyke", "1.3",
              instead="1.293, " + SOFTENING),
        Entry("5.4.1", "10 and 3.85 kPa: failure after", "4 s",
              instead="2.93 s, " + SOFTENING),
        Entry("5.4.1", "flooding after that", "3.5 s",
              instead="3.74 s, " + SOFTENING),
        Entry("5.4.1", "P(FoS < 1) = P(c_i < 10 kPa)", "0.13",
              point_statistics),
    ]),
    ("5.4.2: analysis set 2, horizontal scale of fluctuation", [
        Entry("5.4.2, fig. 5.7a", "W < W_i between 2 and 5 s (base case)",
              "“2 to 5 s”", share_where(between(2.0, 5.0), failed)),
        Entry("5.4.2, fig. 5.7a", "time of W < W_i (base case)", "2 to 5 s",
              quantiles("initial_failure_thesis")),
        Entry("5.4.2, fig. 5.7a", "time of S₁ by displacement (base case)",
              "2 to 5 s", quantiles("initial_failure_displacement")),
        Entry("5.4.2, fig. 5.7b", "time of flooding (base case)",
              "later, more widely spread", quantiles("flooding")),
        Entry("5.4.2, fig. 5.8a", "P(S₁) by θ_h",
              "rises with θ_h; low below 4 m", scale_row("S1")),
        Entry("5.4.2, fig. 5.8a", "P(F) by θ_h", "below P(S₁) for all",
              scale_row("F")),
        Entry("5.4.2, fig. 5.8a", "largest P(S₁) − P(F)",
              "at an intermediate θ_h", largest_drop),
        Entry("5.4.2, fig. 5.8b", "P(F\\|S₁) by θ_h",
              "from below 0.2 (small) to 0.9 (large)", scale_row("F_given_S1")),
        Entry("ch. 5 abstract, 5.4.2, 5.5, 7.4", "P(F\\|S₁), θ_h up to 2 m",
              "below 0.2", scale_row("F_given_S1", small)),
        Entry("5.4.2", "reduction, layered (largest θ_h)", "below 10 %",
              probability("F_given_S1", largest_scale, complement=True)),
        Entry("summary", "reduction at worst", "10 %",
              probability("F_given_S1", largest_scale, complement=True)),
        Entry("summary", "reduction at best", "above 90 % (elsewhere 80 %)",
              instead="1 − P(F\\|S₁) of the smallest θ_h with failures, above"),
        Entry("5.4.2, fig. 5.9", "W_r of stable dykes", "10.5 m",
              stable_median("residual_width")),
        Entry("5.4.2, fig. 5.9", "H_r − h of stable dykes", "0.25 m",
              stable_median("residual_height", True)),
        Entry("5.4.2, fig. 5.9a", "mean H_r − h, θ_h = 4 m", "0.22 m",
              mean(residual_heights(4.0))),
        Entry("5.4.2, fig. 5.9a", "mean H_r − h, θ_h = 48 m", "0.20 m",
              mean(residual_heights(48.0))),
        Entry("5.4.2, fig. 5.9b", "W_r after initial failure",
              "most likely 4 to 8 m", modes(4.0, 8.0)),
        Entry("5.4.2, fig. 5.9b", "W_r after secondary failure",
              "roughly 2 to 3 m", modes(2.0, 3.0)),
        Entry("5.4.2, fig. 5.9b", "mean W_r by θ_h", "smaller with larger θ_h",
              mean_widths),
        Entry("5.4.2, fig. 5.10", "P(F\\|S₁, W_S1) against W_S1",
              "negative correlation", width_of_floods),
        Entry("5.4.2, fig. 5.10", "P(F\\|S₁) where W_S1 is large",
              "still above 0", wide_floods),
    ]),
    ("5.4.3: analysis set 3, water level", [
        Entry("5.4.3, figs. 5.12a, 5.13a", "P(S₁) by H_i − h",
              "falls to 1.0 m, then rises; axis to 0.3", level_row("S1")),
        Entry("5.4.3, (5.1)", "the same in the thesis's reading, W < W_i",
              "the same", level_row("S1_thesis")),
        Entry("5.4.3", "the same by displacement", "the same",
              level_row("S1_displacement")),
        Entry("5.4.3, figs. 5.12b, 5.13a", "P(F) by H_i − h",
              "lower for lower water", level_row("F")),
        Entry("fig. 5.13b", "P(F\\|S₁) by H_i − h", "(curve; axis 0 to 1)",
              level_row("F_given_S1")),
        Entry("5.4.3", "slides of the inner slope, by displacement", "",
              level_row("inner_slide")),
        Entry("5.4.3", "slides of the outer slope, by displacement", "",
              level_row("outer_slide")),
        Entry("5.4.3", "outer slides among those by displacement",
              "dominant from H_i − h = 1.5 m", outer_slides),
        Entry("5.4.3", "outer slope among the failures, by their class",
              "dominant from H_i − h = 1.5 m", outer_share),
        Entry("5.4.3", "time of S₁ at the lowest water",
              "outer faster than inner", initiation_by_side),
        Entry("5.4.3, fig. 5.14b", "W_r above W_i at the lowest water",
              "“may actually increase”", wider),
    ]),
]
