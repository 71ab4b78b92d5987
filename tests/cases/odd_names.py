#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of the user's with signs that mean something in XML, CSV or .prm: every
file of a run can be read, and its parameters.prm makes the same run again.

usage: odd_names.py WAKER_BINARY SOURCE_DIR
"""

import glob
import os
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import meshio
import numpy as np
import runs
from program import Program

MATERIAL = "D\u00fcne 1.5 <& 'clay'>"
LAYER = "a.b: c"
WIND = "wind & golf <v1.5>"
WALL = "50% wall.2"
FOLDER = "r\u00e9sum\u00e9 & back\\slash <1>"

CASE = f"""
subsection Grid
  set Lower corner = 0, 0
  set Upper corner = 4, 2
  set Cell size    = 0.5
end
subsection Materials
  set Names = {MATERIAL}
  subsection {MATERIAL}
    set Model = linear elastic
  end
end
subsection Soil profile
  set Layers = {LAYER}
  subsection {LAYER}
    set Material = {MATERIAL}
    set Polygon  = 0, 0; 3, 0; 3, 1; 0, 1
  end
end
subsection Boundary conditions
  set Names = base.1
  subsection base.1
    set Region = bottom
  end
end
subsection Tractions
  set Names = {WIND}
  subsection {WIND}
    set Method = contour
    set Kind   = vector
    set Value  = 0; -0.1
  end
end
subsection Point loads
  set Names = man & dog
  subsection man & dog
    set From  = 1, 1
    set Force = 0, -0.1
  end
end
subsection Walls
  set Names = {WALL}
  subsection {WALL}
    set Line = 3, 0; 3, 1
  end
end
subsection Time stepping
  set End time = 0.03
end
subsection Output
  set Interval = 0.01
end
"""


def text(*parts):
    with open(os.path.join(*parts), encoding="utf-8") as file:
        return file.read()


def main():
    check = runs.Check()
    with tempfile.TemporaryDirectory(prefix="waker-") as place, \
            Program(sys.argv[1]) as waker:
        def run(file, folder, *options):
            waker.run(["run", file, *options,
                       "--set", "Output/Directory=" + folder], check=True)

        os.chdir(place)
        with open("case.prm", "w", encoding="utf-8") as file:
            file.write(CASE)
        run("case.prm", FOLDER)

        arrays = set()
        files = glob.glob(os.path.join(glob.escape(FOLDER), "solution", "*.vtu"))
        for path in files:
            ElementTree.parse(path)
            arrays |= set(meshio.read(path).point_data)
        for path in glob.glob(os.path.join(glob.escape(FOLDER), "*.pvd")):
            for entry in ElementTree.parse(path).getroot().iter("DataSet"):
                check(f"file of {os.path.basename(path)} is there",
                      os.path.isfile(os.path.join(FOLDER, entry.get("file"))),
                      1, 1)
        check("VTU files", len(files), 10, 99)
        check("array of the traction",
              "force_" + WIND.replace(" ", "_") in arrays, 1, 1)

        table = runs.statistics(FOLDER)
        check("columns of the wall",
              sum(name.startswith("Wall " + WALL) for name in table), 2, 9)

        # Again from parameters.prm, twice: to another folder, and to itself.
        run(os.path.join(FOLDER, "parameters.prm"), "again")
        again = runs.statistics("again")
        different = [name for name in table
                     if not np.array_equal(table[name], again[name],
                                           equal_nan=True)]
        check(f"statistics of the second run differ in {different}",
              len(different), 0, 0)
        first = text(FOLDER, "parameters.prm")
        run(os.path.join(FOLDER, "parameters.prm"), FOLDER, "--overwrite")
        check("parameters.prm differs", text(FOLDER, "parameters.prm") != first,
              0, 0)
    check.exit()


if __name__ == "__main__":
    main()
