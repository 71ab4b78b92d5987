# SPDX-License-Identifier: LGPL-2.1-or-later
"""Is a campaign one of chapter 5's? What the thesis prints says nothing about
another dyke."""

import sys

from plot_state import read_parameters

# Table 5.1 and section 5.3; what is not here may differ.
CONSTANT = {
    "Materials/clay/Model": "von Mises softening",
    "Materials/clay/Unit weight": 15,
    "Materials/clay/Young's modulus": 1000,
    "Materials/clay/Poisson's ratio": 0.45,
    "Materials/clay/Initial strength": 13,
    "Materials/clay/Residual strength": 5,
    "Materials/clay/Softening modulus": -50,
    "Soil profile/Layers": "dyke",
    "Soil profile/dyke/Polygon": "0, 0; 30, 0; 15, 5; 5, 5",
    "Water/Side": "left",
    "Random fields/Names": "strength",
    "Random fields/strength/Coefficient of variation": 0.2,
    "Random fields/strength/Distribution": "normal",
    "Random fields/strength/Correlation function": "Markov",
    "Grid/Cell size": 0.25,
}
# Of scenarios: analyses that vary them, value of the others.
OF_SCENARIOS = {"water_level": (3, 4.75), "scale_x": (2, 24.0),
                "scale_y": (None, 0.5)}


def plain(value):
    """A text in which lists of equal numbers are equal."""
    parts = str(value).replace(";", " ; ").replace(",", " , ").split()
    words = []
    for part in parts:
        try:
            words.append(f"{float(part):.9g}")
        except ValueError:
            words.append(part)
    return " ".join(words)


def differences(store, analysis):
    """What differs from the thesis, in words: a list, empty if nothing."""
    values = read_parameters(store.folder)
    found = []
    for name, expected in CONSTANT.items():
        value = values.get(name, "not given")
        if plain(value) != plain(expected):
            found.append(f"{name} is {value}, not {expected}")
    for name, (varied_by, expected) in OF_SCENARIOS.items():
        for scenario in store.scenarios:
            value = getattr(scenario, name)
            if analysis != varied_by and not abs(value - expected) <= 1e-9:
                found.append(f"{name} is {value:g}, not {expected:g} m")
                break
    return found


def is_thesis(store, analysis):
    """Whether analysis 1, 2 or 3 is the thesis's. Says so if it is not."""
    found = differences(store, analysis)
    if found:
        print(f"{store.folder}: not a campaign of the thesis ({found[0]}"
              + (f" and {len(found) - 1} more" if len(found) > 1 else "")
              + "): its numbers are left out", file=sys.stderr)
    return not found
