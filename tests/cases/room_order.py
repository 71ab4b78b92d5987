#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does every room of the house include only rooms above it?

    /usr/bin/python3 tests/cases/room_order.py SOURCE_DIR
    /usr/bin/python3 tests/cases/room_order.py --self-test

Reads every #include <waker/ROOM/...> in include/waker/ and source/. The first
form fails if a room includes one below it, if a room is not in the list, or if a
header does not exist. The second shows that it can fail.
"""

import os
import re
import sys
import tempfile

# From the ground up, a subroom for itself; CONTRIBUTING.md says what each holds.
ROOMS = [
    "base", "grid", "particles", "materials", "nodes", "mapping",
    "surface/shape", "surface/boxes", "surface", "loads", "mechanics",
    "measures", "control", "output", "case", "observers", "simulation",
    "fields", "store", "statistics", "campaign", "program",
]
# Rooms that may include less than all that is above them.
ONLY = {"fields": ["base"]}
# Headers that CMake makes in the build folder.
GENERATED = {"base/version.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]waker/([^">]+)[">]')
# A header that is private to a room stands beside its sources.
PRIVATE = re.compile(r'^\s*#\s*include\s*"((?!waker/)[^">]+)"')


def allowed(room):
    rooms = ONLY.get(room, ROOMS[:ROOMS.index(room)])
    return rooms + [room]


def files(source):
    """(path, room) of every file of every room; source/main.cc is in none."""
    for top in ("include/waker", "source"):
        for folder, _, names in sorted(os.walk(os.path.join(source, top))):
            room = os.path.relpath(folder, os.path.join(source, top))
            for name in sorted(names):
                if name.endswith((".h", ".cc")) and room != ".":
                    yield (os.path.join(folder, name),
                           room.replace(os.sep, "/"))


def check(source):
    """A list of what is wrong, and the number of includes looked at."""
    problems, count = [], 0
    for path, room in files(source):
        here = os.path.relpath(path, source)
        if room not in ROOMS:
            problems.append(f"{here}: the room {room}/ is not in the list")
            continue
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                match = PRIVATE.match(line)
                if match and not os.path.exists(os.path.join(
                        os.path.dirname(path), match[1])):
                    problems.append(f'{here}:{number}: "{match[1]}" is not '
                                    "beside it")
                match = INCLUDE.match(line)
                if not match:
                    continue
                count += 1
                header = match[1]
                where = f"{here}:{number}"
                if os.path.dirname(header) not in allowed(room):
                    problems.append(f"{where}: {room}/ must not include "
                                    f"<waker/{header}>")
                if header not in GENERATED and not os.path.exists(
                        os.path.join(source, "include/waker", header)):
                    problems.append(f"{where}: <waker/{header}> does not "
                                    "exist")
    return problems, count


def self_test():
    """A little house with every fault, and one without."""
    good = {
        "include/waker/base/a.h": "",
        "include/waker/grid/b.h": "#include <waker/base/a.h>\n",
        "include/waker/fields/f.h": "#include <waker/base/a.h>\n",
        "include/waker/surface/boxes/b.h": "#include <waker/base/a.h>\n",
        "include/waker/surface/s.h": "#include <waker/surface/boxes/b.h>\n",
        "source/grid/b.cc": "#include <waker/grid/b.h>\n"
                            "#include <waker/base/version.h>\n",
        "source/program/p.cc": "  #  include <waker/grid/b.h>\n",
        "source/main.cc": "#include <waker/grid/b.h>\n",
    }
    faults = {
        "source/base/a.cc": "\n#include <waker/grid/b.h>\n",
        "source/fields/f.cc": "#include <waker/grid/b.h>\n",
        "source/cellar/c.cc": "#include <waker/base/a.h>\n",
        "source/grid/c.cc": "#include <waker/base/missing.h>\n",
        "source/grid/d.cc": '#include "waker/program/p.h"\n',
        "source/surface/boxes/b.cc": "#include <waker/surface/s.h>\n",
        "source/grid/e.cc": '#include "moved.h"\n',
    }
    expected = {
        "source/base/a.cc": ["source/base/a.cc:2: base/ must not include "
                             "<waker/grid/b.h>"],
        "source/fields/f.cc": ["source/fields/f.cc:1: fields/ must not include "
                               "<waker/grid/b.h>"],
        "source/cellar/c.cc": ["source/cellar/c.cc: the room cellar/ is not in "
                               "the list"],
        "source/grid/c.cc": ["source/grid/c.cc:1: <waker/base/missing.h> does "
                             "not exist"],
        "source/grid/d.cc": ["source/grid/d.cc:1: grid/ must not include "
                             "<waker/program/p.h>",
                             "source/grid/d.cc:1: <waker/program/p.h> does not "
                             "exist"],
        "source/grid/e.cc": ['source/grid/e.cc:1: "moved.h" is not beside it'],
        "source/surface/boxes/b.cc": ["source/surface/boxes/b.cc:1: "
                                      "surface/boxes/ must not include "
                                      "<waker/surface/s.h>"],
    }

    def build(contents):
        with tempfile.TemporaryDirectory() as source:
            for name, text in contents.items():
                path = os.path.join(source, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            return check(source)

    problems, count = build(good)
    assert problems == [] and count == 7, (problems, count)
    for name, text in faults.items():
        problems, _ = build({**good, name: text})
        assert problems == expected[name], (name, problems)
    print("The check fails where it should.")


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    problems, count = check(sys.argv[1])
    for problem in problems:
        print(problem)
    if count == 0:
        sys.exit(f"{sys.argv[1]}: no #include of a room found")
    if problems:
        sys.exit(1)
    print(f"{count} includes, all from rooms above.")


if __name__ == "__main__":
    main()
