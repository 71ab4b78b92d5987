#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dykes with ground under water in front of the toe, for doc/verification/b_bar.md:
how many of 24 that should stand do not come to rest in 6 s.

    /usr/bin/python3 contrib/verification/foreland.py [--waker build/bin/waker]

Some minutes. Outer slopes of 1:1.5 to 1:4, each at six places on the grid.
"""

from dyke_runs import workspace

CASE = "verification/foreland.prm"
HEIGHT = 4.0  # m, above the ground
SLOPES = (1.5, 2.0, 3.0, 4.0)
SHIFTS = (0.0, 0.1, 0.2, 0.3, 0.35, 0.4)  # m, of cells of 0.5 m
KINDS = ("B-bar in all cells", "B-bar", "standard")


def outline(slope, shift):
    crest = shift + HEIGHT * slope
    return (f"{shift:g}, 2; {crest + 11:g}, 2; {crest + 3:g}, 6; {crest:g}, 6")


def main():
    print("| of 24 | " + " | ".join(KINDS) + " |")
    with workspace(__doc__) as work:
        for method in ("contour", "proximity field"):
            counts = []
            for kind in KINDS:
                outcomes = [work.run(
                    f"{method}-{kind}-{slope:g}-{shift:g}".replace(" ", "-"), CASE,
                    {"Soil profile/dyke/Polygon": outline(slope, shift),
                     "Surface/Method": method, "Output/Interval": 0,
                     "Kinematics and mapping/Volumetric strain": kind})["outcome"]
                            for slope in SLOPES for shift in SHIFTS]
                counts.append(sum(outcome != "stable" for outcome in outcomes))
            print(f"| {method} | " + " | ".join(map(str, counts)) + " |", flush=True)


if __name__ == "__main__":
    main()
