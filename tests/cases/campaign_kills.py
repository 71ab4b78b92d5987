#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A campaign that is killed with SIGKILL ten times at random moments, twice on
two ranks and twice while a second process is at it, and ended with SIGTERM, and
resumed each time, has the results of one that was left alone.

usage: campaign_kills.py WAKER SOURCE_DIRECTORY [SEED]
"""
import os
import random
import signal
import sys
import tempfile
import time

from campaign_case import Campaign, Checks

N = 120
KILLS = 10


def members(session):
    """Processes of a session: mpirun puts its ranks into groups of their own,
    and they outlive it."""
    found = []
    for name in os.listdir("/proc"):
        try:
            if name.isdigit() and os.getsid(int(name)) == session:
                found.append(int(name))
        except ProcessLookupError:
            pass
    return found


def end(campaign, process, done, signal_number, rng):
    """Signal all processes at a random moment after `done` records."""
    if not campaign.wait_for_records(process, done):
        sys.exit(f"ended before it could be killed: {process.communicate()[1]}")
    time.sleep(rng.uniform(0., 0.5))
    for member in members(process.pid):
        try:
            os.kill(member, signal_number)
        except ProcessLookupError:
            pass
    process.communicate()
    return process.returncode


def main():
    waker, source = sys.argv[1:3]
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    rng = random.Random(seed)
    print(f"seed {seed}")
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        whole = Campaign(waker, source, os.path.join(folder, "whole"), N)
        whole.run()
        reference = whole.merged()

        killed = Campaign(waker, source, os.path.join(folder, "killed"), N)
        flags = []
        for kill in range(KILLS):
            # The first one may fall before the folder is complete.
            done = kill * N // (KILLS + 4)
            process = killed.start(*flags, ranks=2 if kill in (4, 8) else 0)
            # Two at once share the work, and what a killed one had claimed.
            other = killed.start(*flags) if flags and kill in (2, 6) else None
            end(killed, process, done, signal.SIGKILL, rng)
            if other is not None:
                end(killed, other, done + 2, signal.SIGKILL, rng)
            print(f"killed after {len(killed.records())} realisations")
            flags = ["--resume"] if os.path.exists(
                os.path.join(killed.folder, "campaign.json")) else []

        process = killed.start(*flags)
        code = end(killed, process, len(killed.records()) + 2, signal.SIGTERM,
                   rng)
        check(code == 143, "SIGTERM: exit code 143", code)
        before = len(killed.records())
        check(before < N, "SIGTERM: something left to do", f"{before} of {N}")
        check(str(before) in killed.call("status"), "status after it")

        killed.run("--resume")
        check.once_each(f"{KILLS} kills and SIGTERM", killed, N)
        check.same(f"{KILLS} kills and SIGTERM", reference, killed.merged())

        # A finished campaign has nothing left to do.
        killed.run("--resume")
        check.once_each("resumed when complete", killed, N)
    check.exit()


if __name__ == "__main__":
    main()
