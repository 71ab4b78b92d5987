# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a store (results.h5) from given realisations, in the format of `waker
merge`, for tests of what reads it."""

import json
import os

import h5py
import numpy as np

INTEGERS = {"outcome": np.int8, "failure_class": np.int8, "attempts": np.int32,
            "n_slides": np.int32, "steps": np.int64,
            "newton_iterations": np.int64, "linear_iterations": np.int64,
            "unconverged_steps": np.int64}
NUMBERS = {name: unit for unit, names in {
    "s": "initial_failure_time initial_failure_time_thesis flooding_time "
         "end_time wall_time field_time",
    "m": "initial_width initial_height residual_width residual_height "
         "width_after_first_slide height_after_first_slide inward_dx inward_dy "
         "outward_dx outward_dy",
    "m2": "inward_area outward_area", "kPa": "mean_strength least_strength",
}.items() for name in names.split()}


def write_store(folder, scenarios, seed=1, parameters="", swept="",
                parameters_hash="0123456789abcdef", machines=None):
    """@param scenarios dictionaries: value, hash, water_level, scale_x, and
    realisations: {number: {quantity: value}}. What a realisation does not give
    is NaN or -1; crest_level is 5 m, scale_y 0.5 m. A store of an earlier version
    has no machines."""
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "parameters.prm"), "w",
              encoding="utf-8") as file:
        file.write(parameters)
    numbers = sorted({i for s in scenarios for i in s["realisations"]})
    column = {number: i for i, number in enumerate(numbers)}
    shape = (len(scenarios), len(numbers))
    with h5py.File(os.path.join(folder, "results.h5"), "w") as file:
        file.attrs.update({
            "title": "Waker campaign", "schema_version": 1, "version": "0.0.0",
            "compiler": "none", "build_flags": "", "seed": np.uint64(seed),
            "parameters_hash": parameters_hash, "parameters": parameters,
            "swept_parameter": swept, "realisations_planned": len(numbers),
            "n_truncated_lines": 0, "n_foreign_lines": 0, "n_surplus": 0,
            "Conventions": "CF-1.8"})
        if machines is not None:
            file.attrs["machines"] = json.dumps(machines)
        file["scenario"] = np.arange(shape[0], dtype=np.int32)
        file["realisation"] = np.array(numbers, dtype=np.int64)
        for name, default in (("water_level", 4.75), ("crest_level", 5.0),
                              ("scale_x", 24.0), ("scale_y", 0.5)):
            file[name] = [float(s.get(name, default)) for s in scenarios]
        for name, key in (("scenario_value", "value"),
                          ("scenario_hash", "hash")):
            file.create_dataset(name, data=[s.get(key, "") for s in scenarios],
                                dtype=h5py.string_dtype())
        for name, kind in list(INTEGERS.items()) + [(n, float)
                                                    for n in NUMBERS]:
            table = np.full(shape, np.nan if kind is float else -1, dtype=kind)
            for row, scenario in enumerate(scenarios):
                for number, values in scenario["realisations"].items():
                    if name in values:
                        table[row, column[number]] = values[name]
            data = file.create_dataset(name, data=table, chunks=True,
                                       compression=4)
            data.attrs["units"] = NUMBERS.get(name, "1")
            data.attrs["long_name"] = name.replace("_", " ")
