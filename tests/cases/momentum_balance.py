#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Momentum: its rate is weight + water + reaction of the base, to the tolerance
of the solver; a block at rest and a block in free flight
(doc/verification/momentum.md).

    /usr/bin/python3 tests/cases/momentum_balance.py WAKER SOURCE_DIR
"""

import os
import sys
import tempfile

import numpy as np
from runs import Check, particles, run, statistics

WEIGHT = 1500.0  # kN: 100 m^2 of 15 kN/m^3, the dyke of chapter 5
RAMP = 1.0       # s, that of the case

# The dyke of chapter 5 on a coarse grid, weak enough to flood within 5 s there.
COARSE = {
    "Grid": {"Cell size": 0.5},
    "Materials__clay": {"Initial strength": 8, "Residual strength": 3.08},
    "Time_stepping": {"End time": 5},
    "Output": {"Interval": 0},
}

# A block of 1 x 1 m that the grid does not hold.
BLOCK = """
subsection Grid
  set Lower corner = -2, 0
  set Upper corner = 4, 5
  set Cell size    = 0.5
end
subsection Materials
  set Names = soil
  subsection soil
    set Model           = linear elastic
    set Unit weight     = 20
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
  end
end
subsection Soil profile
  set Layers = block
  subsection block
    set Material = soil
    set Polygon  = 0, BOTTOM; 1, BOTTOM; 1, TOP; 0, TOP
    set Velocity = VELOCITY
  end
end
subsection Water
  set Side = none
end
subsection Stop rules
  set At rest = false
end
"""
ON_A_BASE = """
subsection Boundary conditions
  set Names = base
  subsection base
    set Region = bottom
    set Type   = fixed
  end
end
"""


class Balance:
    """What the `statistics` of a run say about dP/dt = F (kN), by component."""

    def __init__(self, waker, source, folder, explicit=False, **sections):
        case = os.path.join(source, "parameters", "chapter5", "dyke_weak.prm")
        merged = {key: dict(value) for key, value in COARSE.items()}
        for key, value in sections.items():
            merged.setdefault(key, {}).update(value)
        if explicit:
            merged["Time_stepping"]["Scheme"] = "explicit"
        run(waker, case, folder, **merged)
        rows = statistics(folder)
        self.time, dt = rows["Time (s)"], rows["Time step (s)"][1:]
        self.dt = dt
        ramp = np.minimum(1.0, self.time / RAMP)
        self.rate, self.force, self.error = {}, {}, {}
        for axis, weight in (("x", 0.0), ("y", -WEIGHT)):
            momentum = rows[f"Momentum {axis} (kN s)"]
            reaction = rows[f"Reaction {axis} (kN)"]
            water = rows[f"Water force {axis} (kN)"]
            # A step carries the water of the surface on which it began; the
            # reaction in its row is the one on which it ended.
            force = np.zeros_like(momentum)
            force[1:] = ramp[1:] * (weight + water[:-1] + reaction[1:])
            if not explicit:  # Newmark: the mean of both ends of a step
                force[1:] = 0.5 * (force[1:] + force[:-1])
            self.rate[axis] = np.diff(momentum) / dt
            self.force[axis] = force[1:]
            self.error[axis] = np.abs(self.rate[axis] - self.force[axis])
        # The file has ten digits.
        self.round_off = 1e-9 * np.max(
            np.abs(rows["Momentum x (kN s)"])[1:] / dt)

    def largest_error(self):
        """Relative to the weight."""
        return max(np.max(e) for e in self.error.values()) / WEIGHT


SETTINGS = {
    "default tolerance 1e-3": (1e-3, {"Newton": {"Tolerance": 1e-3}}),
    "tolerance 1e-8": (
        1e-8, {"Newton": {"Tolerance": 1e-8, "Linear tolerance": 1e-6}}),
    "tolerance 1e-8, halved steps": (
        1e-8, {"Newton": {"Tolerance": 1e-8, "Linear tolerance": 1e-6,
                          "Maximum iterations": 6},
               "Time_stepping": {"Time step": 0.08}}),
    "explicit": (0.0, {"explicit": True}),
}


def write_block(folder, bottom, velocity, conditions=""):
    path = os.path.join(folder, "block.prm")
    with open(path, "w", encoding="utf-8") as file:
        file.write(BLOCK.replace("BOTTOM", f"{bottom:g}")
                   .replace("TOP", f"{bottom + 1:g}")
                   .replace("VELOCITY", velocity) + conditions)
    return path


def check_block_at_rest(check, waker, folder):
    output = os.path.join(folder, "rest")
    run(waker, write_block(folder, 0, "", ON_A_BASE), output,
        Newton={"Tolerance": 1e-8}, Time_stepping={"End time": 2})
    rows = statistics(output)
    error = np.abs(rows["Reaction y (kN)"][1:] - 20).max() / 20
    # To the ten digits of the file.
    check("block at rest: base reaction / weight - 1, largest", error, 0, 1e-9)
    check("block at rest: reaction along x (kN), largest",
          np.abs(rows["Reaction x (kN)"][1:]).max(), 0, 1e-10)


def check_block_in_flight(check, waker, folder):
    for velocity in ((1.5, 2.0), (-1.0, -0.5), (0.3, 4.0)):
        output = os.path.join(folder, "flight")
        end = 0.6
        run(waker, write_block(folder, 2.6, "%g; %g" % velocity), output,
            Gravity={"Initial stress": "false"},
            Time_stepping={"End time": end, "Ramp duration": 0})
        for time, mesh in particles(output):
            moved = mesh.point_data["displacement"]
            stress = np.abs(mesh.point_data["deviatoric_stress"]).max()
        error = max(np.abs(moved[:, 0] - velocity[0] * time).max(),
                    np.abs(moved[:, 1] - velocity[1] * time +
                           0.5 * 9.81 * time**2).max())
        check(f"free flight, {velocity} m/s: distance from the parabola (m)",
              error, 0, 1e-6)  # the file has single precision
        check("  and its stress (kPa)", stress, 0, 1e-9)


def main(waker, source):
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        for name, (tolerance, sections) in SETTINGS.items():
            balance = Balance(waker, source, folder, **sections)
            check(f"{name}: |dP/dt - F| / weight", balance.largest_error(), 0,
                  tolerance + balance.round_off / WEIGHT)
            check("  while |dP/dt| (kN) reaches",
                  np.abs(balance.rate["x"]).max(), 30, 300)
            if "halved" in name:
                check("  with a shortest step (s) of", balance.dt.min(), 0.001,
                      0.041)
        check_block_at_rest(check, waker, folder)
        check_block_in_flight(check, waker, folder)
    check.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
