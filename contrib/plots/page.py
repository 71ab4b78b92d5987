# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of a page that a script writes."""

import re
import sys


def replace(page, name, text):
    """The page with `text` between the lines `<!-- begin NAME -->` and
    `<!-- end NAME -->`."""
    pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)",
                         re.DOTALL)
    if not pattern.search(page):
        sys.exit(f"the page has no lines '<!-- begin {name} -->' and "
                 f"'<!-- end {name} -->'")
    return pattern.sub(lambda match: match[1] + text + "\n" + match[2], page)


def rewrite(path, tables):
    """Puts {name: Markdown} into the page in a file."""
    with open(path, encoding="utf-8") as file:
        page = file.read()
    for name, text in tables.items():
        page = replace(page, name, text)
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
