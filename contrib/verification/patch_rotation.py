#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/patch_rotation.md, from data that unit tests
write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Mechanics.*'
    /usr/bin/python3 contrib/verification/patch_rotation.py
"""

from common import plt, read_csv, save

data = read_csv("patch_rotation_90")
angle = data["degrees"]
figure, axes = plt.subplots(1, 2, figsize=(9.5, 3.8))
for axis, parts in ((axes[0], (("xx-yy", "σxx − σyy"), ("xy", "σxy"))),
                    (axes[1], (("mean", "mean stress"),))):
    for (part, label), colour in zip(parts, ("C0", "C2")):
        axis.plot(angle, data[f"exact {part}"], color="0.75", linewidth=5)
        axis.plot(angle, data[f"objective {part}"], color=colour,
                  label=f"{label}, objective rate")
        axis.plot(angle, data[f"small-strain {part}"], color=colour,
                  linestyle="--", label=f"{label}, without")
    axis.set_xlabel("rotation (degrees)")
    axis.set_ylabel("stress of a point (kPa)")
    axis.set_xlim(0, 90)
    axis.set_xticks(range(0, 91, 15))
    axis.legend(fontsize=8)
figure.suptitle("Rigid rotation in 90 steps; grey: exact", fontsize=10)
figure.tight_layout()
save(figure, "patch_rotation")
