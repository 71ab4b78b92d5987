#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of doc/verification/cam_clay.md; runs the program.

    /usr/bin/python3 contrib/verification/cam_clay.py [--waker build/bin/waker]
"""

import numpy as np
from common import plt, save
from dyke_runs import workspace, write_csv
from cam_clay_measures import (FOOTING, HALF_WIDTH, OEDOMETER, RATE, load,
                               oedometer, virgin_compression)


def compression(work, axes):
    strain, vertical, k0 = oedometer(work.run("oedometer", OEDOMETER)).T
    exact = virgin_compression(strain)
    for row in zip(strain, vertical, exact[:, 0], k0, exact[:, 1]):
        print("| %.2f | %.4f | %.4f | %.4f | %.4f |" % row, flush=True)
    fine = np.linspace(0, strain[-1], 61)
    axes.semilogx(virgin_compression(fine)[:, 0], fine, "k-", linewidth=0.8,
                  label="rates, integrated")
    axes.semilogx(vertical, strain, "o", label="Waker")
    axes.invert_yaxis()
    axes.set_xlabel(r"$\sigma'_v$ (kPa)")
    axes.set_ylabel("vertical strain")
    axes.legend()
    write_csv("cam_clay_oedometer",
              {"strain": strain, "vertical_stress_kPa": vertical,
               "integrated_kPa": exact[:, 0], "k0": k0,
               "integrated_k0": exact[:, 1]})


def footing(work, axes):
    columns = {}
    for h in (0.25, 0.125):
        over = load(work.run(f"footing-{h}", FOOTING,
                             {"Grid/Cell size": h, "Output/Interval": 0}))
        print("| %g m | %.3f | %.3f |"
              % (h, over[-1], over[-1] / (1 + 0.5 * h / HALF_WIDTH)), flush=True)
        settlement = 1000 * RATE * np.arange(1, len(over) + 1)
        axes.plot(settlement, over / (1 + 0.5 * h / HALF_WIDTH), label=f"h = {h:g} m")
        columns.setdefault("settlement_mm", settlement)
        columns[f"load_{h:g}"] = over
    axes.axhline(1.0, color="k", linestyle="--")
    axes.set_xlabel("settlement (mm)")
    axes.set_ylabel(r"load over $(2 + \pi)\,s_u$, half a cell wider")
    axes.legend()
    write_csv("cam_clay_footing", columns)


def main():
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.8))
    with workspace(__doc__) as work:
        compression(work, left)
        footing(work, right)
    figure.tight_layout()
    save(figure, "cam_clay")


if __name__ == "__main__":
    main()
