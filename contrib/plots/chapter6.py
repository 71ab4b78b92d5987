#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slope of chapter 6: what failed, how far, under which load, from the
realisations of its campaigns.

usage: chapter6.py DATA_FOLDER FIGURE_FOLDER [CAMPAIGN_FOLDER ...]
                   [--waker PROGRAM] [--page MARKDOWN]

Each campaign folder is first put into DATA_FOLDER as <name>.csv with the columns
that count, named after its Output/Directory without "output-chapter6-". A table
that is there is extended, also by a campaign of a later program with other numbers
(--realisations 52:100 after 0:54), if those that are in both are equal and one of
them slid; else it is replaced, but by the same campaign with other numbers: then it
stays, and that is said. One that is not merged yet is copied and merged by
PROGRAM, and stays as it is. Then the figures of all
that is in DATA_FOLDER are drawn, and the tables put into the sections of the
page; without --page they are printed. What cannot be drawn is said.

A folder of a run of mean strengths (foundation, foundation-2d, foundation-2b-2d
...) becomes a row of mean_strength.csv.

Names: analysis1, analysis2b ... are in 3D, with "-2d" in plane strain; weight1 ...
are under their own weight alone (--set "Load programmes/Names="), length2,
length4, length8 such ones with smooth ends. --waker also computes the histories
of figure 6.2, if DATA_FOLDER has none.
"""

import argparse
import os

import chapter6_histograms
import chapter6_pages
import chapter6_programmes
import page
from chapter6_data import Sets, take, take_run
from chapter6_tables import tables


def draw(sets, data, figures):
    """Draws all; says what is missing: {figure: words}."""
    notes = {"figure_6_02": chapter6_programmes.examples(figures, data)}
    chapter6_programmes.trends(figures)
    for name in chapter6_histograms.FIGURES:
        notes[name] = chapter6_histograms.draw(name, sets, figures)
    notes["pairs"] = chapter6_histograms.draw_pairs(sets, figures)
    for name, note in notes.items():
        if note:
            print(f"{name}: {note}")
    return notes


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", metavar="DATA_FOLDER")
    parser.add_argument("figures", metavar="FIGURE_FOLDER")
    parser.add_argument("campaigns", metavar="CAMPAIGN_FOLDER", nargs="*")
    parser.add_argument("--waker", metavar="PROGRAM")
    parser.add_argument("--page", metavar="MARKDOWN")
    arguments = parser.parse_args()
    for folder in (arguments.data, arguments.figures):
        os.makedirs(folder, exist_ok=True)
    for folder in arguments.campaigns:
        is_run = os.path.exists(os.path.join(folder, "summary.json"))
        print(take_run(folder, arguments.data) if is_run else
              take(folder, arguments.data, arguments.waker))
    if arguments.waker and not os.path.exists(os.path.join(
            arguments.data, chapter6_programmes.EXAMPLES)):
        print(chapter6_programmes.find_examples(arguments.waker,
                                                arguments.data))
    sets = Sets(arguments.data)
    notes = draw(sets, arguments.data, arguments.figures)
    sections = tables(sets)
    sections["pictures"] = chapter6_pages.pictures(sets)
    if not arguments.page:
        print("\n\n".join(sections.values()))
        return
    sections["figures"] = chapter6_pages.figures(notes, os.path.relpath(
        arguments.figures, os.path.dirname(arguments.page) or "."))
    page.rewrite(arguments.page, sections)
    print(arguments.page)


if __name__ == "__main__":
    main()
