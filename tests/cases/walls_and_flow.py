#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls off the grid, inflow and outflow, point loads: the short runs behind
doc/verification/walls.md, flow.md and point_loads.md.

    /usr/bin/python3 tests/cases/walls_and_flow.py WAKER SOURCE_DIR
"""

import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import meshio
import numpy as np
from runs import Check, particles, run, statistics


def check_inclined_wall(check, waker, cases, folder):
    output = os.path.join(folder, "inclined")
    run(waker, os.path.join(cases, "inclined_wall.prm"), output)
    rows = statistics(output)
    along = np.array([2.0, 1.0]) / np.sqrt(5.0)
    exact = 1000.0 / (1.0 - 0.3**2) * 0.001
    force = -sum(rows[f"Wall face {axis} (kN)"][-1] * a
                 for axis, a in zip("xy", along))
    check("inclined wall: force / exact", force / exact, 0.98, 1.005)
    check("  and the corner's against it (kN)",
          abs(rows["Wall corner x (kN)"][-1] + rows["Wall face x (kN)"][-1]),
          0, 1e-6)
    # The files of the walls say the same.
    entries = list(ElementTree.parse(os.path.join(
        output, "walls.pvd")).getroot().iter("DataSet"))
    mesh = meshio.read(os.path.join(output, entries[-1].get("file")))
    data = {key: np.squeeze(value) for key, value in mesh.point_data.items()}
    face = data["wall"] == 1
    check("  pressure of its spots / exact, mean",
          np.average(data["pressure"][face], weights=data["area"][face])
          / exact, 0.98, 1.005)
    check("  spots without soil", np.sum(data["touches"] < 1), 0, 0)


def check_footing(check, waker, cases, folder):
    output = os.path.join(folder, "footing")
    run(waker, os.path.join(cases, "footing.prm"), output,
        Grid={"Cell size": 0.25}, Time_stepping={"Time step": 0.5})
    rows = statistics(output)
    factor = -rows["Wall footing y (kN)"] / (10 * 0.5)
    check("footing, h = 0.25 m: force / (c B) at 10 mm",
          np.interp(10, rows["Time (s)"], factor), 4.4, 5.14)
    check("  at 20 mm", factor[-1], 5.14, 6.4)


def check_flow(check, waker, cases, folder):
    output = os.path.join(folder, "flow")
    run(waker, os.path.join(cases, "flow.prm"), output)
    rows = statistics(output)
    check("flow: largest remainder of mass (Mg)",
          np.abs(rows["Mass remainder (Mg)"]).max(), 0, 1e-12)
    for axis in "xy":
        check(f"flow: largest remainder of momentum along {axis} (kN s)",
              np.abs(rows[f"Momentum remainder {axis} (kN s)"]).max(), 0, 1e-5)
    check("  while the momentum reaches (kN s)",
          rows["Momentum x (kN s)"].max(), 7, 8)
    rate = 0.5 * 18 / 9.81
    check("flow: mass in / (rate x time)",
          rows["Mass in (Mg)"][-1] / (20 * rate), 0.98, 1 + 1e-9)
    late = rows["Time (s)"] > 14
    check("  rate of mass out / in, from 14 s",
          np.polyfit(rows["Time (s)"][late], rows["Mass out (Mg)"][late],
                     1)[0] / rate, 0.98, 1.02)


def check_point_loads(check, waker, cases, folder):
    output = os.path.join(folder, "bar")
    run(waker, os.path.join(cases, "point_load_bar.prm"), output)
    *_, (_, mesh) = particles(output)
    u = mesh.point_data["displacement"][:, 0]
    check("bar: displacement beyond the load / exact, least",
          u[mesh.points[:, 0] > 2.3].min() / 0.00325, 1 - 1e-6, 1 + 1e-6)
    check("  largest", u.max() / 0.00325, 1 - 1e-6, 1 + 1e-6)

    output = os.path.join(folder, "half-space")
    run(waker, os.path.join(cases, "half_space.prm"), output)
    *_, (_, mesh) = particles(output)
    x, y = mesh.points[:, 0], mesh.points[:, 1]
    r = np.hypot(x, y)
    ring = (r > 2) & (r < 4)
    exact = 2 / np.pi * y**3 / r**4
    sigma = np.squeeze(mesh.point_data["stress_yy"])
    check("half-space, 2 to 4 m away: rms error of the vertical stress",
          np.sqrt(np.mean((sigma - exact)[ring]**2)
                  / np.mean(exact[ring]**2)), 0, 0.06)


def main(waker, source):
    check = Check()
    cases = os.path.join(source, "parameters", "chapter3")
    with tempfile.TemporaryDirectory() as folder:
        for part in (check_inclined_wall, check_footing, check_flow,
                     check_point_loads):
            part(check, waker, cases, folder)
    check.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
