#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws every field of two small runs: one with loads, two materials and walls,
far from the origin; one whose soil leaves the grid. Reads all files of both.

    /usr/bin/python3 tests/cases/every_field_drawn.py WAKER SOURCE_DIR

With ParaView (pvbatch, xvfb-run) some fields are drawn with it, too.
"""

import contextlib
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile

import matplotlib.pyplot as plt
import meshio
import numpy as np
from runs import Check, run, statistics

FAR = 155000.0  # m, east
LOADED = f"""
subsection Grid
  set Lower corner = {FAR!r}, 0
  set Upper corner = {FAR + 4!r}, 2
  set Cell size    = 0.25
end
subsection Materials
  set Names = old clay, peat
  subsection old clay
    set Unit weight = 18
    set Initial strength = 30
    set Residual strength = 5
  end
  subsection peat
    set Unit weight = 12
    set Initial strength = 2
    set Residual strength = 1
  end
end
subsection Soil profile
  set Layers = lower, upper
  subsection lower
    set Material = old clay
    set Polygon  = {FAR!r}, 0; {FAR + 4!r}, 0; {FAR + 4!r}, 0.5; {FAR!r}, 0.5
  end
  subsection upper
    set Material = peat
    set Polygon  = {FAR + 1!r}, 0.5; {FAR + 3!r}, 0.5; {FAR + 2.5!r}, 1.5; \\
                   {FAR + 1.5!r}, 1.5
  end
end
subsection Boundary conditions
  set Names = base
  subsection base
    set Region = bottom
  end
end
subsection Water
  set Side  = left
  set Level = 0.75
end
subsection Tractions
  set Names = footing, cart, lost
  subsection footing
    set Method = contour
    set Kind   = vector
    set Value  = 0; -4
    set From   = {FAR + 1.7!r}, 1.45
    set To     = {FAR + 2.3!r}, 1.55
  end
  subsection cart
    set Method = fixed points
    set Value  = 1
    set Facing = 0, 1
    set From   = {FAR + 1.7!r}, 1.45
    set To     = {FAR + 2.3!r}, 1.55
  end
  subsection lost
    set Method  = contour
    set Value   = 1
    set Follows = space
    set From    = {FAR + 1.7!r}, 1.45
    set To      = {FAR + 2.3!r}, 1.55
  end
end
subsection Time stepping
  set Time step     = 0.02
  set End time      = 1
  set Ramp duration = 0
end
subsection Stop rules
  set At rest     = false
  set On flooding = false
end
subsection Output
  set Interval = 0.5
end
"""
LEAVING = """
subsection Grid
  set Lower corner = 0, 0
  set Upper corner = 3, 1
  set Cell size    = 0.25
end
subsection Materials
  set Names = clay
  subsection clay
    set Unit weight = 18
  end
end
subsection Soil profile
  set Layers = block
  subsection block
    set Material = clay
    set Polygon  = 2, 0.25; 2.75, 0.25; 2.75, 0.75; 2, 0.75
    set Velocity = 4; 0
  end
end
subsection Boundary conditions
  set Names = base
  subsection base
    set Region = bottom
  end
end
subsection Gravity
  set Acceleration   = 0
  set Initial stress = false
end
subsection Outflow
  set Faces = right
end
subsection Water
  set Side = none
end
subsection Tractions
  set Names = riding
  subsection riding
    set Method = contour
    set Value  = 0.01
    set Facing = 0, 1
    set From   = 2, 0.7
    set To     = 2.7, 0.8
  end
end
subsection Time stepping
  set Time step     = 0.02
  set End time      = 0.4
  set Ramp duration = 0
end
subsection Stop rules
  set At rest = false
end
subsection Output
  set Interval = 0.2
end
"""


def read_all(check, run_files, folder, what):
    """Every file of every series, with meshio: {series: [mesh, ...]}."""
    meshes, bad = {}, 0
    for name in ("particles", "surface", "grid", "tractions"):
        meshes[name] = [meshio.read(path) for _, path
                        in run_files.read_series(folder, name)]
        for mesh in meshes[name]:
            sizes = {len(mesh.points)} | {len(values) for values
                                          in mesh.point_data.values()}
            bad += mesh.points.dtype != np.float64 or len(sizes) != 1
            bad += not np.isfinite(mesh.points).all()
    check(f"{what}: files", sum(map(len, meshes.values())), 8, 100)
    check("  that are not whole, or not in double precision", bad, 0, 0)
    return meshes


def refused(function, *arguments):
    """What a script says when it gives up."""
    text = io.StringIO()
    try:
        with contextlib.redirect_stdout(text):
            function(*arguments)
    except SystemExit as stop:
        return str(stop)
    return ""


def n_colours(picture, levels=255):
    """Of a picture, in steps of 1/levels."""
    parts = np.round(255 * plt.imread(picture)[..., :3]).astype(int)
    parts = parts * levels // 255
    # One number a pixel: rows of three take ten times as long to sort.
    return len(np.unique(parts @ [1 << 16, 1 << 8, 1]))


def draw_all(check, plot_state, run_files, folder, what, each=1):
    """Each so-many-th of the fields, the last one among them."""
    points = meshio.read(run_files.read_series(folder, "particles")[-1][1])
    parameters = run_files.read_parameters(folder)
    every = run_files.choices(points.point_data)[::-each]
    blank, wrong = [], []
    for choice in every:
        picture = os.path.join(folder, choice.replace("/", "_") + ".png")
        field = plot_state.plot(folder, lambda series: -1, choice, picture, 50)
        if n_colours(picture, 32) < 10:
            blank.append(choice)
        name = choice if choice in points.point_data else choice[:-2]
        values = np.asarray(points.point_data[name], dtype=float)
        if values.ndim == 2 and values.shape[1] > 1:
            values = np.linalg.norm(values, axis=1) if name == choice \
                else values[:, "xyz".index(choice[-1])]
        if field is None:
            wrong += [choice] * (len(values) > 0)
        elif values.max() > values.min() and max(abs(values)) > 1e-30:
            if (field.low, field.high) != (values.min(), values.max()):
                wrong.append(choice)
        elif not field.low < values.min() <= values.max() < field.high:
            wrong.append(choice)
    check(f"{what}: fields drawn", len(every), 20 / each, 200)
    check(f"  blank {blank}", len(blank), 0, 0)
    check(f"  with colours that do not end with the data {wrong}", len(wrong),
          0, 0)
    message = refused(plot_state.plot, folder, lambda series: -1, "weight",
                      os.devnull, 50)
    check("  unknown field: the others are named",
          "velocity_x" in message and "'weight'" in message, 1, 1)
    return points, parameters


def render(check, source, folder, fields, what):
    if not (shutil.which("pvbatch") and shutil.which("xvfb-run")):
        print("no pvbatch: nothing drawn with ParaView")
        return
    for field in fields:
        picture = os.path.join(folder, f"paraview-{field}.png")
        done = subprocess.run(
            ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24 -noreset",
             "pvbatch",
             os.path.join(source, "contrib", "paraview", "render.py"),
             folder, picture, field], check=False, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        good = done.returncode == 0 and "rror" not in done.stdout
        if not good:
            print(done.stdout)
        check(f"{what}: ParaView draws {field}", good, 1, 1)
        check("  colours", n_colours(picture), 2, 1e9)


def main():
    waker, source = sys.argv[1:3]
    sys.path.insert(0, os.path.join(source, "contrib", "plots"))
    import plot_state
    import run_files

    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        def compute(name, text):
            case = os.path.join(folder, name + ".prm")
            with open(case, "w", encoding="utf-8") as file:
                file.write(text)
            run(waker, case, os.path.join(folder, name))
            return os.path.join(folder, name)

        loaded = compute("loaded", LOADED)
        meshes = read_all(check, run_files, loaded, "loaded")
        first = meshes["particles"][0]
        # A point of the layer below, which the grid cuts into sub-cells.
        lower = np.asarray(first.point_data["material"]) == 0
        steps = (first.points[lower, 0] - FAR) / 0.125 - 0.5
        check("  positions off the lattice at 155 km (m)",
              0.125 * np.abs(steps - np.round(steps)).max(), 0, 1e-9)
        rows = statistics(loaded)
        force = rows["Traction footing y (kN)"]
        check("  footing: largest relative change of its resultant",
              np.abs(force / (-4 * 0.6) - 1.0).max(), 0, 1e-11)
        check("  length under it (m)", rows["Traction footing length (m)"][-1],
              0.6 - 1e-9, 0.6 + 1e-9)
        check("  a traction in space has lost its soil (m)",
              rows["Traction lost length (m)"][-1], 0, 0.3)
        points, parameters = draw_all(check, plot_state, run_files, loaded,
                                      "loaded")
        names = run_files.Field(points.point_data, "material",
                                parameters).names
        check(f"  materials by name {names}",
              names == [(0, "old clay"), (1, "peat")], 1, 1)
        render(check, source, loaded, ["plastic_strain", "velocity",
                                       "velocity_y", "material"], "loaded")

        leaving = compute("leaving", LEAVING)
        meshes = read_all(check, run_files, leaving, "leaving")
        check("  points at last", len(meshes["particles"][-1].points), 0, 0)
        check("  facets under load at first",
              len(meshes["tractions"][0].get_cells_type("line")), 1, 100)
        check("  at last", len(meshes["tractions"][-1].points), 0, 0)
        with open(os.path.join(leaving, "log.txt"), encoding="utf-8") as file:
            log = file.read()
        with open(os.path.join(leaving, "summary.json"),
                  encoding="utf-8") as file:
            summary = json.load(file)
        for words in ("traction riding has lost a part",
                      "traction riding loads nothing"):
            check(f"  said once: {words}", log.count(words), 1, 1)
            # A warning, which the summary has, too.
            check("  and in the summary",
                  sum(words in line for line in summary["warnings"]), 1, 1)
        # Without points there is nothing of a field but its name.
        draw_all(check, plot_state, run_files, leaving, "leaving", each=4)
        render(check, source, leaving, ["velocity"], "leaving")
    check.exit()


if __name__ == "__main__":
    main()
