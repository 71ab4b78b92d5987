# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a run, for the scripts that draw it: series, parameters, and what
a field of the particles means. Needs numpy only."""

import os
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

COMPONENTS = "xyz"
# Below it a number of single precision is not what was computed any more.
SMALLEST = 1e-30


def read_series(run, name):
    """[(time, path), ...] of RUN/<name>.pvd; empty if there is none."""
    path = os.path.join(run, name + ".pvd")
    if not os.path.exists(path):
        return []
    entries = ElementTree.parse(path).getroot().iter("DataSet")
    return [
        (float(entry.get("timestep")), os.path.join(run, entry.get("file")))
        for entry in entries
    ]


def read_parameters(run):
    """{"Water/Level": "4.75", ...} of RUN/parameters.prm."""
    path = os.path.join(run, "parameters.prm")
    values, sections = {}, []
    if not os.path.exists(path):
        return values
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if line.startswith("subsection "):
                sections.append(line[len("subsection "):].strip())
            elif line == "end":
                sections.pop()
            else:
                match = re.match(r"set\s+(.*?)\s*=\s*(.*)$", line)
                if match:
                    values["/".join(sections + [match[1]])] = match[2].strip()
    return values


def numbers(text):
    return [float(part) for part in text.split(",")]


def names_of(parameters, field):
    """What the whole numbers of a field stand for; [] if nothing."""
    lists = {"material": "Materials/Names", "wall": "Walls/Names",
             "number": "Tractions/Names"}
    text = parameters.get(lists.get(field, ""), "")
    return [name.strip() for name in text.split(",") if name.strip()]


def choices(point_data):
    """Everything that can be drawn: fields, and the components of vectors."""
    result = []
    for name, values in sorted(point_data.items()):
        result.append(name)
        if np.ndim(values) == 2 and np.shape(values)[1] > 1:
            result += [f"{name}_{c}" for c in COMPONENTS]
    return result


class Field:
    """What is drawn of a field: `values`, one per point; `label`; `names`, a list
    [(number, name), ...] of a field of whole numbers that has names, else None;
    `low` and `high`, the limits of the colours: those of the data."""

    def __init__(self, point_data, choice, parameters, units=None):
        """choice: a field's name (of a vector: its size), or with "_x", "_y",
        "_z" one component of a vector.
        Raises KeyError if there is no such field."""
        name, component = choice, None
        if name not in point_data and choice[-2:-1] == "_" \
                and choice[-1] in COMPONENTS:
            name, component = choice[:-2], COMPONENTS.index(choice[-1])
        values = np.asarray(point_data[name])
        is_vector = values.ndim == 2 and values.shape[1] > 1
        if component is not None and not is_vector:
            raise KeyError(choice)
        self.label = name.replace("_", " ")
        if is_vector and component is None:
            values = np.linalg.norm(values.astype(float), axis=1)
            self.label += ", size"
        elif is_vector:
            values = values[:, component]
            self.label += f", {COMPONENTS[component]}"
        self.values = values.ravel().astype(float)
        unit = (units or {}).get(name)
        if unit:
            self.label += f" ({unit})"

        names = names_of(parameters, name)
        self.names = None
        if names:
            present = np.unique(self.values).astype(int)
            self.names = [(k, names[k] if 0 <= k < len(names) else str(k))
                          for k in present]
        finite = self.values[np.isfinite(self.values)]
        self.low, self.high = (finite.min(), finite.max()) if finite.size \
            else (0.0, 0.0)
        if max(abs(self.low), abs(self.high)) < SMALLEST:
            self.low = self.high = 0.0
        if self.low == self.high:
            # One value: a range around it, so that the bar shows which.
            margin = 0.05 * abs(self.low) or 1.0
            self.low, self.high = self.low - margin, self.high + margin


def read_units(path):
    """{field: unit} of a .vtu file. (meshio does not hand them on.)"""
    units = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("<DataArray") and " units=" in line:
                tag = ElementTree.fromstring(line.rstrip()[:-1] + "/>")
                if tag.get("Name"):
                    units[tag.get("Name")] = tag.get("units")
    return units
