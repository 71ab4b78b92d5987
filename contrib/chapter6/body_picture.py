# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body of points in 3D, drawn with VTK, with axes to scale that matplotlib writes
beside it."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkGlyph3DMapper, vtkLight,
                                         vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass

# From the body to the reader: before the slope, above it, a little to one side.
TO_READER = np.array([0.80, 0.62, 0.42])
SAMPLES = 2  # pixels drawn per pixel printed, in each direction
# Lengths in shares of the box's diagonal, so that boxes of any size look alike.
AXIS_GAP = 0.025  # between the box and its axes
MARGIN = 0.06  # around the box, for numbers and names
MOST_TICKS = 10  # of an axis


def tick_distance(length):
    """The least of 1, 2, 5, 10, ... m that gives at most MOST_TICKS intervals."""
    return min(factor * 10.0**n for n in range(6) for factor in (1, 2, 5)
               if factor * 10.0**n * MOST_TICKS >= length)


class BodyPicture:
    """Draws bodies in a box as seen by one reader, all to one scale."""

    def __init__(self, box, width):
        """box: (lower, upper) corner (m); width: of the picture (pixels)."""
        self.low, self.high = (np.asarray(corner) for corner in box)
        diagonal = np.linalg.norm(self.high - self.low)
        self.axis_gap, margin = AXIS_GAP * diagonal, MARGIN * diagonal
        self.tick_distance = tick_distance((self.high - self.low).max())
        self.to_reader = TO_READER / np.linalg.norm(TO_READER)
        self.right = np.cross([0.0, 1.0, 0.0], self.to_reader)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(self.to_reader, self.right)
        corners = np.array([[(self.low, self.high)[c][d]
                             for d, c in enumerate((i, j, k))]
                            for i in (0, 1) for j in (0, 1) for k in (0, 1)])
        seen = np.column_stack([corners @ self.right, corners @ self.up])
        self.seen_low = seen.min(axis=0) - margin
        self.seen_high = seen.max(axis=0) + margin
        size = self.seen_high - self.seen_low
        self.pixels_per_metre = width / size[0]
        self.width = int(round(width))
        self.height = int(round(size[1] * self.pixels_per_metre))

    def seen(self, x):
        """Where a place is in the picture (m, from its lower left corner)."""
        x = np.asarray(x)
        return np.column_stack([x @ self.right, x @ self.up]) - self.seen_low

    def image(self, particles, rgb):
        """(height, width, 3) array of the body, on white."""
        cloud = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(
            particles.positions, dtype=float), deep=True))
        cloud.SetPoints(points)
        colours = numpy_to_vtk(np.ascontiguousarray(
            np.rint(255 * rgb), dtype=np.uint8), deep=True)
        colours.SetName("colours")
        size = numpy_to_vtk(np.cbrt(particles.fields["volume"])
                            .astype(float), deep=True)
        size.SetName("size")
        cloud.GetPointData().SetScalars(colours)
        cloud.GetPointData().AddArray(size)

        cube = vtkCubeSource()
        mapper = vtkGlyph3DMapper()
        mapper.SetInputData(cloud)
        mapper.SetSourceConnection(cube.GetOutputPort())
        mapper.SetScaleArray("size")
        mapper.SetScaleModeToScaleByMagnitude()
        mapper.SetColorModeToDirectScalars()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetAmbient(0.35)
        actor.GetProperty().SetDiffuse(0.75)

        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.AddActor(actor)
        self.set_lights(renderer)
        self.set_camera(renderer)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(SAMPLES * self.width, SAMPLES * self.height)
        window.AddRenderer(renderer)
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.Update()
        image = grab.GetOutput()
        columns, rows, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars())
        pixels = pixels.reshape(rows // SAMPLES, SAMPLES,
                                columns // SAMPLES, SAMPLES, -1)[..., :3]
        return pixels.mean(axis=(1, 3))[::-1] / 255.0

    def set_lights(self, renderer):
        """A lamp from above on the right, a weaker light from the reader,
        and shade."""
        centre = 0.5 * (self.low + self.high)
        radius = 0.5 * np.linalg.norm(self.high - self.low)
        lamp = vtkLight()
        lamp.SetPositional(False)
        away = 0.5 * self.to_reader + self.up + 0.8 * self.right
        lamp.SetPosition(centre + 6.0 * radius * away / np.linalg.norm(away))
        lamp.SetFocalPoint(centre)
        lamp.SetIntensity(0.9)
        renderer.AddLight(lamp)
        fill = vtkLight()
        fill.SetLightTypeToHeadlight()
        fill.SetIntensity(0.55)
        renderer.AddLight(fill)

        # Shade where soil stands close by (ambient occlusion): shadow maps
        # of VTK 9.1 darken a part of the crest that nothing stands before.
        shade = vtkSSAOPass()
        shade.SetRadius(0.08 * radius)
        shade.SetKernelSize(128)
        shade.SetBias(0.001 * radius)
        shade.BlurOn()
        shade.SetDelegatePass(vtkRenderStepsPass())
        renderer.SetPass(shade)

    def set_camera(self, renderer):
        middle = 0.5 * (self.seen_low + self.seen_high)
        depth = 0.5 * (self.low + self.high) @ self.to_reader
        focus = (middle[0] * self.right + middle[1] * self.up
                 + depth * self.to_reader)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(focus)
        camera.SetPosition(focus + 100.0 * self.to_reader)
        camera.SetViewUp(0.0, 1.0, 0.0)
        camera.SetParallelScale(0.5 * (self.seen_high - self.seen_low)[1])
        renderer.ResetCameraClippingRange()

    def draw(self, axes, particles, rgb):
        size = self.seen_high - self.seen_low
        axes.imshow(self.image(particles, rgb),
                    extent=(0.0, size[0], 0.0, size[1]), aspect="equal")
        axes.set_axis_off()
        low, high = self.low, self.high
        # Name, where the axis begins, along which direction, away from the body.
        for name, begin, d, away in (
                ("x", [low[0], low[1], high[2]], 0, [0.0, 0.0, 1.0]),
                ("z", [high[0], low[1], low[2]], 2, [1.0, 0.0, 0.0]),
                ("y", [low[0], low[1], high[2]], 1, [0.0, 0.0, 1.0])):
            self.draw_axis(axes, name, np.array(begin, dtype=float), d,
                           self.axis_gap * np.array(away))
        axes.set_xlim(0.0, size[0])
        axes.set_ylim(0.0, size[1])

    def draw_axis(self, axes, name, begin, d, away):
        """A line with ticks at multiples of their distance."""
        step = self.tick_distance
        end = begin.copy()
        end[d] = self.high[d]
        line = self.seen([begin + 0.5 * away, end + 0.5 * away])
        axes.plot(line[:, 0], line[:, 1], color="black", linewidth=0.6)
        for value in step * np.arange(np.ceil(begin[d] / step - 1e-9),
                                      end[d] / step + 1e-9):
            at = begin.copy()
            at[d] = value
            tick = self.seen([at + 0.5 * away, at + away, at + 1.9 * away])
            axes.plot(tick[:2, 0], tick[:2, 1], color="black", linewidth=0.6)
            axes.text(*tick[2], f"{value + 0.0:g}", ha="center", va="center",
                      fontsize=6)
        if name == "y":
            axes.text(line[1, 0], line[1, 1] + 0.4 * self.axis_gap, "y (m)", ha="center",
                      va="bottom", fontsize=7)
        else:
            middle = self.seen([0.5 * (begin + end) + 4.4 * away])[0]
            axes.text(*middle, f"{name} (m)", ha="center", va="center",
                      fontsize=7)
