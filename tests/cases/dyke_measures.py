# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dyke drivers and the scripts in contrib/verification measure in the
runs of the dyke of chapter 5."""

import numpy as np

# The case of parameters/chapter5 (m).
CORNERS = ((0, 0), (30, 0), (15, 5), (5, 5))
CELL = 0.25

# The same dyke on cells of 0.5 m, for runs that must be short. There it takes
# 9 instead of 10 kPa to fail: softening depends on the cell size.
COARSE = {"Grid/Cell size": 0.5,
          "Materials/clay/Initial strength": 9,
          "Materials/clay/Residual strength": 9 / 2.6}


def strength(c_i, c_r):
    return {"Materials/clay/Initial strength": c_i,
            "Materials/clay/Residual strength": c_r}


def polygon(change):
    """The profile with every x replaced by change(x)."""
    return {"Soil profile/dyke/Polygon":
            "; ".join(f"{change(x):.9g}, {y}" for x, y in CORNERS)}


def energy_shares(run):
    """The account at the end of a run: {term: kJ}, and the largest remainder
    of all times."""
    rows = run.statistics
    terms = {
        "kinetic energy": rows["Kinetic energy (kJ)"][-1],
        "elastic energy, change": (rows["Elastic energy (kJ)"][-1]
                                   - rows["Elastic energy (kJ)"][0]),
        "plastic dissipation": rows["Plastic dissipation (kJ)"][-1],
        "work withheld by the ramp": rows["Work withheld by the ramp (kJ)"][-1],
        "mapping loss": rows["Mapping loss (kJ)"][-1],
        "potential energy released":
            rows["Potential energy released (kJ)"][-1],
        "work of the water": rows["Work of the water (kJ)"][-1],
        "work of the supports": rows["Work of the supports (kJ)"][-1],
        "remainder": rows["Energy remainder (kJ)"][-1],
    }
    return terms, np.abs(rows["Energy remainder (kJ)"]).max()


def outer_face(points, depth=2 * CELL, shift=0.0):
    """Which points (at the start) lie within `depth` (m) of the outer slope,
    the line y = x - shift."""
    x, y = points["position"][:, 0] - shift, points["position"][:, 1]
    return (x - y) / np.sqrt(2) < depth


class FaceHistory:
    """Of the points of the outer face, in every frame of a run: the largest
    |mean stress| (kPa) and the largest plastic strain. `growth`: the largest
    ratio of |mean stress| to that of the gravity state, over points and frames;
    below `floor` (kPa, 1/3 m of soil) ratios say nothing, it stands for less.
    """

    floor = 5.0

    def __init__(self, run, shift=0.0):
        frames = run.frames()
        start = run.points(0.0)
        face = outer_face(start, shift=shift)
        first = np.abs(start["mean_stress"][face])
        # What the soil itself bears, clear of the face.
        self.deepest = np.abs(start["mean_stress"][~face]).max()
        self.first = first.max()
        self.time, self.pressure, self.plastic = [], [], []
        self.growth, self.yielded = 0.0, 0
        for time, _ in frames:
            points = run.points(time)
            now = np.abs(points["mean_stress"][face])
            plastic = points["plastic_strain"][face]
            self.time.append(time)
            self.pressure.append(now.max())
            self.plastic.append(plastic.max())
            self.yielded = max(self.yielded, np.count_nonzero(plastic))
            self.growth = max(self.growth,
                              (now / np.maximum(first, self.floor)).max())
        self.inside = np.count_nonzero(points["plastic_strain"][~face])


def clusters(position, reach):
    """Number of the cluster of each point: points closer than `reach` (m) in
    both directions belong together. Numbered by size, the largest 0."""
    cell = np.floor(position[:, :2] / reach).astype(int)
    members = {}
    for i, key in enumerate(map(tuple, cell)):
        members.setdefault(key, []).append(i)
    number = np.full(len(position), -1)
    count = 0
    for start in members:
        if number[members[start][0]] >= 0:
            continue
        stack = [start]
        number[members[start]] = count
        while stack:
            i, j = stack.pop()
            for key in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                if key in members and number[members[key][0]] < 0:
                    number[members[key]] = count
                    stack.append(key)
        count += 1
    sizes = np.bincount(number, minlength=count)
    rank = np.empty(count, dtype=int)
    rank[np.argsort(-sizes, kind="stable")] = np.arange(count)
    return rank[number]


class Blocks:
    """The parts of the dyke, of at least `smallest` (m^2), that bands of softened
    soil separate. Intact is a point that has lost less than half of what it can
    lose of its strength. By the place of their centres, from the water to the
    toe: the first is what stands."""

    def __init__(self, points, c_i, c_r, smallest=3.0):
        intact = np.flatnonzero(
            points["undrained_shear_strength"] > 0.5 * (c_i + c_r))
        position = points["position"][intact, :2]
        volume = points["volume"][intact]
        number = clusters(position, CELL)
        area = np.bincount(number, weights=volume)
        found = [position[number == k]
                 for k in np.flatnonzero(area >= smallest)]
        self.areas = area[area >= smallest]
        order = np.argsort([block[:, 0].mean() for block in found])
        self.blocks = [found[k] for k in order]
        self.areas = self.areas[order]

    def __len__(self):
        return len(self.blocks)

    def band_before_toe(self, lowest=0.75):
        """The band between the block at the toe and the next one: its middle
        (n, 2), one point per row of cells above `lowest` (m) in which both are,
        and the angle of a straight line through it to the horizontal (degrees).
        None if fewer than two blocks have left, or the band is too short."""
        if len(self) < 3:
            return None
        behind, toe = self.blocks[-2:]
        middle = []
        top = min(behind[:, 1].max(), toe[:, 1].max())
        for y in np.arange(lowest, top, CELL):
            edges = [block[np.abs(block[:, 1] - y) < CELL / 2, 0]
                     for block in (behind, toe)]
            if all(len(x) > 0 for x in edges):
                middle.append((0.5 * (edges[0].max() + edges[1].min()), y))
        if len(middle) < 5:
            return None
        middle = np.array(middle)
        run_over_rise = np.polyfit(middle[:, 1], middle[:, 0], 1)[0]
        return middle, np.degrees(np.arctan2(1, run_over_rise))


def distances(points, segments):
    """Distance (m) of each point (n, 2) to the nearest of the segments."""
    a, b = segments[:, 0], segments[:, 1]
    along = b - a
    length = np.maximum(np.sum(along**2, axis=1), 1e-30)
    nearest = np.full(len(points), np.inf)
    for i, x in enumerate(points):
        share = np.clip(np.sum((x - a) * along, axis=1) / length, 0, 1)
        nearest[i] = np.linalg.norm(a + share[:, None] * along - x,
                                    axis=1).min()
    return nearest


def surface_agreement(one, other, limit=CELL):
    """Share of the length of one surface (n, 2, 2) that lies within `limit`
    (m) of the other, and the distances at the middles of its segments."""
    middle = one.mean(axis=1)
    length = np.linalg.norm(one[:, 1] - one[:, 0], axis=1)
    distance = distances(middle, other)
    return np.sum(length[distance <= limit]) / np.sum(length), distance
