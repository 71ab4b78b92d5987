# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures of doc/verification have in common."""

import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "doc", "verification", "data")
FIGURES = os.path.join(ROOT, "doc", "verification", "figures")

plt.rcParams.update({
    "figure.figsize": (7.0, 4.0), "figure.dpi": 110, "savefig.dpi": 110,
    "axes.grid": True, "grid.alpha": 0.3, "font.size": 10,
    "legend.frameon": False,
})


def read_csv(name):
    """{column: [numbers]} of doc/verification/data/<name>.csv."""
    with open(os.path.join(DATA, name + ".csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}


def save(figure, name):
    """Write doc/verification/figures/<name>.png."""
    os.makedirs(FIGURES, exist_ok=True)
    path = os.path.join(FIGURES, name + ".png")
    figure.savefig(path, bbox_inches="tight")
    print(os.path.relpath(path, ROOT))
