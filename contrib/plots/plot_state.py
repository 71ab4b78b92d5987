#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the state of a two-dimensional dyke at one time, in the manner of
figure 5.5 of Remmerswaal (2023): the material points coloured by undrained
shear strength, the detected surface in red, the fixed base in black, and the
water level.

    /usr/bin/python3 contrib/plots/plot_state.py RUN -o state.png

reads RUN/particles.pvd, surface.pvd, parameters.prm and summary.json (the last
two and the surface only if they are there). It needs no display.
"""

import argparse
import json
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from mpl_toolkits.axes_grid1 import make_axes_locatable


def read_series(run, name):
    """[(time, path), ...] of RUN/<name>.pvd; empty if there is none."""
    path = os.path.join(run, name + ".pvd")
    if not os.path.exists(path):
        return []
    entries = ElementTree.parse(path).getroot().iter("DataSet")
    return [
        (float(entry.get("timestep")), os.path.join(run, entry.get("file")))
        for entry in entries
    ]


def read_parameters(run):
    """{"Water/Level": "4.75", ...} of RUN/parameters.prm."""
    path = os.path.join(run, "parameters.prm")
    values, sections = {}, []
    if not os.path.exists(path):
        return values
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if line.startswith("subsection "):
                sections.append(line[len("subsection "):].strip())
            elif line == "end":
                sections.pop()
            else:
                match = re.match(r"set\s+(.*?)\s*=\s*(.*)$", line)
                if match:
                    values["/".join(sections + [match[1]])] = match[2].strip()
    return values


def numbers(text):
    return [float(part) for part in text.split(",")]


def squares(centres, sides):
    """Corners (n, 4, 2) of squares."""
    unit = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])
    return centres[:, None, :] + unit[None, :, :] * sides[:, None, None]


def water_reach(segments, level, side):
    """x up to which water stands: where the surface first crosses the level,
    seen from the water; over a flooded dyke, its highest vertex."""
    a, b = segments[:, 0], segments[:, 1]
    crosses = (a[:, 1] - level) * (b[:, 1] - level) < 0.0
    if not crosses.any():
        vertices = segments.reshape(-1, 2)
        return vertices[vertices[:, 1].argmax(), 0]
    a, b = a[crosses], b[crosses]
    share = (level - a[:, 1]) / (b[:, 1] - a[:, 1])
    x = a[:, 0] + share * (b[:, 0] - a[:, 0])
    return x.min() if side == "left" else x.max()


def plot(run, frame, field, output, dpi):
    series = read_series(run, "particles")
    if not series:
        sys.exit(f"{run}: no particles.pvd; is this the folder of a run?")
    time, path = series[frame(series)]
    points = meshio.read(path)
    if field not in points.point_data:
        sys.exit(
            f"{path}: no field '{field}'; there are: "
            + ", ".join(sorted(points.point_data))
        )
    position = points.points[:, :2]
    sides = np.sqrt(points.point_data["volume"])

    parameters = read_parameters(run)
    if "Grid/Lower corner" in parameters:
        lower = numbers(parameters["Grid/Lower corner"])
        upper = numbers(parameters["Grid/Upper corner"]) \
            if "Grid/Upper corner" in parameters else None
    else:
        lower, upper = [position[:, 0].min(), position[:, 1].min()], None
    base = lower[1]
    x_min = max(lower[0], position[:, 0].min() - 4.0)
    x_max = position[:, 0].max() + 4.0
    if upper is not None:
        x_max = min(upper[0], x_max)
    top = position[:, 1].max()

    figure, axes = plt.subplots(figsize=(10, 3.2))

    # The surface belongs to the same time; other frames do not count.
    segments = None
    for surface_time, surface_path in read_series(run, "surface"):
        if abs(surface_time - time) < 1e-6 and os.path.exists(surface_path):
            surface = meshio.read(surface_path)
            lines = surface.get_cells_type("line")
            chain = surface.point_data["chain"][lines[:, 0]]
            segments = surface.points[:, :2][lines]
            segments, chain = segments[chain >= 0], chain[chain >= 0]

    side = parameters.get("Water/Side", "none")
    if side in ("left", "right"):
        level = float(parameters["Water/Level"])
        top = max(top, level)
        if segments is not None and len(segments) > 0:
            reach = water_reach(segments, level, side)
        else:
            reach = position[position[:, 1].argmax(), 0]
        start = x_min if side == "left" else x_max
        axes.fill_between([start, reach], base, level, color="lightblue",
                          linewidth=0, zorder=0)
        axes.plot([start, reach], [level, level], color="steelblue",
                  linewidth=1, zorder=0.1)
    if segments is not None and len(segments) > 0:
        # No water inside the body, where points have moved apart.
        for number in np.unique(chain):
            axes.fill(*segments[chain == number][:, 0].T, color="white",
                      linewidth=0, zorder=0.5)
        axes.add_collection(LineCollection(segments, colors="red",
                                           linewidths=1.0, zorder=2))

    collection = PolyCollection(squares(position, sides), cmap="viridis",
                                linewidths=0, antialiaseds=False, zorder=1)
    collection.set_array(points.point_data[field])
    axes.add_collection(collection)
    label = field.replace("_", " ")
    if field == "undrained_shear_strength":
        label = "undrained shear\nstrength (kPa)"
    bar = make_axes_locatable(axes).append_axes("right", "1.5%", pad=0.1)
    figure.colorbar(collection, cax=bar, label=label)

    axes.plot([x_min, x_max], [base, base], color="black", linewidth=2,
              zorder=3, solid_capstyle="butt")
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(base - 0.2, top + 0.5)
    axes.set_aspect("equal")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    title = f"t = {time:.2f} s"
    summary_path = os.path.join(run, "summary.json")
    if os.path.exists(summary_path) and time >= series[-1][0]:
        with open(summary_path, encoding="utf-8") as file:
            title += f": {json.load(file)['outcome']}"
    axes.set_title(title)
    figure.savefig(output, dpi=dpi, bbox_inches="tight")
    print(f"{output}: {len(position)} points at t = {time:g} s")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("run", help="folder of a run")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--time", type=float, metavar="T",
                       help="the state nearest to this time (s)")
    which.add_argument("--frame", type=int, default=-1, metavar="N",
                       help="the Nth state, from 0; negative: from the end "
                            "(default: the last)")
    parser.add_argument("--field", default="undrained_shear_strength",
                        help="field that colours the points "
                             "(default: undrained_shear_strength)")
    parser.add_argument("-o", "--output", metavar="PNG",
                        help="picture to write (default: RUN/state.png)")
    parser.add_argument("--dpi", type=int, default=150)
    arguments = parser.parse_args()

    def frame(series):
        if arguments.time is not None:
            return int(np.argmin([abs(time - arguments.time)
                                  for time, _ in series]))
        if not -len(series) <= arguments.frame < len(series):
            sys.exit(f"{arguments.run}: no frame {arguments.frame}; "
                     f"there are {len(series)}")
        return arguments.frame

    plot(arguments.run, frame, arguments.field,
         arguments.output or os.path.join(arguments.run, "state.png"),
         arguments.dpi)


if __name__ == "__main__":
    main()
