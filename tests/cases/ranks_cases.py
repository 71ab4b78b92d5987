# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs on several ranks in ranks.py."""
from dataclasses import dataclass, field
from typing import Dict, List, Tuple

import numpy as np

tight = ["Newton/Tolerance=1e-12", "Newton/Linear tolerance=1e-12",
         "Newton/Maximum iterations=50", "Newton/Maximum linear iterations=5000",
         "Gravity/Tolerance=1e-12"]
# The residual is a norm over all nodes: single points on a loose surface, of which
# it hardly consists, are exact to 1e-10 a digit later, and so is the end of a
# tangent that converges slowly.
tighter = ["Newton/Tolerance=1e-13"]


@dataclass
class Case:
    file: str
    settings: List[str]
    step: float  # s
    ranks: Tuple[int, ...] = (3,)
    steps: int = 20
    # What a step without balance is there for; else there is none.
    unbalanced: str = ""
    # Columns of the statistics that say that what the case is of has happened: not
    # zero at the end.
    shows: Tuple[str, ...] = ()
    # With assertions and sanitizers, which make it 50 to 100 times slower.
    few: List[str] = field(default_factory=list)
    # Written for it: in settings, {folder} is where.
    files: Dict[str, str] = field(default_factory=dict)


WEAK = "chapter5/dyke_weak.prm"
weak = ["Grid/Cell size=0.5", "Time stepping/Ramp duration=0"]
weak_few = ["Grid/Cell size=1"]

# With B-bar the pressure of a domain that sticks out by a hair moves nodes with
# hardly a mass behind a roller: how far a domain does so is round-off.
behind = "Boundary conditions/behind the "
ends_held = [
    "Boundary conditions/Names=base, left side, right side, near end, far end, "
    "behind the near end, behind the far end",
    behind + "near end/Region=box", behind + "near end/From=-10, -10, -10",
    behind + "near end/To=30, 10, -0.001",
    behind + "far end/Region=box", behind + "far end/From=-10, -10, 8.001",
    behind + "far end/To=30, 10, 18"]

submerged = ["Grid/Cell size=0.5", "Random fields/Names=",
             "Time stepping/Ramp duration=0", "Gravity/Initial share=0.9"]


def submerged_outline():
    """Of the submerged slope from its toe up, with a vertex every 0.4 m or so:
    pieces between vertices that the soil carries lie on all ranks."""
    corners = np.array([[0, 0], [52, 0], [34, 2.25], [20, 16.25], [0, 16.25],
                        [0, 0]])
    lines = ["# x y (m), anticlockwise"]
    for a, b in zip(corners[:-1], corners[1:]):
        n = int(np.ceil(np.linalg.norm(b - a) / 0.4))
        lines += ["%.15g %.15g" % tuple(a + (b - a) * i / n) for i in range(n)]
    return "\n".join(lines + ["0 0"]) + "\n"


# The block of 1 m^2 that flies.
FLYING = "verification/flying_block.prm"

cases = {
    "weak dyke": Case(WEAK, weak, 0.01, (2, 3, 4), few=weak_few),
    "contour": Case(WEAK, weak + ["Surface/Method=contour"], 0.01, (2, 3, 4),
                    few=weak_few),
    "explicit": Case(WEAK, weak + ["Time stepping/Scheme=explicit"],
                     0.0056,  # it takes its own, of 0.005 s
                     (2, 3, 4), few=weak_few),
    "springs": Case(WEAK, weak + ["Boundary conditions/left side/Method=penalty"],
                    0.01, (2, 3, 4), few=weak_few),
    "double mapping": Case(WEAK, weak + [
        "Newton/Tangent=double mapping",
        "Kinematics and mapping/Volumetric strain=B-bar",
        "Newton/Maximum iterations=500"], 0.01, few=weak_few),
    "nonlocal": Case(WEAK, weak + ["Materials/clay/Regularisation=nonlocal",
                                   "Materials/clay/Averaging length=1"], 0.01,
                     (2, 3, 4), few=weak_few),
    # Its reach is ten cells.
    "nonlocal far": Case(WEAK, weak + ["Materials/clay/Regularisation=nonlocal",
                                       "Materials/clay/Averaging length=2"], 0.01,
                         (4,), few=weak_few),
    "pore water": Case("verification/dyke_rising_line.prm",
                       ["Kinematics and mapping/Volumetric strain=standard",
                        "Time stepping/Ramp duration=0",
                        "Gravity/Initial share=0.9"], 0.01, (2, 3, 4),
                       few=weak_few),
    "slice": Case("verification/dyke_slice.prm", ["Grid/Cell size=0.5"], 0.01),
    "water in space": Case("chapter6/dyke_3d.prm",
                           ["Time stepping/Ramp duration=0",
                            "Gravity/Initial share=0.9"] + tighter, 0.01,
                           few=["Grid/Cell size=2"]),
    "contour in space": Case("chapter6/dyke_3d.prm",
                             ["Surface/Method=contour", "Surface/Prismatic=false",
                              "Time stepping/Ramp duration=0",
                              "Gravity/Initial share=0.9"] + ends_held + tighter,
                             0.01, few=["Grid/Cell size=2"]),
    "contour of slice": Case("verification/dyke_slice.prm",
                             ["Grid/Cell size=0.5", "Surface/Method=contour"],
                             0.01),
    # Until soil has come in and gone out.
    "flow": Case("chapter3/flow.prm", ["Grid/Upper corner=2.25, 2"], 0.02,
                 (2, 3, 4), 40, shows=("Mass in (Mg)", "Mass out (Mg)")),
    "wall": Case("chapter3/inclined_wall.prm", [], 0.02, (2, 3, 4)),
    "friction": Case("verification/dyke_on_ground.prm", tighter, 0.01),
    "load programme": Case("chapter6/drawdown_2d.prm",
                           ["Load programmes/drawdown/Start time=0",
                            "Load programmes/drawdown/Rate=-3"] + tighter, 0.01,
                           (2, 3, 4), few=["Grid/Cell size=0.5"]),
    "load programme in space": Case("chapter6/foundation.prm",
                                    ["Grid/Cell size=0.25",
                                     "Newton/Maximum iterations=200",
                                     "Load programmes/foundation/Start time=0"]
                                    + tighter, 0.01, (2, 3, 4),
                                    few=["Grid/Cell size=0.5"]),
    "submerged slope": Case("chapter3/submerged_slope.prm", submerged, 0.01,
                            (2, 3, 4)),
    # The thin toe has its water on the contour: nodes there have hardly any soil.
    "user's surface": Case("chapter3/submerged_slope.prm", submerged + [
        "Tractions/Names=water, toe",
        "Tractions/water/Method=user surface",
        "Tractions/water/Surface file={folder}/outline.txt",
        # Not base and left side.
        "Tractions/water/Facing=1, 2", "Tractions/water/Opening=80",
        "Tractions/water/From=-1, -1", "Tractions/water/To=40, 20",
        "Tractions/water/Minimum support=0.01",
        "Tractions/toe/Method=contour", "Tractions/toe/Kind=hydrostatic",
        "Tractions/toe/Level=20", "Tractions/toe/Unit weight=10",
        "Tractions/toe/From=40, 0", "Tractions/toe/To=62, 20"], 0.01, (2, 3, 4),
        shows=("Traction water length (m)", "Traction toe length (m)"),
        files={"outline.txt": submerged_outline()}),
    "tractions": Case("chapter3/inclined_bar_3d.prm", [], 0.01, (2, 3, 4)),
    "all methods": Case("chapter3/bar_1d_mpm.prm", [], 0.01, (2, 3, 4)),
    # Fixed and updated points, and a pressure that rides on points.
    "points": Case("chapter3/inclined_bar.prm",
                   ["Tractions/top/Method=updated points",
                    "Tractions/end/Method=updated points",
                    "Tractions/contour/Follows=soil"], 0.01, (2, 3, 4)),
    "points in space": Case("chapter3/inclined_bar_3d.prm",
                            ["Tractions/top/Method=updated points",
                             "Tractions/end/Method=updated points",
                             "Tractions/contour/Follows=soil"], 0.01),
    "detected": Case("chapter3/inclined_bar_detected.prm", [], 0.01, (2, 3, 4)),
    "point load": Case("chapter3/cantilever.prm", ["Newton/Tolerance=1e-11"], 0.02,
                       (2, 3, 4)),
    "rising water": Case("chapter3/rising_water.prm", [], 0.5, (2, 3, 4)),
    "foundation": Case("chapter6/foundation_2d.prm",
                       ["Load programmes/foundation/Mass=with mass",
                        "Load programmes/foundation/Start time=0"], 0.01,
                       (2, 3, 4)),
    # Laws and waters in the ground.
    "shansep": Case("verification/dyke_shansep.prm", [], 0.02, (2, 3)),
    "stages": Case("verification/dyke_stages.prm", tighter, 0.02, (2, 3)),
    "head lines": Case("verification/dyke_head_lines.prm", tighter, 0.02, (2, 3)),
    "delay": Case("verification/dyke_delay.prm", [], 0.02, (2, 3)),
    "traffic": Case("verification/dyke_traffic.prm", [], 0.02, (2, 3)),
    "cam clay": Case("verification/cam_clay_footing.prm", [], 0.5, (2, 3)),
    "water in pores": Case("verification/strip_footing_undrained.prm", [], 0.05, (2, 3)),
    "k0": Case("verification/level_ground_k0.prm", [], 0.02, (2, 3)),
    "softening friction": Case("verification/slope_softening.prm", [], 0.02, (2, 3)),
    "storm": Case("verification/dyke_storm.prm", [], 60, (2, 3)),
    # Dealt out anew twice.
    "flying block": Case(FLYING, [], 0.008, (4,), 60),
    # Not dealt out anew: it leaves ranks empty.
    "empty ranks": Case(FLYING, ["Surface/Method=contour",
                                 "Ranks/Largest imbalance=1000"], 0.008, (4,), 60),
    # 16 with the layer around the grid.
    "more ranks than cells": Case(FLYING, ["Grid/Upper corner=2, 2",
                                           "Grid/Cell size=1"], 0.001, (6, 17)),
    # In one cell at the start and at the end.
    "all points on one rank": Case(FLYING, [
        "Soil profile/block/Polygon=0.5, 0.5; 0.75, 0.5; 0.75, 0.75; 0.5, 0.75"],
        0.00015, (4,)),
    "no balance": Case(WEAK, weak + ["Boundary conditions/Names=base",
                                     "Boundary conditions/base/Type=roller",
                                     "Gravity/Initial stress=false",
                                     "Time stepping/Scheme=quasi-static at rest"],
                       0.01, (2, 3, 4), few=weak_few,
                       unbalanced="nothing holds it along x: the long step finds "
                       "no balance"),
    # Asked for the places of all points at its start, then not for 40 steps.
    "copy that goes": Case(WEAK, weak + ["Sliding masses/Watch=true",
                                         "Sliding masses/Displacement=0.05"], 0.01,
                           steps=60, few=weak_few),
    "slope": Case("chapter6/slope.prm", ["Grid/Cell size=0.25",
                                         "Newton/Maximum iterations=200"] + tighter,
                  0.01, (2, 3, 4), few=["Grid/Cell size=0.5"]),
}

# What takes a minute at most.
quick = {"weak dyke": (2, 3), "contour": (3,), "explicit": (3,),
         "nonlocal": (3,), "points": (3,), "flow": (3,), "wall": (3,),
         "springs": (3,), "no balance": (3,)}

# With the tolerances that users have.
at_defaults = ("weak dyke", "submerged slope", "slope", "load programme",
               "load programme in space", "flow", "wall", "user's surface")
