#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure and numbers of doc/verification/conditioning.md, from data that a unit
test writes:

    WAKER_VERIFICATION_DATA=doc/verification/data build/bin/unit_tests \\
        --gtest_filter='Long.fields_conditioning*'
    /usr/bin/python3 contrib/verification/conditioning.py
"""

import numpy as np

from common import plt, read_csv, save

data = {key: np.array(values)
        for key, values in read_csv("conditioning").items()}
CELL, THETA = 0.25, (8.0, 1.0)
SHAPE = (20, 64)
X = (4.125, 11.125)  # of the penetration tests


def correlation(lag, theta):
    """Of two cells `lag` cells apart on a line, normalised: second difference
    of the variance function (Vanmarcke 1983)."""
    def integral(n):
        a = 2 * abs(n) * CELL / theta
        return a + np.exp(-a) - 1
    second = integral(lag + 1) - 2 * integral(lag) + integral(lag - 1)
    return second / (2 * integral(1))


def formula(error_variance):
    """Mean and standard deviation of a normal vector, given part of it."""
    i, j = np.round(data["x"] / CELL - 0.5), np.round(data["y"] / CELL - 0.5)
    c = (correlation(i[:, None] - i, THETA[0])
         * correlation(j[:, None] - j, THETA[1]))
    observed = np.isin(data["x"], X)
    c_oo = c[np.ix_(observed, observed)] + error_variance * np.eye(
        observed.sum())
    weights = np.linalg.solve(c_oo, c[observed])
    mean = weights.T @ data["measured"][observed]
    variance = 1 - np.einsum("ol,ol->l", weights, c[observed])
    return mean, np.sqrt(np.maximum(variance, 0)), observed


for name, error in (("", 0.0), (" with error", 0.25)):
    mean, sd, observed = formula(error)
    print(f"error variance {error}: largest difference of the mean "
          f"{abs(mean - data['mean' + name]).max():.1e}, of the standard "
          f"deviation {abs(sd - data['sd' + name]).max():.1e}; standard "
          f"deviation in measured cells {data['sd' + name][observed].min():.3f}"
          f" to {data['sd' + name][observed].max():.3f}")
mean, sd, observed = formula(0.0)
print("measured cells: largest difference of the conditional field",
      abs(data["conditional"] - data["measured"])[observed].max())
END = data["x"] > 15.8
print("right end: standard deviation", data["sd"][END].mean())

figure, axes = plt.subplots(4, 1, figsize=(8.5, 9.5), sharex=True,
                            height_ratios=[1, 1, 1, 1.2],
                            constrained_layout=True)
for axis, key, title in ((axes[0], "unconditional", "A field z_u"),
                         (axes[1], "conditional",
                          "The same, conditioned on two penetration tests"),
                         (axes[2], "sd", "Standard deviation of all such")):
    limits = (0, 1) if key == "sd" else (-3, 3)
    image = axis.imshow(data[key].reshape(SHAPE), origin="lower",
                        extent=(0, 16, 0, 5), aspect="auto", vmin=limits[0],
                        vmax=limits[1],
                        cmap="viridis" if key == "sd" else "RdBu_r")
    axis.grid(False)
    axis.set_title(title, fontsize=10)
    axis.set_ylabel("y (m)")
    for x in X:
        axis.axvline(x, color="k", linewidth=0.8, linestyle=":")
    figure.colorbar(image, ax=axis, pad=0.01)

middle = np.isclose(data["y"], 2.625)
x = data["x"][middle]
for name, error, colour in (("", 0.0, "C0"), (" with error", 0.25, "C1")):
    mean, sd, _ = formula(error)
    text = f"error variance {error:g}"
    axes[3].plot(x, data["sd" + name][middle], color=colour,
                 label=f"standard deviation, {text}")
    axes[3].plot(x, sd[middle], ".", color=colour)
    axes[3].plot(x, data["mean" + name][middle], "--", color=colour,
                 label=f"mean, {text}")
    axes[3].plot(x, mean[middle], ".", color=colour)
axes[3].set_title("Row y = 2.625 m: lines Waker, dots the formula",
                  fontsize=10)
axes[3].set_xlabel("x (m)")
axes[3].set_ylim(-0.75, 1.05)
axes[3].legend(fontsize=8, ncol=2, loc="lower right")
save(figure, "conditioning")
