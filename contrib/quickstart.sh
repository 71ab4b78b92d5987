#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# From a fresh Debian 12 machine to a picture of a failed dyke: installs the
# packages, builds Waker in build/, runs the weak dyke of chapter 5, and a small
# campaign that says how likely failure is. May be run again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case_file=parameters/chapter5/dyke_weak.prm
run=output/dyke_weak

echo "== 1. Packages"
contrib/install_packages.sh
echo "== 2. Build"
contrib/build.sh waker
echo "== 3. Run $case_file"
build/bin/waker run "$case_file" --overwrite --set "Output/Directory=$run"

echo "== 4. What happened"
/usr/bin/python3 - "$run/summary.json" <<'EOF'
import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    s = json.load(file)


def say(time, what):
    print(f"  {'never' if time is None else f'{time:.2f} s':>8}  {what}")


say(0.0, f"the dyke is {s['initial_width']:.2f} m wide at the water level")
say(s["initial_failure_time"], "initial failure")
say(s["flooding_time"], "flooding")
say(s["end_time"], f"end: {s['stop_reason']}")
print(f"Outcome: {s['outcome']}. {s['residual_width']:.2f} m of width and "
      f"{s['residual_height']:.2f} m of height are left.")
print(f"{s['steps']} steps of {s['particles']} material points in "
      f"{s['wall_time']:.1f} s; {s['unconverged_steps']} steps did not "
      "converge.")
EOF

echo "== 5. Picture"
/usr/bin/python3 contrib/plots/plot_state.py "$run" -o "$run/final_state.png"
echo "For ParaView: $run/particles.pvd, surface.pvd, grid.pvd"

echo "== 6. How likely is that? 40 realisations of the base case of chapter 5"
build/bin/waker campaign parameters/chapter5/analysis1.prm --overwrite \
  --set "Campaign/Realisations=40" --set "Output/Directory=output/analysis1"
/usr/bin/python3 contrib/plots/campaign.py output/analysis1
echo "More of them, kill and resume, what the figures say: doc/campaigns.md"
