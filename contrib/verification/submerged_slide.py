#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, figure and data of the slides under water of doc/verification/pore_water.md:
water in the ground and outside, at rest or flowing, and half the weight under half the
gravity. A minute.

    /usr/bin/python3 contrib/verification/submerged_slide.py [--cells 1,0.5] [--set ...]
"""

from common import plt, save
from dyke_runs import option, workspace, write_csv
from slide_measures import BUOYANT, CASE, SEEPAGE, SEEPING, cells, reach

TIMES = (0, 1, 2, 3, 4, 5, 6, 7, 8)
SLIDES = (("at rest", CASE, BUOYANT), ("flowing", SEEPING, SEEPAGE))


def main():
    sizes = [float(cell) for cell in option("--cells", "1,0.5").split(",")]
    figure, panels = plt.subplots(2, 1, figsize=(7.0, 4.4), sharex=True)
    rows = []
    with workspace(__doc__) as work:
        for axes, (name, case, buoyant) in zip(panels, SLIDES):
            for cell in sizes:
                runs = [work.run(f"{name}-{cell}-{number}", case,
                                 {**cells(cell), **settings})
                        for number, settings in enumerate(({}, buoyant))]
                at = [[reach(run.points(time)) for run in runs] for time in TIMES]
                rows += [(name, cell, time, *water, *light)
                         for time, (water, light) in zip(TIMES, at)]
                moved = [at[-1][k][1] - at[0][k][1] for k in (0, 1)]
                print("| %s | %g m | %.2f m | %.2f m | %+.1f %% | %.1f m | %.2f m |"
                      % (name, cell, *moved, 100 * (moved[0] / moved[1] - 1),
                         at[-1][1][0] - at[0][1][0],
                         max(abs(a[0] - b[0]) for a, b in at)), flush=True)
            for run, label, size, colour in zip(
                    runs, ("water", "buoyant weight"), (3.0, 0.8), ("C0", "C1")):
                x = run.points()["position"]
                axes.plot(x[:, 0], x[:, 1], "s", markersize=size, color=colour,
                          label=label)
            axes.set_aspect("equal")
            axes.grid(False)
            axes.set_ylabel(f"water {name}\ny (m)")
    write_csv("pore_water_slide", dict(zip(
        ("water", "cell_m", "time_s", "water_front_m", "water_centre_m",
         "buoyant_front_m", "buoyant_centre_m"), zip(*rows))))
    panels[1].set_xlabel("x (m)")
    panels[0].legend(markerscale=2)
    save(figure, "pore_water_slide")


if __name__ == "__main__":
    main()
