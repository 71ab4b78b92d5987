#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/proximity_field.md, from
doc/verification/data/proximity_field.csv, which a unit test writes:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter=Surface.flat_face_has_no_mean_offset
    /usr/bin/python3 contrib/verification/proximity_field.py
"""

import numpy as np
from common import plt, read_csv, save

data = {key: np.array(values)
        for key, values in read_csv("proximity_field").items()}
figure, axes = plt.subplots()
print("radius  mean offset  furthest inward  furthest outward  (cells)")
for colour, radius in zip(("C3", "C0", "C1", "C2"),
                          np.unique(data["radius_h"])):
    rows = data["radius_h"] == radius
    offset = data["offset_h"][rows]
    mean, inward, outward = (data[key][rows]
                             for key in ("mean_h", "inward_h", "outward_h"))
    overall = np.average(mean, weights=data["crossings"][rows])
    print(f"{radius:6g}  {overall:11.6f}  {inward.min():15.4f}  "
          f"{outward.max():16.4f}")
    axes.fill_between(offset, inward, outward, color=colour, alpha=0.25,
                      linewidth=0)
    axes.plot(offset, mean, color=colour, label=f"a = {radius:g} h")
axes.axhline(0.0, color="black", linewidth=0.8)
axes.set_xlim(0.0, 1.0)
axes.set_xlabel("height of the face in its cell (h)")
axes.set_ylabel("detected minus true height (h)")
axes.legend(ncol=4, loc="upper center")
axes.set_ylim(-0.17, 0.19)
axes.set_title("Flat face, 2 x 2 points per cell: mean over all horizontal "
               "offsets, and range", fontsize=10)
save(figure, "proximity_field")
