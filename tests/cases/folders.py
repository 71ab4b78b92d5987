#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs, strength reductions and campaigns do with their folders: what is
left of an earlier one, links, input files that have changed, two at once, kills,
a full disk.

usage: folders.py WAKER SOURCE_DIRECTORY
"""
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

import program
from campaign_case import Campaign, Checks, finish
from campaign_trouble import SmallDisk, contents

# Seconds or less each.
COARSE = ["Grid/Cell size=0.5", "Time stepping/Time step=0.02"]
CASES = {  # name: command, file, settings
    "walls": ("run", "chapter3/footing.prm",
              ["Grid/Cell size=0.5", "Time stepping/Time step=1",
               "Time stepping/End time=2"]),
    "dyke": ("run", "chapter5/dyke_weak.prm",
             COARSE + ["Time stepping/End time=0.2"]),
    "factor": ("strength-reduction", "chapter5/dyke_weak.prm",
               COARSE + ["Time stepping/End time=6",
                         "Strength reduction/Lower factor=0.25",
                         "Strength reduction/Upper factor=4",
                         "Strength reduction/Tolerance=0.5"]),
}


class Folders:
    """Starts the program in one folder after the other."""

    def __init__(self, waker, source, place):
        self.waker = os.path.abspath(waker)
        self.source = os.path.abspath(source)
        self.place = place
        self.environment = dict(os.environ, OMP_NUM_THREADS="1",
                                OMPI_MCA_ess_singleton_isolated="1")

    def path(self, name):
        return os.path.join(self.place, name)

    def command(self, case, folder, *flags, settings=()):
        command, file, own = case if isinstance(case, tuple) else CASES[case]
        words = [self.waker, command,
                 os.path.join(self.source, "parameters", file), *flags,
                 "--set", f"Output/Directory={folder}"]
        # The later one of two settings of one parameter counts.
        for path, value in dict(text.split("=", 1)
                                for text in [*own, *settings]).items():
            words += ["--set", f"{path}={value}"]
        return words

    def start(self, case, folder, *flags, settings=()):
        """In the background."""
        words = self.command(case, folder, *flags, settings=settings)
        return subprocess.Popen(words, text=True, env=self.environment,
                                stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE)

    def asked(self, case, folder, *flags, settings=(), cwd=None, check=False):
        """To its end, without a process to wait for or to kill."""
        words = self.command(case, folder, *flags, settings=settings)
        return program.shared(self.waker).run(
            words[1:], env=self.environment, cwd=cwd, check=check)

    def run(self, case, folder, *flags, **more):
        """The same. Must succeed."""
        self.asked(case, folder, *flags, check=True, **more)


def names(folder):
    """Relative paths of all files."""
    return {os.path.relpath(path, folder) for path in contents(folder)}


def results(folder):
    """Contents of the files that two equal runs have in common."""
    found = {os.path.relpath(path, folder): data
             for path, data in contents(folder).items()}
    for name in ("log.txt", "parameters.prm", "lock"):
        found.pop(name, None)
    found = {name: data for name, data in found.items()
             if not name.startswith("checkpoints")}
    if "summary.json" in found:
        summary = json.loads(found["summary.json"])
        summary.pop("wall_time")
        found["summary.json"] = summary
    return found


def times(folder, series="particles"):
    root = ElementTree.parse(os.path.join(folder, series + ".pvd")).getroot()
    return [float(entry.get("timestep")) for entry in root.iter("DataSet")]


def nothing_is_left(folders, check):
    """Each case in the folder of each other one, with files of the user's."""
    fresh = {}
    for name in CASES:
        folders.run(name, folders.path("fresh-" + name))
        fresh[name] = names(folders.path("fresh-" + name))
    check("walls.pvd" in fresh["walls"], "walls are written")
    folder = folders.path("used")
    mine = {"notes.txt", "solution/walls-best.vtu", "statistics.ods",
            "lock.txt"}
    for name in mine:
        os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write("mine")
    order = list(CASES)
    for name in order + order[::-1]:
        folders.run(name, folder, "--overwrite")
        left = names(folder) - mine - fresh[name]
        check(not left and mine <= names(folder),
              f"--overwrite: {name} leaves what it writes itself",
              sorted(left))


def links(folders, check):
    """Nothing outside of the folder is touched."""
    other = folders.path("fresh-dyke")
    before = contents(other)
    folder = folders.path("linked")
    folders.run("dyke", folder)
    shutil.rmtree(os.path.join(folder, "solution"))
    os.symlink(os.path.join(other, "solution"),
               os.path.join(folder, "solution"))
    for flag in ("--overwrite", "--resume"):
        check.refused(f"{flag}: solution/ is a link",
                      folders.asked("dyke", folder, flag),
                      os.path.join(folder, "solution"))
    os.remove(os.path.join(folder, "solution"))
    os.remove(os.path.join(folder, "statistics"))
    os.symlink(os.path.join(other, "statistics"),
               os.path.join(folder, "statistics"))
    for flag in ("--overwrite", "--resume"):
        check.refused(f"{flag}: statistics is a link",
                      folders.asked("dyke", folder, flag),
                      os.path.join(folder, "statistics"))
    check(contents(other) == before, "the other run is as it was")
    # The folder itself may be one.
    os.remove(os.path.join(folder, "statistics"))
    os.symlink(folder, folders.path("name"))
    folders.run("dyke", folders.path("name"), "--overwrite")
    check(names(folder) == names(other) and
          os.path.islink(folders.path("name")),
          "a folder by the name of a link")


END = ["Time stepping/End time=0.1", "Time stepping/Time step=0.02"]


def changed_inputs(folders, check):
    """The surface that is loaded changes between a run and its resumption."""
    surface = os.path.join(folders.source, "parameters/chapter3/inclined_bar.txt")
    with open(surface, encoding="utf-8") as file:
        text = file.read()
    place = folders.path("inputs")
    os.mkdir(place)

    def write(name, contents_):
        with open(os.path.join(place, name), "w", encoding="utf-8") as file:
            file.write(contents_)

    write("bar.txt", text)
    file = "chapter3/inclined_bar.prm"
    settings = [f"Tractions/{name}/Surface file=bar.txt"
                for name in ("points", "surface", "top", "base")]
    case = ("run", file, settings + END)
    folder = folders.path("inputs-run")
    folders.run(case, folder, cwd=place)
    before = contents(folder)
    write("bar.txt", "# the same, but not as a file\n" + text)
    check.refused("--resume with another surface", folders.asked(
        case, folder, "--resume", cwd=place),
                  "contents of Tractions/points/Surface file")
    check(contents(folder) == before, "and nothing changed")

    # The file may have moved, and the copy of the parameters runs anywhere.
    write("bar.txt", text)
    parameters = os.path.join(folder, "parameters.prm")
    again = folders.path("inputs-again")
    folders.run(("run", parameters, []), again)
    check(results(again) == results(folder),
          "parameters.prm reproduces the run from another folder")
    os.remove(os.path.join(place, "bar.txt"))
    write("moved.txt", text)
    moved = [s.replace("bar.txt", "moved.txt") for s in settings]
    folders.run(("run", file, moved + END), folder,
                "--resume", cwd=place)
    check(results(folder) == results(again), "--resume with a file that moved")


def changed_settings(folders, check):
    """Other intervals and stop rules from the checkpoint on."""
    settings = ["Time stepping/End time=0.4", "Output/Interval=0.2",
                "Output/Checkpoint interval=0.2"]
    folder = folders.path("settings")
    folders.run("dyke", folder, settings=settings)
    check(times(folder) == [0, 0.2, 0.4], "an interval of 0.2 s", times(folder))
    folders.run("dyke", folder, "--resume", settings=[
        "Time stepping/End time=0.6", "Output/Interval=0.06",
        "Output/Grid=false"])
    check(times(folder) == [0, 0.2, 0.4, 0.42, 0.48, 0.54, 0.6],
          "resumed with 0.06 s", times(folder))
    check(times(folder, "grid") == [0, 0.2, 0.4], "and without the grid",
          times(folder, "grid"))
    folders.run("dyke", folder, "--resume", settings=[
        "Time stepping/End time=0.8", "Output/Interval=0"])
    check(times(folder)[-2:] == [0.6, 0.8], "resumed without an interval",
          times(folder))
    # At rest by generous limits; resumed with others it goes on.
    rest = folders.path("rest")
    folders.run("dyke", rest, settings=[
        "Time stepping/End time=3", "Stop rules/Rest plastic strain=1",
        "Stop rules/Rest velocity=100", "Stop rules/Rest duration=0.2"])
    with open(os.path.join(rest, "summary.json"), encoding="utf-8") as file:
        first = json.load(file)
    folders.run("dyke", rest, "--resume", settings=[
        "Time stepping/End time=3", "Stop rules/Rest plastic strain=2",
        "Stop rules/Rest velocity=100", "Stop rules/Rest duration=0.4"])
    with open(os.path.join(rest, "summary.json"), encoding="utf-8") as file:
        second = json.load(file)
    check("at rest" in first["stop_reason"] and
          "at rest" in second["stop_reason"] and
          abs(second["end_time"] - first["end_time"] - 0.4) < 0.03,
          "other limits of rest: the time at rest begins anew",
          f"{first['end_time']} and {second['end_time']} s")


def wait_for(process, path, seconds=60):
    end = time.monotonic() + seconds
    while not os.path.exists(path):
        if process.poll() is not None or time.monotonic() > end:
            sys.exit(f"{path} does not come: {process.communicate()}")
        time.sleep(0.005)


def two_at_once(folders, check):
    """One works in a folder, the other is refused; a killed one is no hindrance.
    """
    long = ["Time stepping/End time=10", "Output/Checkpoint interval=0.1"]
    for case in ("dyke", "factor"):
        folder = folders.path("busy-" + case)
        first = folders.start(case, folder, settings=long)
        wait_for(first, os.path.join(folder, "parameters.prm"))
        if case == "dyke":
            wait_for(first, os.path.join(folder, "checkpoints",
                                         "checkpoint-0.bin"))
        first.send_signal(signal.SIGSTOP)  # it must not end meanwhile
        for other in ("dyke", "factor"):
            for flag in ("--overwrite", "--resume"):
                check.refused(f"{other} {flag}, while {case} runs",
                              folders.asked(other, folder, flag,
                                            settings=long),
                              f"process {first.pid}")
        check(first.poll() is None, "the first one is left alone")
        first.send_signal(signal.SIGKILL)
        first.communicate()
        check(os.path.exists(os.path.join(folder, "lock")),
              "killed: its lock is left")
        folders.run(case, folder, "--resume", settings=long)
        check(not os.path.exists(os.path.join(folder, "lock")),
              f"{case}: resumed, and no lock is left")

    # Started in the same moment in a new folder: one of them.
    folder = folders.path("same-moment")
    crowd = [folders.start("dyke", folder) for _ in range(4)]
    codes = sorted(process.wait() for process in crowd)
    for process in crowd:
        process.stderr.close()
    check(codes == [0, 2, 2, 2], "four at the same moment: one runs", codes)
    check(results(folder) == results(folders.path("fresh-dyke")),
          "and its files are whole")

    with open(os.path.join(folder, "lock"), "w", encoding="utf-8") as file:
        json.dump({"what": "waker run", "host": "elsewhere", "process": 12,
                   "since": "2026-01-31T12:00:00Z"}, file)
    check.refused("a lock of another host", folders.asked(
        "dyke", folder, "--overwrite"), "process 12 on elsewhere")

    # A file of the user's that has the name of the lock, and nothing else.
    for case in CASES:
        folder = folders.path("locksmith-" + case)
        os.makedirs(folder)
        path = os.path.join(folder, "lock")
        with open(path, "w", encoding="utf-8") as file:
            file.write("mine")
        for flags in ((), ("--overwrite",)):
            check.refused(f"{case}: a file lock of the user's",
                          folders.asked(case, folder, *flags),
                          "holds a file lock that is not ours")
        with open(path, encoding="utf-8") as file:
            check(file.read() == "mine", "it stays as it was")
        os.remove(path)
        folders.run(case, folder)


def killed_reduction(folders, check, rng):
    """kill -9 at random moments; a damaged line of the table."""
    folder = folders.path("killed-factor")
    start = time.monotonic()
    # A process of its own, as those that are killed.
    finish(folders.start("factor", folders.path("timed")))
    duration = time.monotonic() - start
    flags, kills = [], 0
    for _ in range(6):
        process = folders.start("factor", folder, *flags)
        time.sleep(rng.uniform(0.2, 0.7) * duration)
        process.kill()
        process.communicate()
        kills += process.returncode == -signal.SIGKILL
        if os.path.exists(os.path.join(folder, "parameters.prm")):
            flags = ["--resume"]
    folders.run("factor", folder, *flags)
    reference = results(folders.path("fresh-factor"))
    check(kills > 0 and results(folder) == reference,
          f"strength reduction after {kills} kills")

    table = os.path.join(folder, "strength_reduction.csv")
    with open(table, encoding="utf-8") as file:
        lines = file.read().split("\n")
    lines[2] = (lines[2].replace(",stable,", ",failed,")
                if ",stable," in lines[2]
                else lines[2].replace(",failed,", ",stable,"))
    with open(table, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
    folders.run("factor", folder, "--resume")
    with open(os.path.join(folder, "log.txt"), encoding="utf-8") as file:
        log = file.read()
    check(results(folder) == reference and "1 damaged line" in log,
          "a flipped trial is found and made again")


def full_disk(folders, disk, check):
    """Every file is whole, and the run goes on when there is space."""
    if disk.folder is None:
        print("not run without a small disk, which takes root: a full disk")
        return
    settings = ["Time stepping/End time=1", "Output/Interval=0.1",
                "Output/Checkpoint interval=0.04"]
    whole = folders.path("disk-whole")
    folders.run("dyke", whole, settings=settings)
    folder = os.path.join(disk.folder, "run")
    process = folders.start("dyke", folder, settings=settings)
    error = process.communicate()[1]
    check(process.returncode not in (0, -signal.SIGSEGV) and
          "No space left" in error, "a full disk is told",
          f"exit code {process.returncode}: " + error.replace("\n", " | "))
    good, count = True, 0
    for path in contents(folder):
        if path.endswith((".vtu", ".pvd")):
            count += 1
            with open(path, "rb") as file:
                good = good and file.read().rstrip().endswith(b"</VTKFile>")
    for series in ("particles", "surface", "grid"):
        root = ElementTree.parse(
            os.path.join(folder, series + ".pvd")).getroot()
        for entry in root.iter("DataSet"):
            good = good and os.path.exists(
                os.path.join(folder, entry.get("file")))
    with open(os.path.join(folder, "statistics"), encoding="utf-8") as file:
        statistics = file.read()
    good = good and (not statistics or statistics[-1] == "\n")
    good = good and not any(path.endswith(".tmp") for path in contents(folder))
    check(good and count > 3, "and every file is whole", f"{count} files")
    disk.remount("size=50m")
    folders.run("dyke", folder, "--resume", settings=settings)
    check(results(folder) == results(whole), "then resumed")


def campaigns(folders, check):
    """Two resumptions share the work; nobody overwrites what runs."""
    n = 16
    campaign = Campaign(folders.waker, folders.source,
                        folders.path("campaign"), n)
    first = campaign.start()
    campaign.wait_for_records(first, 1)
    first.send_signal(signal.SIGSTOP)  # it must not end meanwhile
    check.refused("campaign --overwrite while it runs",
                  campaign.asked("--overwrite"), f"process {first.pid}")
    check(first.poll() is None, "the campaign is left alone")
    first.send_signal(signal.SIGKILL)
    first.communicate()
    # The first of two stands still in the middle of its work; the second one
    # does all but what the first has claimed.
    before = len(campaign.records())
    first = campaign.start("--resume")
    campaign.wait_for_records(first, before + 2)
    first.send_signal(signal.SIGSTOP)
    second = campaign.start("--resume")
    error = second.communicate()[1]
    check(second.returncode == 0, "second of two resumptions", error)
    first.send_signal(signal.SIGCONT)
    error = first.communicate()[1]
    check(first.returncode == 0, "first of two resumptions", error)
    check.once_each("two resumptions at once", campaign, n)
    done = [sum(b'"realisation"' in line for line in open(path, "rb"))
            for path in campaign.journals()]
    check(len(done) >= 3 and all(done[1:]), "both have computed", done)
    check(not os.path.exists(os.path.join(campaign.folder, "writers")),
          "no claim is left")
    whole = Campaign(folders.waker, folders.source, folders.path("whole"), n)
    whole.run()
    check.same("two resumptions at once", whole.merged(), campaign.merged())

    # A flipped digit in a journal and in campaign.json.
    path = campaign.journals()[0]
    with open(path, encoding="utf-8") as file:
        text = file.read()
    at = text.index('"residual_height":') + len('"residual_height":')
    with open(path, "w", encoding="utf-8") as file:
        file.write(text[:at] + chr(ord(text[at]) ^ 1) + text[at + 1:])
    said = campaign.call("status")
    check(f"{n - 1} of {n}" in said and "checksum" in said,
          "a flipped bit: status", said.split("\n")[0])
    info = os.path.join(campaign.folder, "campaign.json")
    with open(info, encoding="utf-8") as file:
        text = file.read()
    with open(info, "w", encoding="utf-8") as file:
        file.write(text.replace('"water_level": 4', '"water_level": 5', 1))
    check.refused("a flipped bit in campaign.json: merge", campaign.ask(
        [campaign.waker, "merge", campaign.folder]), "checksum")
    campaign.run("--resume")
    check.same("flipped bits, then resumed", whole.results(),
               campaign.results())

    # Snapshots and all the rest go; the folder of a run before as well.
    used = Campaign(folders.waker, folders.source, folders.path("used"), 4,
                    set={"Snapshots/First": 2})
    folders.run("walls", used.folder, "--overwrite")
    used.run("--overwrite")
    check(os.path.isdir(os.path.join(used.folder, "snapshots", "0-1")),
          "a campaign with snapshots")
    plain = Campaign(folders.waker, folders.source, used.folder, 4,
                     set={"Campaign/Seed": 2})
    plain.run("--overwrite")
    reference = Campaign(folders.waker, folders.source, folders.path("plain"),
                         4, set={"Campaign/Seed": 2})
    reference.run()
    left = names(used.folder) - names(reference.folder)
    check(left == {"notes.txt", "solution/walls-best.vtu", "statistics.ods",
                   "lock.txt"}
          and not os.path.exists(os.path.join(used.folder, "snapshots")),
          "--overwrite of campaigns leaves the user's files", sorted(left))


def main():
    waker, source = sys.argv[1:3]
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    print(f"seed {seed}")
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as place, SmallDisk(
            os.path.join(place, "disk")) as disk:
        folders = Folders(waker, source, place)
        nothing_is_left(folders, check)
        links(folders, check)
        changed_inputs(folders, check)
        changed_settings(folders, check)
        two_at_once(folders, check)
        killed_reduction(folders, check, random.Random(seed))
        full_disk(folders, disk, check)
        campaigns(folders, check)
    check.exit()


if __name__ == "__main__":
    main()
