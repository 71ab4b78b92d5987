#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dyke in 3D that is lower along a part of its length: H and W are those of
its lowest and narrowest section, and the water gets over it there.

    /usr/bin/python3 tests/cases/dyke_in_space.py WAKER SOURCE_DIRECTORY
"""

import subprocess

from waker_case import Checks, workspace_of_arguments

H = 0.5  # cells, m
# From z = 0 to 2 m the dyke is 5 m high, from there to 4 m it is 1 m lower; its
# slopes stay where they are.
SPACE = {
    "Dimension": 3, "Grid/Cell size": H,
    "Grid/Lower corner": "-2, 0, 0", "Grid/Upper corner": "32, 6, 4",
    "Soil profile/Layers": "high, low",
    **{f"Soil profile/{name}/{key}": value
       for name, polygon, extent in (
           ("high", "0, 0; 30, 0; 15, 5; 5, 5", "0, 2"),
           ("low", "0, 0; 30, 0; 18, 4; 4, 4", "2, 4"))
       for key, value in (("Material", "clay"), ("Polygon", polygon),
                          ("Extent", extent))},
    "Boundary conditions/Names":
    "base, left side, right side, back side, front side",
    **{f"Boundary conditions/{name} side/{key}": value
       for name in ("back", "front")
       for key, value in (("Region", name), ("Type", "roller"))},
    "Materials/clay/Initial strength": 20,
    "Water/Level": 3, "Time stepping/Time step": 0.02,
    "Time stepping/End time": 0.02, "Output/Interval": 0,
}


def main():
    checks = Checks()
    workspace, _ = workspace_of_arguments()
    with workspace:
        run = workspace.run("low", "chapter5/dyke.prm", SPACE)
        rows = run.statistics
        # The detected surface lies about 0.1 cells above the drawn one.
        checks.between("H is that of the low part", run["residual_height"],
                       4, 4 + 0.2 * H, "m")
        checks.between("  at z", run["residual_height_z"], 2.75, 3.75, "m")
        # Both parts have their slopes in the same planes: W at 3 m is the
        # same, 21 - 3 = 18 m, but for what is seen of the step.
        checks.between("W", run["residual_width"], 18, 18 + 0.4 * H, "m")
        checks.equal("statistics: z of H", rows["z of H (m)"][-1],
                     run["residual_height_z"])
        checks.equal("statistics: z of W", rows["z of W (m)"][-1],
                     run["residual_width_z"])

        narrow = workspace.run("narrow", "chapter5/dyke.prm", {
            **SPACE, "Soil profile/low/Polygon":
            "0, 0; 28, 0; 16, 4; 4, 4"})
        checks.between("W of the narrow part", narrow["residual_width"], 16,
                       16 + 0.4 * H, "m")
        checks.between("  at z", narrow["residual_width_z"], 2.25, 3.75, "m")

        flooded = workspace.run("flooded", "chapter5/dyke.prm", {
            **SPACE, "Water/Rise": "0: 0, 0.1: 1.5, 0.2: 1.5",
            "Time stepping/End time": 0.2})
        checks.equal("water 0.5 m above the low part, and as much below the "
                     "high one", flooded["outcome"], "flooding")
        # It rises by 15 m/s from 3 m.
        checks.between("  at", flooded["flooding_time"], 1 / 15,
                       1 / 15 + 0.2 * H / 15 + 0.02, "s")
        projected = workspace.run("projected", "chapter5/dyke.prm", {
            **SPACE, "Surface/Prismatic": "true"})
        checks.equal("prismatic: no z", projected["residual_height_z"], None)
        checks.equal("prismatic: no z in the statistics",
                     [name for name in projected.statistics
                      if name.startswith("z of")], [])

        words = [workspace.waker, "run",
                 workspace.source + "/parameters/chapter5/dyke.prm",
                 "--validate"]
        for key, value in {**SPACE, "Water/Level": 4.5}.items():
            words += ["--set", f"{key}={value}"]
        refused = subprocess.run(words, capture_output=True, text=True,
                                 check=False)
        checks.equal("water above the low part at the start",
                     (refused.returncode, "Water/Level" in refused.stderr),
                     (2, True))
    checks.finish()


if __name__ == "__main__":
    main()
