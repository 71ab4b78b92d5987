# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the last state of a run with ParaView (5.11; Debian packages paraview,
python3-paraview, xvfb, xauth), without a display:

    xvfb-run -a -s "-screen 0 1600x1200x24 -noreset" \\
      pvbatch contrib/paraview/render.py RUN PNG [FIELD]

(-noreset: else the display starts anew between ParaView's two looks at it, which may
find none.)

Points coloured by FIELD (undrained_shear_strength; any field of particles.pvd, of a
vector its size or a component: velocity, velocity_x), detected surface in red, its
wetted part in blue, the base in black. The colours end where the data do; the bar
stands below the body.
"""

import os
import sys

import numpy as np
from paraview import servermanager
from paraview.simple import *  # noqa: F403 (that is how pvbatch is used)
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))), "plots"))
from run_files import (COMPONENTS, Field, choices, read_parameters, read_series,
                       read_units)

# Twelve colours that differ, for fields of names (ColorBrewer's "Paired").
COLOURS = [(31, 120, 180), (51, 160, 44), (255, 127, 0), (227, 26, 28),
           (106, 61, 154), (177, 89, 40), (166, 206, 227), (178, 223, 138),
           (253, 191, 111), (251, 154, 153), (202, 178, 214), (255, 255, 153)]
# Where the body is in the picture, as shares of its height and width.
BODY_LOW, BODY_HIGH, BODY_WIDTH = 0.30, 0.97, 0.94


def point_fields(source):
    """{name: array} of a source as it is now."""
    data = servermanager.Fetch(source).GetPointData()
    return {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))
            for k in range(data.GetNumberOfArrays())}


def colour(display, choice, field, view, is_vector):
    """Colours of the points, and their bar below the body."""
    if is_vector:
        component = choice[-1] if choice[-2:-1] == "_" \
            and choice[-1] in COMPONENTS else None
        name = choice[:-2] if component else choice
        ColorBy(display, ("POINTS", name,
                          component.upper() if component else "Magnitude"))
    else:
        name = choice
        ColorBy(display, ("POINTS", name))
    table = GetColorTransferFunction(name)
    if field.names is None:
        table.ApplyPreset("Viridis (matplotlib)", True)
        # After the preset, which has a range of its own.
        table.RescaleTransferFunction(field.low, field.high)
    else:
        table.InterpretValuesAsCategories = 1
        table.AnnotationsInitialized = 1
        table.Annotations = [text for value, label in field.names
                             for text in (str(value), label)]
        table.IndexedColors = [part / 255.0
                               for k in range(len(field.names))
                               for part in COLOURS[k % len(COLOURS)]]
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(table, view)
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.ScalarBarLength = 0.5
    bar.ScalarBarThickness = 14
    # Names stand below the bar, numbers above it.
    bar.Position = [0.25, 0.03 if field.names is None else 0.11]
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.Title = field.label
    bar.ComponentTitle = ""
    bar.RangeLabelFormat = "%.4g"
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = "%.4g"


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    run, picture = sys.argv[1:3]
    choice = sys.argv[3] if len(sys.argv) == 4 else "undrained_shear_strength"
    series = read_series(run, "particles")
    if not series:
        sys.exit(f"{run}: no particles.pvd; is this the folder of a run?")
    time = series[-1][0]

    view = CreateRenderView()
    view.ViewSize = [1600, 500]
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    # First of all: what is shown, and its range, are those of this time.
    view.ViewTime = time
    GetAnimationScene().AnimationTime = time

    points = PVDReader(FileName=os.path.join(run, "particles.pvd"))
    points.UpdatePipeline(time)
    is_empty = points.GetDataInformation().GetNumberOfPoints() == 0
    if is_empty:
        text = Text(Text="no soil is left")
        Show(text, view).Color = [0.0, 0.0, 0.0]
    else:
        fields = point_fields(points)
        try:
            field = Field(fields, choice, read_parameters(run),
                          read_units(series[-1][1]))
        except KeyError:
            sys.exit(f"no field '{choice}'; there are: "
                     + ", ".join(choices(fields)))
        display = Show(points, view)
        display.SetRepresentationType("Points")
        colour(display, choice, field, view,
               choice not in fields or fields[choice].ndim == 2)

    surface_file = os.path.join(run, "surface.pvd")
    if os.path.exists(surface_file):
        surface = PVDReader(FileName=surface_file)
        surface.UpdatePipeline(time)
        for name, value, rgb, width in (
                ("wetted", 0, [1.0, 0.0, 0.0], 2.0),
                ("on_face", 2, [0.0, 0.0, 0.0], 4.0),  # the grid's lower face
                ("wetted", 1, [0.2, 0.5, 0.9], 4.0)):
            if surface.GetDataInformation().GetNumberOfPoints() == 0:
                break
            part = Threshold(Input=surface, Scalars=["POINTS", name])
            part.LowerThreshold = part.UpperThreshold = value
            part.UpdatePipeline(time)
            if part.GetDataInformation().GetNumberOfCells() == 0:
                continue
            lines = Show(part, view)
            lines.ColorArrayName = ["POINTS", ""]  # one colour
            lines.AmbientColor = lines.DiffuseColor = rgb
            lines.LineWidth = width

    if not is_empty:
        shown = [points.GetDataInformation().GetBounds()]
        if os.path.exists(surface_file) \
                and surface.GetDataInformation().GetNumberOfPoints() > 0:
            shown.append(surface.GetDataInformation().GetBounds())
        low = [min(b[2 * d] for b in shown) for d in range(3)]
        high = [max(b[2 * d + 1] for b in shown) for d in range(3)]
        height = max((high[1] - low[1]) / (BODY_HIGH - BODY_LOW),
                     (high[0] - low[0]) / BODY_WIDTH
                     * view.ViewSize[1] / view.ViewSize[0], 1e-6)
        centre = [0.5 * (a + b) for a, b in zip(low, high)]
        centre[1] -= (0.5 * (BODY_LOW + BODY_HIGH) - 0.5) * height
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = centre
        view.CameraPosition = [centre[0], centre[1],
                               high[2] + 10.0 * height + 1.0]
        view.CameraParallelScale = 0.5 * height
        # As large as the soil that they stand for.
        in_space = high[2] > low[2]
        side = np.mean(fields["volume"]) ** (1 / 3 if in_space else 1 / 2)
        display.PointSize = max(2.0, 0.9 * side / height * view.ViewSize[1])
    SaveScreenshot(picture, view)
    print(f"{picture}: t = {time:g} s")


main()
