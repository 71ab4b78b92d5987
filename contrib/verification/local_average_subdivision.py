#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/local_average_subdivision.md, from data that unit
tests write:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Long.fields_local_average_subdivision*'
    /usr/bin/python3 contrib/verification/local_average_subdivision.py

With the argument "known", the errors that the unit tests expect: from a second
implementation in numpy, of matrices only, with its own quadrature.
"""

import sys

import numpy as np

from common import plt, read_csv, save


def cell_covariances(size, theta, n, n_points=60):
    """Covariances of cells of `size` that are 0 <= i, j < n cells apart, for
    the ellipsoidal Markov correlation; array (n, n)."""
    points, weights = np.polynomial.legendre.leggauss(n_points)
    points, weights = (points + 1) / 2, weights / 2
    weights = weights * (1 - points)
    table = np.zeros((n, n))
    for i in range(n):
        for j in range(n):
            for s in (1, -1):
                for t in (1, -1):
                    x = 2 * size[0] / theta[0] * (i + s * points)
                    y = 2 * size[1] / theta[1] * (j + t * points)
                    rho = np.exp(-np.hypot(x[:, None], y[None, :]))
                    table[i, j] += weights @ rho @ weights
    return table


def between(table, first, second):
    """The covariance matrix of two lists of cells (i, j)."""
    lag = abs(np.array(first)[:, None] - np.array(second)[None, :])
    return table[lag[..., 0], lag[..., 1]]


def subdivide(field, shape, size, theta):
    """One stage: the rows of `field` are the cells as linear functions of the
    noise; n_x * n_y rows, then 4 n_x n_y."""
    (n_x, n_y), n_noise = shape, field.shape[1]
    child_size = (size[0] / 2, size[1] / 2)
    among_children = cell_covariances(child_size, theta, 6)
    among_parents = cell_covariances(size, theta, 3)
    children = np.zeros((2 * n_y, 2 * n_x, n_noise + 3 * n_x * n_y))
    drawn = [(0, 0), (1, 0), (0, 1)]
    column = n_noise
    for j in range(n_y):
        for i in range(n_x):
            hood = [(a, b) for b in range(max(j - 1, 0), min(j + 2, n_y))
                    for a in range(max(i - 1, 0), min(i + 2, n_x))]
            own = [(2 * i + a, 2 * j + b) for a, b in drawn]
            s = np.mean([between(among_children,
                                 [(2 * a + p, 2 * b + q) for a, b in hood],
                                 own) for p in (0, 1) for q in (0, 1)], axis=0)
            a_t = np.linalg.solve(between(among_parents, hood, hood), s).T
            c = np.linalg.cholesky(between(among_children, own, own) - a_t @ s)
            values = np.zeros((3, children.shape[2]))
            values[:, :n_noise] = a_t @ field[[a + n_x * b for a, b in hood]]
            values[:, column:column + 3] = c
            column += 3
            for value, (x, y) in zip(values, own):
                children[y, x] = value
            children[2 * j + 1, 2 * i + 1] = -values.sum(axis=0)
            children[2 * j + 1, 2 * i + 1, :n_noise] += 4 * field[i + n_x * j]
    return children.reshape(4 * n_x * n_y, -1), (2 * n_x, 2 * n_y), child_size


def known_errors():
    """Relative errors (%) of variance and covariance of neighbours in x."""
    for k, m, theta in (((8, 8), 2, (4, 4)), ((8, 8), 3, (4, 4)),
                        ((8, 8), 3, (8, 8)), ((8, 8), 3, (16, 16)),
                        ((8, 8), 3, (32, 32)), ((6, 3), 3, (192, 4)),
                        ((6, 3), 3, (32, 4))):
        size, shape = (2.**m, 2.**m), k
        cells = [(i, j) for j in range(k[1]) for i in range(k[0])]
        field = np.linalg.cholesky(between(
            cell_covariances(size, theta, max(k)), cells, cells))
        for _ in range(m):
            field, shape, size = subdivide(field, shape, size, theta)
        exact = cell_covariances(size, theta, 2)
        field = field.reshape(shape[1], shape[0], -1)
        variance = 100 * ((field**2).sum(axis=2) / exact[0, 0] - 1)
        lag_1 = 100 * ((field[:, 1:] * field[:, :-1]).sum(axis=2)
                       / exact[1, 0] - 1)
        print(f"{k}, m = {m}, theta = {theta}: variance {variance.min():.3f} "
              f"{variance.max():.3f}, lag 1 {lag_1.mean():.3f} "
              f"{lag_1.min():.2f} {lag_1.max():.2f}")


def draw():
    """Variance of the cells of chapter 5's field, and errors against m."""
    rows = read_csv("local_average_subdivision_map")
    figure = plt.figure(figsize=(9.5, 6.4))
    axes = figure.subplot_mosaic([["24", "24"], ["4", "4"], ["rows", "scale"]],
                                 height_ratios=[1, 1, 1.5])
    theta, variance = np.array(rows["theta_h"]), np.array(rows["variance %"])
    for value in (24., 4.):
        quarter = variance[theta == value].reshape(20, 120)
        half = np.hstack([quarter, quarter[:, ::-1]])
        full = np.vstack([half, half[::-1]])
        axis = axes[f"{value:g}"]
        image = axis.imshow(full, origin="lower", extent=(0, 30, 0, 5),
                            cmap="RdBu_r", vmin=-33, vmax=33, aspect="auto")
        axis.grid(False)
        axis.set_title(f"Error of the variance, θ_h = {value:g} m, "
                       "θ_v = 0.5 m, cells of 0.125 m", fontsize=10)
        axis.set_ylabel("y (m)")
        figure.colorbar(image, ax=axis, label="%", pad=0.01)
        axes["rows"].plot((np.arange(40) + 0.5) / 8, full.mean(axis=1), ".-",
                          label=f"θ_h = {value:g} m")
    axes["4"].set_xlabel("x (m)")
    axes["rows"].set_xlabel("y (m)")
    axes["rows"].set_ylabel("%")
    axes["rows"].set_title("Mean error of the variance in a row", fontsize=10)
    axes["rows"].set_ylim(-23, 30)
    axes["rows"].legend(fontsize=8, loc="upper center", ncol=2)

    table = read_csv("local_average_subdivision")
    dim, m = np.array(table["dim"]), np.array(table["m"])
    scale = np.array(table["theta/cell"])
    for d, style in ((1, "--"), (2, "-")):
        for stage, colour in ((2, "C0"), (3, "C3")):
            chosen = (dim == d) & (m == stage)
            for side in ("least", "largest"):
                axes["scale"].semilogx(
                    scale[chosen],
                    np.array(table[side + " variance %"])[chosen],
                    "o" + style, color=colour, markersize=4,
                    label=f"{d}D, m = {stage}" if side == "least" else None)
    axes["scale"].set_xticks([4, 8, 16, 32], ["4", "8", "16", "32"])
    axes["scale"].set_xticks([], minor=True)
    axes["scale"].set_xlabel("isotropic θ (cells)")
    axes["scale"].set_ylabel("%")
    axes["scale"].set_title("Least and largest error of the variance",
                            fontsize=10)
    axes["scale"].set_ylim(-22, 20)
    axes["scale"].legend(fontsize=8, loc="upper right", ncol=2)
    figure.tight_layout()
    save(figure, "local_average_subdivision")


if sys.argv[1:] == ["known"]:
    known_errors()
else:
    draw()
