#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that only push, with friction: a block slides as Coulomb says; --long: the toe of
the weak dyke lies on ground with friction to its tip, and hangs over held nodes
(doc/verification/contact.md).

usage: contact.py WAKER SOURCE_DIRECTORY [--long]
"""

import sys

import block_measures as block
import toe_measures as toe
from waker_case import Checks, workspace_of_arguments

SIZE = 0.25  # m


def blocks(checks, work):
    runs = {mu: work.run(f"block-{mu}", block.CASE, {block.FRICTION: mu})
            for mu in (0.3, 0.44, 0.45)}
    for mu, low, high in (0.3, -0.01, 0.01), (0.45, 0.08, 0.12):
        a, start = block.fitted(runs[mu])
        # Met: none, and one while the contact forms.
        checks.below(f"block, friction {mu}: steps that were halved",
                     runs[mu]["unconverged_steps"], 3)
        # Met: 0.0001 and 0.005; what still rings in the contact.
        checks.between("  acceleration over g (sin b - mu cos b)",
                       a / block.acceleration(mu), 0.98, 1.02)
        # The weight comes at once, and there is less friction until the contact has
        # formed: against 0.88 m/s of 2 s with a friction of 0.45.
        checks.between("  speed that this start leaves (m/s), as before", start,
                       low, high)
        # 22 % further than half of a t^2, and no more than that speed says.
        checks.between("  way over that with this speed and acceleration",
                       block.way(runs[mu]) / (2 * start + 2 * a), 0.97, 1.03)
    # The control: a hundredth less friction is another acceleration.
    checks.above("  acceleration with 0.44 over that with 0.45",
                 block.fitted(runs[0.44])[0] / block.acceleration(0.45), 1.1)


def toes(checks, work):
    # On cells of 0.5 m single points decide how high a tip is.
    end = {**toe.END, "Time stepping/End time": 7}
    ends = {}
    for name, file, cells in (
            ("held nodes", toe.HELD, toe.cells),
            ("ground with friction", toe.ON_GROUND, toe.cells_on_ground)):
        run = work.run(name.replace(" ", "-"), file, {**cells(SIZE), **end})
        ends[name] = toe.fronts(toe.profile(run.points(), SIZE), SIZE)
        checks.above(f"toe on {name}: how far it slides out (m)", ends[name][0], 3)
    front, on_ground, tip = ends["ground with friction"]
    checks.below("  its tip above the ground (m)", tip, 0.02)
    checks.below("  beyond what lies on the ground (m)", front - on_ground, 0.01)
    # The control: nodes hold what is on them, and the rest rolls over that.
    front, on_ground, tip = ends["held nodes"]
    checks.above("  held nodes: its tip above the ground (m)", tip, 0.1)
    checks.above("  held nodes: beyond what lies on the ground (m)",
                 front - on_ground, 1)


def main():
    parts = (blocks,)
    if "--long" in sys.argv:
        sys.argv.remove("--long")
        parts = (toes,)
    work, _ = workspace_of_arguments()
    checks = Checks()
    with work:
        for part in parts:
            part(checks, work)
    checks.finish()


if __name__ == "__main__":
    main()
