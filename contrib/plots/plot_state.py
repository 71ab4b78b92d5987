#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the state of a two-dimensional dyke at one time, in the manner of
figure 5.5 of Remmerswaal (2023): the material points coloured by undrained
shear strength, the detected surface in red, the fixed base in black, and the
water level. A body in space is seen from the front.

    /usr/bin/python3 contrib/plots/plot_state.py RUN -o state.png
    /usr/bin/python3 contrib/plots/plot_state.py RUN --field velocity

Any field of the points can give the colours: of a vector its size, or one
component (velocity_x); materials by their names. The colours end where the data
do. Reads RUN/particles.pvd, surface.pvd, parameters.prm and summary.json (the
last two and the surface only if they are there). It needs no display.
"""

import argparse
import json
import os
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import BoundaryNorm, ListedColormap
from mpl_toolkits.axes_grid1 import make_axes_locatable

from run_files import (Field, choices, numbers, read_parameters, read_series,
                       read_units)


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


def section_lines(surface):
    """Points (n, 2) of the segments of a section: lines in 2D; of a prismatic body
    the sides of its triangles at the back, in their order."""
    lines = surface.get_cells_type("line")
    triangles = surface.get_cells_type("triangle")
    if len(lines) > 0 or len(triangles) == 0:
        return lines
    z = surface.points[:, 2]
    at_back = z[triangles] == z.min()
    sides = at_back.sum(axis=1) == 2
    return triangles[sides][at_back[sides]].reshape(-1, 2)


def read_surface(run, time):
    """Segments (n, 2, 2) of the detected surface with their chains, and the water
    level as the wetted lines have it (None if they do not tell); of this time,
    or None, None, None."""
    for surface_time, path in read_series(run, "surface"):
        if abs(surface_time - time) > 1e-6 or not os.path.exists(path):
            continue
        surface = meshio.read(path)
        lines = section_lines(surface)
        # A body in space has no section, a body that has left has nothing.
        if "chain" not in surface.point_data or len(lines) == 0:
            break
        chain = surface.point_data["chain"].ravel()[lines[:, 0]]
        if not (chain >= 0).any():
            break
        segments = surface.points[:, :2][lines]
        pressure = surface.point_data["pressure"].ravel()
        deepest = int(np.argmax(pressure))
        depth = (surface.points[deepest, 1], pressure[deepest]) \
            if pressure[deepest] > 0.0 else None
        return segments[chain >= 0], chain[chain >= 0], depth
    return None, None, None


def water_level(parameters, depth):
    """m; None if there is no water."""
    if parameters.get("Water/Side", "none") not in ("left", "right"):
        return None
    try:
        if depth is not None:  # also where it has risen
            return depth[0] + depth[1] / float(
                parameters.get("Water/Unit weight", "10"))
        return float(parameters["Water/Level"])
    except (KeyError, ValueError):
        return None


def frame_of(parameters, position):
    """Lower and upper corner of what is shown, without the water (m)."""
    lower = numbers(parameters["Grid/Lower corner"]) \
        if "Grid/Lower corner" in parameters else None
    upper = numbers(parameters["Grid/Upper corner"]) \
        if "Grid/Upper corner" in parameters else None
    if len(position) == 0:
        return np.array((lower or [0.0, 0.0])[:2]), \
            np.array((upper or [1.0, 1.0])[:2])
    least, most = position.min(axis=0), position.max(axis=0)
    x_min, x_max = least[0] - 4.0, most[0] + 4.0
    if lower is not None:
        x_min = max(lower[0], x_min)
    if upper is not None:
        x_max = min(upper[0], x_max)
    base = lower[1] if lower is not None else least[1]
    return np.array([x_min, base]), np.array([x_max, most[1]])


def colour_points(figure, axes, position, sides, field):
    """The points as squares, and the colour bar beside them."""
    collection = PolyCollection(squares(position, sides), linewidths=0,
                                antialiaseds=False, zorder=1)
    collection.set_array(field.values)
    bar_axes = make_axes_locatable(axes).append_axes("right", "1.5%", pad=0.1)
    if field.names is None:
        collection.set_cmap("viridis")
        collection.set_clim(field.low, field.high)
        bar = figure.colorbar(collection, cax=bar_axes, label=field.label)
    else:
        n = len(field.names)
        values = np.array([value for value, _ in field.names])
        collection.set_array(np.searchsorted(values, field.values))
        colours = plt.get_cmap("tab10" if n <= 10 else "tab20")
        collection.set_cmap(ListedColormap([colours(k % colours.N)
                                            for k in range(n)]))
        collection.set_norm(BoundaryNorm(np.arange(n + 1) - 0.5, n))
        bar = figure.colorbar(collection, cax=bar_axes, ticks=range(n),
                              label=field.label)
        bar.ax.set_yticklabels([name for _, name in field.names])
        bar.ax.tick_params(length=0)
    axes.add_collection(collection)
    return bar


def fit_label(figure, bar):
    """In as many lines as the height of the bar asks for."""
    figure.draw_without_rendering()
    height = bar.ax.get_window_extent().height / figure.dpi * 72.0  # points
    label = bar.ax.yaxis.label
    letters = int(height / (0.55 * label.get_fontsize()))
    label.set_text(textwrap.fill(label.get_text(), max(10, letters),
                                 break_long_words=False))


def plot(run, frame, choice, output, dpi):
    """Returns the Field that was drawn; None if no points are left."""
    series = read_series(run, "particles")
    if not series:
        sys.exit(f"{run}: no particles.pvd; is this the folder of a run?")
    time, path = series[frame(series)]
    points = meshio.read(path)
    parameters = read_parameters(run)
    try:
        field = Field(points.point_data, choice, parameters, read_units(path))
    except KeyError:
        sys.exit(f"{path}: no field '{choice}'; there are: "
                 + ", ".join(choices(points.point_data)))
    position = points.points[:, :2]
    in_space = parameters.get("Dimension", "2") == "3"
    sides = points.point_data["volume"].ravel() ** (1 / 3 if in_space else 1 / 2)
    if in_space:  # what is in front last
        order = np.argsort(points.points[:, 2], kind="stable")
        position, sides = position[order], sides[order]
        field.values = field.values[order]
    (x_min, base), (x_max, top) = frame_of(parameters, position)

    figure, axes = plt.subplots(figsize=(10, 3.2))
    segments, chain, depth = read_surface(run, time)
    level = water_level(parameters, depth)
    if level is not None and level > base:
        top = max(top, level)
        side = parameters["Water/Side"]
        if segments is not None:
            reach = water_reach(segments, level, side)
        elif len(position) > 0:
            reach = position[position[:, 1].argmax(), 0]
        else:
            reach = x_max if side == "left" else x_min
        start = x_min if side == "left" else x_max
        axes.fill_between([start, reach], base, level, color="lightblue",
                          linewidth=0, zorder=0)
        axes.plot([start, reach], [level, level], color="steelblue",
                  linewidth=1, zorder=0.1)
    if segments is not None:
        # No water inside the body, where points have moved apart.
        for number in np.unique(chain):
            axes.fill(*segments[chain == number][:, 0].T, color="white",
                      linewidth=0, zorder=0.5)
        axes.add_collection(LineCollection(segments, colors="red",
                                           linewidths=1.0, zorder=2))
    bar = None
    if len(position) > 0:
        bar = colour_points(figure, axes, position, sides, field)
    else:
        axes.text(0.5, 0.5, "no soil is left", ha="center", va="center",
                  transform=axes.transAxes)

    axes.plot([x_min, x_max], [base, base], color="black", linewidth=2,
              zorder=3, solid_capstyle="butt")
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(base - 0.2, top + 0.5)
    axes.set_aspect("equal")
    axes.ticklabel_format(useOffset=False)  # real coordinates, also far away
    if max(abs(x_min), abs(x_max)) >= 1e4:
        axes.locator_params(axis="x", nbins=5)  # they are long
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    title = f"t = {time:.2f} s"
    summary_path = os.path.join(run, "summary.json")
    if os.path.exists(summary_path) and time >= series[-1][0]:
        with open(summary_path, encoding="utf-8") as file:
            title += f": {json.load(file)['outcome']}"
    axes.set_title(title)
    if bar is not None:
        fit_label(figure, bar)
    figure.savefig(output, dpi=dpi, bbox_inches="tight")
    plt.close(figure)
    print(f"{output}: {len(position)} points at t = {time:g} s")
    return field if len(position) > 0 else None


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
                        help="field that colours the points; of a vector also "
                             "<field>_x, _y, _z "
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
