#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/stable_dyke.md: stress on the outer face
of a dyke that stands, for several strengths, offsets and minimum supports.

    /usr/bin/python3 contrib/verification/stable_dyke.py
"""

from common import plt, save
from dyke_runs import workspace, write_csv
import dyke_measures as measures

CASE = "chapter5/dyke.prm"
SETTINGS = {"Time stepping/End time": 10, "Stop rules/At rest": "false",
            "Output/Interval": 0.5, "Output/Surface": "false"}
SUPPORT = "Water/Minimum support"


def watch(work, shift=0.0, **changes):
    run = work.run("run", CASE, {**SETTINGS, **changes,
                                 **measures.polygon(lambda x: x + shift)})
    return run, measures.FaceHistory(run, shift)


with workspace(__doc__) as work:
    print("| c_i (kPa) | |p| of the face at the start, later | growth | "
          "yield on the face | elsewhere |")
    for c in (13, 11, 10.5, 10.1):
        run, face = watch(work, **measures.strength(c, c / 2.6))
        print(f"| {c} | {face.first:.1f}, {max(face.pressure):.1f} | "
              f"{face.growth:.3f} | {face.yielded} | {face.inside} |",
              flush=True)

    table = {key: [] for key in ("shift_m", "face_start_kPa", "face_kPa",
                                 "inside_kPa", "growth", "yield")}
    print("| shift (m) | |p| of the face at the start, later | growth | "
          "yield on the face |")
    for k in range(13):
        shift = 0.02 * k
        run, face = watch(work, shift)
        for key, value in zip(table, (shift, face.first, max(face.pressure),
                                      face.deepest, face.growth,
                                      face.yielded)):
            table[key].append(value)
        print(f"| {shift:.2f} | {face.first:.1f}, {max(face.pressure):.1f} | "
              f"{face.growth:.3f} | {face.yielded} |", flush=True)
    write_csv("stable_dyke_shifts", table)

    supports = (0.0, 0.01, 0.05, 0.2)
    profiles = {}
    for support in supports:
        work.settings[SUPPORT] = support
        run, face = watch(work, **{"Time stepping/End time": 0.01})
        points = run.points(0.0)
        keep = measures.outer_face(points)
        profiles[support] = (points["position"][keep, 1],
                             points["mean_stress"][keep])
        print(f"minimum support {support}: {profiles[support][1].min():.1f} "
              f"to {face.first:.1f} kPa")

write_csv("stable_dyke", {
    "height_m": profiles[0.01][0],
    **{f"p_kPa_support_{support:g}": values
       for support, (_, values) in profiles.items()}}, 4)

figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
for support, colour in ((0.2, "C1"), (0.05, "C3"), (0.01, "C0")):
    height, values = profiles[support]
    left.plot(values, height, ".", color=colour, markersize=4,
              label=f"minimum support {support:g}")
left.plot([47.5, 0], [0, 4.75], color="black", linewidth=1,
          label="water pressure")
left.set_xlabel("p of the points within 0.5 m of the face (kPa)")
left.set_ylabel("height (m)")
left.legend()
right.plot(table["shift_m"], table["face_start_kPa"], "o-",
           label="outer face, gravity state")
right.plot(table["shift_m"], table["face_kPa"], "x-",
           label="outer face, largest in 10 s")
right.plot(table["shift_m"], table["inside_kPa"], color="black", linewidth=1,
           label="inside the dyke")
right.set_ylim(0, None)
right.set_xlabel("shift of the profile (m); a cell is 0.25 m")
right.set_ylabel("largest |p| (kPa)")
right.legend()
figure.tight_layout()
save(figure, "stable_dyke")
