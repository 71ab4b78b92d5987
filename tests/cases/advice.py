#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Follow all advice that the program prints.

Each case is a command that must be refused (exit code 2). From the third line
of the message comes what is to be done: a name that is meant, --set options,
other options, values of other parameters. Each piece is followed, and the
command must then be accepted, or at least not be refused for the same reason.

usage: advice.py WAKER_BINARY SOURCE_DIR
"""

import glob
import os
import re
import subprocess
import sys
import tempfile
import time

from program import Program

waker = Program(sys.argv[1])
source = os.path.abspath(sys.argv[2])
dyke = os.path.join(source, "parameters/chapter5/dyke.prm")
random_dyke = os.path.join(source, "parameters/chapter5/analysis1.prm")
failures = 0
n_followed = 0


def call(arguments):
    done = waker.run(arguments)
    return done.returncode, done.stderr.strip().split("\n")


def complain(arguments, what, lines):
    global failures
    failures += 1
    print("FAIL", " ".join(arguments), "\n    ", what, "\n    ",
          "\n     ".join(lines))


def advice_in(allowed):
    """Pieces of advice: ("meant", name), ("set", [options]),
    ("option", word)."""
    found = [("meant", name)
             for name in re.findall(r'did you mean "(.+?)"\?', allowed)]
    one = r'--set (?:"[^"]+"|\S+=\S*)'
    for group in re.findall(rf"{one}(?: {one})*", allowed):
        settings = re.findall(r'--set (?:"([^"]+)"|(\S+=\S*))', group)
        found.append(("set", [(quoted or plain).rstrip(",;")
                              for quoted, plain in settings]))
    rest = re.sub(rf'{one}|did you mean ".+?"\?', "", allowed)
    for path, value in re.findall(
            r"\b([A-Z][\w ]*?/[A-Z][\w ]*?) = (\w+)", rest):
        found.append(("set", [f"{path}={value}"]))
    for option in re.findall(r"--(?:overwrite|resume|help|validate)\b", rest):
        found.append(("option", option))
    return found


def corrected(arguments, wrong, kind, what, fill):
    """The arguments with a piece of advice followed."""
    if kind == "meant":
        return [argument.replace(wrong, what, 1) for argument in arguments]
    if kind == "option":
        return arguments + [what]
    result = list(arguments)
    for setting in what:
        path = setting.split("=", 1)[0]
        value = setting.split("=", 1)[1]
        if value == "...":
            value = fill[path]
        # What was given for the same name is given up.
        result = without(result, path) + ["--set", f"{path}={value}"]
    return result


def without(arguments, path):
    """The arguments without --set of a parameter."""
    result = list(arguments)
    for i in range(len(result) - 1, 0, -1):
        if result[i - 1] == "--set" and result[i].startswith(path + "="):
            del result[i - 1:i + 1]
    return result


def follow(arguments, n, wrong="", fill=None, instead_of=None, accepted=True):
    """Follow the n pieces of advice that the refusal of a command holds.
    `instead_of`: of a parameter that is set, the one that is given up."""
    global n_followed
    code, lines = call(arguments)
    if code != 2 or len(lines) != 3:
        complain(arguments, f"exit code {code}, {len(lines)} lines", lines)
        return
    pieces = advice_in(lines[2])
    if len(pieces) != n:
        complain(arguments, f"{len(pieces)} pieces of advice, not {n}: "
                 f"{pieces}", lines)
    for kind, what in pieces:
        second = corrected(arguments, wrong, kind, what, fill or {})
        for new, old in (instead_of or {}).items():
            if kind == "set" and what[0].startswith(new + "="):
                second = without(second, old)
        code, after = call(second)
        n_followed += 1
        same = len(after) == 3 and after[1] == lines[1]
        if (accepted and code != 0) or same:
            complain(second, f"advice {kind} {what}: exit code {code}", after)


def settings(*values):
    return [word for value in values for word in ("--set", value)]


def main():
    check = ["run", dyke, "--validate"]

    # Names that are meant: of commands, options, parameters, sections.
    follow(["rum", dyke, "--validate"], 2, wrong="rum", accepted=False)
    follow(["parameter"], 2, wrong="parameter", accepted=False)
    follow(check + ["--overwite"], 2, wrong="--overwite", accepted=False)
    follow(check + settings("Water.Level=4"), 1, wrong="Water.Level")
    follow(check + settings("Grid/Cel size=0.25"), 1, wrong="Cel size")
    follow(check + settings("Gird/Cell size=0.25"), 1, wrong="Gird")
    follow(check + settings("Cell size=0.25"), 1, wrong="Cell size")
    follow(check + settings("Materials/cley/Unit weight=15"), 1, wrong="cley")

    # Random fields: other commands, or none of them.
    random_run = ["run", random_dyke, "--validate"]
    follow(random_run, 1)
    with open(random_dyke, encoding="utf-8") as file:
        text = file.read()
    two = text.replace("""
  set Names = strength
""", """
  set Names = strength, other
  set Correlations = strength, other: 0.5
  subsection other
    set Property                 = residual strength
    set Coefficient of variation = 0.2
    set Scales of fluctuation    = 24, 0.5
  end
""")
    with open("two.prm", "w", encoding="utf-8") as file:
        file.write(two)
    follow(["run", "two.prm", "--validate"], 1)
    for again in (["--realisation", "3"], []):
        command = random_run + again
        if not again:
            command = ["campaign", random_dyke, "--validate"]
        code, lines = call(command)
        if code != 0:
            complain(command, f"exit code {code}", lines)

    # A swept parameter.
    sweep = os.path.join(source, "parameters/chapter5/analysis3.prm")
    with open(sweep, encoding="utf-8") as file:
        swept = re.search(r"subsection Sweep.*?Parameter\s*=\s*(.*?)\n",
                          file.read(), re.S).group(1).strip()
    follow(["campaign", sweep, "--validate"] + settings(swept + "=4"), 2,
           fill={"Sweep/Values": "4; 4.25"}, instead_of={"Sweep/Values": swept})

    # Values of other parameters.
    stress = "Soil profile/dyke/Initial stress=-1; -1; -1; 0"
    follow(check + settings(stress), 1)
    follow(check + settings("Water/Level=5.5"), 1)
    follow(check + settings("Boundary conditions/Names="), 1)
    follow(check + settings("Time stepping/Load duration=1",
                            "Time stepping/Scheme=quasi-static"), 1)
    follow(check + settings("Tractions/Names=load", "Tractions/load/Method=volume",
                            "Tractions/load/Value=1"), 1, accepted=False)
    follow(check + settings("Time stepping/Move points=false",
                            "Time stepping/Scheme=quasi-static",
                            "Kinematics and mapping/Strain=logarithmic"), 1,
           accepted=False)

    # Folders that are not empty.
    os.mkdir("full")
    with open("full/letter", "w", encoding="utf-8"):
        pass
    follow(["run", dyke] + settings("Output/Directory=full",
                                    "Time stepping/End time=0"), 2,
           accepted=False)
    with open("full/campaign.json", "w", encoding="utf-8"):
        pass
    follow(["run", dyke] + settings("Output/Directory=full",
                                    "Time stepping/End time=0"), 1,
           fill={"Output/Directory": "other"})

    # A folder in use, and one with a lock that is not ours.
    # (It would come to rest, and end, within a second.)
    long_run = settings("Time stepping/End time=1000",
                        "Stop rules/Rest duration=1000", "Output/Interval=0",
                        "Output/Directory=busy")
    busy = subprocess.Popen([waker.path, "run", dyke] + long_run,
                            stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL, env=waker.environment)
    try:
        end = time.monotonic() + 60
        while not (os.path.exists("busy/lock") and os.path.getsize("busy/lock")):
            if busy.poll() is not None or time.monotonic() > end:
                complain(["run", dyke] + long_run, "takes no lock", [])
                break
            time.sleep(0.05)
        follow(["run", dyke, "--overwrite"] +
               settings("Output/Directory=busy", "Time stepping/End time=0"), 1,
               fill={"Output/Directory": "free"})
        if busy.poll() is not None:
            complain(["run", dyke] + long_run, "ended too early", [])
    finally:
        busy.kill()
        busy.wait()
    os.mkdir("locked")
    with open("locked/lock", "w", encoding="utf-8") as file:
        file.write("of the front door\n")
    follow(["run", dyke] + settings("Output/Directory=locked",
                                    "Time stepping/End time=0"), 1,
           fill={"Output/Directory": "unlocked"})

    # Whoever adds advice adds a line above.
    texts = ""
    for path in glob.glob(os.path.join(source, "source/**/*.cc"),
                          recursive=True):
        with open(path, encoding="utf-8") as file:
            texts += file.read()
    n_set = len(re.findall(r'--set (?:\\"|[A-Z])', re.sub(r'"\s*"', "", texts)))
    if n_set != 11:
        complain([], f"the sources hold {n_set} times --set", [])
    print(f"{n_followed} pieces of advice followed, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    with waker, tempfile.TemporaryDirectory(prefix="waker-") as place:
        os.chdir(place)
        code = main()
        os.chdir("/")
    sys.exit(code)
