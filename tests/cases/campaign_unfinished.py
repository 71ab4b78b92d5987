#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Realisations that are killed half-way go on from their checkpoints: the
campaign has the results of one that was left alone. Checkpoints that are
damaged, or of another campaign, are not used.

usage: campaign_unfinished.py WAKER SOURCE_DIRECTORY
"""
import json
import os
import re
import shutil
import signal
import sys
import tempfile
import time

from campaign_case import Campaign, Checks

N = 2
SETTINGS = {"Grid/Cell size": 0.25, "Time stepping/Time step": 0.01,
            "Campaign/Checkpoint interval": 0.05}
KILLS = 4


def note(campaign):
    """(number, what is noted) of the realisation under way, or nothing."""
    for number in range(N):
        path = os.path.join(campaign.folder, "running", f"0-{number}",
                            "progress.json")
        try:
            with open(path, encoding="utf-8") as file:
                return number, json.load(file)
        except (FileNotFoundError, ValueError):
            pass
    return None


def wait_for_note(campaign, process, differs_from):
    """The first one that is another."""
    end = time.monotonic() + 60.
    while time.monotonic() < end:
        found = note(campaign)
        if found is not None and found != differs_from:
            return found
        if process.poll() is not None:
            sys.exit(f"ended first: {process.communicate()[1]}")
        time.sleep(0.002)
    process.kill()
    sys.exit("no realisation was kept")


def kill(process):
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()


def damage(campaign, number):
    folder = os.path.join(campaign.folder, "running", f"0-{number}",
                          "checkpoints")
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), "r+b") as file:
            file.seek(-100, os.SEEK_END)
            file.write(b"damaged")


def main():
    waker, source = sys.argv[1:3]
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:
        whole = Campaign(waker, source, os.path.join(folder, "whole"), N,
                         set={**SETTINGS, "Campaign/Checkpoint interval": 0})
        whole.run()
        reference = whole.merged()
        check(not os.path.exists(os.path.join(whole.folder, "running")),
              "interval 0 keeps nothing")

        killed = Campaign(waker, source, os.path.join(folder, "killed"), N,
                          set=SETTINGS)
        flags, before = [], None
        for _ in range(KILLS):
            process = killed.start(*flags)
            found = wait_for_note(killed, process, before)
            if before is not None and found[0] == before[0]:
                check(found[1]["kept_time"] >= before[1]["kept_time"],
                      "goes on from where it was kept",
                      f"{found} after {before}")
            kill(process)
            before = note(killed)
            flags = ["--resume"]
            if before is not None:
                status = killed.call("status")
                check(f"realisation {before[0]} of scenario 0: left at t ="
                      in status, "status says what was left", status)
        check(before is not None, "something was left")

        # By another campaign, and damaged: begun anew.
        number = before[0]
        other = Campaign(waker, source, os.path.join(folder, "other"), N,
                         set={**SETTINGS, "Campaign/Seed": 5})
        process = other.start()
        found = None
        while found is None or found[1]["kept_time"] < 1.5:
            found = wait_for_note(other, process, found)
        kill(process)
        left = note(other)
        ours = os.path.join(killed.folder, "running", f"0-{number}")
        shutil.rmtree(ours)
        shutil.copytree(os.path.join(other.folder, "running", f"0-{left[0]}"),
                        ours)
        process = killed.start("--resume")
        first = wait_for_note(killed, process, (number, left[1]))
        kill(process)
        check(first[0] == number and first[1]["kept_time"] < 1.5,
              "a foreign one is not used", first)
        if os.path.exists(os.path.join(ours, "checkpoints")):
            damage(killed, number)

        said = killed.ask(killed.command("--resume"), check=True).stdout
        busy = re.findall(r"ranks busy ([0-9.]+) %", said)
        check(len(busy) == 1 and 0 < float(busy[0]) <= 100,
              "a rank is not busier than it can be", busy)
        check.once_each("kills", killed, N)
        check.same("kills", reference, killed.merged())
        check(not os.path.exists(os.path.join(killed.folder, "running")),
              "finished realisations leave nothing")

        # SIGTERM keeps what is under way, and --overwrite removes it.
        process = other.start("--resume")
        wait_for_note(other, process, note(other))
        process.send_signal(signal.SIGTERM)
        process.communicate()
        check(process.returncode == 143, "SIGTERM", process.returncode)
        other.run("--overwrite", set={"Campaign/Seed": 1})
        check.same("--overwrite", reference, other.merged())
        check(not os.path.exists(os.path.join(other.folder, "running")),
              "--overwrite removes what was kept")
    check.exit()


if __name__ == "__main__":
    main()
