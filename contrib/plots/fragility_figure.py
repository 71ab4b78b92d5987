# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fragility: probabilities against the water level (m above datum), from the
tables that `waker merge` writes."""

import numpy as np

import figure_files as look

EVENTS = (("S1", look.S1, "P_S1", "not made monotone: low water may be worse"),
          ("F", look.FLOOD, "P_F", "made to rise with the water"))


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


def in_words(store):
    """The yearly numbers, if there are any."""
    yearly = store.report_json().get("yearly")
    if not yearly:
        return ""
    p = yearly["P_F"]
    words = (f"at most {p['high']:.2g}" if p["kind"] == "upper bound" else
             f"at least {p['low']:.2g}" if p["kind"] == "lower bound" else
             f"{p['estimate']:.2g} [{p['low']:.2g}, {p['high']:.2g}]")
    budget = yearly["risk"]["macro_instability"]
    verdict = (f"; budget of macro-instability {budget['budget']:.2g}: "
               f"{budget['verdict']}" if budget else "")
    return f"$P(F)$ per year: {words}{verdict}"


def undecided(points):
    """How many realisations have no outcome, in words."""
    lost = sum(int(row["n_undecided"]) for row in points)
    not_final = sum(int(row["n_S1_not_final"]) for row in points)
    n = lost + sum(int(row["n"]) for row in points)
    words = [f"{lost} of {n} undecided"] if lost else []
    if not_final:
        words += [f"{not_final} initial failures not final"]
    return (", ".join(words) + ": thin bounds and shades hold whatever these "
            "would have done" if words else "")


def estimated_only(fine, estimate, level, kinds):
    """The line of the estimates, broken beside levels with a bound only."""
    at = np.searchsorted(level, fine)
    at = np.clip(at, 1, len(level) - 1)
    bound = kinds != "estimate"
    exact = np.isclose(fine[:, None], level[None, :], rtol=0.0, atol=1e-9)
    beside = np.where(exact.any(axis=1), (exact & bound).any(axis=1),
                      bound[at - 1] | bound[at])
    return np.where(beside, np.nan, estimate)


def fragility(files, name, store):
    """Returns what is missing."""
    points, curve = store.report("fragility"), store.report("fragility_curve")
    if len(points) < 2 or "P_F_if_all_failed_high" not in points[0]:
        return "needs report/fragility.csv with two water levels: waker merge"
    figure, axes = look.panels(2, 3.4, 8.0, sharex=True)
    rows = []
    level, fine = column(points, "water_level"), column(curve, "water_level")
    smallest = 1.0
    for panel, (event, style, key, words) in zip(axes, EVENTS):
        low, high = column(curve, key + "_low"), column(curve, key + "_high")
        estimate = column(curve, key)
        kinds = np.array([row[key + "_kind"] for row in points])
        values = np.array([column(points, key + end)
                           for end in ("", "_low", "_high",
                                       "_if_none_failed_low",
                                       "_if_all_failed_high")])
        seen = values.ravel()
        smallest = min(smallest, *seen[seen > 0.0])
        panel.fill_between(fine, np.maximum(low, 1e-12), high, linewidth=0,
                           color=style["color"], alpha=0.15)
        panel.plot(fine, estimated_only(fine, estimate, level, kinds),
                   color=style["color"], label=words)
        known = kinds == "estimate"
        panel.plot(level[known], values[0][known], color=style["color"],
                   marker=style["marker"], linestyle="none", markersize=5,
                   label="counted, 95 % interval")
        panel.vlines(level[known], np.maximum(values[1][known], 1e-12),
                     values[2][known], color=style["color"], linewidth=1.2)
        panel.vlines(level, np.maximum(values[3], 1e-12), values[4],
                     color=style["color"], linewidth=0.6)
        for what, bound, marker in (("upper bound", values[4], "v"),
                                    ("lower bound", values[3], "^")):
            chosen = kinds == what
            if chosen.any():
                panel.plot(level[chosen], bound[chosen], marker=marker,
                           linestyle="none", markerfacecolor="white",
                           color=style["color"], markersize=6,
                           label=f"{what} only (95 %)")
        crest = store.scenarios[0].crest_level
        if np.isfinite(crest):
            panel.axvline(crest, color="black", linestyle=":", linewidth=1.0,
                          label=f"crest as drawn, {crest:g} m")
        panel.set_yscale("log")
        panel.set_xlabel("water level $h$ (m above datum)")
        panel.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06))
        rows += [[event, "curve", *point, point[2], point[3]] for point in
                 zip(fine, estimate, low, high)]
        rows += [[event, kind, *point] for kind, *point in
                 zip(kinds, level, *values)]
    axes[0].set_ylabel("$P(S_1|h)$")
    axes[1].set_ylabel("$P(F|h)$")
    for panel in axes:
        panel.set_ylim(0.7 * smallest, 1.3)
    yearly = in_words(store)
    caption = [text for text in (yearly, undecided(points)) if text]
    if caption:
        figure.supxlabel("\n".join(caption), fontsize=9)
    files.save(figure, name, [store],
               ["event", "what", "water_level_m", "probability", "low",
                "high", "low_if_none_failed", "high_if_all_failed"], rows,
               [text.replace("$", "") for text in caption])
    return None
