# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the last state of a run with ParaView (5.11; Debian packages paraview,
python3-paraview, xvfb, xauth), without a display:

    xvfb-run -a pvbatch contrib/paraview/render.py RUN PNG [FIELD]

Points coloured by FIELD (undrained_shear_strength), detected surface in red, its
wetted part in blue, the base in black.
"""

import os
import sys

from paraview.simple import *  # noqa: F403 (that is how pvbatch is used)

if len(sys.argv) not in (3, 4):
    sys.exit(__doc__)
run, picture = sys.argv[1:3]
field = sys.argv[3] if len(sys.argv) == 4 else "undrained_shear_strength"

view = CreateRenderView()
view.ViewSize = [1600, 500]
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0

points = PVDReader(FileName=os.path.join(run, "particles.pvd"))
time = points.TimestepValues[-1]
points.UpdatePipeline(time)
display = Show(points, view)
display.SetRepresentationType("Points")
display.PointSize = 4.0
ColorBy(display, ("POINTS", field))
display.RescaleTransferFunctionToDataRange(False, True)
display.SetScalarBarVisibility(view, True)
GetColorTransferFunction(field).ApplyPreset("Viridis (matplotlib)", True)
bar = GetScalarBar(GetColorTransferFunction(field), view)
bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
bar.Title = field.replace("_", " ")

surface_file = os.path.join(run, "surface.pvd")
if os.path.exists(surface_file):
    surface = PVDReader(FileName=surface_file)
    for name, value, colour, width in (
            ("wetted", 0, [1.0, 0.0, 0.0], 2.0),
            ("on_face", 2, [0.0, 0.0, 0.0], 4.0),  # the grid's lower face
            ("wetted", 1, [0.2, 0.5, 0.9], 4.0)):
        part = Threshold(Input=surface, Scalars=["POINTS", name])
        part.LowerThreshold = part.UpperThreshold = value
        part.UpdatePipeline(time)
        if part.GetDataInformation().GetNumberOfCells() == 0:
            continue
        lines = Show(part, view)
        lines.ColorArrayName = ["POINTS", ""]  # one colour
        lines.AmbientColor = lines.DiffuseColor = colour
        lines.LineWidth = width

view.ViewTime = time
bounds = points.GetDataInformation().GetBounds()
centre = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
view.CameraParallelProjection = 1
view.CameraFocalPoint = centre
view.CameraPosition = [centre[0], centre[1], centre[2] + 100.0]
view.CameraParallelScale = 0.6 * max(
    bounds[3] - bounds[2],
    (bounds[1] - bounds[0]) * view.ViewSize[1] / view.ViewSize[0])
SaveScreenshot(picture, view)
print(f"{picture}: t = {time:g} s")
