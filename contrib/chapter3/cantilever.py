#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cantilever in large rotation: the tip against the elastica and AMPLE
(doc/verification/cantilever.md)."""

import numpy as np
from common import Runs, parse_arguments, plt, save, save_data, save_numbers

from large_strain import cantilever_parameters, tip_displacement

LENGTH, YOUNG, POISSON = 10.0, 12000.0, 0.2  # m, kPa
AXIAL = YOUNG / (1 - POISSON**2)             # EA in plane strain, kN
BENDING = AXIAL / 12                         # EI, kN m^2
SHEAR = 5 / 6 * YOUNG / (2 * (1 + POISSON))  # GA of a rectangle, kN
AMPLE = (5.689, 8.257)                       # back, down (m) at 100 kN, 3^2


def elastica(force, length=LENGTH, flexible=True):
    """Displacement of the tip, back and down (m): Euler's elastica, with
    flexible also stretch and shear (Reissner's beam). From the tip, where there
    is no moment, back to the root, where there is no slope: bisection on the
    tip's slope."""
    def strains(slope):
        if not flexible:
            return 0.0, 0.0
        return force * np.sin(slope) / AXIAL, force * np.cos(slope) / SHEAR

    def rates(slope, curvature):
        stretch, shear = strains(slope)
        forward = (1 + stretch) * np.cos(slope) - shear * np.sin(slope)
        down = (1 + stretch) * np.sin(slope) + shear * np.cos(slope)
        return np.array([-curvature, force / BENDING * forward,
                         1.0 - forward, down])

    def shape(tip_slope, steps=1000):
        ds = length / steps
        state = np.array([tip_slope, 0.0, 0.0, 0.0])
        for _ in range(steps):
            half = state + 0.5 * ds * rates(*state[:2])
            state = state + ds * rates(*half[:2])
        return state

    low, high = 0.0, 0.5 * np.pi
    for _ in range(40):
        middle = 0.5 * (low + high)
        if shape(middle)[0] > 0.0:
            high = middle
        else:
            low = middle
    return tuple(float(value) for value in shape(low)[2:])


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers, rows = {}, []
    paths = {}

    def tip(h, per_direction, force, label="stretched", **sets):
        name = f"cantilever/{label}-{h}-{per_direction}-{force:g}"
        run = runs.run(name, "cantilever.prm", cantilever_parameters(
            h, per_direction, force, **sets))
        if (h, per_direction) == (0.25, 6):
            paths[force] = run
        return tip_displacement(run.points(), h, per_direction)

    # The elastica, to the end of the beam and to where the force acts.
    exact = elastica(10.417)
    for per_direction in (3, 6):
        for h in (0.5, 0.25, 0.125):
            back, down = tip(h, per_direction, 10.417)
            reach = LENGTH - 0.5 * h / per_direction
            near = elastica(10.417, reach)
            rows.append((h, per_direction, down, back, near[1], near[0]))
            numbers[f"10.417 kN, h = {h}, {per_direction}^2"] = {
                "down (m)": round(down, 4), "back (m)": round(back, 4),
                "down / elastica": round(down / exact[1], 4),
                "back / elastica": round(back / exact[0], 4),
                "down / elastica to the force": round(down / near[1], 4),
                "back / elastica to the force": round(back / near[0], 4)}
    for force in (10.417, 100.0):
        for flexible in (False, True):
            back, down = elastica(force, flexible=flexible)
            kind = "Reissner's beam" if flexible else "Euler's elastica"
            numbers[f"{kind}, {force:g} kN"] = {"down (m)": round(down, 4),
                                                "back (m)": round(back, 4)}
    mapping = "Kinematics and mapping/"
    for label, per_direction, sets in (
            ("stretched", 3, {}), ("stretched", 6, {}),
            ("no-ghost", 6, {"Time stepping/Ghost stiffness": 0}),
            ("constant-no-ghost", 3, {"Time stepping/Ghost stiffness": 0,
                                      mapping + "Domains": "constant"}),
            ("linear", 6, {mapping + "Domains": "constant",
                           mapping + "Functions": "linear"})):
        back, down = tip(0.25, per_direction, 100.0, label, **sets)
        numbers[f"100 kN, h = 0.25, {per_direction}^2, {label}"] = {
            "down (m)": round(down, 4), "back (m)": round(back, 4),
            "down / AMPLE": round(down / AMPLE[1], 4),
            "back / AMPLE": round(back / AMPLE[0], 4)}

    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
    for force, colour in ((10.417, "C0"), (100.0, "C3")):
        for time, _ in paths[force].frames():
            points = paths[force].points(time)
            axes[0].plot(points["position"][:, 0], points["position"][:, 1],
                         ",", color=colour, alpha=0.25 if time < 1 else 1)
    axes[0].set_aspect("equal")
    axes[0].set_xlabel("x (m)")
    axes[0].set_ylabel("y (m)")
    axes[0].set_title("10.417 kN (blue), 100 kN (red), each tenth of the load",
                      fontsize=8)
    for per_direction, style in ((3, "s"), (6, "o")):
        part = [row for row in rows if row[1] == per_direction]
        h = [row[0] for row in part]
        axes[1].loglog(h, [abs(row[2] / row[4] - 1) for row in part],
                       style + "-", color="C0",
                       label=f"down, {per_direction}² points")
        axes[1].loglog(h, [abs(row[3] / row[5] - 1) for row in part],
                       style + "--", color="C1",
                       label=f"back, {per_direction}² points")
    axes[1].set_xlabel("h (m)")
    axes[1].set_ylabel("error against the elastica, 10.417 kN")
    axes[1].legend(fontsize=7)
    figure.tight_layout()
    save_data("cantilever", dict(zip(
        ("h_m", "points_per_direction", "down_m", "back_m",
         "elastica_down_m", "elastica_back_m"), map(list, zip(*rows)))))
    save(figure, "cantilever")
    save_numbers("cantilever", numbers)


if __name__ == "__main__":
    main()
