#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 3.5 to 3.7: error of the nodal forces of a bar with an inclined side,
at 50 places on the grid and for several angles; and the same bar in 3D."""

import numpy as np
from common import (METHODS, Nodes, Runs, parse_arguments, plt, save, save_data,
                    save_numbers, write_text)

HEIGHT = 3.0
LENGTH = 6.0  # at the base, m, for tan(theta) up to 1
EXACT = ["points", "nodes", "surface", "contour"]
ALL = ["points", "nodes", "surface", "detected", "contour"]


def corners_of(tangent, offset, height=HEIGHT):
    length = max(LENGTH, height * tangent + 3.0)
    return [(offset, 0.0), (offset + length, 0.0), (offset + length, height),
            (offset + height * tangent, height)]


def polygon(corners):
    return "; ".join(f"{x!r}, {y!r}" for x, y in corners)


def errors_of(nodes, tangent, methods, rest, width=1.0):
    """{method: (E_Fx, E_Fy)}, eqs. (3.6) and (3.7), over the active nodes: the
    force of a method on the inclined side, the top and the base, and that on
    the other sides, against the internal force."""
    result = {}
    for method in methods:
        # Points and nodes carry the inclined side only.
        side_only = method in ("points", "nodes")
        parts = [method] + ["top", "base"] * side_only + rest
        difference = np.abs(sum(nodes.force(part) for part in parts)
                            - nodes["internal_force"])[nodes.active]
        total = difference.sum(axis=0) / (HEIGHT * width)
        result[method] = (float(total[0]), float(total[1] / tangent))
    return result


QUIET = {"Output/Particles": "false", "Output/Surface": "false"}


def evaluate(runs, tangent, offset, detected=True):
    corners = corners_of(tangent, offset)
    label = f"inclined_bar/{tangent:g}-{offset:.3f}"
    chain = runs.write_chain(label + "-chain", corners)
    sets = {"Soil profile/bar/Polygon": polygon(corners),
            "Tractions/points/Surface file": chain,
            "Tractions/surface/Surface file": chain,
            "Tractions/top/Surface file": chain,
            "Tractions/base/Surface file": chain,
            **QUIET}
    errors = errors_of(Nodes(runs.run(label, "inclined_bar.prm", sets)),
                       tangent, EXACT, ["end"])
    if detected:
        sets = {"Soil profile/bar/Polygon":
                polygon(corners_of(tangent, offset, 3 * HEIGHT)), **QUIET}
        nodes = Nodes(runs.run(label + "-detected",
                               "inclined_bar_detected.prm", sets))
        errors.update(errors_of(nodes, tangent, ["detected"],
                                ["below", "above", "base", "end"]))
    return errors


def write_prism(path, corners, z0, z1):
    """The outline of the body as an STL file (text)."""
    n = len(corners)
    triangles = []
    for k in range(n):
        (xa, ya), (xb, yb) = corners[k], corners[(k + 1) % n]
        a, b, c, d = ((xa, ya, z0), (xb, yb, z0), (xb, yb, z1), (xa, ya, z1))
        triangles += [(a, b, c), (a, c, d)]
    for k in range(1, n - 1):  # the bar is convex
        p, q, r = corners[0], corners[k], corners[k + 1]
        triangles += [((*p, z0), (*r, z0), (*q, z0)),
                      ((*p, z1), (*q, z1), (*r, z1))]
    lines = ["solid bar"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {!r} {!r} {!r}".format(*v) for v in triangle]
        lines += ["endloop", "endfacet"]
    write_text(path, "\n".join(lines + ["endsolid bar"]) + "\n")


def evaluate_3d(runs, tangent, offset, extent):
    corners = corners_of(tangent, offset)
    label = f"inclined_bar_3d/{tangent:g}-{offset:.3f}-{extent[0]:g}"
    surface = runs.path(label + ".stl")
    write_prism(surface, corners, *extent)
    sets = {"Soil profile/bar/Polygon": polygon(corners),
            "Soil profile/bar/Extent": f"{extent[0]!r}, {extent[1]!r}",
            "Tractions/points/Surface file": surface,
            "Tractions/surface/Surface file": surface,
            "Tractions/top/Surface file": surface,
            "Tractions/base/Surface file": surface,
            "Tractions/nodes/From": f"-2, 0, {extent[0]!r}",
            "Tractions/nodes/To": f"14, 2.999999, {extent[1]!r}",
            **QUIET}
    nodes = Nodes(runs.run(label, "inclined_bar_3d.prm", sets))
    return errors_of(nodes, tangent, EXACT,
                     ["end", "front", "back"], extent[1] - extent[0])


# The bar of inclined_bar_detected.prm in 3D, between rollers at z = 0 and 2 m:
# the proximity field rounds free ends.
IN_3D = {
    "Dimension": 3, "Grid/Lower corner": "-2, 0, 0",
    "Grid/Upper corner": "22, 10, 2",
    "Boundary conditions/Names": "lower end, upper end",
    "Boundary conditions/lower end/Region": "back",
    "Boundary conditions/lower end/Type": "roller",
    "Boundary conditions/upper end/Region": "front",
    "Boundary conditions/upper end/Type": "roller",
    "Soil profile/bar/Initial stress": "-1; -1; -1; 0; 0; 0",
    **{f"Tractions/{name}/Facing": "-1, 1, 0"
       for name in ("detected", "below", "above")},
    "Tractions/base/Facing": "0, -1, 0", "Tractions/end/Facing": "1, 0, 0",
    "Tractions/detected/From": "-2, 3.25, 0",
    "Tractions/detected/To": "22, 6.25, 2",
    "Tractions/below/From": "-2, 0, 0", "Tractions/below/To": "22, 3.25, 2",
    "Tractions/above/From": "-2, 6.25, 0", "Tractions/above/To": "22, 10, 2",
}


def evaluate_detected_3d(runs, tangent, offset):
    sets = {**IN_3D, "Soil profile/bar/Polygon":
            polygon(corners_of(tangent, offset, 3 * HEIGHT)), **QUIET}
    run = runs.run(f"inclined_bar_3d/detected-{tangent:g}-{offset:.3f}",
                   "inclined_bar_detected.prm", sets)
    return errors_of(Nodes(run), tangent, ["detected"],
                     ["below", "above", "base", "end"], 2.0)


def statistics(errors):
    """Mean and largest E_Fx and E_Fy (%) of [{method: (x, y)}, ...]."""
    result = {}
    for method in errors[0]:
        values = 100 * np.array([e[method] for e in errors])
        result[method] = {"mean x": float(values[:, 0].mean()),
                          "mean y": float(values[:, 1].mean()),
                          "max x": float(values[:, 0].max()),
                          "max y": float(values[:, 1].max())}
    return result


def draw_offsets(offsets, errors, name):
    columns = {"offset_m": offsets.tolist()}
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
    for method in ALL:
        values = 100 * np.array([e[method] for e in errors])
        for k, axis in enumerate(axes):
            axis.semilogy(offsets, np.maximum(values[:, k], 1e-5),
                          color=METHODS[method][1],
                          linestyle=METHODS[method][2],
                          label=METHODS[method][0])
            columns[f"{method}_E_F{'xy'[k]}_percent"] = values[:, k].tolist()
    for k, axis in enumerate(axes):
        axis.set_xlabel("offset (m)")
        axis.set_ylabel(f"$E_{{F_{'xy'[k]}}}$ (%)")
    axes[1].legend(fontsize=7)
    figure.tight_layout()
    save_data(name, columns)
    save(figure, name)


def draw_angles(by_angle):
    """Figure 3.7: over the offset for three angles, and means over the angle."""
    figure, axes = plt.subplots(2, 2, figsize=(10, 7))
    columns = {}
    for k in range(2):
        for colour, tangent in zip(("C0", "C1", "C2"), (0.25, 0.5, 1.0)):
            offsets, errors = by_angle[tangent]
            for method, line in (("surface", "-"), ("contour", ":")):
                values = 100 * np.array([e[method][k] for e in errors])
                columns.setdefault("offset_m", offsets.tolist())
                columns[f"{method}_{tangent:g}_E_F{'xy'[k]}_percent"] = \
                    values.tolist()
                axes[0, k].plot(offsets, values, colour + line,
                                label=f"{method}, tan θ = {tangent:g}")
        axes[0, k].set_xlabel("offset (m)")
        axes[0, k].set_ylabel(f"$E_{{F_{'xy'[k]}}}$ (%)")
    axes[0, 0].legend(fontsize=7)
    save_data("figure_3_7", columns)

    tangents = sorted(by_angle)
    columns = {"tan_theta": tangents}
    for method in ALL:
        for k in range(2):
            means = [100 * float(np.mean([e[method][k]
                                          for e in by_angle[t][1]]))
                     for t in tangents]
            columns[f"{method}_E_F{'xy'[k]}_percent"] = means
            axes[1, k].semilogy(np.degrees(np.arctan(tangents)),
                                np.maximum(means, 1e-5), marker="o",
                                markersize=3, color=METHODS[method][1],
                                linestyle=METHODS[method][2],
                                label=METHODS[method][0])
            axes[1, k].set_xlabel("θ (degrees)")
            axes[1, k].set_ylabel(f"mean $E_{{F_{'xy'[k]}}}$ (%)")
    axes[1, 0].legend(fontsize=7)
    save_data("figure_3_7_angles", columns)
    figure.tight_layout()
    save(figure, "figure_3_7")


def main():
    runs = Runs(parse_arguments(__doc__))
    numbers, by_angle = {}, {}
    for tangent, n in ((0.5, 50), (0.25, 50), (1.0, 50), (0.125, 25),
                       (0.375, 25), (0.75, 25), (1.5, 25), (2.0, 25)):
        offsets = np.arange(n) / n
        errors = [evaluate(runs, tangent, float(round(x, 6))) for x in offsets]
        by_angle[tangent] = (offsets, errors)
        numbers[f"tan {tangent:g}"] = statistics(errors)
    draw_offsets(*by_angle[0.5], "figure_3_6")
    draw_angles(by_angle)

    # In 3D: one end of the extent on a plane of the grid, and neither.
    for extent in ((0.0, 2.0), (0.3, 2.3)):
        errors = [evaluate_3d(runs, 0.5, float(round(x, 6)), extent)
                  for x in np.arange(10) / 10]
        numbers[f"3D, tan 0.5, z from {extent[0]:g} m"] = statistics(errors)
    errors = [evaluate_detected_3d(runs, 0.5, float(round(x, 6)))
              for x in np.arange(10) / 10]
    numbers["3D, tan 0.5, z from 0 m"].update(statistics(errors))
    save_numbers("inclined_bar", numbers)


if __name__ == "__main__":
    main()
