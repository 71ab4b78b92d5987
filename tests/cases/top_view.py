#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ground as seen from above, found again from the points that the same run wrote;
lines on the ground, in 3D. (That a resumed run leaves the same files: restart.py.)

    /usr/bin/python3 tests/cases/top_view.py WAKER SOURCE_DIR
"""

import base64
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import matplotlib.pyplot as plt
import meshio
import numpy as np
from runs import Check, run

H = 0.5      # m, cells
SIDE = H / 2  # of the squares
# A block that is too weak for its own weight: it spreads to the right.
BODY = f"""
set Dimension = 3
subsection Grid
  set Lower corner = 0, 0, 0
  set Upper corner = 4, 2, 1
  set Cell size    = {H}
end
subsection Materials
  set Names = clay
  subsection clay
    set Unit weight       = 20
    set Initial strength  = 2
    set Residual strength = 1
  end
end
subsection Soil profile
  set Layers = block
  subsection block
    set Material = clay
    set Polygon  = 0, 0; 2.5, 0; 1.5, 1.5; 0, 1.5
  end
end
subsection Boundary conditions
  set Names = base, rear, near end, far end
  subsection base
    set Region = bottom
  end
  subsection rear
    set Region = left
    set Type   = roller
  end
  subsection near end
    set Region = back
    set Type   = fixed
  end
  subsection far end
    set Region = front
    set Type   = roller
  end
end
subsection Water
  set Side = none
end
subsection Time stepping
  set Time step     = 0.02
  set End time      = 1.6
  set Ramp duration = 0
end
subsection Stop rules
  set At rest = false
end
subsection Output
  set Interval            = 0.8
  set Checkpoint interval = 0.2
  set Top view            = true
end
"""


def series(folder, name):
    with open(os.path.join(folder, name + ".pvd"), encoding="utf-8") as file:
        return [os.path.join(folder, path)
                for path in re.findall(r'file="([^"]*)"', file.read())]


def array(path, start, kind):
    """An array of a .vtu file: meshio does not know polylines."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    data = text[text.index(">\n", text.index("<DataArray",
                                             text.index(start) - 60)) + 2:]
    data = data[:data.index("\n")]
    n_blocks, _, _, _ = struct.unpack("<4I", base64.b64decode(data[:24]))
    assert n_blocks == 1
    return np.frombuffer(zlib.decompress(base64.b64decode(data[24:])), kind)


def seen_from_above(points, spatial):
    """{square: (top, id)}: each point's domain is a cube of its first volume."""
    over_middle, in_square = {}, {}
    x = points.points
    for p, number in enumerate(points.point_data["id"]):
        # Middles in [x - reach, x + reach); at first those that it covers.
        for seen, reach in ((over_middle, 0.5), (in_square, 1 - 1e-6)):
            ranges = [range(int(np.ceil(x[p, d] / SIDE - reach - 0.5)),
                            int(np.ceil(x[p, d] / SIDE + reach - 0.5)))
                      for d in (0, 2)]
            for i in ranges[0]:
                for k in ranges[1] if spatial else (0,):
                    top = x[p, 1] + 0.5 * SIDE
                    if 0 <= i < 16 and 0 <= k < 4 \
                            and top > seen.get((i, k), (-np.inf, 0))[0]:
                        seen[i, k] = (top, int(number))
    return {**in_square, **over_middle}


def check_views(check, folder, what, spatial):
    kind, n = ("quad", 4) if spatial else ("line", 2)
    differ = squares = 0
    worst = moved = 0.0
    for path, view in zip(series(folder, "particles"),
                          series(folder, "top_view")):
        seen = seen_from_above(meshio.read(path), spatial)
        mesh = meshio.read(view)
        check(f"{what}: squares", len(mesh.get_cells_type(kind)), len(seen),
              len(seen))
        corners = mesh.points.reshape(-1, n, 3)
        ids = mesh.point_data["id"][::n]
        heights = mesh.point_data["height"][::n]
        for corner, number, height in zip(corners, ids, heights):
            i, k = (int(np.rint(corner[:, d].min() / SIDE)) for d in (0, 2))
            top, of_point = seen[i, k]
            # Points that lay beside each other may reach equally high.
            differ += of_point != number and abs(top - height) > 1e-6
            worst = max(worst, abs(top - height), np.ptp(corner[:, 1]),
                        abs(corner[0, 1] - height))
            squares += 1
        moved = max(moved, np.abs(mesh.point_data["displacement"]).max())
    check(f"{what}: squares at all times", squares, 1, 1e9)
    check("  other points than above", differ, 0, 0)
    check("  heights (m)", worst, 0, 1e-6)  # single precision
    check("  largest displacement seen (m)", moved, 0.3, 3)


def check_lines(check, folder):
    files = series(folder, "ground_lines")
    check("files of lines", len(files), 3, 3)
    # At t = 0: the crest ends on the slope 1.25 cells below its edge, all
    # along; nothing has moved.
    kinds = array(files[0], 'Name="kind"', np.int32)
    x = array(files[0], '<Points>', np.float64).reshape(-1, 3) \
        if len(kinds) else np.zeros((0, 3))
    check("t = 0: kinds", np.abs(kinds).max(), 0, 0)
    check("  from z (m)", x[:, 2].min(), SIDE / 2 - 1e-9, SIDE / 2 + 1e-9)
    check("  to z (m)", x[:, 2].max(), 1 - SIDE / 2 - 1e-9,
          1 - SIDE / 2 + 1e-9)
    check("  straight (m)", np.ptp(x[:, 0]), 0, 1e-9)
    # The slope falls by 1.5 m in 1 m; steps of points, half a cell wide.
    check("  at x (m)", x[0, 0], 1.5 + 1.25 * H / 1.5 - SIDE,
          1.5 + 1.25 * H / 1.5 + SIDE)
    kinds = array(files[-1], 'Name="kind"', np.int32)
    ends = array(files[-1], 'Name="offsets"', np.int64)
    types = array(files[-1], 'Name="types"', np.uint8)
    check("at the end: there is an outline of what has moved",
          (kinds == 2).sum(), 2, 1e9)
    check("  all are polylines", (types == 4).all(), 1, 1)
    check("  of two points or more", np.diff([0, *ends]).min(), 2, 1e9)
    check("  and have all points", ends[-1], len(kinds), len(kinds))


def check_picture(check, source, folder):
    if not (shutil.which("pvbatch") and shutil.which("xvfb-run")):
        print("no pvbatch: no picture drawn")
        return
    picture = os.path.join(folder, "pairs.png")
    done = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24 -noreset", "pvbatch",
         os.path.join(source, "contrib", "chapter6", "pictures.py"), folder,
         picture, "--times", "0", "1.6", "--field", "displacement_x"],
        check=False, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT)
    good = done.returncode == 0 and "rror" not in done.stdout
    if not good:
        print(done.stdout)
    check("picture drawn", good, 1, 1)
    pixels = plt.imread(picture)[..., :3]
    # 10 inches at 200 dpi; the body on the left has many colours.
    check("  pixels across", pixels.shape[1], 2000, 2000)
    body = pixels[:, :pixels.shape[1] // 2].reshape(-1, 3)
    coloured = body[np.ptp(body, axis=1) > 0.1]
    check("  its body", len(coloured) / len(body), 0.05, 0.9)
    check("  in colours", len(np.unique(coloured.round(2), axis=0)), 100, 1e9)


def main():
    waker, source = sys.argv[1:3]
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        case = os.path.join(folder, "body.prm")
        with open(case, "w", encoding="utf-8") as file:
            file.write(BODY)
        whole = os.path.join(folder, "whole")
        run(waker, case, whole)
        check_views(check, whole, "a body", True)
        check_lines(check, whole)
        check_picture(check, source, whole)

        plane = os.path.join(folder, "plane.prm")
        with open(plane, "w", encoding="utf-8") as file:
            file.write(
                BODY[:BODY.index("  subsection near end")]
                .replace("Dimension = 3", "Dimension = 2")
                .replace("0, 0, 0", "0, 0").replace("4, 2, 1", "4, 2")
                .replace("rear, near end, far end", "rear")
                + BODY[BODY.index("end\nsubsection Water"):])
        run(waker, plane, os.path.join(folder, "plane"))
        check_views(check, os.path.join(folder, "plane"), "a section", False)
        check("a section has no lines", os.path.exists(os.path.join(
            folder, "plane", "ground_lines.pvd")), 0, 0)
        # All of them are the run's own.
        run(waker, case, whole, Output={"Top view": "false"})
        left = [name for name in os.listdir(os.path.join(whole, "solution"))
                if "top_view" in name or "lines" in name]
        check(f"--overwrite leaves nothing of them {left}", len(left), 0, 0)
        check("  nor their lists", sum(os.path.exists(os.path.join(
            whole, name + ".pvd")) for name in ("top_view", "ground_lines")),
            0, 0)
    check.exit()


if __name__ == "__main__":
    main()
