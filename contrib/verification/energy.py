#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/energy.md: the energy account of the weak
dyke, and what its remainder depends on.

    /usr/bin/python3 contrib/verification/energy.py
"""

import numpy as np
from common import plt, save
from dyke_runs import sampled, workspace, write_csv
import dyke_measures as measures

TERMS = {
    "released": "Potential energy released (kJ)",
    "dissipation": "Plastic dissipation (kJ)",
    "kinetic": "Kinetic energy (kJ)",
    "elastic": "Elastic energy (kJ)",
    "mapping_loss": "Mapping loss (kJ)",
    "water": "Work of the water (kJ)",
    "ramp": "Work withheld by the ramp (kJ)",
    "remainder": "Energy remainder (kJ)",
}

VARIANTS = {
    "as it is": {},
    "dt = 0.005 s": {"Time stepping/Time step": 0.005},
    "dt = 0.0025 s": {"Time stepping/Time step": 0.0025},
    "tolerance 1e-4": {"Newton/Tolerance": 1e-4},
    "tolerance 1e-5": {"Newton/Tolerance": 1e-5},
    "double mapping": {"Newton/Tangent": "double mapping"},
    "no objective rate": {"Kinematics and mapping/Objective rate": "false"},
    "linear functions": {"Kinematics and mapping/Functions": "linear"},
}

with workspace(__doc__) as work:
    base = None
    table = {key: [] for key in ("variant", "released_kJ", "dissipation_kJ",
                                 "mapping_loss_kJ", "ramp_work_kJ",
                                 "water_work_kJ", "remainder_kJ",
                                 "largest_remainder_percent",
                                 "least_dissipation_of_a_step_kJ")}
    for name, changes in VARIANTS.items():
        run = work.run("run", "chapter5/dyke_weak.prm",
                       {"Output/Interval": 0, **changes})
        terms, largest = measures.energy_shares(run)
        if not changes:
            times, base = sampled(run, TERMS.values())
            for key, value in terms.items():
                print(f"  {key}: {value:.3f} kJ/m")
        released = terms["potential energy released"]
        row = (name, released, terms["plastic dissipation"],
               terms["mapping loss"], terms["work withheld by the ramp"],
               terms["work of the water"], terms["remainder"],
               100 * largest / released,
               np.diff(run.statistics["Plastic dissipation (kJ)"]).min())
        for key, value in zip(table, row):
            table[key].append(value)
        print("| " + " | ".join(value if isinstance(value, str)
                                else f"{value:.3g}" for value in row) + " |",
              flush=True)

write_csv("energy", {"time_s": times,
                     **{key + "_kJ": base[name]
                        for key, name in TERMS.items()}})
write_csv("energy_variants", table)

figure, (large, small) = plt.subplots(1, 2, figsize=(9.5, 3.8))
for key, label in (("released", "potential energy released"),
                   ("dissipation", "plastic dissipation"),
                   ("kinetic", "kinetic energy")):
    large.plot(times, base[TERMS[key]], label=label)
elastic = base[TERMS["elastic"]]
large.plot(times, elastic - elastic[0], label="elastic energy, change")
large.set_ylabel("energy (kJ/m)")
for key, label in (("mapping_loss", "mapping loss"),
                   ("water", "work of the water"),
                   ("ramp", "withheld by the ramp"),
                   ("remainder", "remainder")):
    small.plot(times, base[TERMS[key]], label=label)
limit = 0.003 * base[TERMS["released"]]
small.fill_between(times, -limit, limit, color="grey", alpha=0.15,
                   label="0.3 % of the released energy")
for axes in (large, small):
    axes.set_xlabel("time (s)")
    axes.legend()
figure.tight_layout()
save(figure, "energy")
