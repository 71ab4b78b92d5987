# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is measured of slides under water, and the same without any water.

Shared by submerged_slide.py here and in contrib/verification.
"""

import numpy as np

CASE = "verification/slope_sliding_submerged.prm"
# Masses and forces are those under water: gravity and weight are halved.
BUOYANT = {"Materials/soil/Unit weight": 10, "Gravity/Acceleration": 4.905,
           "Tractions/Names": "", "Pore water/Phreatic line": ""}
# The same in water that flows, and its seepage force.
SEEPING = "verification/slope_sliding_seeping.prm"
SEEPAGE = {**BUOYANT, "Point loads/seepage/Force": "220, 0"}


def cells(size):
    """Cells of this size (m), and a time step in proportion."""
    return {"Grid/Cell size": size, "Time stepping/Time step": 0.02 * size}


def reach(points):
    """Where 99 % of the soil lies behind (m), and its centre (m)."""
    x, mass = points["position"][:, 0], points["mass"]
    order = np.argsort(x)
    behind = np.cumsum(mass[order]) / mass.sum()
    return (float(x[order][np.searchsorted(behind, 0.99)]),
            float((x * mass).sum() / mass.sum()))
