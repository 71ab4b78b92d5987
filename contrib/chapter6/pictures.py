# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a run in 3D, good enough to print (200 dpi), without a display: for each
time the body, coloured by a field, and beside it the ground as seen from above, with
its slides and lines. With ParaView's Python (5.11; Debian packages paraview,
python3-paraview, python3-matplotlib, xvfb, xauth):

    xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" \\
      pvbatch contrib/chapter6/pictures.py RUN PNG --times 1 3 15 \\
      --field displacement

RUN: the folder of a run with Output/Particles and Output/Top view. Times: the frames
next to these (s); without --times the first, the middle and the last one. Field: any
of particles.pvd, of a vector its size or a component (displacement, velocity_x,
plastic_strain, undrained_shear_strength).

The body: each point is a cube of its volume. From above: soil of sliding masses
in the colour of its number if they are watched, else the field; shaded by a
light from the reader's left; lines of ground_lines.pvd.
"""

import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LightSource, Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))), "plots"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from body_picture import BodyPicture
from frames import Frame
from run_files import Field, choices, read_series

DPI = 200
WIDTH = 10.0  # inches
# Share of the width that the body takes; the rest is the top view's.
BODY_SHARE = 0.56
# 22 that differ: slopes that crumble have some twenty masses.
SLIDE_COLOURS = [plt.get_cmap(name)(k)[:3] for name, numbers in (
    ("Set1", range(9)), ("Set2", range(8)), ("tab20b", range(0, 20, 4)))
    for k in numbers]
LINES = {0: ("end of the crest", "black", "-"),
         1: ("scarp", "darkviolet", "-"),
         2: ("moved by 1.25 cells", "black", "--")}


def frames_at(run, times):
    series = read_series(run, "particles")
    if not series:
        sys.exit(f"{run}: no particles.pvd; is this the folder of a run with "
                 "Output/Particles?")
    at = np.array([time for time, _ in series])
    if times is None:
        numbers = [0, len(at) // 2, len(at) - 1]
    else:
        numbers = [int(np.argmin(np.abs(at - time))) for time in times]
        for time, k in zip(times, numbers):
            if abs(at[k] - time) > 1e-6 * max(1.0, at[-1]):
                print(f"no picture at {time:g} s: the nearest file is of "
                      f"{at[k]:g} s (they reach from {at[0]:g} to "
                      f"{at[-1]:g} s)")
        if min(times) > at[-1] or max(times) < at[0]:
            sys.exit("none of these times was computed")
    return [Frame(run, series, k) for k in sorted(set(numbers))]


def limits(frames, field):
    """Of the colours, those of the data at all times; and what the field is
    called."""
    fields = {name: np.concatenate([frame.particles.fields[name]
                                    for frame in frames])
              for name in frames[0].particles.fields
              if field in (name, name + "_x", name + "_y", name + "_z")}
    every = Field(fields, field, frames[0].parameters, frames[0].units)
    return every.low, every.high, every.label


def draw_top_view(axes, frame, field, colours, norm):
    """The ground from above: z to the left, x towards the reader, as the body
    is seen. Returns the numbers of the slides that are there."""
    top = frame.top_view
    height = top.raster("height")
    shade = LightSource(azdeg=225, altdeg=50).hillshade(
        np.where(np.isnan(height), np.nanmin(height), height),
        dx=top.side, dy=top.side, vert_exag=0.6)
    slides = []
    if "slide" in top.fields:
        number = top.raster("slide")
        slides = [int(k) for k in np.unique(number[np.isfinite(number)])
                  if k > 0]
        rgb = np.full(height.shape + (3,), 0.85)
        for k in slides:
            rgb[number == k] = SLIDE_COLOURS[(k - 1) % len(SLIDE_COLOURS)][:3]
    else:
        values = Field(top.fields, field, frame.parameters).values
        rgb = colours(norm(top.raster(values)))[..., :3]
    rgb = rgb * (0.45 + 0.55 * shade)[..., None]
    alpha = np.isfinite(height).astype(float)
    axes.imshow(np.dstack([rgb, alpha]), extent=top.extent, origin="lower",
                interpolation="nearest", aspect="equal")
    for kind, line in frame.ground_lines:
        _, colour, style = LINES[kind]
        axes.plot(line[:, 2], line[:, 0], color=colour, linestyle=style,
                  linewidth=1.0)
    axes.set_xlim(top.extent[1], top.extent[0])
    axes.set_ylim(top.extent[3], top.extent[2])
    axes.set_xlabel("z (m)", fontsize=8)
    axes.set_ylabel("x (m)", fontsize=8)
    axes.tick_params(labelsize=7)
    return slides


def legend(figure, slides, kinds, place):
    handles = [Line2D([], [], color=LINES[k][1], linestyle=LINES[k][2],
                      label=LINES[k][0]) for k in sorted(kinds)]
    handles += [Patch(color=SLIDE_COLOURS[(k - 1) % len(SLIDE_COLOURS)],
                      label=f"sliding mass {k}") for k in sorted(slides)]
    many = len(handles) > 15  # five lines are what there is room for
    if handles:
        figure.legend(handles=handles, loc="center", bbox_to_anchor=place,
                      ncol=4 if many else 3, fontsize=5 if many else 7,
                      frameon=False)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run")
    parser.add_argument("picture")
    parser.add_argument("--times", type=float, nargs="+")
    parser.add_argument("--field", default="displacement")
    arguments = parser.parse_args()

    frames = frames_at(arguments.run, arguments.times)
    field = arguments.field
    try:
        low, high, label = limits(frames, field)
    except KeyError:
        sys.exit(f"no field '{field}'; there are: "
                 + ", ".join(choices(frames[0].particles.fields)))
    colours = plt.get_cmap("YlOrRd")
    norm = Normalize(low, high)

    body = BodyPicture(frames[0].box, WIDTH * BODY_SHARE * DPI)
    row = WIDTH * BODY_SHARE * body.height / body.width
    foot = 0.8  # inches, of colour bar and legend
    total = len(frames) * row + foot
    figure = plt.figure(figsize=(WIDTH, total), dpi=DPI)
    slides, kinds = set(), set()
    for k, frame in enumerate(frames):
        bottom = (foot + (len(frames) - 1 - k) * row) / total
        axes = figure.add_axes([0.0, bottom, BODY_SHARE, row / total])
        values = Field(frame.particles.fields, field,
                       frame.parameters).values
        body.draw(axes, frame.particles, colours(norm(values))[:, :3])
        axes.text(0.02, 0.95, f"t = {frame.time:.4g} s",
                  transform=axes.transAxes, va="top", fontsize=9)
        axes = figure.add_axes([BODY_SHARE + 0.05, bottom + 0.17 * row / total,
                                0.94 - BODY_SHARE, 0.75 * row / total])
        slides.update(draw_top_view(axes, frame, field, colours, norm))
        kinds.update(kind for kind, _ in frame.ground_lines)
    bar = figure.add_axes([0.12, 0.55 * foot / total, 0.32, 0.12 / total])
    figure.colorbar(plt.cm.ScalarMappable(norm, colours), cax=bar,
                    orientation="horizontal")
    bar.tick_params(labelsize=7)
    bar.set_xlabel(label, fontsize=8)
    legend(figure, slides, kinds, (0.77, 0.5 * foot / total))
    figure.savefig(arguments.picture, dpi=DPI)
    print(f"{arguments.picture}: t = "
          + ", ".join(f"{frame.time:g}" for frame in frames) + " s")


main()
