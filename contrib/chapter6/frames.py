# SPDX-License-Identifier: LGPL-2.1-or-later
"""A moment of a run in 3D, read with VTK: points, the ground as seen from above and
lines on it."""

import os
import sys

import numpy as np
from run_files import numbers, read_parameters, read_series, read_units
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


class Points:
    """`positions` (n x 3, m) and `fields` {name: array} of a .vtu file."""

    def __init__(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        self.grid = reader.GetOutput()
        n = self.grid.GetNumberOfPoints()
        self.positions = vtk_to_numpy(self.grid.GetPoints().GetData()) \
            if n > 0 else np.zeros((0, 3))
        data = self.grid.GetPointData()
        self.fields = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))
                       for k in range(data.GetNumberOfArrays())}


class TopView:
    """The raster of a top_view file; `fields` have one row a square."""

    def __init__(self, path, box):
        points = Points(path)
        corners = points.positions.reshape(-1, 4, 3)
        self.fields = {name: values[::4]
                       for name, values in points.fields.items()}
        low, high = box
        self.side = corners[0, 2, 0] - corners[0, 0, 0]
        self.extent = (low[2], high[2], low[0], high[0])  # z, x
        self.shape = (round((high[0] - low[0]) / self.side),
                      round((high[2] - low[2]) / self.side))
        self.at = tuple(np.rint((corners[:, 0, d] - low[d])
                                / self.side).astype(int) for d in (0, 2))

    def raster(self, values):
        """values (or a field's name) as an array [x, z]; nan: no soil."""
        if isinstance(values, str):
            values = self.fields[values]
        raster = np.full(self.shape, np.nan)
        raster[self.at] = values
        return raster


def read_lines(path):
    """[(kind, vertices), ...] of a ground_lines file."""
    points = Points(path)
    if len(points.positions) == 0:
        return []
    cells = points.grid.GetCells()
    ends = vtk_to_numpy(cells.GetOffsetsArray())
    return [(int(points.fields["kind"][begin]), points.positions[begin:end])
            for begin, end in zip(ends[:-1], ends[1:])]


class Frame:
    def __init__(self, run, series, number):
        self.time, path = series[number]
        self.units = read_units(path)
        self.parameters = read_parameters(run)
        self.box = tuple(
            np.array(numbers(self.parameters[f"Grid/{corner} corner"]))
            for corner in ("Lower", "Upper"))
        self.particles = Points(path)
        views, lines = (read_series(run, name)
                        for name in ("top_view", "ground_lines"))
        if not lines:
            sys.exit(f"{run}: no ground_lines.pvd; is it a run in 3D with "
                     "Output/Top view = true?")
        self.top_view = TopView(dict(views)[self.time], self.box)
        self.ground_lines = read_lines(dict(lines)[self.time])
