# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 5.5 and 5.11: typical realisations, chosen by outcome and computed
again with `waker run --realisation`."""

import json
import os
import subprocess
import sys

import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import figure_files as look
import store as campaign
from plot_state import read_parameters, read_series, squares, water_reach

MOVED = 0.5  # m, horizontally: soil that has slid
# Lowest soil that has slid, as height above the base (m).
ALONG_BASE, ABOVE_BASE = 0.75, 1.0
MAXIMUM_TRIALS = 40  # runs until one fits


class Runner:
    """Computes realisations again, each once: folders runs/<analysis>-s-i."""

    def __init__(self, waker, folder):
        self.waker, self.folder = waker, folder

    def folder_of(self, scenario, number):
        # The hash in the name: another campaign does not find old runs.
        hash_ = scenario.store.attribute("parameters_hash")[:8]
        return os.path.join(self.folder,
                            f"{hash_}-{scenario.index}-{number}")

    def run(self, scenario, number):
        """Folder of the run of one realisation."""
        folder = self.folder_of(scenario, number)
        if os.path.exists(os.path.join(folder, "summary.json")):
            return folder
        command = [self.waker, "run",
                   os.path.join(scenario.store.folder, "parameters.prm"),
                   "--realisation", str(number), "--overwrite",
                   "--set", "Output/Directory=" + folder,
                   "--set", "Output/Interval=0"]
        if scenario.store.attribute("swept_parameter"):
            command += ["--scenario", str(scenario.index)]
        environment = dict(os.environ, OMPI_MCA_ess_singleton_isolated="1")
        done = subprocess.run(command, env=environment, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            sys.exit(" ".join(command) + "\n" + done.stdout)
        self.compare(scenario, number, folder)
        return folder

    @staticmethod
    def compare(scenario, number, folder):
        """Another version of the program may make other fields."""
        with open(os.path.join(folder, "summary.json"),
                  encoding="utf-8") as file:
            summary = json.load(file)
        where = int(np.flatnonzero(scenario.realisation == number)[0])
        stored = (campaign.OUTCOMES[scenario["outcome"][where]],
                  float(scenario["residual_width"][where]))
        again = summary["outcome"], summary["residual_width"]
        if stored[0] != again[0] or abs(stored[1] - again[1]) > 0.01:
            print(f"warning: realisation {number} is not the one of the "
                  f"campaign (outcome, W_r: {stored}, now {again}); is this "
                  "the program that made the campaign?", file=sys.stderr)


def final_points(folder):
    return meshio.read(read_series(folder, "particles")[-1][1])


def initiation_height(folder):
    """Height above the base (m) of the lowest soil that has slid: of its 2 %
    lowest points, where they were at first. NaN if none has."""
    points = final_points(folder)
    displacement = points.point_data["displacement"][:, :2]
    at_first = points.points[:, :2] - displacement
    slid = np.abs(displacement[:, 0]) > MOVED
    if not slid.any():
        return np.nan
    return float(np.quantile(at_first[slid, 1], 0.02) - at_first[:, 1].min())


def candidates(scenario, *conditions):
    """Numbers of the realisations that meet the first of the conditions that
    any meets, lowest first."""
    for condition in conditions:
        if condition.any():
            return scenario.realisation[condition]
    return np.array([], dtype=int)


def choose(scenario, runner):
    """[(letter, words, realisation number or None), ...] of figure 5.5. Each is
    the lowest number that meets the rule; see doc/results/README.md."""
    outcome, kind = scenario["outcome"], scenario["failure_class"]
    slides = scenario["n_slides"]
    stands = outcome == campaign.INITIAL_FAILURE
    floods = outcome == campaign.FLOODING
    retrogressive = kind == campaign.RETROGRESSIVE
    small = scenario["residual_width"] >= 0.5 * scenario["initial_width"]
    damaged = (scenario["residual_height"] - scenario.water_level
               < 0.8 * scenario.freeboard)

    def first(numbers):
        return int(numbers[0]) if len(numbers) else None

    def by_height(fits):
        once = stands & (kind == campaign.INITIAL_ONLY)
        numbers = candidates(scenario, once & small, once)
        for number in numbers[:MAXIMUM_TRIALS]:
            if fits(initiation_height(runner.run(scenario, number))):
                return int(number)
        return None

    return [
        ("a", "no initial failure",
         first(candidates(scenario, outcome == campaign.STABLE))),
        ("b", "initial failure through a weak zone above the foundation",
         by_height(lambda height: height >= ABOVE_BASE)),
        ("c", "initial failure along the foundation",
         by_height(lambda height: height <= ALONG_BASE)),
        ("d", "retrogressive failure without flooding",
         first(candidates(scenario, retrogressive & stands & damaged,
                          retrogressive & stands))),
        ("e", "retrogressive failure with flooding",
         first(candidates(scenario, retrogressive & floods & (slides >= 3),
                          retrogressive & floods))),
        ("f", "initial failure and horizontal slide, with flooding",
         first(candidates(scenario,
                          (kind == campaign.HORIZONTAL) & floods))),
    ]


def choose_outer(scenarios):
    """(scenario, number) of figure 5.11: outer slope, lowest water that has
    one; otherwise (None, None)."""
    for scenario in sorted(scenarios, key=lambda s: s.water_level):
        numbers = candidates(scenario,
                             (scenario["failure_class"] == campaign.OUTER)
                             & scenario.counted)
        if len(numbers):
            return scenario, int(numbers[0])
    return None, None


def draw(axes, folder, water_level, limits):
    """The last state of a run: points coloured by strength, detected surface
    red, base black, water. Returns the collection for a colour bar."""
    time, _ = read_series(folder, "particles")[-1]
    points = final_points(folder)
    position = points.points[:, :2]
    sides = np.sqrt(points.point_data["volume"])
    parameters = read_parameters(folder)
    base = (position[:, 1] - points.point_data["displacement"][:, 1]).min()
    if "Grid/Lower corner" in parameters:
        base = float(parameters["Grid/Lower corner"].split(",")[1])
    x_min, x_max = -3.0, max(36.0, position[:, 0].max() + 1.0)

    segments = np.empty((0, 2, 2))
    for surface_time, path in read_series(folder, "surface"):
        if abs(surface_time - time) < 1e-6:
            surface = meshio.read(path)
            lines = surface.get_cells_type("line")
            chain = np.ravel(surface.point_data["chain"])[lines[:, 0]]
            segments = surface.points[:, :2][lines][chain >= 0]
            chain = chain[chain >= 0]
    reach = (water_reach(segments, water_level, "left") if len(segments)
             else position[position[:, 1].argmax(), 0])
    axes.fill_between([x_min, reach], base, water_level, color="lightblue",
                      linewidth=0, zorder=0)
    axes.plot([x_min, reach], [water_level] * 2, color="steelblue",
              linewidth=0.8, zorder=0.1)
    if len(segments):
        for number in np.unique(chain):  # no water inside the body
            axes.fill(*segments[chain == number][:, 0].T, color="white",
                      linewidth=0, zorder=0.5)
        axes.add_collection(LineCollection(segments, colors="red",
                                           linewidths=0.8, zorder=2))
    # A little larger than their volume: no specks where soil is stretched.
    collection = PolyCollection(squares(position, 1.3 * sides), cmap="viridis",
                                linewidths=0, antialiaseds=False, zorder=1,
                                rasterized=True)
    collection.set_array(points.point_data["undrained_shear_strength"])
    collection.set_clim(*limits)
    axes.add_collection(collection)
    axes.plot([x_min, x_max], [base, base], color="black", linewidth=1.6,
              zorder=3)
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(base - 0.2, base + 5.6)
    axes.set_aspect("equal")
    axes.grid(False)
    return collection


def strength_limits(folders):
    """Colour limits (kPa) that hold for all of them."""
    values = np.concatenate([
        final_points(folder).point_data["undrained_shear_strength"].ravel()
        for folder in folders])
    return np.floor(np.quantile(values, 0.01)), np.ceil(
        np.quantile(values, 0.99))


COLUMNS = ["panel", "what", "scenario", "realisation", "outcome", "class",
           "n_slides", "initial_failure_time_s", "flooding_time_s",
           "residual_width_m", "residual_height_m", "initiation_height_m"]


def facts(letter, words, scenario, number, folder):
    where = int(np.flatnonzero(scenario.realisation == number)[0])
    get = lambda name: scenario[name][where]
    return [letter, words, scenario.index, number,
            campaign.OUTCOMES[int(get("outcome"))],
            campaign.CLASSES[int(get("failure_class"))], int(get("n_slides")),
            get("initial_failure_time"), get("flooding_time"),
            get("residual_width"), get("residual_height"),
            initiation_height(folder)]


def figure_5_5(files, base, runner):
    """Returns what could not be shown."""
    chosen = choose(base, runner)
    shown = [(letter, words, number, runner.run(base, number))
             for letter, words, number in chosen if number is not None]
    missing = [f"({letter}) {words}: no realisation fits"
               for letter, words, number in chosen if number is None]
    if shown:
        limits = strength_limits([folder for *_, folder in shown])
        n_rows = (len(shown) + 1) // 2
        figure, axes = plt.subplots(n_rows, 2, squeeze=False,
                                    figsize=(10.0, 1.25 * n_rows + 0.3))
        for panel in axes.ravel()[len(shown):]:
            panel.set_axis_off()
        rows = []
        for panel, (letter, words, number, folder) in zip(axes.ravel(), shown):
            collection = draw(panel, folder, base.water_level, limits)
            panel.set_title(f"({letter}) {words}: no. {number}", fontsize=8)
            rows.append(facts(letter, words, base, number, folder))
        for panel in axes[:, 0]:
            panel.set_ylabel("y (m)")
        for panel in axes[-1]:
            panel.set_xlabel("x (m)")
        figure.colorbar(collection, ax=axes, shrink=0.8, pad=0.01,
                        label="undrained shear strength (kPa)")
        files.save(figure, "figure_5_05", [base.store], COLUMNS, rows, missing)
    return "; ".join(missing) or None


def figure_5_11(files, scenarios, runner):
    scenario, number = choose_outer(scenarios)
    if scenario is None:
        return "no failure of the outer slope"
    folder = runner.run(scenario, number)
    figure, panel = plt.subplots(figsize=(7.2, 1.9))
    collection = draw(panel, folder, scenario.water_level,
                      strength_limits([folder]))
    panel.set_title(f"$H_i-h$ = {scenario.freeboard:g} m: no. {number}",
                    fontsize=8)
    panel.set_xlabel("x (m)")
    panel.set_ylabel("y (m)")
    figure.colorbar(collection, ax=panel, pad=0.01,
                    label="undrained shear\nstrength (kPa)")
    files.save(figure, "figure_5_11", [scenario.store], COLUMNS,
               [facts("", "failure of the outer slope", scenario, number,
                      folder)])
    return None
