#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure, data and numbers of the walls in doc/verification/mohr_coulomb.md; runs the
program for two minutes.

    /usr/bin/python3 contrib/verification/earth_pressure.py [--waker build/bin/waker]
"""

import numpy as np
from common import plt, save
from dyke_runs import workspace, write_csv
from friction_measures import WALLS, rankine, wall_force

VARIANTS = (  # wall, base, psi, cell (m), points per direction
    ("passive", "smooth", "0", 0.25, 2),
    ("active", "smooth", "0", 0.25, 2),
    ("passive", "fixed", "0", 0.25, 2),
    ("passive", "fixed", "0", 0.125, 2),
    ("passive", "fixed", "friction_angle", 0.25, 2),
    ("passive", "fixed", "friction_angle", 0.125, 2),
    ("passive", "fixed", "friction_angle", 0.25, 1),
    ("passive", "fixed", "friction_angle", 0.125, 1))


def main():
    figure, axes = plt.subplots(1, 2)
    rows = []
    with workspace(__doc__) as work:
        for wall, base, dilatancy, cell, per_direction in VARIANTS:
            case, rate = WALLS[wall]
            run = work.run(f"{wall}-{base}-{dilatancy}-{cell}-{per_direction}", case, {
                "Boundary conditions/base/Type":
                    "roller" if base == "smooth" else "fixed",
                "Materials/soil/Dilatancy angle": dilatancy,
                "Grid/Cell size": cell,
                "Material points/Points per direction": per_direction})
            force = wall_force(run, rate)
            rows.append((wall, base, "phi" if dilatancy != "0" else "0", cell,
                         per_direction, force[-1], force[-1] / rankine(wall) - 1.0))
            print("| %s | %s | ψ = %s | %g m | %d | %.2f | %+.2f %% |"
                  % (*rows[-1][:6], 100 * rows[-1][6]), flush=True)
            ax = axes[0 if wall == "passive" else 1]
            ax.plot(1e3 * abs(rate) * run.statistics["Time (s)"][1:], force,
                    label=f"{base} base, ψ = {rows[-1][2]}, h = {cell:g} m, "
                          f"{per_direction**2} a cell")
    for ax, wall in zip(axes, ("passive", "active")):
        ax.axhline(rankine(wall), color="grey", linewidth=0.8)
        ax.set_title(wall, loc="left", fontsize=9)
        ax.set_xlabel("wall moved (mm)")
    axes[0].set_ylabel("force on the wall (kN/m)")
    axes[0].set_ylim(0, 1.4 * rankine("passive"))
    axes[0].legend(fontsize=6)
    save(figure, "mohr_coulomb_walls")
    write_csv("mohr_coulomb_walls",
              dict(zip(("wall", "base", "dilatancy", "cell_m", "points_per_direction",
                        "force_kn_per_m", "over_rankine"), zip(*rows))))
    assert np.isfinite([row[5] for row in rows]).all()


if __name__ == "__main__":
    main()
