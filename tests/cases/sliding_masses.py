#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliding masses of the weak dyke, found again from what the run wrote at each
step; and those of a slice of it in 3D.

    /usr/bin/python3 tests/cases/sliding_masses.py WAKER SOURCE_DIRECTORY
"""

import dyke_measures as measures
import numpy as np
from waker_case import Checks, read_points, workspace_of_arguments

LIMIT = 0.2  # m
END = 6.0    # s; two slides
# Coarse, and every step on the disk.
COARSE = {**measures.COARSE, "Time stepping/Time step": 0.02,
          "Time stepping/End time": END, "Output/Interval": 0.02,
          "Output/Surface": "false", "Stop rules/At rest": "false",
          "Stop rules/On flooding": "false"}


def upper_cluster(u, weight):
    """True where the best of all splits in two puts a point into the upper
    part: each is tried."""
    order = np.argsort(u, kind="stable")
    x, w = u[order], weight[order]
    best, cut = np.inf, None
    first, second, third = (np.cumsum(f) for f in (w, w * x, w * x * x))
    for k in np.flatnonzero(np.diff(x)):  # the lower part is x[:k + 1]
        rest = [total[-1] - total[k] for total in (first, second, third)]
        squares = (third[k] - second[k] ** 2 / first[k]
                   + rest[2] - rest[1] ** 2 / rest[0])
        if squares < best:
            best, cut = squares, x[k + 1]
    return np.full(len(u), True) if cut is None else u >= cut


class Again:
    """The masses from the points of every step."""

    def __init__(self, start):
        self.position = start["position"]
        self.volume = start["initial_volume"]
        self.slide = np.zeros(len(self.position), dtype=int)
        self.times = []

    def look(self, time, points):
        u = np.linalg.norm(points["position"] - self.position, axis=1)
        while (stable := np.flatnonzero(self.slide == 0)).size and \
                u[stable].max() > LIMIT:
            self.times.append(time)
            moved = stable[upper_cluster(u[stable], self.volume[stable])]
            self.slide[moved] = len(self.times)


def retrogression(start, slide, half):
    """From the end of the highest row of points at t = 0, towards +x."""
    x, y = start["position"][:, 0], start["position"][:, 1]
    crest = y > y.max() - half
    stable = crest & (slide == 0)
    front = x[stable].max() + half if stable.any() else x[crest].min() - half
    return x[crest].max() + half - front


def check_plane(checks, run):
    frames = run.frames()
    start = read_points(frames[0][1])
    again = Again(start)
    wrong = 0
    for time, path in frames:
        points = read_points(path)
        again.look(time, points)
        wrong += int((points["slide"] != again.slide).sum())
    sliding = run["sliding_masses"]
    masses = sliding["masses"]
    checks.above("frames looked at", len(frames), END / 0.02)
    checks.above("sliding masses", len(masses), 2)
    checks.equal("points in another mass than found again, in all frames",
                 wrong, 0)
    # Frames have the time in single precision.
    checks.below("times", max(abs(mass["time"] - time) for mass, time
                              in zip(masses, again.times)), 1e-6, "s")
    checks.equal("number of masses found again", len(again.times), len(masses))

    volume, x = again.volume, again.position
    checks.below("volumes: largest error", max(
        abs(mass["volume"] - volume[again.slide == k + 1].sum())
        for k, mass in enumerate(masses)), 1e-4, "m^2")
    whole = sliding["whole_volume"]
    checks.below("sum of all masses and of stable soil, less the whole",
                 abs(sum(mass["volume"] for mass in masses)
                     + volume[again.slide == 0].sum() - whole), 1e-4, "m^2")
    checks.below("volume of the drawn dyke", abs(whole - 100), 1e-6, "m^2")
    checks.below("relative failure volume", abs(
        sliding["relative_failure_volume"] - sliding["failed_volume"] / whole),
        1e-12)
    for key, axis in (("x", 0), ("y", 1)):
        checks.below(f"centres, {key}: largest error", max(
            abs(mass[key] - np.average(x[again.slide == k + 1, axis],
                                       weights=volume[again.slide == k + 1]))
            for k, mass in enumerate(masses)), 1e-5, "m")
    half = 0.125
    checks.below("retrogression distance", abs(
        sliding["retrogression_distance"]
        - retrogression(start, again.slide, half)), 1e-9, "m")
    checks.above("  which is some", sliding["retrogression_distance"], 1, "m")
    checks.equal("no width in the plane", sliding["damaged_crest_width"], None)

    rows = run.statistics
    checks.equal("statistics: masses at the end", rows["Sliding masses"][-1],
                 len(masses))
    checks.below("statistics: stable soil moved by", max(
        rows["Largest displacement of stable soil (m)"]), LIMIT, "m")
    checks.above("  and by", max(
        rows["Largest displacement of stable soil (m)"]), 0.9 * LIMIT, "m")
    checks.below("statistics: share of the volume", abs(
        rows["Relative failure volume"][-1]
        - sliding["relative_failure_volume"]), 1e-9)
    checks.above("  which never falls",
                 np.diff(rows["Relative failure volume"]).min(), 0)


def check_slice(checks, plane, body):
    """A slice of one cell is the dyke in the plane."""
    thickness = 0.5
    a, b = plane["sliding_masses"], body["sliding_masses"]
    checks.above("3D: masses", len(b["masses"]), 1)
    checks.equal("  as in the plane", len(b["masses"]), len(a["masses"]))
    # The two solve the same equations to Newton's tolerance: what comes near
    # the limit at the end of a step may pass it in the next.
    for key, factor, limit in (("time", 1, 0.021), ("x", 1, 1e-6),
                               ("volume", thickness, 1e-6)):
        checks.below(f"  {key}: largest difference", max(
            abs(p[key] * factor - s[key])
            for p, s in zip(a["masses"], b["masses"])), limit)
    checks.below("  width less the thickness", max(
        abs(mass["width"] - thickness) for mass in b["masses"]), 1e-9, "m")
    checks.below("  damaged crest", abs(
        b["damaged_crest_width"] - thickness), 1e-9, "m")
    checks.below("  retrogression distance", abs(
        b["retrogression_distance"] - a["retrogression_distance"]), 1e-9, "m")


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace:
        run = workspace.run("plane", "chapter5/dyke_weak.prm", COARSE)
        check_plane(checks, run)
        short = {**COARSE, "Time stepping/End time": 3.5,
                 "Output/Interval": 0, "Surface/Prismatic": "true"}
        ends = {f"Boundary conditions/{name} side/{key}": value
                for name in ("back", "front")
                for key, value in (("Region", name), ("Type", "roller"))}
        check_slice(
            checks,
            workspace.run("short", "chapter5/dyke_weak.prm",
                          {**short, "Surface/Prismatic": "false"}),
            workspace.run("slice", "chapter5/dyke_weak.prm", {
                **short, "Dimension": 3, "Grid/Lower corner": "-6, 0, 0",
                "Grid/Upper corner": "42, 6, 0.5", "Boundary conditions/Names":
                "base, left side, right side, back side, front side", **ends}))
        off = workspace.run("off", "chapter5/dyke_weak.prm", {
            **short, "Surface/Prismatic": "false",
            "Time stepping/End time": 0.1, "Sliding masses/Watch": "false"})
        checks.equal("not watched: summary", off["sliding_masses"], None)
        checks.equal("not watched: columns",
                     [name for name in off.statistics if "Sliding" in name], [])
        checks.equal("not watched: fields",
                     [name for name in off.points() if name == "slide"], [])
    checks.finish()


if __name__ == "__main__":
    main()
