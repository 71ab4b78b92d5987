# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures of chapter 5 have in common: look, and files."""

import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9, "axes.titlelocation": "left",
    "axes.grid": True, "grid.alpha": 0.25, "grid.linewidth": 0.6,
    "axes.axisbelow": True, "axes.spines.top": False,
    "axes.spines.right": False, "legend.frameon": False,
    "legend.fontsize": 8, "lines.linewidth": 1.6, "pdf.fonttype": 42,
    "savefig.dpi": 150, "figure.constrained_layout.use": True,
})

# Okabe & Ito: told apart with any colour vision; markers differ as well.
BLUE, VERMILLION, GREEN, GREY, ORANGE = (
    "#0072B2", "#D55E00", "#009E73", "#666666", "#E69F00")
S1 = {"color": BLUE, "marker": "o", "label": "$P(S_1)$"}
FLOOD = {"color": VERMILLION, "marker": "s", "label": "$P(F)$"}
GIVEN = {"color": GREEN, "marker": "D", "label": "$P(F|S_1)$"}
# Hollow, so that our own marker shows inside.
THESIS = {"color": "black", "marker": "*", "markersize": 13,
          "markerfacecolor": "none", "markeredgewidth": 1.0,
          "linestyle": "none", "label": "printed in the thesis", "zorder": 5}


def sequence(n):
    """n colours from light to dark, for ordered values."""
    return plt.get_cmap("viridis_r")(np.linspace(0.12, 0.98, max(n, 2)))[:n]


def number(x):
    """Short text of a number for a CSV file; empty if there is none."""
    if isinstance(x, (str, int, np.integer)):
        return str(x)
    return "" if x is None or np.isnan(x) else f"{x:.6g}"


class FigureFiles:
    """Writes PNG, PDF and CSV of each figure into a folder."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)
        self.written = []

    def path(self, name):
        return os.path.join(self.folder, name)

    def save(self, figure, name, stores, columns, rows, notes=()):
        """@param stores whose numbers the figure shows; @param rows of the
        CSV; @param notes more comment lines for its head."""
        for ending in (".png", ".pdf"):
            # No date in the file: the same store gives the same bytes.
            metadata = {"CreationDate": None} if ending == ".pdf" else None
            figure.savefig(self.path(name + ending), metadata=metadata,
                           bbox_inches="tight")
        plt.close(figure)
        with open(self.path(name + ".csv"), "w", encoding="utf-8",
                  newline="") as file:
            for line in [store.describe() for store in stores] + list(notes):
                file.write(f"# {line}\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(columns)
            writer.writerows([number(x) for x in row] for row in rows)
        self.written.append(name)
        print(f"{self.path(name)}.png, .pdf, .csv")


def panels(n, height=3.0, width=7.2, **options):
    """A figure with n panels side by side, lettered as in the thesis."""
    figure, axes = plt.subplots(1, n, figsize=(width, height), **options)
    axes = np.atleast_1d(axes)
    for letter, panel in zip("abc", axes):
        panel.set_title(f"({letter})")
    return figure, axes


def stores_of(scenarios):
    """Each store once."""
    return list(dict.fromkeys(scenario.store for scenario in scenarios))
