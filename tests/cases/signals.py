# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals are obeyed from the first moment on: while a large case is set up
the program ends at once, with 128 + the signal, and leaves nothing behind.

usage: signals.py WAKER SOURCE_DIR
"""

import os
import signal
import subprocess
import sys
import tempfile
import time

WAKER, SOURCE = sys.argv[1:3]
DYKE = os.path.join(SOURCE, "parameters", "chapter5")
# Minutes of set-up, most of it in one call of a library.
LARGE = ["--set", "Grid/Cell size=0.025"]
COMMANDS = [
    ["run", os.path.join(DYKE, "dyke.prm"), *LARGE],
    ["strength-reduction", os.path.join(DYKE, "dyke.prm"), *LARGE],
    ["campaign", os.path.join(DYKE, "analysis1.prm"), *LARGE]]


def resident(pid):
    """Memory of a process (MB)."""
    with open(f"/proc/{pid}/status", encoding="utf-8") as file:
        for line in file:
            if line.startswith("VmRSS:"):
                return float(line.split()[1]) / 1024
    return 0.


def files(folder):
    return sorted(os.path.join(root, name) for root, folders, names in
                  os.walk(folder) for name in folders + names)


def end_in_set_up(command, megabytes, number):
    """Send the signal once the program has grown so large."""
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        with subprocess.Popen([WAKER, *command], cwd=folder,
                              stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT) as process:
            while process.poll() is None and resident(process.pid) < megabytes:
                time.sleep(0.02)
            process.send_signal(number)
            text, _ = process.communicate(timeout=60)
        assert process.returncode == 128 + number, (
            command, process.returncode, text)
        assert files(folder) == [], (command, files(folder))


def main():
    # Early, while the parameters are read or MPI starts; and well into it:
    # the program alone has less than 150 MB, the equations more than 500.
    end_in_set_up(COMMANDS[0], 150, signal.SIGINT)
    end_in_set_up(COMMANDS[0], 500, signal.SIGTERM)
    end_in_set_up(COMMANDS[1], 300, signal.SIGTERM)
    end_in_set_up(COMMANDS[2], 300, signal.SIGINT)


if __name__ == "__main__":
    main()
