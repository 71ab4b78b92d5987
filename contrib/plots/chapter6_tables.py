# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/results/chapter6/README.md that hang on the realisations."""

import numpy as np
from chapter6_data import FIRST_CLASS, NAMES, paired
from chapter6_thesis import ROWS
from estimates import mean_of_few, proportion, sign_test

PENDING = "*not run yet*"
ANALYSES = tuple(NAMES)


def share(mask, words=""):
    """'0.21 [0.17, 0.26], 63 of 300'."""
    n, count = len(mask), int(np.sum(mask))
    if n == 0:
        return PENDING
    p, low, high = proportion(count, n)
    return f"{p:.3g} [{low:.3g}, {high:.3g}], {count} of {n}{words}"


def mean(values):
    """'0.25 [0.24, 0.27]' of those that are there."""
    values = values[~np.isnan(values)]
    if len(values) == 0:
        return "–"
    middle, low, high = mean_of_few(values)
    text = f"{middle:.3g}" + ("" if np.isnan(low) else
                              f" [{low:.3g}, {high:.3g}]")
    return text.replace("-", "−")


def comparison(sets):
    """What chapter 6 prints, section by section."""
    lines = []
    for title, rows in ROWS:
        lines += ["", f"### {title}", "",
                  "| what | the thesis | ours in 3D | ours in 2D |",
                  "|---|---|---|---|"]
        for what, printed, space, plane in rows:
            cells = [cell if isinstance(cell, str) else
                     (cell(sets) or PENDING) for cell in (space, plane)]
            lines.append(f"| {what} | {printed} | {cells[0]} | {cells[1]} |")
    return "\n".join(lines[1:])


def campaigns(sets):
    """How many, how long, how well."""
    lines = ["| | N | lost | steps that did not converge | s each: mean, "
             "median | campaign |", "|---|---|---|---|---|---|"]
    for s in sorted(sets, key=lambda s: (s.is_screen, s.is_plane, s.name)):
        wall = s["wall_time"]
        bad = int(np.nansum(s["unconverged_steps"]))
        steps = int(np.nansum(s["steps"]))
        lines.append(
            f"| {s.label}, {'2D' if s.is_plane else '3D'} | {len(s)} | "
            f"{s.n_lost} | {bad} of {steps} | {np.nanmean(wall):.3g}, "
            f"{np.nanmedian(wall):.3g} | {', '.join(f'`{h}`' for h in s.hashes)}, seed {s.seed} |")
    return "\n".join(lines)


def inherent(sets):
    """The screen under own weight against the load that was reached."""
    lines = []
    for plane in (True, False):
        for name in ANALYSES:
            screen, loaded = sets.screen(name, plane), sets.analysis(name,
                                                                     plane)
            i, j = paired(screen, loaded)
            if not len(i):
                continue
            fails, open_ = screen.mask_fails[i], screen.mask_undecided[i]
            load = loaded["load"][j]
            if lines:
                lines.append("")
            lines += [f"{NAMES[name]}, {'2D' if plane else '3D'}, "
                      f"{len(i)} realisations:", "",
                      "| under its own weight | load < 0.05 m | "
                      "0.05 to 0.1 m | 0.1 m and more | all |",
                      "|---|---|---|---|---|"]
            for words, mask in (
                    ("slides", fails),
                    ("moves at the end, has not slid", open_),
                    ("at rest", ~fails & ~open_)):
                cells = [np.sum(mask & low) for low in
                         (load < 0.05, (load >= 0.05) & (load < 0.1),
                          load >= 0.1)]
                lines.append(f"| {words} | " + " | ".join(
                    str(int(c)) for c in (*cells, mask.sum())) + " |")
            lines.append("")
            for limit in (0.05, FIRST_CLASS):
                lines.append(
                    f"- The limit {limit:g} m says the same as the screen of "
                    f"{int(np.sum((load < limit) == fails))} of {len(i)}.")
            failed = screen.mask_outcome[i]
            if np.any(failed != fails):
                lines.append(
                    f"- The outcome is *initial failure* of "
                    f"{int(np.sum(failed & fails))} of the {int(fails.sum())} "
                    f"that slide, and of {int(np.sum(failed & open_))} of the "
                    f"{int(open_.sum())} that move and have not slid.")
    return "\n".join(lines) if lines else PENDING


def longer_screen(sets):
    """Whether what still moves at the end of the screen slides later."""
    short, long = sets.screen("1", True), sets.get("weight1-2d-15s")
    i, j = paired(short, long)
    if not len(i):
        return None
    open_ = short.mask_undecided[i]
    later = int(np.sum(long.mask_fails[j] & open_))
    alike = int(np.sum(short.mask_fails[i] == long.mask_fails[j]))
    return (f"Of the {int(open_.sum())} in 2D that still move at 3 s "
            f"{later or 'none'} slide{'s' * (later == 1)} until 15 s; the "
            f"screens agree in {alike} of {len(i)}.")


def stronger(sets):
    """How often 3D bears more than its twin."""
    lines = ["| | pairs | 3D bears more | load in 3D (m) | in 2D (m) | "
             "difference (m) |", "|---|---|---|---|---|---|"]
    n_rows = len(lines)
    for name in ANALYSES:
        space, plane = sets.analysis(name), sets.analysis(name, True)
        i, j = paired(space, plane)
        if not len(i):
            continue
        x, y = space["load"][i], plane["load"][j]
        lines.append(f"| {NAMES[name]} | {len(i)} | {share(x > y + 1e-9)} | "
                     f"{mean(x)} | {mean(y)} | {mean(x - y)} |")
    for name in ANALYSES:
        space, plane = sets.screen(name), sets.screen(name, True)
        i, j = paired(space, plane)
        if not len(i):
            continue
        x, y = space.mask_fails[i], plane.mask_fails[j]
        lines += ["", f"Own weight, {NAMES[name]}, {len(i)} pairs: both slide "
                  f"{int(np.sum(x & y))}, 2D alone {int(np.sum(y & ~x))}, "
                  f"3D alone {int(np.sum(x & ~y))}, neither "
                  f"{int(np.sum(~x & ~y))}."]
    return "\n".join(lines) if len(lines) > n_rows else PENDING


def classes(sets):
    """The sliding masses after the first one (section 7.4), in 3D."""
    lines = ["| 3D | N | masses after the first | sides | behind, centred | "
             "behind, off centre | remnants | any at the sides | any behind |",
             "|---|---|---|---|---|---|---|---|---|"]
    n_rows = len(lines)
    for name in ANALYSES:
        s = sets.analysis(name)
        if s is None:
            continue
        side, centred, off, remnant = (
            s["n_masses_" + c] for c in ("side", "behind_centred",
                                         "behind_off_centre", "remnant"))
        total = int(np.sum(np.maximum(s["n_masses"] - 1, 0)))
        lines.append(
            f"| {NAMES[name]} | {len(s)} | {total} | {side.sum():.0f} | "
            f"{centred.sum():.0f} | {off.sum():.0f} | {remnant.sum():.0f} | "
            f"{share(side > 0)} | {share(centred + off > 0)} |")
    return "\n".join(lines) if len(lines) > n_rows else PENDING


MEASURES = (("load", "load (m)"),
            ("retrogression_distance", "retrogression (m)"),
            ("relative_failure_volume", "volume (-)"),
            ("damaged_crest_width", "crest width (m)"))
DIRECTIONS = {"2b": "load down; more retrogression, width, volume",
              "2c": "load up, less scatter; volume smaller",
              "3a": "less scatter, smaller, none inherent",
              "3c": "more scatter, larger", "3d": "more scatter, larger",
              "3e": "more scatter, larger, more inherent",
              "4b": "load up, less retrogression, smaller",
              "4c": "load below that of 4B, more retrogression than 4B, "
                    "narrower"}


def verdict(values):
    values = values[~np.isnan(values)]
    if len(values) < 2:
        return "–"
    middle, low, high = mean_of_few(values)
    word = "up" if low > 0 else "down" if high < 0 else "open"
    return f"{word} {middle:+.2f} [{low:+.2f}, {high:+.2f}]".replace("-", "−")


def moves(sets):
    """Each analysis against the base case, realisation by realisation."""
    lines = ["| | | pairs | " + " | ".join(m[1] for m in MEASURES)
             + " | deviation of the load: base, here (m) | the thesis |",
             "|---" * (5 + len(MEASURES)) + "|"]
    n_rows = len(lines)
    for name in ANALYSES[1:]:
        for plane in (False, True):
            s, base = sets.analysis(name, plane), sets.analysis("1", plane)
            i, j = paired(s, base)
            if not len(i):
                continue
            cells = [verdict(s[m][i] - base[m][j]) for m, _ in MEASURES]
            spread = (f"{np.std(base['load'][j], ddof=1):.2f}, "
                      f"{np.std(s['load'][i], ddof=1):.2f}"
                      if len(i) > 1 else "–")
            lines.append(f"| {NAMES[name]} | {'2D' if plane else '3D'} | "
                         f"{len(i)} | " + " | ".join(cells)
                         + f" | {spread} | {DIRECTIONS[name]} |")
    return "\n".join(lines) if len(lines) > n_rows else PENDING


def length(sets):
    """Inherent instability against the length of the slope, smooth ends."""
    lines = ["| | slides under its own weight | moves at the end, has not "
             "slid | s each |", "|---|---|---|---|"]
    plane = sets.screen("1", True)
    found = [sets.get(f"length{n}") for n in (2, 4, 8)]
    entries = ([(plane, "plane strain, a section")] if plane else []) + [
        (s, s.label) for s in found if s] + (
        [(sets.screen("1"), "L = 8 m, ends held (analysis 1)")]
        if sets.screen("1") else [])
    for s, label in entries:
        lines.append(f"| {label} | {share(s.mask_fails)} | "
                     f"{int(s.mask_undecided.sum())} | "
                     f"{np.nanmean(s['wall_time']):.3g} |")
    if not any(found):
        lines += ["", "With smooth ends: " + PENDING + "."]
    return "\n".join(lines + length_pairs(
        (sets.get("length8"), "smooth ends"), (sets.screen("1"), "held ends"),
        (plane, "plane strain")))


def length_pairs(*sets):
    """What slides in one of two sets alone, of L = 8 m; the same fields."""
    lines = ["", "| L = 8 m, pairs | first | second | first alone | second alone "
             "| p |", "|---|---|---|---|---|---|"]
    n_rows = len(lines)
    for k, (one, label) in enumerate(sets):
        for other, other_label in sets[k + 1:]:
            i, j = paired(one, other)
            if not len(i):
                continue
            x, y = one.mask_fails[i], other.mask_fails[j]
            alone = int(np.sum(x & ~y)), int(np.sum(y & ~x))
            lines.append(
                f"| {label}, {other_label} | {int(x.sum())} of {len(i)} | "
                f"{int(y.sum())} | {alone[0]} | {alone[1]} | "
                f"{sign_test(*alone):.2g} |")
    return lines if len(lines) > n_rows else []


def tables(sets):
    """{name of the section of the page: Markdown}."""
    text = inherent(sets)
    more = longer_screen(sets)
    return {"comparison": comparison(sets), "campaigns": campaigns(sets),
            "inherent": text + (f"\n\n{more}" if more else ""),
            "stronger": stronger(sets), "classes": classes(sets),
            "moves": moves(sets), "length": length(sets)}
