#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/weights.md, from data that unit tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Mapping.*'
    /usr/bin/python3 contrib/verification/weights.py
"""

from common import plt, read_csv, save

functions = read_csv("weights_functions")
offsets = read_csv("weights_offsets")

figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
for kind, colour in (("linear", "C1"), ("GIMP", "C0")):
    left.plot(functions["d/h"], functions[f"{kind} S"], color=colour,
              label=f"{kind} S")
    left.plot(functions["d/h"], functions[f"{kind} h S'"], color=colour,
              linestyle="--", label=f"{kind} h S′")
left.set_xlabel("distance of the point from the node (h)")
left.set_title("One direction, half-size h/4", fontsize=10)
left.legend(fontsize=8)

for kind, colour in (("linear", "C1"), ("GIMP", "C0")):
    right.semilogy(offsets["offset / h"], offsets[f"{kind} int N"],
                   color=colour, label=f"{kind}, ∫N")
    right.semilogy(offsets["offset / h"], offsets[f"{kind} int grad N"],
                   color=colour, linestyle="--", label=f"{kind}, ∫∇N")
right.set_ylim(1e-17, 1e2)
right.set_xlabel("offset of the lattice (h)")
right.set_title("Largest error of a nodal integral, points 0.7 h apart",
                fontsize=10)
right.legend(fontsize=8, ncol=2, loc="center")
figure.tight_layout()
save(figure, "weights")
