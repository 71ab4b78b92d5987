#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/no_softening.md: the dyke of chapter 5
with strengths that do not soften.

    /usr/bin/python3 contrib/verification/no_softening.py
"""

import numpy as np
from common import plt, save
from dyke_runs import sampled, workspace, write_csv
import dyke_measures as measures

CASE = "verification/dyke_no_softening.prm"
WIDTH = "Dyke width W (m)"

with workspace(__doc__) as work:
    curves, final = {}, None
    print("| c (kPa) | outcome | W at the start, at the end (m) | "
          "initial failure (s) | end (s) |")
    for c in (8.0, 7.6, 7.4, 7.2, 7.0):
        run = work.run("run", CASE,
                       {"Output/Interval": 0, **measures.strength(c, c)})
        curves[c] = (sampled(run, [WIDTH], 0.1), run["initial_width"])
        start = run["initial_failure_time"]
        print(f"| {c} | {run['outcome']} | {run['initial_width']:.2f}, "
              f"{run['residual_width']:.2f} | "
              f"{'none' if start is None else f'{start:.2f}'} | "
              f"{run['end_time']:.2f} |", flush=True)
        final = run.points(), run.surface()
    for cell in (0.5, 0.25):
        result = work.factor_of_safety(
            "fos", CASE, {"Grid/Cell size": cell, **measures.strength(8, 8),
                          "Strength reduction/Lower factor": 0.9,
                          "Strength reduction/Upper factor": 1.3,
                          "Strength reduction/Tolerance": 0.005})
        print(f"h = {cell} m: fails between "
              f"{8 / result['lowest_failed_factor']:.3f} and "
              f"{8 / result['highest_stable_factor']:.3f} kPa; factor of "
              f"safety for 13 kPa "
              f"{13 / 8 * result['factor_of_safety']:.3f}")

longest = max((times for (times, _), _ in curves.values()), key=len)
write_csv("no_softening", {
    "time_s": longest,
    **{f"W_m_c_{c:g}": np.interp(longest, times, columns[WIDTH])
       for c, ((times, columns), _) in curves.items()}})

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.2),
                                     gridspec_kw={"width_ratios": (1, 1.6)})
for c, ((times, columns), initial) in curves.items():
    left.plot(times, columns[WIDTH] - initial, label=f"c = {c:g} kPa")
left.set_xlabel("time (s)")
left.set_ylabel("change of the width W (m)")
left.legend()
points, surface = final
drawn = right.scatter(points["position"][:, 0], points["position"][:, 1],
                      c=points["plastic_strain"], s=1.6, marker="s",
                      linewidths=0, cmap="magma_r", vmax=1.0)
for segment in surface:
    right.plot(segment[:, 0], segment[:, 1], color="red", linewidth=0.8)
right.plot([0, 30, 15, 5, 0], [0, 0, 5, 5, 0], color="grey", linewidth=0.8)
right.set_aspect("equal")
right.grid(False)
right.set_xlabel("x (m)")
right.set_title("c = 7 kPa at rest: plastic strain", fontsize=10)
figure.colorbar(drawn, ax=right, fraction=0.012, pad=0.02)
figure.tight_layout()
save(figure, "no_softening")
