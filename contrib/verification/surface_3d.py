#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/surface_3d.md, from the data that unit
tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter=Surface.flat_face_in_3d*:Surface.detected_volume*:Loads.buoyancy_of*
    /usr/bin/python3 contrib/verification/surface_3d.py
"""

import numpy as np
from common import plt, read_csv, save


def table(name):
    return {key: np.array(values) for key, values in read_csv(name).items()}


def orders(h, error):
    return np.log(error[:-1] / error[1:]) / np.log(h[:-1] / h[1:])


flat = table("surface_3d_flat_face")
print("radius  mean offset  furthest inward  furthest outward  (cells)")
for radius in np.unique(flat["radius_h"]):
    rows = flat["radius_h"] == radius
    mean = np.average(flat["mean_h"][rows], weights=flat["crossings"][rows])
    print(f"{radius:6g}  {mean:11.5f}  {flat['inward_h'][rows].min():15.4f}  "
          f"{flat['outward_h'][rows].max():16.4f}")

figure, axes = plt.subplots()
ball = table("surface_3d_ball")
h = 1.0 / ball["cells_per_radius"]
error = -ball["volume_error"]
print("ball: orders", orders(h, error))
axes.errorbar(h, error, yerr=ball["scatter"], fmt="o-", color="C0",
              label="ball of radius 1, 3D")
block = table("surface_3d_block")
for dim, colour, label in ((3, "C3", "turned blocks 1.6 x 1 x 1.3, 3D"),
                           (2, "C1", "turned blocks 1.6 x 1, 2D")):
    rows = block["dim"] == dim
    size, rms = block["h_m"][rows], block["rms"][rows]
    print(f"blocks in {dim}D: rms {rms}, orders", orders(size, rms))
    axes.plot(size, rms, "s-", color=colour, label=label)
axes.plot(h, 0.5 * h**2, "k:", label="second order")
axes.set_xscale("log")
axes.set_yscale("log")
axes.set_xlabel("cell size h (m)")
axes.set_ylabel("volume missing (share)")
axes.legend()
axes.set_title("Detected volume, a = h, 2 points per cell and direction",
               fontsize=10)
save(figure, "surface_3d")
