#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and data of the slide under water of doc/verification/pore_water.md: water in
the ground and outside, and half the weight under half the gravity.

    /usr/bin/python3 contrib/verification/submerged_slide.py [--set ...]
"""

from common import plt, save
from dyke_runs import workspace, write_csv
from slide_measures import BUOYANT, CASE, reach

TIMES = (0, 1, 2, 3, 4, 5, 6, 7, 8)


def main():
    figure, axes = plt.subplots()
    with workspace(__doc__) as work:
        runs = {name: work.run(name, CASE, settings) for name, settings in
                (("water", {}), ("buoyant weight", BUOYANT))}
        rows = []
        for time in TIMES:
            numbers = [reach(run.points(time)) for run in runs.values()]
            rows.append((time, *numbers[0], *numbers[1]))
            print("| %g s | %.2f m | %.2f m | %.2f m | %.2f m |" % rows[-1],
                  flush=True)
        for (name, run), colour in zip(runs.items(), ("C0", "C1")):
            x = run.points()["position"]
            size = 3.0 if name == "water" else 0.8
            axes.plot(x[:, 0], x[:, 1], "s", markersize=size, color=colour,
                      label=name)
    write_csv("pore_water_slide", dict(zip(
        ("time_s", "water_front_m", "water_centre_m", "buoyant_front_m",
         "buoyant_centre_m"), zip(*rows))))
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.legend(markerscale=2)
    save(figure, "pore_water_slide")
    print("front apart by at most %.2f m" % max(
        abs(row[1] - row[3]) for row in rows))


if __name__ == "__main__":
    main()
