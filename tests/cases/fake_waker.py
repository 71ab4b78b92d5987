#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stands for `waker run FILE --realisation I` where only the files matter: a
dyke whose soil above a height that depends on I has slid by 1 m."""

import json
import os
import sys

import meshio
import numpy as np

SLID_ABOVE = {6: 1.6}  # m; the others: 0.1 m
# As in chapter5_figures.py: outcome, W_r (m).
RESULTS = {0: ("stable", 11.0), 2: ("initial failure", 14.3),
           5: ("initial failure", 8.2), 6: ("initial failure", 6.2),
           7: ("initial failure", 2.4), 8: ("flooding", 0.0),
           9: ("flooding", 0.0)}


def series(folder, name):
    with open(os.path.join(folder, name + ".pvd"), "w",
              encoding="utf-8") as file:
        file.write('<?xml version="1.0"?><VTKFile type="Collection">'
                   f'<Collection><DataSet timestep="4" file="{name}.vtu"/>'
                   '</Collection></VTKFile>')


def main():
    arguments = sys.argv[1:]
    number = int(arguments[arguments.index("--realisation") + 1])
    folder = next(word.split("=", 1)[1] for word in arguments
                  if word.startswith("Output/Directory="))
    if arguments[0] != "run" or not os.path.exists(arguments[1]):
        sys.exit("usage: run FILE ...")
    os.makedirs(folder, exist_ok=True)
    x, y = np.meshgrid(np.arange(0.25, 30, 0.5), np.arange(0.25, 5, 0.5))
    inside = (y < x) & (y < (30.0 - x) / 3.0)
    at_first = np.column_stack([x[inside], y[inside], 0.0 * y[inside]])
    displacement = np.zeros_like(at_first)
    slid = ((at_first[:, 0] > 12.0)
            & (at_first[:, 1] > SLID_ABOVE.get(number, 0.1)))
    displacement[slid, 0] = 1.0
    meshio.Mesh(at_first + displacement,
                [("vertex", np.arange(len(at_first))[:, None])],
                {"displacement": displacement,
                 "volume": np.full(len(at_first), 0.25),
                 "undrained_shear_strength": 10.0 + np.sin(at_first[:, 0])}
                ).write(os.path.join(folder, "particles.vtu"))
    outline = np.array([[0, 0, 0], [30, 0, 0], [15, 5, 0], [5, 5, 0]], float)
    lines = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
    meshio.Mesh(outline, [("line", lines)], {"chain": np.zeros(4)}).write(
        os.path.join(folder, "surface.vtu"))
    series(folder, "particles")
    series(folder, "surface")
    with open(os.path.join(folder, "summary.json"), "w",
              encoding="utf-8") as file:
        json.dump(dict(zip(("outcome", "residual_width"), RESULTS[number])),
                  file)


if __name__ == "__main__":
    main()
