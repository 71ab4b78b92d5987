#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong input to the program: each gets exit code 2, three lines on standard
error (where, what, what is allowed), and nothing is written.

usage: bad_input.py WAKER_BINARY SOURCE_DIR
"""

import json
import os
import re
import sys
import tempfile

from program import Program

source = os.path.abspath(sys.argv[2])
good = os.path.join(source, "parameters/chapter5/dyke.prm")
slope = os.path.join(source, "parameters/chapter6/slope.prm")
foundation = os.path.join(source, "parameters/chapter6/foundation.prm")
random = os.path.join(source, "parameters/chapter5/analysis1.prm")
with open(good, encoding="utf-8") as good_file:
    good_lines = good_file.read().splitlines()

NUMBER = ":[0-9]+"
CLAY = "Materials/clay"
POLYGON = "Soil profile/dyke/Polygon"
# The loads of these cases are of one name.
LOAD = "--set", "Tractions/Names=load"
POINT_LOAD = "--set", "Point loads/Names=p"
PROGRAMME = "--set", "Load programmes/Names=q"


def sets(*values):
    return [word for value in values for word in ("--set", value)]


def write(path, contents):
    with open(path, "wb") as file:
        file.write(os.fsencode(contents))


def contents_of(folder):
    """All that is below it, files with their contents."""
    found = {}
    for base, folders, files in os.walk(folder):
        for name in folders:
            found[os.path.join(base, name)] = None
        for name in files:
            with open(os.path.join(base, name), "rb") as file:
                found[os.path.join(base, name)] = file.read()
    return found


class Cases:
    """Calls the program with wrong input, in the working folder."""

    def __init__(self, program):
        self.program = program
        self.made = 0
        self.failures = 0

    def complain(self, name, what, done):
        self.failures += 1
        print(f"FAILED: {name}: {what}")
        print("    " + done.stderr.replace("\n", "\n    ").encode(
            "utf-8", "replace").decode(), flush=True)

    def check(self, name, where, what, arguments):
        """Where and what: regular expressions that the first two lines must
        match."""
        self.made += 1
        before = contents_of(".")
        done = self.program.run(arguments)
        lines = done.stderr.split("\n") + ["", "", ""]
        for is_good, problem in (
                (done.returncode == 2,
                 f"exit code {done.returncode} instead of 2"),
                (done.stderr.count("\n") == 3, "not three lines"),
                (re.search(where, lines[0]),
                 f"first line does not match '{where}'"),
                (re.search(what, lines[1]),
                 f"second line does not match '{what}'"),
                (re.search("^allowed: .", lines[2]),
                 "third line does not say what is allowed"),
                (contents_of(".") == before, "wrote something")):
            if not is_good:
                self.complain(name, problem, done)

    def set_value(self, name, path, value, what):
        """The same with one value of the good case changed."""
        self.check(name, f"^--set {path}$", what,
                   ["run", good, "--set", f"{path}={value}"])

    def edit(self, name, changed, line, what):
        """The same with other lines than those of the good case."""
        write("case.prm", "\n".join(changed) + "\n")
        self.check(name, f"^case.prm{line}$", what, ["run", "case.prm"])

    def traction(self, name, entry, value, what, *more):
        self.check(name, f"^--set Tractions/load/{entry}$", what,
                   ["run", good, *LOAD, "--set",
                    f"Tractions/load/{entry}={value}", *sets(*more)])

    def wall(self, entry, value, what):
        self.check(f"wall: {entry} {value}", f"^--set Walls/w/{entry}$", what,
                   ["run", good,
                    *sets("Walls/Names=w", f"Walls/w/{entry}={value}")])

    def inflow(self, entry, value, what, *more):
        self.check(f"inflow: {entry} {value}", f"^--set Inflow/i/{entry}$",
                   what,
                   ["run", good, *sets("Inflow/Names=i",
                                       f"Inflow/i/{entry}={value}", *more)])


def replaced(old, new):
    """The lines of the good case with a text replaced, once in each line."""
    lines = [line.replace(old, new, 1) for line in good_lines]
    assert lines != good_lines, old
    return lines


def without_layers():
    """Neither the list of layers nor the one there is."""
    lines = [line for line in good_lines if "Layers" not in line]
    first = next(i for i, line in enumerate(lines) if "subsection dyke" in line)
    last = next(i for i in range(first + 1, len(lines)) if "  end" in lines[i])
    return lines[:first] + lines[last + 1:]


def command_line(cases):
    check = cases.check
    check("no command", "command line", "subcommand", [])
    check("no file given", "command line", "FILE", ["run"])
    check("unknown option", "command line", "fast", ["run", good, "--fast"])
    check("both modes", "command line", "resume",
          ["run", good, "--resume", "--overwrite"])
    check("unknown format", "command line", "yaml",
          ["parameters", "--format", "yaml"])
    check("no value", "^--set Water$", "cannot read",
          ["run", good, "--set", "Water"])


def files(cases):
    check, edit = cases.check, cases.edit
    check("missing file", "^no.prm$", "No such file", ["run", "no.prm"])
    check("folder", r"^\.$", "is a folder", ["run", "."])
    # Each would wait for ever, or read without an end. Not in the working
    # folder, all of which is read.
    with tempfile.TemporaryDirectory(prefix="waker-") as place:
        pipe = os.path.join(place, "pipe")
        os.mkfifo(pipe)
        for path, kind in ((pipe, "a pipe"), ("/dev/zero", "a device")):
            what = "is no regular file, but " + kind
            check(f"parameters from {kind}", f"^{path}$", what, ["run", path])
            check(f"measurements from {kind}",
                  "^--set Random fields/strength/Measurements$", what,
                  ["campaign", random,
                   *sets(f"Random fields/strength/Measurements={path}")])
            check(f"levels from {kind}", "^--set Risk/Level table$", what,
                  ["campaign", random,
                   *sets("Risk/Level distribution=table",
                         f"Risk/Level table={path}")])
            cases.traction(f"surface from {kind}", "Surface file", path, what,
                           "Tractions/load/Method=user surface")
        os.rename(pipe, os.path.join(place, "campaign.json"))
        for command in ("status", "merge"):
            check(f"{command} of a pipe", f"^{place}$", "but a pipe",
                  [command, place])
    check("empty input", "^standard input", "no material", ["run", "-"])
    edit("misspelt name", replaced("Cell size", "Cel size"), NUMBER,
         '"Cel size"')
    edit("misspelt section", replaced("subsection Grid", "subsection Gird"),
         NUMBER, '"Gird"')
    edit("duplicate name",
         [line for line in good_lines
          for _ in range(1 + ("Cell size" in line))], NUMBER,
         "twice, first at case.prm:")
    edit("duplicate section", replaced("subsection Water", "subsection Grid"),
         NUMBER, "twice, first at case.prm:")
    edit("end missing", good_lines[:-1], NUMBER, "not closed")
    edit("end too much", good_lines + ["end"], NUMBER, "without a subsection")
    edit("no language", ["Hello" + good_lines[0]] + good_lines[1:], NUMBER,
         "Hello")
    edit("material of no name", replaced("Material = clay", "Material = peat"),
         NUMBER, "peat")


def values(cases):
    set_value = cases.set_value
    set_value("unknown name", "Grid/Size", 1, '"Size"')
    set_value("wrong type", "Grid/Cell size", "fine", '"fine"')
    set_value("out of range", "Dimension", 4, '"4"')
    set_value("no choice", "Water/Side", "up", '"up"')
    set_value("negative strength", f"{CLAY}/Initial strength", -1, "-1 kPa")
    set_value("residual above initial", f"{CLAY}/Residual strength", 14,
              "14 kPa")
    set_value("Poisson", f"{CLAY}/Poisson's ratio", 0.5, r"0\.5")
    set_value("snap-back", f"{CLAY}/Softening modulus", -600, "snap-back")
    set_value("hardening", f"{CLAY}/Softening modulus", 50, "50 kPa")
    # Whatever the model.
    set_value("kappa above lambda", f"{CLAY}/Kappa", 0.3, "Lambda 0.2")
    set_value("no kappa", f"{CLAY}/Kappa", 0, "is 0")
    set_value("lambda", f"{CLAY}/Lambda", "1e308", "is 1e")
    set_value("void ratio", f"{CLAY}/Void ratio", 0, "is 0")
    set_value("OCR", f"{CLAY}/OCR", 0.9, "is 0.9")
    set_value("OCR is no number", f"{CLAY}/OCR", "nan", "nan")
    set_value("least pressure", f"{CLAY}/Least pressure", 0, "is 0")
    set_value("negative p_c", f"{CLAY}/Preconsolidation pressure", -1, "is -1")
    set_value("time step", "Time stepping/Time step", 0, "is 0")
    set_value("tolerance", "Newton/Tolerance", 0, "is 0")
    set_value("edge of the crest", "Sliding masses/Crest edge", "left",
              '"left"')
    # The crest is that of x = 5 to 15 m, by the domains of its points.
    set_value("edge off the crest", "Sliding masses/Crest edge", 15.5,
              "is 15.5 m, but the crest reaches from x = 4.89")
    set_value("water above crest", "Water/Level", 5.5,
              "not below the crest at 5 m")
    set_value("water at the crest", "Water/Level", 5,
              "not below the crest at 5 m")
    set_value("water below the base", "Water/Level", -1, "below all soil")
    set_value("no level", "Water/Level", "none", "water stands on the left")
    set_value("level with a comma", "Water/Level", "4,75", '"4,75"')
    set_value("hexadecimal level", "Water/Level", "0x4", '"0x4"')
    set_value("constant loads", "Stop rules/Loads constant from", "0x4",
              '"0x4"')
    set_value("flooded from the start", "Water/Rise", 0.5, "flooded")
    set_value("too many numbers", "Grid/Upper corner", "42, 6, 1", "3 numbers")
    # Far from what anything has, wherever numbers are.
    for path, value in (("Water/Rise", "0: 0, 1e308: 1"),
                        (f"{CLAY}/Young's modulus", "1e308"),
                        (f"{CLAY}/Initial strength", "13 + 1e-300*depth"),
                        ("Time stepping/End time", "1e-300"),
                        (f"{CLAY}/Strength at top", "1e308"),
                        (f"{CLAY}/Strength growth", "1e308"),
                        (f"{CLAY}/Tensile strength", "1e308")):
        set_value(f"{path} of {value}", path, value, "the number 1e")
    set_value("softening length", f"{CLAY}/Softening length", "1e300",
              r"1e\+300 m")
    set_value("largest rise", "Time stepping/Largest rise", "1e-300",
              "1e-300 m")
    cases.edit("no layer", without_layers(),
               r" \(default of Soil profile/Layers\)", "no layer")


def sizes(cases):
    """Without a limit: refused before anything is allocated."""
    check = cases.check
    check("a wide box", "dyke.prm:[0-9]+$", "Grid/Cell size: .* unknowns",
          ["run", good, *sets("Grid/Upper corner=1070000000, 6")])
    cases.set_value("tiny cells", "Grid/Cell size", "1e-4",
                    r"5\.76e\+10 unknowns")
    cases.set_value("no time step", "Time stepping/Time step", "1e-14",
                    "steps")
    check("tiny cells of a field", "^--set Random fields/strength/Cell size$",
          "cells of the field along x",
          ["campaign", random,
           *sets("Random fields/strength/Cell size=1e-14, 3")])
    check("narrow bins", "^--set Histograms/Width bin$", "bins",
          ["campaign", random, *sets("Histograms/Width bin=1e-9")])
    sweep = "Sweep/Parameter=Grid/Cell size"
    check("a later value of a sweep", "^--set Sweep/Values$",
          "^Grid/Cell size: is 0.7: Grid/Upper corner: .*no multiple",
          ["campaign", random, *sets(sweep, "Sweep/Values=0.5; 0.7")])
    check("the first value of a sweep", "prm:[0-9]+$",
          r"no multiple of the cell size.*\(Grid/Cell size is 0.7\)",
          ["campaign", random, *sets(sweep, "Sweep/Values=0.7; 0.5")])
    check("many realisations", "^--set Campaign/Realisations$",
          r"2\.15e\+09",
          ["campaign", random, *sets("Campaign/Realisations=2147483647")])
    check("a load far away", "^--set Point loads/p/From$",
          r"15[0-9.]+ m from the nearest",
          ["run", good, *POINT_LOAD, *sets("Point loads/p/From=155000, 5",
                                           "Point loads/p/Force=0, -1")])


def decimal_commas(cases):
    """Where one number is wanted and where a list has too many; what is no
    formula; what does not repeat."""
    check, set_value = cases.check, cases.set_value
    set_value("comma: number", "Grid/Cell size", "0,25", '"0,25"')
    set_value("comma: list", "Grid/Lower corner", "-6,5, 0", '"-6,5, 0"')
    set_value("comma: one number or two", "Grid/Lower corner", "-6,5", '"-6,5"')
    set_value("comma: velocity", "Soil profile/dyke/Velocity", "0,25",
              "1 number or expression")
    set_value("comma: table", "Water/Rise", "0: 1,5, 3: 2", "no pair")
    set_value("comma: polygon", POLYGON, "0,5, 0; 30, 0; 15, 5", "corner 1")
    set_value("rise in two parts", "Water/Rise", "1; 2", '";" has no meaning')
    set_value("chance", "Water/Rise", "0.1*rand()", "would not repeat")
    set_value("long expression", "Water/Rise", "1" * 40000, "40000 characters")
    check("comma: stress", "^--set Soil profile/dyke/Initial stress$",
          "a comma",
          ["run", good,
           *sets("Soil profile/dyke/Initial stress=-1,5; -1; -1; 0",
                 "Gravity/Initial stress=false")])
    check("comma: displacement", "Boundary conditions/base/Displacement$",
          "a comma",
          ["run", good,
           *sets("Boundary conditions/base/Displacement=0,1*t; free",
                 "Boundary conditions/base/Type=prescribed")])
    check("seed", "^--set Campaign/Seed$", "18446744073709551616",
          ["campaign", good, *sets("Campaign/Seed=18446744073709551616")])


def numbers_of_the_command_line(cases):
    check = cases.check
    for n in ("-1", "18446744073709551615", "99999999999999999999", "1.5",
              "1e3", "", "x"):
        for option in ("realisation", "scenario"):
            check(f"--{option}={n}", "command line", f"--{option}",
                  ["run", good, f"--{option}={n}"])
    check("--realisation -1", "command line", '--realisation is "-1"',
          ["run", good, "--realisation", "-1"])
    for part in ("-1/2", "0/2", "3/2", "1", "1/", "/", "", "1/99999999999",
                 "1.5/2", "1 / 2"):
        check(f"--chunk={part}", "command line", "--chunk",
              ["campaign", good, f"--chunk={part}"])
    for part in ("-1:2", "2:2", "3:2", ":", "", "0:18446744073709551616",
                 "0-5"):
        check(f"--realisations={part}", "command line", "--realisations",
              ["campaign", good, f"--realisations={part}"])


def texts(cases):
    """Text that is no text, and too much of it."""
    check, set_value = cases.check, cases.set_value
    write("latin.prm", b"subsection Materials\n  set Names = D\374ne\n")
    check("Latin-1", "^latin.prm:2$", r"D\?ne", ["run", "latin.prm"])
    check("Latin-1 folder", "^--set Output/Directory$", "no plain text",
          ["run", good, "--set", b"Output/Directory=D\374ne"])
    set_value("folder with #", "Output/Directory", "run#1", "parameters.prm")
    set_value("folder ends in backslash", "Output/Directory", "run\\",
              "parameters.prm")
    write("deep.prm", "subsection a\n" * 20000)
    check("deep", "^deep.prm:11$", "deep", ["run", "deep.prm"])
    write("zeros.prm", bytes(100000))
    check("zeros", "^zeros.prm:1$", "cannot read", ["run", "zeros.prm"])


def grid(cases):
    """What only the grid can tell."""
    check, set_value = cases.check, cases.set_value
    set_value("no multiple of cells", "Grid/Upper corner", "42.1, 6",
              "multiple")
    set_value("outside the grid", POLYGON, "0,0; 50,0; 15,5", "outside")
    set_value("self-crossing", POLYGON, "0,0; 30,0; 5,5; 15,5", "Polygon")
    set_value("two corners", POLYGON, "0,0; 30,0", "Polygon")
    set_value("no area", POLYGON, "0,0; 30,0; 15,0", "Polygon")
    check("a layer thinner than round-off", f"^--set {POLYGON}$", "too thin",
          ["run", good, *sets(f"{POLYGON}=0,0; 1e-12,0; 1e-12,1e-12",
                              "Water/Side=none")])
    check("a thin layer beside a thick one",
          "^--set Soil profile/film/Polygon$", "too thin",
          ["run", good, *sets(
              "Soil profile/Layers=dyke, film",
              "Soil profile/film/Material=clay",
              "Soil profile/film/Polygon=31,0; 31.000000000001,0; 31,1e-12")])
    set_value("points", "Material points/Points per direction", 0, '"0"')
    set_value("stress with gravity step", "Soil profile/dyke/Initial stress",
              "-1; -1; -1; 0", "gravity step")
    check("stress of three parts", "^--set Soil profile/dyke/Initial stress$",
          "has 3",
          ["run", good, *sets("Soil profile/dyke/Initial stress=1; 2; 3",
                              "Gravity/Initial stress=false")])
    check("corners inside rows", "^--set Material points/Placement$",
          "inside rows",
          ["run", good, *sets("Material points/Placement=rows",
                              f"{POLYGON}=0,0; 30,0; 30,1.05; 0,1.05",
                              "Water/Side=none")])
    check("overlap", "^--set Soil profile/[a-z]+/Polygon$", "overlap",
          ["run", good, *sets(
              "Soil profile/Layers=dyke, berm",
              "Soil profile/berm/Material=clay",
              "Soil profile/berm/Polygon=20,0; 35,0; 35,2; 20,2")])
    check("validate", "^--set", "outside",
          ["run", good, "--validate", *sets(f"{POLYGON}=0,0; 50,0; 15,5")])
    check("strength reduction", "^--set", "the lower factor",
          ["strength-reduction", good,
           *sets("Strength reduction/Upper factor=0.1")])


def tractions(cases):
    check, traction = cases.check, cases.traction
    write("open.txt", "8 1\n20 1\n15 5\n")
    write("crossing.txt", "8 1\n20 4\n20 1\n8 4\n8 1\n")
    write("clockwise.txt", "8 1\n15 4\n20 1\n8 1\n")
    write("outside.txt", "8 1\n50 1\n15 4\n8 1\n")
    for shape, what in (("open", "is open"), ("crossing", "crosses"),
                        ("clockwise", "wrong side"),
                        ("outside", "outside the grid"),
                        ("missing", "cannot be read")):
        traction(f"user surface: {shape}", "Surface file", f"{shape}.txt",
                 what, "Tractions/load/Method=user surface")
    check("no user surface", "Tractions/load/Surface file", "is empty",
          ["run", good, *LOAD, *sets("Tractions/load/Method=user surface")])
    traction("volume with GIMP", "Method", "volume", "linear")  # fits MPM only
    traction("volume of a slope", "Method", "volume", "cannot be placed",
             "Kinematics and mapping/Functions=linear")
    traction("no such method", "Method", "surface", '"surface"')
    traction("file for contour", "Surface file", "open.txt", "contour")
    traction("two pressures", "Value", "1; 2", "2 numbers")
    traction("vector", "Value", "1", "1 number", "Tractions/load/Kind=vector")
    traction("no expression", "Value", "1 +", "cannot be read")
    traction("comma", "Value", "0,25", "a comma")
    hydrostatic = "Tractions/load/Kind=hydrostatic"
    traction("table", "Level", "0: 1, 0: 2", "does not come after",
             hydrostatic)
    traction("level below the surface", "Level", "-1",
             "no part of the surface", hydrostatic)
    traction("nothing there", "From", "-5, 3", "no part of the surface",
             "Tractions/load/To=-4, 4")
    traction("nothing that faces", "Facing", "0, -1", "no part of the surface")
    traction("fixed points by t", "Value", "1 + t", "once, at t = 0",
             "Tractions/load/Method=fixed points")
    traction("a liquid on soil", "Follows", "soil", "liquid", hydrostatic,
             "Tractions/load/Level=1")
    traction("nodes on soil", "Follows", "soil", '"surface nodes"',
             "Tractions/load/Method=surface nodes")
    traction("fixed points in space", "Follows", "space", "fixed points",
             "Tractions/load/Method=fixed points")
    traction("half a box", "From", "1, 1, 1", "3 numbers",
             "Tractions/load/To=2, 2")
    check("level without a surface", "Tractions/load/Level", "is empty",
          ["run", good, *LOAD, *sets(hydrostatic)])
    check("unnamed traction", "^--set Tractions/Names", "no subsection",
          ["run", good, *sets("Tractions/Names=load, wind",
                              "Tractions/load/Value=1")])


def other_loads(cases):
    check, set_value = cases.check, cases.set_value
    set_value("gaps as wide as domains", "Surface/Minimum gap width", 1, "1")
    set_value("rise", "Water/Rise", "0: 0, 2", "no pair")
    set_value("constant from when?", "Stop rules/Loads constant from", "soon",
              "soon")
    check("loads that are not constant",
          "^--set Stop rules/Loads constant from", "Water/Rise changes",
          ["run", good, *sets("Water/Rise=0.01*t",
                              "Stop rules/Loads constant from=5")])
    check("point load nowhere", "^--set Point loads/p/From", "no point",
          ["run", good, *POINT_LOAD, *sets("Point loads/p/Force=0, 1",
                                           "Point loads/p/From=-5, 3",
                                           "Point loads/p/To=-4, 4")])
    check("point load", "^--set Point loads/p/Force", "1 number",
          ["run", good, *POINT_LOAD, *sets("Point loads/p/Force=1",
                                           "Point loads/p/From=-5, 3")])


def load_programmes(cases):
    """On the crest, from x = 5 to 15 m."""
    check, usual = cases.check, {"Rate": 0.5, "From": 7, "To": 9}

    def programme(entry, text, settings=()):
        path = "Load programmes/q/"
        values = dict(usual, **{name: value for name, value in settings
                                if "/" not in name})
        others = [f"{name}={value}" for name, value in settings if "/" in name]
        check(f"load programme: {entry}",
              f"(^--set |default of ){path}{entry}[)]?$", text,
              ["run", good, *PROGRAMME,
               *sets(*others, *(f"{path}{name}={value}"
                                for name, value in values.items()))])

    programme("Rate", "is 0", [("Rate", 0)])
    programme("From", "not level", [("To", 25)])
    programme("From", "beyond the soil", [("From", -8), ("To", -7)])
    programme("Load", "none of Tractions/Names", [("Drives", "traction")])
    programme("Drives", "Water/Side is none", [
        ("Drives", "water"), ("Water/Side", "none")])
    programme("Stopped by", "no dyke", [
        ("Stopped by", "loss of width"), ("Stop above", 1),
        ("Water/Side", "none"), ("Water/Level", "none")])
    programme("Stopped by", "no points carry the load", [
        ("Stopped by", "settlement of the load"), ("Stop above", 1),
        ("Drives", "water")])
    programme("Hold above", "is 0", [("Held by", "largest settlement rate")])
    programme("Table", "no table", [("Kind", "table of time"), ("Table", "2*t")])
    programme("Table", "does not come after",
              [("Kind", "table of a quantity"), ("Table", "3: 0, 1: 5")])


def walls_and_flow(cases):
    wall, inflow = cases.wall, cases.inflow
    wall("Line", "1, 1", "1 corners")
    wall("Line", "1, 1; 1, x", "no number")
    wall("Line", "1, 1; 1, 99", "leaves the grid")
    wall("Displacement", "t", "1 parts")
    wall("Type", "sticky", "sticky")
    cases.check("wall: explicit", "Time stepping/Scheme", "walls",
                ["run", good, *sets("Walls/Names=w",
                                    "Walls/w/Line=1, 1; 1, 2",
                                    "Time stepping/Scheme=explicit")])
    cases.set_value("no such face", "Outflow/Faces", "right, front", "front")
    cases.set_value("closed face", "Outflow/Faces", "bottom", "closed")
    inflow("Velocity", "0", "0")
    inflow("Material", "sand", "no material", "Inflow/i/Velocity=1")
    inflow("From", "0, 0.1", "0.1 m", "Inflow/i/Velocity=1",
           "Inflow/i/Material=clay")
    inflow("Face", "bottom", "held", "Inflow/i/Velocity=1",
           "Inflow/i/Material=clay")


def three_dimensions(cases):
    """Height maps, and faces that are held and open in parts."""
    def check(name, path, what, *values):
        cases.check(name, f"^--set {path}$", what,
                    ["run", slope, *sets("Grid/Cell size=0.5", *values)])

    places = [(x, z) for x in (0, 3.5) for z in (0, 4, 8)]
    top = "Soil profile/slope/Top"

    def height_map(name, lines, what):
        write("map.csv", "\n".join(lines) + "\n")
        check(name, top, what, f"{top}=map.csv")

    table = ["x, z, y"] + [f"{x}, {z}, 0.5" for x, z in places]
    height_map("height map: hole", table[:3] + table[4:], "hole")
    height_map("height map: two heights", table + ["0, 4, 0.7"], "two heights")
    height_map("height map: too small", [line for line in table
                                         if ", 8," not in line],
               "inside the layer")
    height_map("height map: no titles", table[1:], "names of three")
    height_map("height map: nothing left",
               ["x, z, y"] + [f"{x}, {z}, -1" for x, z in places],
               "leaves nothing")
    check("height map: no file", top, "nowhere.csv", f"{top}=nowhere.csv")

    # A roof that comes back over itself, and a wall.
    def stl(name, triangles, what):
        write("map.stl", "solid\n" + "".join(
            "facet normal 0 1 0\nouter loop\n" + "".join(
                f"vertex {x} {y} {z}\n" for x, y, z in triangle)
            + "endloop\nendfacet\n" for triangle in triangles) + "endsolid\n")
        check(name, top, what, f"{top}=map.stl")

    a, b, c, d = (0, 0.5, 0), (4, 0.5, 0), (4, 0.5, 8), (0, 0.5, 8)
    flat = [(a, b, c), (a, c, d)]
    stl("height map: overhang", flat + [(c, a, (1, 0.9, 6))], "folds back")
    stl("height map: wall", flat + [((1, 0.5, 2), (2, 0.5, 4), (2, 0.9, 4))],
        "upright")
    stl("height map: half of it", flat[:1], "hole")

    cases.check("whole sub-cells that are not the profile",
                r"slope\.prm:\d+$", "Placement: the whole sub-cells have",
                ["run", slope,
                 *sets("Grid/Cell size=0.5",
                       "Soil profile/slope/Polygon=0,0; 3,0; 3,0.9; 0,0.9")])
    cases.check("held and open", r"slope\.prm:\d+$",
                "Outflow/near toe/Face: .*near end",
                ["run", slope, *sets("Outflow/near toe/From=3, 0, 0",
                                     "Grid/Cell size=0.5")])
    cases.check("open as a whole, held in a part", "^--set Outflow/Faces$",
                "near end", ["run", slope, *sets("Outflow/Faces=right, back",
                                                 "Grid/Cell size=0.5")])
    check("opening off the lines", "Outflow/near toe/From", "3.6 m",
          "Outflow/near toe/From=3.6, 0, 0")
    check("opening without a face", "Outflow/near toe/Face", "ceiling",
          "Outflow/near toe/Face=ceiling")
    check("no share", "Gravity/Initial share", "0",
          "Gravity/Initial share=0")

    # What makes a layer thin.
    extent = "Soil profile/slope/Extent"
    check("thin: extent", extent, "too thin: .* m.3, .* z = 0 to 0.01 m",
          f"{extent}=0, 0.01")
    write("map.csv", "x, z, y\n" + "\n".join(
        f"{x}, {z}, 0.01" for x, z in places) + "\n")
    check("thin: height map", top, "too thin: .* m.3", f"{top}=map.csv")
    # A binary STL that has lost a byte.
    write("map.stl", b" " * 80 + b"\x02\0\0\0" + b"\0" * 99)
    check("damaged STL", top,
          "announces 2 facets, with which it would have 184 bytes, but it has "
          "183", f"{top}=map.stl")
    # A condition between two lines of the grid, in part of the command line.
    near_end = "Boundary conditions/near end"
    cases.check("no node",
                rf"slope\.prm:\d+, with --set {near_end}/To$",
                "no node of the grid in its region: along x it reaches from "
                "the end of the grid, -0.5 m to -1 m",
                ["run", slope, *sets("Grid/Cell size=0.5",
                                     f"{near_end}/To=-1, 10, 10")])

    # A section beside the load.
    section = "Cross-section"
    for z in ("3.4", "4.5"):
        cases.check(f"section at {z}", f"^--set {section}$",
                    "beside the load of Load programmes/foundation, which "
                    "reaches from 3.5 m to less than 4.5 m",
                    ["run", foundation, *sets(f"{section}={z}",
                                              "Grid/Cell size=0.5")])


def tables(cases):
    """The first row looks like titles to a careless reader."""
    for table in ("3;0.01\n4;0.001\n", "3,5;0,01\n4;0.001\n",
                  "3,5,0,01\n4,0.001\n", "x, y\n3;0.01\n"):
        write("levels.csv", table)
        cases.check(f"levels: {table}", "^levels.csv:[12]$",
                    "not a level and a prob",
                    ["campaign", random,
                     *sets("Risk/Level distribution=table",
                           "Risk/Level table=levels.csv")])
        cases.check(f"measurements: {table}", "^levels.csv:[12]$", '"',
                    ["campaign", random,
                     *sets("Random fields/strength/Measurements=levels.csv")])


def output_folder(cases):
    """Root may write anywhere, but not below a file."""
    check, set_value = cases.check, cases.set_value
    write("file", "")
    set_value("below a file", "Output/Directory", "file/output", "file")
    set_value("is a file", "Output/Directory", "file", "file")
    set_value("no folder name", "Output/Directory", "", "empty")
    check("nothing to resume", "dyke.prm:[0-9]+", "does not exist",
          ["run", good, "--resume"])
    os.mkdir("full")
    write("full/letter", "")
    set_value("not empty", "Output/Directory", "full", "full")


def after_a_run(cases):
    done = cases.program.run(
        ["run", "-", *sets("Output/Directory=done",
                           "Output/Checkpoint interval=0.01")], stdin=short())
    if done.returncode != 0:
        cases.complain("a good case", "did not run", done)
    if not os.path.isfile("done/summary.json"):
        cases.complain("a good case", "left no summary", done)
    in_done = sets("Output/Directory=done")
    done = cases.program.run(["run", good, "--validate", *in_done])
    if done.returncode != 0:
        cases.complain("validate", "minds the run in the output folder", done)
    if "not empty" not in done.stdout:
        cases.complain("validate", "does not mention the folder", done)
    cases.check("run before", "Output/Directory", "done",
                ["run", good, *in_done])
    cases.check("checkpoint of another case", "Output/Directory",
                "another case", ["run", good, *in_done, "--resume"])
    # Only what must not differ is told.
    cases.check("what differs", "Output/Directory",
                "differ: Grid/Cell size \\(0.5 there, 0.25 here\\)$",
                ["run", good, *in_done, "--resume",
                 *sets("Output/Checkpoint interval=3", "Stop rules/At rest=false",
                       "Time stepping/End time=50")])


def gravity_step_fails(cases):
    """No wrong input: the summary says what is known, and null of the rest."""
    done = cases.program.run(
        ["run", "-", *sets("Output/Directory=unheld",
                           "Boundary conditions/Names=left side")],
        stdin=short())
    if done.returncode != 3 or "the gravity step stops" not in done.stdout:
        cases.complain("a body that is not held", "is no numerical failure", done)
        return
    with open("unheld/summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    unknown = ("initial_width", "residual_width", "residual_height", "particles",
               "sliding_masses")
    if (any(summary[name] is not None for name in unknown)
            or not summary["wall_time"] > 0
            or summary["outcome"] != "numerical failure"):
        cases.complain("a body that is not held", f"summary {summary}", done)


def short():
    """The good case with large cells, and soon at its end."""
    lines = [re.sub("= 40$", "= 0.05",
                    re.sub("^  set Cell size .*", "  set Cell size = 0.5",
                           line)) for line in good_lines]
    return "\n".join(lines) + "\n"


def same_as_a_process(cases, real):
    """Some calls once more: a process of its own says the same."""
    def said(program, arguments, stdin):
        done = program.run(arguments, stdin=stdin)
        # How long it took.
        out = re.sub(r"[0-9.]+ s, [0-9.e+-]+ us per point and step",
                     "TIME", done.stdout)
        return done.returncode, out, done.stderr

    run_short = ["run", "-", "--overwrite", *sets("Output/Directory=short")]
    for code, arguments, stdin in (
            (0, ["--version"], ""),
            (2, ["run", good, "--fast"], ""),
            (2, ["run", "latin.prm"], ""),
            (2, ["run", good, "--set", b"Output/Directory=D\374ne"], ""),
            (2, ["run", good, *sets(f"{POLYGON}=0,0; 50,0; 15,5")], ""),
            (0, ["run", good, "--validate"], ""),
            (0, run_short, short())):
        cases.made += 1
        results = []
        for program in (cases.program, real):
            results.append(said(program, arguments, stdin))
            if arguments is run_short:
                with open("short/statistics", "rb") as file:
                    results[-1] += (file.read(),)
        if results[0] != results[1] or results[0][0] != code:
            cases.failures += 1
            print(f"FAILED: {arguments}: not as a process:", *results,
                  sep="\n    ")


def main():
    with tempfile.TemporaryDirectory(prefix="waker-") as place, \
            Program(sys.argv[1]) as program, \
            Program(sys.argv[1], direct=True) as real:
        os.chdir(place)
        cases = Cases(program)
        for group in (command_line, files, values, sizes, decimal_commas,
                      numbers_of_the_command_line, texts, grid, tractions,
                      other_loads, load_programmes, walls_and_flow, three_dimensions,
                      tables,
                      output_folder, after_a_run, gravity_step_fails):
            group(cases)
        same_as_a_process(cases, real)
        os.chdir("/")
    print(f"{cases.made} cases, {cases.failures} failures")
    return 1 if cases.failures else 0


if __name__ == "__main__":
    sys.exit(main())
