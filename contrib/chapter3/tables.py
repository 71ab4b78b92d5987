#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/results/chapter3/README.md, table 7.1 among them, from the
numbers that the studies have kept. Needs no runs."""

import os
import sys

from common import RESULTS, ROOT, load_numbers, write_text

PAGE = os.path.join(RESULTS, "README.md")
ROWS = {"points": "surface points", "nodes": "surface nodes",
        "surface": "exact surface (user's)", "detected": "proximity field",
        "volume": "volume of the points", "contour": "support domains (contour)"}
# What table 7.1 of the thesis prints, by row.
THESIS = {"points": ("-", "-", "-", "-"), "nodes": ("-", "--", "--", "N/A"),
          "surface": ("-", "++", "+", "+"), "detected": ("", "", "", ""),
          "volume": ("++", "N/A", "N/A", "N/A"),
          "contour": ("N/A", "++", "++", "++")}


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |",
             "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |"
                              for row in rows])


def grade(error):
    """The key of table 7.1 by the error of the nodal force over the load: `++`
    none but round-off of the files, `+` below 10 %, `-` below 75 %, `--`."""
    if error is None:
        return "N/A"
    return ("++" if error < 1e-5 else "+" if error < 0.1
            else "-" if error < 0.75 else "--")


def percent(value):
    """A share (not per cent), in %; round-off as such."""
    return "below 0.001 %" if value < 1e-5 else f"{100 * value:.3g} %"


def minus(text):
    """Markdown would join hyphens."""
    return text.replace("-", "−")


def table_7_1():
    bar, inclined = load_numbers("bar_1d"), load_numbers("inclined_bar")
    slope = load_numbers("submerged_slope")
    rows = []
    for key, name in ROWS.items():
        cells = []
        for k, case in enumerate(("MPM", "GIMP")):
            entry = bar.get(f"{case} {key}")
            error = entry and entry["mean"]
            cells.append((grade(error), "" if error is None
                          else percent(error), THESIS[key][k]))
        entry = inclined["tan 0.5"].get(key)
        error = entry and max(entry["mean x"], entry["mean y"]) / 100
        cells.append((grade(error), "" if error is None else percent(error),
                      THESIS[key][2]))
        run = {"points": "points", "detected": "proximity field",
               "surface": "exact surface, at the start", "contour": "contour"}.get(key)
        if slope and run:
            cells.append(slope_grade(slope, run) + (THESIS[key][3],))
        else:
            cells.append(("N/A", "", THESIS[key][3]))
        rows.append([name] + [
            f"**{minus(g)}** {value} ({minus(thesis)})" if thesis
            else f"**{minus(g)}** {value}" for g, value, thesis in cells])
    return table(["method", "MPM-1D", "GIMP-1D", "GIMP-2D",
                  "submerged slope"], rows)


def slope_grade(slope, run):
    """By the error of the initial stress at the surface: of the vertical stress
    of the flat top and the roughness of the mean stress of the steep face, the
    larger share. `++` below 1 %, else as for the bars."""
    share = max(slope[run]["the same as a share"],
                slope[run]["mean stress, 45 degrees, as a share"])
    return "++" if share < 0.01 else grade(share), percent(share)


def bar_table():
    numbers = load_numbers("bar_1d")
    rows = []
    for case in ("MPM", "GIMP"):
        for key, name in ROWS.items():
            entry = numbers.get(f"{case} {key}")
            if entry:
                rows.append([case, name, percent(entry["mean"]),
                             percent(entry["max"]),
                             f"{100 * entry['share of offsets below 1e-5']:.0f}"
                             " %"])
    return table(["functions", "method", "mean error", "largest",
                  "offsets without error"], rows)


def inclined_table():
    numbers = load_numbers("inclined_bar")
    thesis = {("tan 0.5", "surface"): "2.1, 1.3 (derived: 2.12, 1.30)",
              ("tan 0.25", "surface"): "derived: 0.88, 0.50",
              ("tan 1", "surface"):
              "derived: 4.87, 2.98; largest 8.33, 4.17",
              ("tan 0.5", "points"): "about 50",
              ("tan 0.5", "nodes"): "about 100"}
    rows = []
    for case in sorted(numbers, key=lambda c: (c.startswith("3D"), float(
            c.split("tan ")[1].split(",")[0]), c)):
        for key in ROWS:
            if key not in numbers[case]:
                continue
            entry = numbers[case][key]
            values = [entry[k] for k in ("mean x", "mean y", "max x", "max y")]
            expected = thesis.get((case, key), "0" if key == "contour" else "")
            rows.append([case.replace("tan", "tan θ ="), ROWS[key],
                         *("0" if v < 1e-3 else f"{v:.3g}" for v in values),
                         expected])
    return table(["case", "method", "E_Fx mean (%)", "E_Fy mean (%)",
                  "E_Fx largest", "E_Fy largest", "thesis (%)"], rows)


def uniaxial_table():
    numbers = load_numbers("uniaxial_block")
    rows = []
    for case, entry in numbers.items():
        functions, method = case.split(",")[0].split()
        rows.append(["GIMP" if functions == "GIMP" else "MPM", ROWS[method],
                     case.split("end ")[1], f"{entry['least']:.4f}",
                     f"{entry['largest']:.4f}",
                     f"{100 * entry['share within 1 %']:.0f} %"])
    return table(["functions", "method", "end at", "least σ_xx (kPa)",
                  "largest", "points within 1 %"], rows)


def cylinder_table():
    numbers = load_numbers("cylinder")
    rows = []
    for case, entry in numbers.items():
        placement, support, method = case.split(", ")
        rows.append([placement, support, ROWS[method],
                     percent(entry["displacement"]), percent(entry["stress"]),
                     f"{entry['order of displacement']:.2f}",
                     f"{entry['order of stress']:.2f}"])
    return table(["placement", "minimum support", "method",
                  "error of displacement, h = 1/32 m",
                  "of stress", "order of displacement", "of stress"], rows)


def slope_table():
    numbers = load_numbers("submerged_slope")
    del numbers["minimum support"]
    keys = [key for entry in numbers.values() for key, value in entry.items()
            if not isinstance(value, dict)]
    rows = []
    for key in dict.fromkeys(keys):
        cells = [numbers[run].get(key, "–") for run in numbers]
        if key.endswith("share"):
            cells = [percent(c) for c in cells]
        rows.append([key] +
                    [f"{c:.3g}" if isinstance(c, float) else c for c in cells])
    return table(["", *numbers], rows)


def slope_loads_table():
    entry = load_numbers("submerged_slope")["points"]
    loads = {key: value for key, value in entry.items()
             if key.startswith("loads at")}
    return table(["", "loaded points", "mean height of soil above (m)",
                  "largest (m)", "under more than 0.5 m"],
                 [[key, value["loaded_points"],
                   f"{value['mean_cover_m']:.2f}",
                   f"{value['largest_cover_m']:.2f}",
                   value["under_more_than_a_cell"]]
                  for key, value in loads.items()])


def support_table():
    numbers = load_numbers("submerged_slope")["minimum support"]
    return table(["minimum support", "roughness of the mean stress at 45° (kPa)",
                  "run to 1 s ended at (s)"],
                 [[support, f"{roughness:.1f}", f"{end:g}"]
                  for support, (roughness, end) in numbers.items()])


def dyke_table():
    numbers = load_numbers("dyke_contour")
    rows = [[name, entry["outcome"],
             *(f"{entry[key]:.2f}" +
               ("" if name == "proximity field" else
                f" ({100 * entry[key + ' / proximity field'] - 100:+.1f} %)")
               for key in ("initial failure (s)", "flooding (s)"))]
            for name, entry in numbers.items()]
    return table(["surface", "outcome", "initial failure (s)", "flooding (s)"],
                 rows)


TABLES = {"table 7.1": (table_7_1, ("bar_1d", "inclined_bar")),
          "bar": (bar_table, ("bar_1d",)),
          "inclined bar": (inclined_table, ("inclined_bar",)),
          "uniaxial block": (uniaxial_table, ("uniaxial_block",)),
          "cylinder": (cylinder_table, ("cylinder",)),
          "slope": (slope_table, ("submerged_slope",)),
          "slope loads": (slope_loads_table, ("submerged_slope",)),
          "minimum support": (support_table, ("submerged_slope",)),
          "dyke": (dyke_table, ("dyke_contour",))}


def main():
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    for name, (make, needs) in TABLES.items():
        begin, end = f"<!-- begin {name} -->", f"<!-- end {name} -->"
        if begin not in page or end not in page:
            sys.exit(f"{PAGE}: no place for the table \"{name}\"")
        if any(load_numbers(study) is None for study in needs):
            print("    not run yet:", name)
            continue
        head, rest = page.split(begin, 1)
        page = head + begin + "\n" + make() + "\n" + end + \
            rest.split(end, 1)[1]
    write_text(PAGE, page)
    print("   ", os.path.relpath(PAGE, ROOT))


if __name__ == "__main__":
    main()
