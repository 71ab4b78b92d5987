#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/explicit.md: the weak dyke, implicit and
explicit.

    /usr/bin/python3 contrib/verification/explicit.py
"""

import numpy as np
from common import plt, save
from dyke_runs import sampled, workspace, write_csv
import dyke_measures as measures

WIDTH, HEIGHT = "Dyke width W (m)", "Dyke height H (m)"
CASE = "chapter5/dyke_weak.prm"
SCHEMES = {
    "implicit": {},
    "explicit": {"Time stepping/Scheme": "explicit"},
    "explicit, Courant number 0.25": {"Time stepping/Scheme": "explicit",
                                      "Time stepping/Courant number": 0.25},
}

with workspace(__doc__) as work:
    histories, surfaces, table = {}, {}, []
    for name, changes in SCHEMES.items():
        run = work.run("run", CASE, {"Output/Interval": 0, **changes})
        terms, largest = measures.energy_shares(run)
        histories[name] = sampled(run, [WIDTH, HEIGHT])
        surfaces[name] = run.surface()
        share, distance = measures.surface_agreement(surfaces["implicit"],
                                                     surfaces[name])
        print(f"| {name} | {run['steps']} | "
              f"{run['initial_failure_time']:.3f} | "
              f"{run['flooding_time']:.3f} | {100 * share:.1f} | "
              f"{distance.max():.3f} | "
              f"{100 * largest / terms['potential energy released']:.3f} |",
              flush=True)

times = histories["explicit"][0]
write_csv("explicit", {
    "time_s": times,
    **{f"{quantity[6]}_{name}": np.interp(times, t, columns[quantity])
       for name, key in (("implicit_m", "implicit"), ("explicit_m", "explicit"))
       for t, columns in [histories[key]] for quantity in (WIDTH, HEIGHT)}})
for name in ("implicit", "explicit"):
    write_csv(f"explicit_surface_{name}",
              dict(zip(("x0_m", "y0_m", "x1_m", "y1_m"),
                       surfaces[name].reshape(-1, 4).T)))

figure, (top, bottom) = plt.subplots(2, 1, figsize=(9, 5.6))
for name, line in (("implicit", "-"), ("explicit", "--")):
    t, columns = histories[name]
    top.plot(t, columns[WIDTH], "C0" + line, label=f"width W, {name}")
    top.plot(t, columns[HEIGHT], "C1" + line, label=f"height H, {name}")
    for k, segment in enumerate(surfaces[name]):
        bottom.plot(segment[:, 0], segment[:, 1],
                    {"implicit": "C0", "explicit": "C3"}[name] + line,
                    linewidth=1.5, label=name if k == 0 else None)
top.set_xlabel("time (s)")
top.set_ylabel("(m)")
top.legend()
bottom.plot([0, 30, 15, 5, 0], [0, 0, 5, 5, 0], color="grey", linewidth=0.6)
bottom.set_aspect("equal")
bottom.set_xlabel("x (m)")
bottom.set_ylabel("y (m)")
bottom.set_title("surface at flooding", fontsize=10)
bottom.legend()
figure.tight_layout()
save(figure, "explicit")
