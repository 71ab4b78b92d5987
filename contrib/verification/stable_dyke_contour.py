#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mean dyke at several places on the grid, its water on the proximity field and
on the contour of the support domains: does the outer face stay elastic?

usage: stable_dyke_contour.py [--waker PATH] [--source DIR] [--data FILE.csv]
"""
import argparse
import csv
import glob
import os
import subprocess
import sys
import tempfile

import meshio
import numpy as np

OFFSETS = [0.0, 0.03, 0.08, 0.16, 0.17, 0.18]  # m
CORNERS = [(0, 0), (30, 0), (15, 5), (5, 5)]
LOADS = [("proximity field", 0.01), ("contour", 0.01), ("contour", 0.0)]


def measure(options, folder, offset, placement, method, support):
    """Points that yield within 3 s, largest plastic strain, largest |p| (kPa)."""
    polygon = "; ".join(f"{x + offset}, {y}" for x, y in CORNERS)
    command = [options.waker, "run",
               os.path.join(options.source, "parameters/chapter5/dyke.prm"),
               "--overwrite"]
    for name, value in {"Soil profile/dyke/Polygon": polygon,
                        "Material points/Placement": placement,
                        "Surface/Method": method,
                        "Water/Minimum support": support,
                        "Time stepping/End time": 3, "Output/Interval": 3,
                        "Output/Grid": "false", "Output/Directory": folder}.items():
        command += ["--set", f"{name}={value}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    last = sorted(glob.glob(os.path.join(folder, "solution/particles-*.vtu")))[-1]
    data = meshio.read(last).point_data
    strain = np.asarray(data["plastic_strain"])
    return (int((strain > 1e-6).sum()), float(strain.max()),
            float(np.abs(data["mean_stress"]).max()))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    here = os.path.dirname(os.path.dirname(os.path.dirname(
        os.path.abspath(__file__))))
    parser.add_argument("--source", default=here)
    parser.add_argument("--waker", default=os.path.join(here, "build/bin/waker"))
    parser.add_argument("--data")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [(placement, offset, method, support,
                 *measure(options, os.path.join(folder, "run"), offset,
                          placement, method, support))
                for placement in ("sub-cells", "rows") for offset in OFFSETS
                for method, support in LOADS]
    with open(options.data, "w", encoding="utf-8",
              newline="") if options.data else sys.stdout as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["placement", "offset_m", "method", "minimum_support",
                         "points_that_yield", "largest_plastic_strain",
                         "largest_pressure_kPa"])
        for row in rows:
            writer.writerow([f"{x:.6g}" if isinstance(x, float) else x
                             for x in row])


if __name__ == "__main__":
    main()
