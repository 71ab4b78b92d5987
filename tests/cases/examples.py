#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every example under parameters/ runs for its first 60 steps, as it is given: none
fails numerically. Campaigns: their first realisation.

    /usr/bin/python3 tests/cases/examples.py WAKER SOURCE_DIR
"""

import glob
import os
import re
import subprocess
import sys
import tempfile

N_STEPS = 60
# The bodies in space of chapter 6 are on cells twice as large here.
SPACE = re.compile(r"set Dimension\s*=\s*3")
CELL = re.compile(r"set Cell size\s*=\s*([0-9.]+)")


def command(waker, path, name, folder):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    step = re.search(r"set Time step\s*=\s*([0-9.e-]+)", text)
    end = re.search(r"set End time\s*=\s*([0-9.e-]+)", text)
    words = [waker, "run", path, "--set", "Output/Directory=" + folder]
    if step and end:
        short = min(float(end[1]), N_STEPS * float(step[1]))
        words += ["--set", f"Time stepping/End time={short:g}"]
    if name.startswith("chapter6") and SPACE.search(text):
        words += ["--set", f"Grid/Cell size={2 * float(CELL.search(text)[1]):g}"]
    if re.search(r"subsection Random fields\n(?:.*\n)*?\s*set Names\s*=\s*\S", text):
        words += ["--realisation", "0"]
    return words


def main():
    waker, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    os.chdir(source)  # files name others from there
    bad = 0
    files = sorted(glob.glob("parameters/*/*.prm"))
    for path in sys.argv[3:] or files:
        name = path.partition("/")[2]
        with tempfile.TemporaryDirectory() as work:
            done = subprocess.run(command(waker, path, name, os.path.join(work, "out")),
                                  capture_output=True, text=True,
                                  env=dict(os.environ, OMP_NUM_THREADS="1"))
        good = done.returncode == 0
        bad += not good
        print(f"{name}: " + ("ok" if good else f"ends with {done.returncode}\n"
                             + (done.stdout + done.stderr)[-1500:]), flush=True)
    if bad:
        sys.exit(f"{bad} of {len(files)} examples do not run")


if __name__ == "__main__":
    main()
