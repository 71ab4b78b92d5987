# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every number that chapter 5 of Remmerswaal (2023) prints as a result, what
its abstract, conclusions (5.5, 7.4) and the summary repeat of it, and the
numbers of chapter 4; with what a campaign gives for each.

An Entry has a function of the stores that returns (ours, interval, of how many)
as texts, or None where the store that it needs is not there.
"""

import math
from dataclasses import dataclass
from typing import Callable, Optional

import numpy as np

import store as campaign
from estimates import mean_with_interval, proportion
from geometry_figures import (enough, first_widths, height_above_water,
                              residual_width)


@dataclass
class Entry:
    where: str  # section or figure of the thesis
    what: str
    printed: str
    ours: Optional[Callable] = None  # of Stores; None: no number of a campaign
    instead: str = ""  # where to look if there is no function


POINTS = "1, points"  # key of analysis 1 with `Statistics of = points`


class Stores:
    """The scenarios of the three analyses; lists are empty where missing."""

    def __init__(self, stores):
        self.base = stores[1].scenarios[0] if 1 in stores else None
        self.points = stores[POINTS].scenarios[0] if POINTS in stores else None
        self.scales = sorted(
            campaign.with_base_case(stores[2].scenarios, self.base)
            if 2 in stores else [], key=lambda s: s.scale_x)
        self.levels = sorted(
            campaign.with_base_case(stores[3].scenarios, self.base)
            if 3 in stores else [], key=lambda s: s.freeboard)

    def scale(self, value):
        return next((s for s in self.scales
                     if abs(s.scale_x - value) < 1e-6), None)


def share(count, n, digits=3):
    """Texts of a proportion."""
    estimate, low, high = proportion(count, n)
    shown = "–" if math.isnan(estimate) else f"{estimate:.{digits}f}"
    return shown, f"{low:.{digits}f} to {high:.{digits}f}", f"{count} of {n}"


def probability(name, of=lambda stores: stores.base, complement=False):
    def ours(stores):
        scenario = of(stores)
        if scenario is None:
            return None
        *_, count, n = scenario.probabilities()[name]
        return share(n - count if complement else count, n)
    return ours


def share_where(condition, among=lambda s: s.counted,
                of=lambda stores: stores.base):
    """Share of the realisations for which `condition` holds."""
    def ours(stores):
        scenario = of(stores)
        if scenario is None:
            return None
        chosen = among(scenario)
        return share(int((condition(scenario) & chosen).sum()),
                     int(chosen.sum()))
    return ours


def mean(values, unit="m"):
    def ours(stores):
        numbers = values(stores)
        if numbers is None or len(numbers) == 0:
            return None
        middle, low, high = mean_with_interval(numbers)
        return f"{middle:.3f} {unit}", f"{low:.3f} to {high:.3f}", str(
            len(numbers))
    return ours


def row(scenarios, label, name):
    """One probability for all values of a sweep."""
    def ours(stores):
        chosen = scenarios(stores)
        if not chosen:
            return None
        parts, bounds, numbers = [], [], []
        for scenario in chosen:
            estimate, low, high, count, n = scenario.probabilities()[name]
            value = f"{label(scenario):g} m: "
            parts.append(value + ("–" if math.isnan(estimate)
                                  else f"{estimate:.3f}"))
            bounds.append(f"{low:.3f} to {high:.3f}")
            numbers.append(f"{count}/{n}")
        return tuple("<br>".join(texts) for texts in (parts, bounds, numbers))
    return ours


def scale_row(name, condition=lambda scale: True):
    return row(lambda stores: [s for s in stores.scales
                               if condition(s.scale_x)],
               lambda s: s.scale_x, name)


def level_row(name):
    return row(lambda stores: stores.levels, lambda s: s.freeboard, name)


def largest_drop(stores):
    """theta_h with the largest P(S1) - P(F): initial failures that stood."""
    rows = [(scenario.probabilities(), scenario.scale_x)
            for scenario in stores.scales if scenario.n > 0]
    if not rows:
        return None
    p, scale = max(rows, key=lambda row: row[0]["S1"][0] - row[0]["F"][0])
    shown, interval, n = share(p["S1"][3] - p["F"][3], p["S1"][4])
    return f"{shown} at {scale:g} m", interval, n


def quantiles(event, of=lambda stores: stores.base):
    def ours(stores):
        scenario = of(stores)
        if scenario is None or len(scenario.times(event)) == 0:
            return None
        times = scenario.times(event)
        low, middle, high = np.quantile(times, (0.05, 0.5, 0.95))
        return (f"median {middle:.2f} s", f"5 to 95 %: {low:.2f} to "
                f"{high:.2f} s", str(len(times)))
    return ours


def modes(low, high):
    """Share of residual widths in a range, and the highest bin of 0.5 m in
    it; all scales from 4 m on."""
    def ours(stores):
        scenarios = enough(stores.scales)
        if not scenarios:
            return None
        widths = np.concatenate([residual_width(s) for s in scenarios])
        if len(widths) == 0:
            return None
        edges = np.arange(low, high + 0.01, 0.5)
        counts, _ = np.histogram(widths, edges)
        where = edges[counts.argmax()]
        shown, interval, n = share(
            int(((widths >= low) & (widths < high)).sum()), len(widths))
        return (f"{shown}; highest bin {where:g} to {where + 0.5:g} m",
                interval, n)
    return ours


def mean_widths(stores):
    scenarios = enough(stores.scales)
    rows = [(s.scale_x, *mean_with_interval(residual_width(s)),
             int(s.residual().sum())) for s in scenarios]
    rows = [r for r in rows if r[-1] > 0]
    if not rows:
        return None
    return ("<br>".join(f"{r[0]:g} m: {r[1]:.2f} m" for r in rows),
            "<br>".join(f"{r[2]:.2f} to {r[3]:.2f}" for r in rows),
            "<br>".join(str(r[4]) for r in rows))


def wide_floods(stores):
    """Floods among the initial failures that left the widest dykes."""
    scenarios = enough(stores.scales) or ([stores.base] if stores.base else [])
    if not scenarios:
        return None
    widths, flooded, _ = first_widths(scenarios)
    if len(widths) == 0:
        return None
    limit = np.quantile(widths, 0.9)
    widest = widths >= limit
    shown, interval, n = share(int(flooded[widest].sum()), int(widest.sum()))
    return f"{shown} (W_S1 ≥ {limit:.1f} m, the widest tenth)", interval, n


def width_of_floods(stores):
    """Mean W_S1 of those that flooded minus that of the others: its sign is
    that of the correlation."""
    scenarios = enough(stores.scales) or ([stores.base] if stores.base else [])
    if not scenarios:
        return None
    widths, flooded, _ = first_widths(scenarios)
    if flooded.sum() < 2 or (~flooded).sum() < 2:
        return None
    a, b = widths[flooded], widths[~flooded]
    difference = a.mean() - b.mean()
    half = 1.96 * math.sqrt(a.var(ddof=1) / len(a) + b.var(ddof=1) / len(b))
    return (f"W_S1 of floods minus others: {difference:.2f} m",
            f"{difference - half:.2f} to {difference + half:.2f} m",
            f"{len(a)} and {len(b)}")


def initiation_by_side(stores):
    """Median time of S1 at the lowest water: outer slope, inner one."""
    if not stores.levels:
        return None
    scenario = stores.levels[-1]
    kind = scenario["failure_class"]
    outer = kind == campaign.OUTER
    inner = ~outer & (kind != campaign.SETTLED) & (kind != campaign.OVERFLOW)
    times = scenario.event_time("initial_failure")
    failed = scenario.counted & ~np.isnan(times)
    if not (failed & outer).any() or not (failed & inner).any():
        return None
    return (f"median {np.median(times[failed & outer]):.2f} s outer, "
            f"{np.median(times[failed & inner]):.2f} s inner", "",
            f"{int((failed & outer).sum())} and "
            f"{int((failed & inner).sum())}")


def wider(stores):
    """Share of residual dykes wider than at first, at the lowest water."""
    if not stores.levels:
        return None
    scenario = stores.levels[-1]
    kept = scenario.residual()
    return share(int((scenario["residual_width"]
                      > scenario["initial_width"] + 0.3)[kept].sum()),
                 int(kept.sum()))


def level_shares(count, of):
    """A share at each water level: numbers of realisations of a scenario."""
    def ours(stores):
        if not stores.levels:
            return None
        parts = [(s.freeboard, share(int(count(s)), int(of(s))))
                 for s in stores.levels]
        return ("<br>".join(f"{f:g} m: {p[0]}" for f, p in parts),
                "<br>".join(p[1] for _, p in parts),
                "<br>".join(p[2] for _, p in parts))
    return ours


# Of the failures, by their class; and of the slides seen by displacement.
outer_share = level_shares(
    lambda s: ((s["failure_class"] == campaign.OUTER) & s.counted).sum(),
    lambda s: len(s.times("initial_failure")))
outer_slides = level_shares(
    lambda s: len(s.times("outer_slide")),
    lambda s: len(s.times("initial_failure_displacement")))


def residual_heights(scale):
    def values(stores):
        scenario = stores.scale(scale)
        return None if scenario is None else height_above_water(scenario)
    return values


def classes(name, flooded=None):
    code = campaign.CLASSES.index(name)

    def condition(scenario):
        chosen = scenario["failure_class"] == code
        if flooded is not None:
            floods = scenario["outcome"] == campaign.FLOODING
            chosen = chosen & (floods if flooded else ~floods)
        return chosen
    return share_where(condition)
