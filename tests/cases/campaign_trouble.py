#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Things that go wrong in a campaign: realisations that fail numerically, a full
disk, a folder that cannot be written, damaged journals, another campaign's
folder, wrong input. Each is recorded or refused with a clear message, what is
finished is kept, and --resume ends with the results of a campaign without the
trouble.

usage: campaign_trouble.py WAKER SOURCE_DIRECTORY [rank]

"rank": only what takes a small disk, and with it root: one rank of two fails.
Without it the exit code is 77.
"""
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

from campaign_case import Campaign, Checks

N = 9


def contents(folder):
    """{path: bytes} of all files."""
    found = {}
    for base, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(base, name), "rb") as file:
                found[os.path.join(base, name)] = file.read()
    return found


class SmallDisk:
    """A tmpfs of 2 MB; None as folder where that cannot be mounted."""

    def __init__(self, folder):
        os.mkdir(folder)
        self.folder = folder
        words = ["mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", folder]
        if os.geteuid() != 0 or subprocess.run(
                words, capture_output=True, check=False).returncode != 0:
            self.folder = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.folder is not None:
            subprocess.run(["umount", "-l", self.folder], check=False)

    def remount(self, options):
        subprocess.run(["mount", "-o", "remount," + options, self.folder],
                       check=True)

    def fill(self, leave):
        """A file that takes all but so many bytes. Returns its path."""
        path = os.path.join(self.folder, "filler")
        free = os.statvfs(self.folder)
        with open(path, "wb") as file:
            file.write(bytes(free.f_bavail * free.f_frsize - leave))
        return path


def reproduces(campaign, record, check):
    """`waker run --realisation` does what the campaign did, a second attempt
    with half the time step included, beside the campaign's folder."""
    words = [campaign.waker, "run", campaign.file,
             "--realisation", str(record["realisation"])]
    for name, value in campaign.settings.items():
        if name != "Output/Directory":
            words += ["--set", f"{name}={value}"]
    with tempfile.TemporaryDirectory(prefix="waker-") as place:
        done = campaign.ask(words, cwd=place)
        folder = os.path.join(
            place, f"output-analysis1-realisation-{record['realisation']}")
        check(done.returncode == 0 and os.path.isdir(folder),
              "a repeated realisation runs by itself", done.stderr)
        with open(os.path.join(folder, "summary.json"),
                  encoding="utf-8") as file:
            summary = json.load(file)
    check(summary["outcome"] == record["outcome"]
          and summary["residual_width"] == record["residual_width"],
          "and ends as in the campaign", f"{summary['outcome']}, "
          f"W = {summary['residual_width']} and {record['residual_width']} m")


def folders_are_safe(whole, check):
    """A run does not replace a campaign, nor a new campaign a user's files."""
    words = [whole.waker, "run", whole.file, "--realisation", "0",
             "--overwrite", "--set", f"Output/Directory={whole.folder}"]
    before = contents(whole.folder)
    check.refused("a run in the folder of a campaign", whole.ask(words),
                  whole.folder)
    check(contents(whole.folder) == before, "and nothing changed")
    check.refused("fewer realisations than are there", whole.asked(
        "--resume", set={"Campaign/Realisations": N - 1}), str(N))

    mine = ["logbook.txt", "journal-of-mine.jsonl", "report/notes.csv"]
    for name in mine:
        with open(os.path.join(whole.folder, name), "w",
                  encoding="utf-8") as file:
            file.write("mine")
    whole.run("--overwrite", set={"Campaign/Seed": 2})
    check(all(os.path.exists(os.path.join(whole.folder, name))
              for name in mine), "--overwrite leaves the user's files")
    whole.settings["Campaign/Seed"] = 2
    check.once_each("--overwrite", whole, N)


def a_rank_fails(make, disk, check):
    """The disk is full for one of two ranks: the other one must not wait for
    ever. (A limit on the size of files would stop MPI itself.)"""
    if disk.folder is None:
        print("not run: a tmpfs cannot be mounted, which takes root")
        sys.exit(77)
    campaign = make("ranks", folder=os.path.join(disk.folder, "ranks"))
    campaign.run("--realisations", "0:2")
    filler = disk.fill(24576)
    process = campaign.start("--resume", ranks=2)
    try:
        error = process.communicate(timeout=60)[1]
        check(process.returncode == 4 and "cannot be written" in error,
              "a rank of two fails: all end", f"exit code {process.returncode}")
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        check(False, "a rank of two fails: all end", "it hangs")
    os.remove(filler)
    campaign.run("--resume", ranks=2)
    check.once_each("a rank of two fails, then resumed", campaign, N)


def numerical_failures(make, check):
    """Few iterations, no halving: some succeed with a smaller step at the
    second or third attempt, those that yield most do not."""
    hard = {"Newton/Tolerance": 1e-8, "Newton/Maximum iterations": 2,
            "Time stepping/Maximum halvings": 0, "Campaign/Attempts": 3}
    campaign = make("failing", set=hard)
    campaign.run()
    check.once_each("numerical failures", campaign, N)
    records = campaign.records()
    failed = [record for record in records
              if record["outcome"] == "numerical failure"]
    others = [record for record in records if record not in failed]
    check(failed and others, "some fail, the others do not",
          f"{len(failed)} of {N}")
    check(all(record["attempts"] == 3 for record in failed),
          "each was tried three times")
    check(any(record["attempts"] == 2 for record in others),
          "some succeed when repeated",
          sorted(record["attempts"] for record in others))
    check(all("converge" in record["stop_reason"] for record in failed),
          "the record says what failed",
          failed[0]["stop_reason"] if failed else "")
    text = campaign.call("status")
    check(f"{len(failed)} numerical failure(s)" in text, "status counts them",
          text.strip().replace("\n", " | "))
    merged = campaign.merged()
    report = os.path.join(campaign.folder, "report", "report.json")
    with open(report, encoding="utf-8") as file:
        scenario = json.load(file)["scenarios"][0]
    check(scenario["n_numerical_failure"] == len(failed)
          and scenario["n"] == len(others), "report.json counts them")
    table = merged["report/probabilities.csv"]
    check(int(table[0]["n_numerical_failure"]) == len(failed),
          "probabilities.csv counts them")
    repeated = next((record for record in others if record["attempts"] == 2),
                    None)
    if repeated:
        reproduces(campaign, repeated, check)


def no_result(make, check):
    """No realisation can do it: that is no probability of 0."""
    hopeless = {"Newton/Tolerance": 1e-8, "Newton/Maximum iterations": 1,
                "Time stepping/Maximum halvings": 0, "Campaign/Attempts": 1,
                "Campaign/Realisations": 2}
    campaign = make("hopeless", set=hopeless)
    asked = campaign.asked()
    check(asked.returncode == 3 and "no realisation gave a result"
          in asked.stdout + asked.stderr, "no result: exit code 3",
          f"exit code {asked.returncode}")
    merged = campaign.ask([campaign.waker, "merge", campaign.folder])
    check(merged.returncode == 3 and "no realisation gave a result"
          in merged.stdout + merged.stderr, "no result: merge says so, too",
          f"exit code {merged.returncode}")
    with open(os.path.join(campaign.folder, "report", "report.json"),
              encoding="utf-8") as file:
        scenario = json.load(file)["scenarios"][0]
    check(scenario["n"] == 0 and scenario["n_numerical_failure"] == 2,
          "no result: report.json counts two failures")


def full_disk(make, disk, reference, check):
    """The disk is full after a few realisations."""
    if disk.folder is not None:
        campaign = make("full", folder=os.path.join(disk.folder, "full"))
        campaign.run("--realisations", "0:2")
        filler = disk.fill(24576)
        process = campaign.start("--resume")
    else:
        campaign = make("full")
        campaign.run("--realisations", "0:2")

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        filler = None
        process = campaign.start("--resume", process={
            "preexec_fn": limit, "restore_signals": False})
    check.refused("full disk", process, "cannot be written", code=4)
    n = len(campaign.records())
    check(2 < n < N, "full disk: what was finished is kept", f"{n} of {N}")
    check(f"{n} of {N}" in campaign.call("status"), "full disk: status")
    if filler is not None:
        os.remove(filler)
    campaign.run("--resume")
    check.once_each("full disk, then resumed", campaign, N)
    check.same("full disk, then resumed", reference, campaign.merged())


def run_on_full_disk(make, check):
    """A single run, whose files may not grow: not the input's fault."""
    campaign = make("run-full")
    words = [campaign.waker, "run", campaign.file, "--realisation", "0"]
    for name, value in campaign.settings.items():
        words += ["--set", f"{name}={value}"]

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (8000, 8000))

    process = subprocess.Popen(
        words, text=True, env=campaign.environment, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, preexec_fn=limit, restore_signals=False)
    error = process.communicate()[1]
    check(process.returncode == 4 and "cannot be written" in error and
          "there is no checkpoint yet: --overwrite begins anew" in error,
          "full disk: a run", f"{process.returncode}: {error}")
    for command in (["parameters"], ["--help"],
                    ["status", make("whole").folder]):
        with open("/dev/full", "w", encoding="utf-8") as full:
            process = subprocess.Popen(
                [campaign.waker, *command], text=True, stdout=full,
                env=campaign.environment, stderr=subprocess.PIPE)
            check.refused(f"full disk: {command[0]}", process,
                          "standard output", code=4)


def measurements_gone(make, folder, check):
    """Status and merge compute nothing: the measurements may be gone."""
    file = os.path.join(folder, "measured.csv")
    with open(file, "w", encoding="utf-8-sig") as measured:
        measured.write("x, y, value\n10.1, 2.1, 11\n")
    campaign = make("measured", set={
        "Campaign/Realisations": 2,
        "Random fields/strength/Measurements": file})
    campaign.run()
    os.remove(file)
    check("2 of 2" in campaign.call("status"), "no measurements: status")
    campaign.call("merge")
    check.refused("no measurements: campaign", campaign.asked("--resume"),
                  "measured.csv")


def unwritable(make, disk, folder, reference, check):
    """Neither a new campaign nor a resumption starts in such a folder."""
    if disk.folder is not None:
        place = disk.folder
        lock, unlock = (lambda: disk.remount("ro")), (lambda: disk.remount("rw"))
    else:
        place = os.path.join(folder, "locked")
        os.mkdir(place)
        lock, unlock = (lambda: os.chmod(campaign.folder, 0o555)), (
            lambda: os.chmod(campaign.folder, 0o755))
    campaign = make("unwritable", folder=os.path.join(place, "unwritable"))
    campaign.run("--realisations", "0:3")
    before = contents(campaign.folder)
    lock()
    check.refused("unwritable folder", campaign.asked("--resume"),
                  campaign.folder)
    unlock()
    check(contents(campaign.folder) == before, "unwritable: nothing changed")
    campaign.run("--resume")
    check.once_each("unwritable, then resumed", campaign, N)
    check.same("unwritable, then resumed", reference, campaign.merged())


def damaged_journals(whole, folder, reference, check):
    """A last line without its end, and a line of nonsense in the middle."""

    def truncate(lines):
        lines[-2] = lines[-2][:len(lines[-2]) // 2]
        del lines[-1]

    def damage(lines):
        lines[3] = lines[3].replace('"outcome":', '"out\0\xff')

    for name, change, word in [("truncated last line", truncate, "no end"),
                               ("damaged line", damage, "checksum is wrong")]:
        campaign = Campaign(whole.waker, ".", os.path.join(folder, name[:7]), N)
        campaign.file = whole.file
        shutil.copytree(whole.folder, campaign.folder)
        path = campaign.journals()[0]
        with open(path, encoding="latin-1") as file:
            lines = file.read().split("\n")
        change(lines)
        with open(path, "w", encoding="latin-1") as file:
            file.write("\n".join(lines))
        text = campaign.call("status")
        check(f"{N - 1} of {N}" in text and word in text, f"{name}: status",
              text.strip().replace("\n", " | "))
        text = campaign.call("merge")
        check(word in text, f"{name}: merging tells")
        campaign.run("--resume")
        check.once_each(f"{name}, then resumed", campaign, N)
        check.same(f"{name}, then resumed", reference, campaign.merged())


def other_campaign(whole, folder, check):
    """Another seed is another campaign, another N is not."""
    before = contents(whole.folder)
    other = {"Campaign/Seed": 4711}
    for flags in [("--resume",), ("--chunk", "1/2"),
                  ("--realisations", "0:2")]:
        check.refused(f"folder of another campaign, {flags[0]}",
                      whole.asked(*flags, set=other), whole.folder)
    error = whole.asked("--resume", set={
        **other, "Output/Checkpoint interval": 7,
        "Campaign/Checkpoint interval": 7}).stderr
    check("Campaign/Seed (" in error and "Checkpoint interval" not in error,
          "only what forbids it is told", error)
    check.refused("a campaign that is there", whole.asked(), whole.folder)
    check(contents(whole.folder) == before, "another campaign: nothing changed")

    # A foreign journal in the folder does not get in.
    alien = Campaign(whole.waker, ".", os.path.join(folder, "alien"), 4,
                     set=other)
    alien.file = whole.file
    alien.run()
    copy = Campaign(whole.waker, ".", os.path.join(folder, "mixed"), N)
    shutil.copytree(whole.folder, copy.folder)
    shutil.copy(alien.journals()[0],
                os.path.join(copy.folder, "journal-99999.jsonl"))
    text = copy.call("status")
    check("another campaign" in text, "journal of another campaign: status")
    check.same("journal of another campaign", whole.results(), copy.merged())


def wrong_input(make, folder, check):
    before = contents(folder)
    campaign = make("wrong")
    for what, flags, settings, problem in [
            ("chunk 0", ("--chunk", "0/3"), {}, "0/3"),
            ("chunk 4 of 3", ("--chunk", "4/3"), {}, "4/3"),
            ("chunk of words", ("--chunk", "one"), {}, "one"),
            ("empty interval", ("--realisations", "5:5"), {}, "5:5"),
            ("interval beyond N", ("--realisations", "90:99"), {}, "90"),
            ("nothing to resume", ("--resume",), {}, "holds no campaign"),
            ("no realisations", (), {"Campaign/Realisations": 0}, '"0"'),
            ("minimum above N", (), {"Campaign/Minimum realisations": 99},
             "99"),
            ("swept twice", (), {"Sweep/Parameter": "Water/Level",
                                 "Sweep/Values": "4; 4"}, "twice"),
            ("swept twice, written otherwise", (),
             {"Sweep/Parameter": "Water/Level", "Sweep/Values": "4.0; 4.00"},
             "no difference"),
            ("unknown sweep", (), {"Sweep/Parameter": "Water/Depth",
                                   "Sweep/Values": "4; 3"}, "Depth"),
            ("wrong swept value", (), {"Sweep/Parameter": "Water/Level",
                                       "Sweep/Values": "4; 9"}, "9"),
            ("wrong scale", (), {
                "Random fields/strength/Scales of fluctuation": "24, 0"},
             "0"),
            ("set and swept", (), {
                "Sweep/Parameter": "Water/Level", "Sweep/Values": "4.5; 4",
                "Water/Level": "4"}, "swept"),
            ("sweep of the analysis", (), {
                "Sweep/Parameter": "Slides/Rate", "Sweep/Values": "1; 2"},
             "no difference"),
            ("snapshot that is not computed", (), {
                "Snapshots/Realisations": str(N)}, str(N)),
            ("below a file", (), {"Output/Directory": __file__ + "/x"},
             os.path.basename(__file__))]:
        check.refused(what, campaign.asked(*flags, set=settings), problem)
    for command in ("status", "merge"):
        check.refused(f"{command} of no folder", campaign.ask(
            [campaign.waker, command, campaign.folder]), campaign.folder)
    check(contents(folder) == before and not os.path.exists(campaign.folder),
          "wrong input: nothing written")


def main():
    waker, source = sys.argv[1:3]
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder, SmallDisk(
            os.path.join(folder, "disk")) as disk:

        def make(name, **more):
            return Campaign(waker, source, more.pop(
                "folder", os.path.join(folder, name)), N, **more)

        if sys.argv[3:] == ["rank"]:
            a_rank_fails(make, disk, check)
            check.exit()
        wrong_input(make, folder, check)
        whole = make("whole")
        whole.run()
        reference = whole.merged()
        numerical_failures(make, check)
        no_result(make, check)
        full_disk(make, disk, reference, check)
        run_on_full_disk(make, check)
        measurements_gone(make, folder, check)
        unwritable(make, disk, folder, reference, check)
        damaged_journals(whole, folder, reference, check)
        other_campaign(whole, folder, check)
        folders_are_safe(whole, check)
    check.exit()


if __name__ == "__main__":
    main()
