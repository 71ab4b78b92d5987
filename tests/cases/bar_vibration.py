#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bar, fixed at one end, in its first mode: frequency, energy, and order in
the time step (doc/verification/bar.md).

    /usr/bin/python3 tests/cases/bar_vibration.py WAKER SOURCE_DIR
"""

import os
import sys
import tempfile

import numpy as np
from runs import Check, run, statistics

LENGTH, SPEED, VELOCITY = 25.0, 10.0, 0.1  # m, m/s, m/s
OMEGA = 0.5 * np.pi * SPEED / LENGTH       # rad/s, of the first mode
AMPLITUDE = 2.0 / np.pi * VELOCITY         # of the centre of mass, m/s


def predicted_error(h, dt):
    """Relative error of the frequency with linear functions and two points per
    cell: the mesh's share of (kh)^2/24, that of the way from nodes to points and
    back, 3/32 (kh)^2, and Newmark's."""
    kh = 0.5 * np.pi * h / LENGTH
    return -kh**2 * (1 / 24 + 3 / 32) - (OMEGA * dt)**2 / 12


def predicted_loss(h, dt, time):
    """Share of the energy that mapping takes, as above: points get N a, so that
    nodes get 1 - 3/16 (kh)^2 of their acceleration back."""
    kh = 0.5 * np.pi * h / LENGTH
    return 3 / 64 * kh**2 * OMEGA**2 * dt * time


def fitted_frequency(time, velocity):
    """Of the best fit of a cosine and a sine, rad/s, and its amplitude."""
    def fit(omega):
        waves = np.column_stack((np.cos(omega * time), np.sin(omega * time)))
        factors = np.linalg.lstsq(waves, velocity, rcond=None)[0]
        return np.sum((velocity - waves @ factors)**2), np.hypot(*factors)

    low, high, golden = 0.97 * OMEGA, 1.03 * OMEGA, (5**0.5 - 1) / 2
    while high - low > 1e-9:
        a, b = high - golden * (high - low), low + golden * (high - low)
        if fit(a)[0] < fit(b)[0]:
            high = b
        else:
            low = a
    return low, fit(low)[1]


class Vibration:
    """A run of bar_13.prm or bar_25.prm, and what it came to."""

    def __init__(self, waker, source, cells, folder, **sections):
        case = os.path.join(source, "parameters", "verification",
                            f"bar_{cells}.prm")
        sections.setdefault("Output", {})["Interval"] = 0
        run(waker, case, folder, **sections)
        rows = statistics(folder)
        # Kinetic energy at the start: half the mass times half of v0^2.
        mass = 4 * rows["Kinetic energy (kJ)"][0] / VELOCITY**2
        self.time = rows["Time (s)"]
        self.velocity = rows["Momentum x (kN s)"] / mass
        energy = rows["Kinetic energy (kJ)"] + rows["Elastic energy (kJ)"]
        self.energy = energy / energy[0]
        self.loss = rows["Mapping loss (kJ)"][-1] / energy[0]
        frequency, self.amplitude = fitted_frequency(self.time, self.velocity)
        self.error = frequency / OMEGA - 1

    def at(self, times):
        """Velocity of the centre of mass at times that are steps."""
        steps = np.searchsorted(self.time, times - 1e-6)
        assert np.allclose(self.time[steps], times, atol=1e-6)
        return self.velocity[steps]


def self_convergence(waker, source, folder, time_steps, **sections):
    """Root mean square differences of the velocity of the centre of mass over
    two periods between each time step and the next, 25 cells (m/s)."""
    times = np.arange(0.0, 20.01, 0.4)
    velocities = [
        Vibration(waker, source, 25, folder,
                  Time_stepping={"Time step": dt, "End time": 20},
                  **sections).at(times) for dt in time_steps]
    return np.array([np.sqrt(np.mean((a - b)**2))
                     for a, b in zip(velocities, velocities[1:])])


def main(waker, source):
    check = Check()
    with tempfile.TemporaryDirectory() as folder:
        for cells, limit in ((13, 0.003), (25, 0.001)):
            bar = Vibration(waker, source, cells, folder)
            check(f"{cells} cells: error of the frequency", bar.error, -limit,
                  limit)
            check(f"{cells} cells: amplitude / exact",
                  bar.amplitude / AMPLITUDE, 0.998, 1.002)
            check(f"{cells} cells: lowest energy in 100 s / at the start",
                  bar.energy.min(), 0.998, 1.0005)

            dt = 0.05
            bar = Vibration(waker, source, cells, folder,
                            Kinematics_and_mapping={"Functions": "linear"},
                            Time_stepping={"Time step": dt})
            h = LENGTH / cells
            expected = predicted_error(h, dt)
            check(f"{cells} cells, linear functions: error of the frequency",
                  bar.error, expected - 1e-4, expected + 1e-4)
            expected = predicted_loss(h, dt, 100)
            check(f"{cells} cells, linear functions: energy lost by mapping",
                  bar.loss, 0.95 * expected, 1.05 * expected)

        differences = self_convergence(waker, source, folder,
                                       (0.2, 0.1, 0.05, 0.025))
        for ratio in differences[:-1] / differences[1:]:
            check("differences for dt and dt/2: ratio (second order: 4)", ratio,
                  3.7, 4.3)
    check.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
