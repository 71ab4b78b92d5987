#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, data and figure of the seeping slopes in doc/verification/pore_water.md; runs
the program.

    /usr/bin/python3 contrib/verification/seeping_slope.py [--cells 1,0.5]
        [--factors 1] [--waker build/bin/waker]

A minute; factors of safety are computed on the cells of --factors alone.
"""

from common import plt, save
from dyke_runs import draw_points, option, workspace, write_csv
from seepage_measures import (AT_START, BUOYANT, HYDROSTATIC, KINKED, LONG,
                              closed_form, difference, mobilised)


def main():
    cells = [float(cell) for cell in option("--cells", "1,0.5").split(",")]
    of_factors = [float(cell) for cell in option("--factors", "1").split(",")]
    with workspace(__doc__) as work:
        rows = []
        for cell in cells:
            sets = {"Grid/Cell size": cell}
            water = work.run(f"water-{cell}", KINKED, {**sets, **AT_START})
            light = work.run(f"light-{cell}", KINKED,
                             {**sets, **BUOYANT, **AT_START})
            sets["Time stepping/Time step"] = 0.02 * cell
            factors = [float("nan")] * 2
            if cell in of_factors:
                factors = [
                    work.factor_of_safety(f"{name}-factor-{cell}", KINKED,
                                          {**sets, **more})["factor_of_safety"]
                    for name, more in (("water", {}), ("light", BUOYANT))]
            rows.append((cell, difference(water, light), difference(water, light, 1.5),
                         *factors))
            print("| %g m | %.3f %% | %.4f %% | %.3f | %.3f |"
                  % (cell, *(100 * r for r in rows[-1][1:3]), *factors), flush=True)
        write_csv("pore_water_seeping",
                  dict(zip(("cell_m", "rms", "rms_below_1.5_m", "factor_pore_water",
                            "factor_buoyant"), zip(*rows))))
        for name, sets, is_parallel in (("along", {}, True), ("x", HYDROSTATIC, False)):
            print("| %s | %.4f | %.4f |"
                  % (name, mobilised(work.run(name, LONG, sets)),
                     closed_form(is_parallel)), flush=True)
        figure, panels = plt.subplots(2, 1, figsize=(7.0, 5.0), sharex=True)
        for axes, run, name in zip(panels, (water, light),
                                   ("pore water", "buoyant weight, seepage force")):
            points = run.points(0.0)
            draw_points(axes, points, points["stress_xy"], label="σ_xy (kPa)", s=9,
                        cmap="viridis", vmin=0, vmax=40)
            axes.set_ylim(-0.5, 11)
            axes.set_title(name, fontsize=9)
        panels[1].set_xlabel("x (m)")
        save(figure, "pore_water_seeping")


if __name__ == "__main__":
    main()
