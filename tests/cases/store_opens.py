# SPDX-License-Identifier: LGPL-2.1-or-later
"""A store opens in xarray and in h5py, with all that they need to know.

    store_opens.py UNIT_TESTS     the store of a unit test, values and all
    store_opens.py RESULTS.h5     that of a campaign
"""

import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np
import xarray

PLANE = ("scenario", "realisation")
SPACE = PLANE + ("slide",)
MASSES = PLANE + ("mass",)
MOVED = [f"{first}{way}_{what}" for first in ("", "first_")
         for way in ("inward", "outward") for what in ("area", "dx", "dy")]
PROBABILITIES = ("P_S1", "P_F", "P_F_given_S1", "P_S1_geometry", "P_S1_thesis",
                 "P_S1_displacement", "P_inner_slide", "P_outer_slide",
                 "P_F_given_S1_thesis", "P_F_monotone")
# name: (dimensions, type on the disk, units)
VARIABLES = {
    "scenario_value": (("scenario",), "O", "1"),
    "scenario_hash": (("scenario",), "O", "1"),
    **{name: (("scenario",), "f8", "m")
       for name in ("water_level", "crest_level", "base_level", "scale_x",
                    "scale_y")},
    **{name: (("scenario",), "i8", "1") for name in ("n", "n_S1", "n_F")},
    **{name + end: (("scenario",), "i1" if end == "_kind" else "f8", "1")
       for name in PROBABILITIES for end in ("", "_low", "_high", "_kind")},
    **{name: (PLANE, "i1", "1") for name in (
        "outcome", "failure_class", "still_moving", "loads_change", "at_box")},
    **{name: (PLANE, "i4", "1") for name in (
        "attempts", "n_slides", "n_masses", "n_masses_remnant", "n_masses_side",
        "n_masses_behind_centred", "n_masses_behind_off_centre")},
    **{name: (PLANE, "i8", "1")
       for name in ("steps", "newton_iterations", "linear_iterations",
                    "unconverged_steps", "points_beyond_law")},
    **{name: (PLANE, "f8", "s")
       for name in ("initial_failure_time", "initial_failure_time_thesis",
                    "flooding_time", "end_time", "wall_time", "field_time")},
    **{name: (PLANE, "f8", "m")
       for name in ("initial_width", "initial_height", "residual_width",
                    "residual_height", "width_after_first_slide",
                    "height_after_first_slide")},
    **{name: (PLANE, "f8", "m2" if name.endswith("area") else "m")
       for name in MOVED},
    "initial_failure_time_displacement": (PLANE, "f8", "s"),
    **{f"{slope}_slide_{what}": (PLANE, "f8", units)
       for slope in ("inner", "outer")
       for what, units in (("time", "s"), ("area", "m2"), ("share", "1"),
                           ("crest_cut", "m"))},
    **{name: (PLANE, "f8", "kPa") for name in ("mean_strength", "least_strength")},
    **{name: (SPACE, "f8", "s") for name in ("slide_start", "slide_end")},
    **{name: (SPACE, "f8", "m") for name in ("slide_width", "slide_height")},
    **{name: (PLANE, "f8", "m3") for name in (
        "body_volume", "stable_volume", "first_mass_volume")},
    **{name: (PLANE, "f8", "m") for name in (
        "retrogression_distance", "damaged_crest_width", "first_mass_width",
        "residual_width_z", "residual_height_z")},
    "relative_failure_volume": (PLANE, "f8", "1"),
    "first_mass_time": (PLANE, "f8", "s"),
    "load": (PLANE, "f8", "1"),
    "load_stop_time": (PLANE, "f8", "s"),
    "mass_time": (MASSES, "f8", "s"),
    "mass_volume": (MASSES, "f8", "m3"),
    **{"mass_" + name: (MASSES, "f8", "m") for name in (
        "width", "x", "y", "z", "x_from", "x_to", "z_from", "z_to")},
}
DIMENSIONS = {"scenario": "i4", "realisation": "i8", "slide": "i4",
              "mass": "i4"}
ATTRIBUTES = {
    **{name: str for name in ("Conventions", "title", "version", "compiler",
                              "build_flags", "parameters_hash", "parameters",
                              "swept_parameter")},
    **{name: np.integer
       for name in ("schema_version", "seed", "realisations_planned",
                    "n_truncated_lines", "n_damaged_lines", "n_foreign_lines",
                    "n_repeated_lines", "n_conflicting_lines", "n_surplus")},
    **{name: np.floating
       for name in ("slide_rate", "slide_duration", "slide_minimum_change")},
}
FLAGS = {
    "outcome": "stable initial_failure flooding numerical_failure "
               "still_moving loads_still_change stopped_by_the_box",
    "failure_class": "none initial_only retrogressive horizontal outer "
                     "settled overflow",
    "still_moving": "no yes",
    "loads_change": "no yes",
    "at_box": "no yes",
    **{name + "_kind": "estimate upper_bound lower_bound unknown"
       for name in PROBABILITIES},
}


def check(good, what):
    if not good:
        sys.exit(f"FAILED: {what}")


def check_with_h5py(path):
    with h5py.File(path, "r") as file:
        check(set(file) - {"scale_z"} == set(VARIABLES) | set(DIMENSIONS),
              f"names: {set(file) ^ (set(VARIABLES) | set(DIMENSIONS))}")
        for name, kind in DIMENSIONS.items():
            check(h5py.h5ds.is_scale(file[name].id), f"{name} is no dimension scale")
            check(h5py.h5ds.get_scale_name(file[name].id) == name.encode(),
                  f"name of {name}")
            check(file[name].dtype == kind, f"type of {name}")
        for name, (dimensions, kind, units) in VARIABLES.items():
            data = file[name]
            check(data.dtype == kind, f"type of {name}: {data.dtype}")
            check(data.ndim == len(dimensions), f"dimensions of {name}")
            for axis, dimension in zip(data.dims, dimensions):
                check(axis[0] == file[dimension], f"{dimension} of {name}")
            check(data.attrs["units"] == units, f"units of {name}")
            if data.ndim > 1:
                check(data.compression == "gzip", f"{name} is not compressed")
                fill = data.attrs["_FillValue"]
                check(fill.dtype == kind, f"type of the fill value of {name}")
                check(np.isnan(fill) if kind == "f8" else fill == -1,
                      f"fill value of {name}")
        for name in list(VARIABLES) + list(DIMENSIONS):
            check(file[name].attrs["long_name"], f"long_name of {name}")
        for name, meanings in FLAGS.items():
            attributes = file[name].attrs
            check(attributes["flag_meanings"] == meanings, f"flags of {name}")
            check(attributes["flag_values"].tolist()
                  == list(range(len(meanings.split()))), f"flags of {name}")


def check_with_xarray(path):
    with xarray.open_dataset(path, engine="h5netcdf") as data:
        check(set(data.dims) == set(DIMENSIONS), f"dimensions {data.dims}")
        check(set(data.coords) == set(DIMENSIONS), f"coordinates {data.coords}")
        for name, (dimensions, _, _) in VARIABLES.items():
            check(data[name].dims == dimensions,
                  f"dimensions of {name}: {data[name].dims}")
        for name, kind in ATTRIBUTES.items():
            check(isinstance(data.attrs[name], kind),
                  f"{name} is a {type(data.attrs[name])}")
        check(data.attrs["title"] == "Waker campaign", "title")
        check(data.attrs["schema_version"] == 1, "schema version")
        # Times are numbers, not dates; what was not run is masked.
        check(data["end_time"].dtype == "f8", "end_time is no number")
        check(data["outcome"].min() >= 0, "-1 is not masked")
        not_run = np.isnan(data["outcome"])
        for name, (dimensions, _, _) in VARIABLES.items():
            if dimensions == PLANE:
                check(np.isnan(data[name].where(not_run)).all(),
                      f"{name} of what was not run")
        return data.load()


def check_values(data):
    """The records of tests/unit/store_records.h."""
    check(data["realisation"].values.tolist() == [0, 1, 2, 5, 7], "realisations")
    check(data["scenario_value"].values.tolist() == ["4.5", "3,5 µm"], "texts")
    check(data["scale_x"][0] == 6. and np.isnan(data["scale_x"][1]), "scale_x")
    check(data.attrs["seed"] == 18446744073709551557, "seed")
    check(data.attrs["parameters"] == '# "quoted"\nsubsection Water\nend\n',
          "parameters")
    check(data.attrs["swept_parameter"] == "Water/Level", "swept parameter")
    # Scenario 0 has 4 realisations of which 2 flooded, scenario 1 has 2 of 2.
    check(data["n"].values.tolist() == [4, 2], "n")
    check(data["P_F"].values.tolist() == [0.5, 1.0], "P(F)")
    check(abs(data["P_F_low"].values[0] - 0.06759) < 1e-5, "interval")
    check(data["P_F_kind"].values.tolist() == [0, 2], "kinds")
    # Higher water is not safer: the two levels are pooled.
    check(np.allclose(data["P_F_monotone"], 4 / 6), "monotone")
    run = [(0, 0), (0, 1), (0, 2), (0, 5), (1, 1), (1, 7)]
    check(int((data["outcome"] >= 0).sum()) == len(run), "number of outcomes")
    for k, i in run:
        record = data.sel(scenario=k, realisation=i)
        floods = i % 2 == 1
        check(record["outcome"] == (2 if floods else 0), f"outcome of {k}, {i}")
        check(record["mean_strength"] == 13. + 1. / (3. + i), f"strength of {i}")
        check(record["steps"] == 800 + i, f"steps of {i}")
        check(record["initial_width"] == 18. + k, f"width of {k}, {i}")
        check(np.isnan(record["flooding_time"]) != floods, f"time of {i}")
        check(record["n_slides"] == (2 if floods else 0), f"slides of {i}")


def main():
    source = sys.argv[1]
    if source.endswith(".h5"):
        check_with_h5py(source)
        data = check_with_xarray(source)
    else:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "results.h5")
            subprocess.run(
                [source, "--gtest_filter=Statistics.store_for_other_programs"],
                check=True, stdout=subprocess.DEVNULL,
                env={**os.environ, "WAKER_TEST_STORE": path})
            check_with_h5py(path)
            data = check_with_xarray(path)
            check_values(data)
    print(f"{len(VARIABLES)} quantities, {dict(data.dims)}: read by "
          f"xarray {xarray.__version__} and h5py {h5py.__version__}")


if __name__ == "__main__":
    main()
