#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A campaign whose realisations are computed by several ranks each has the
outcomes of one on single ranks: on one group and on two, in chunks, interrupted
and gone on with on another number, after a rank has died. Snapshots are whole.
What cannot be is refused, once, before anything is written.

usage: campaign_ranks.py WAKER SOURCE_DIRECTORY [REALISATIONS]
"""
import glob
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np
import ranks_cases
import ranks_compare
from campaign_case import Campaign, Checks, finish

N = 6  # of more than one outcome
FEW = 4  # where starting and ending is what counts
TWO = {"Campaign/Ranks per realisation": 2}
HOPELESS = {"Newton/Tolerance": 1e-8, "Newton/Maximum iterations": 1,
            "Time stepping/Maximum halvings": 0, "Campaign/Attempts": 2,
            "Campaign/Realisations": 2, "Snapshots/First": 1}


# Work, which ranks share, and what says when and where it was done.
NO_RESULTS = ("steps", "iterations", "wall_time", "field_time", "hash", "rank",
              "host", "started")


def numbers(value, path=""):
    """All numbers of a record, with their paths; NaN and None alike."""
    if isinstance(value, dict):
        for name, part in value.items():
            if not any(word in name for word in NO_RESULTS):
                yield from numbers(part, f"{path}/{name}")
    elif isinstance(value, list):
        for i, part in enumerate(value):
            yield from numbers(part, f"{path}/{i}")
    elif value is None or isinstance(value, (int, float)):
        yield path, None if value is None or value != value else value


def like(check, what, reference, other):
    """The same outcomes, and all numbers but for what softening makes of
    round-off."""
    worst, different = (0., ""), []
    ones = {record["realisation"]: record for record in reference.records()}
    for two in other.records():
        one = ones[two["realisation"]]
        if any(one[name] != two[name]
               for name in ("outcome", "stop_reason", "attempts")):
            different.append((two["realisation"], one["outcome"],
                              two["outcome"]))
            continue
        a, b = dict(numbers(one)), dict(numbers(two))
        for path in sorted(set(a) | set(b)):
            x, y = a.get(path), b.get(path)
            if (x is None) != (y is None):
                different.append((two["realisation"], path, x, y))
            elif x is not None:
                worst = max(worst, (abs(x - y) / max(1., abs(x)), path))
    check(not different, f"{what}: outcomes", different)
    # Met today: 2e-8, times equal. Softening makes more of round-off, and a
    # Newton iteration more or less 1e-6.
    check(worst[0] <= 1e-5, f"{what}: numbers", worst)


def children(process):
    """Process numbers of the ranks that an mpirun has started, in order."""
    words = ["pgrep", "-P", str(process.pid)]
    text = subprocess.run(words, capture_output=True, text=True,
                          check=False).stdout
    return sorted(int(word) for word in text.split())


def kept(campaign):
    """The times up to which realisations under way are kept."""
    found = []
    for path in glob.glob(os.path.join(campaign.folder, "running", "*",
                                       "progress.json")):
        try:
            with open(path, encoding="utf-8") as file:
                found.append(json.load(file)["kept_time"])
        except (FileNotFoundError, ValueError):
            pass  # finished just now
    return found


def wait_for_kept(campaign, process, time_kept):
    """Until one is kept at so late a time (s). False if the process ended."""
    while process.poll() is None:
        if max(kept(campaign), default=0.) >= time_kept:
            return True
        time.sleep(0.002)
    return False


def stopped(make, whole, check):
    """Stopped with r = 2 and gone on with on one rank, and the other way."""
    for first, then in ((2, 1), (1, 2)):
        what = f"stopped with r = {first}, gone on with r = {then}"
        campaign = make(f"stopped-{first}",
                        n=FEW, set={"Campaign/Checkpoint interval": 0.02})
        process = campaign.start(
            ranks=first, set={"Campaign/Ranks per realisation": first})
        check(campaign.wait_for_records(process, 1) and
              wait_for_kept(campaign, process, 0.5), f"{what}: it runs")
        for pid in children(process):
            os.kill(pid, signal.SIGTERM)
        finish(process, 143)
        times = kept(campaign)
        check(len(times) == 1 and times[0] >= 0.5, f"{what}: is kept", times)
        check(len(campaign.records()) < FEW, f"{what}: something is left")
        campaign.run("--resume", ranks=then,
                     set={"Campaign/Ranks per realisation": then})
        check.once_each(what, campaign, FEW)
        like(check, what, whole, campaign)


def a_rank_dies(make, whole, check):
    """The second of a group: all end, what is finished is kept."""
    campaign = make("dies", n=FEW)
    process = campaign.start(ranks=2, set=TWO)
    check(campaign.wait_for_records(process, 2), "a rank dies: it runs")
    os.kill(children(process)[-1], signal.SIGKILL)
    try:
        process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        check(False, "a rank dies: all end", "they hang")
    check(process.returncode != 0, "a rank dies: all end", process.returncode)
    n = len(campaign.records())
    check(2 <= n < FEW, "a rank dies: what is finished is kept", n)
    campaign.run("--resume", ranks=2, set=TWO)
    check.once_each("a rank died", campaign, FEW)
    like(check, "a rank died", whole, campaign)


def snapshots_are_whole(make, check):
    """With tight tolerances those of two ranks are those of one."""
    settings = {"Campaign/Realisations": 1, "Snapshots/First": 1,
                "Time stepping/Time step": 0.02, "Time stepping/End time": 0.2,
                "Time stepping/Ramp duration": 0, "Output/Interval": 0.2,
                "Materials/clay/Initial strength": 7,  # yields at once
                **dict(text.split("=") for text in ranks_cases.tight)}
    one, two = make("whole-1", set=settings), make("whole-2", set=settings)
    one.run()
    two.run(ranks=2, set=TWO)
    places = [os.path.join(campaign.folder, "snapshots", "0-0")
              for campaign in (one, two)]
    moves = np.abs(ranks_compare.last_points(places[1])["velocity"]).max()
    check(moves > 1e-6, "a snapshot moves", moves)
    d, where = ranks_compare.compare_output(*places)
    check(d < 1e-10, "a snapshot is whole", f"{d:.1e} ({where})")


def all_fail(make, check):
    """All ranks of a group meet a numerical failure together."""
    campaign = make("hopeless", set=HOPELESS)
    error = finish(campaign.start(ranks=2, set=TWO), 3)
    records = campaign.records()
    check(len(records) == 2 and all(
        record["outcome"] == "numerical failure" and record["attempts"] == 2
        for record in records), "numerical failures are recorded", error)
    check(os.path.exists(os.path.join(campaign.folder, "snapshots", "0-0",
                                      "summary.json")),
          "and have snapshots")


def refusals(make, check):
    for n_ranks, flags, settings, where in (
            (0, (), TWO, "Campaign/Ranks per realisation"),
            (3, (), TWO, "Campaign/Ranks per realisation"),
            (2, (), {"Campaign/Ranks per realisation": 4},
             "Campaign/Ranks per realisation"),
            (2, (), {"Campaign/Ranks per realisation": 0},
             "Campaign/Ranks per realisation"),
            (2, ("--nonsense",), TWO, "--nonsense")):
        campaign = make("refused")
        process = campaign.start(*flags, ranks=n_ranks, set=settings)
        error = process.communicate()[1]
        check(process.returncode == 2 and error.count("allowed: ") == 1
              and where in error and not os.path.exists(campaign.folder),
              f"refused once: {where} on {n_ranks or 1} rank(s)",
              error.strip().replace("\n", " | ")[:250])


def once_for_all(waker, work, check):
    """What only the first rank could do, or all would repeat."""
    def call(*words, text=""):
        return subprocess.run(["mpirun", "-n", "2", waker, *words], input=text,
                              env=ranks_compare.ENVIRONMENT, capture_output=True,
                              text=True, timeout=60)
    done = call("run", "-", "--set", "Output/Directory=" + os.path.join(work, "-"),
                text="set Dimension = 2\n")
    check(done.returncode == 2 and done.stderr.count("allowed: ") == 1
          and "standard input" in done.stderr, "refused once: -", done.stderr[:200])
    done = call("--version")
    check(done.returncode == 0 and done.stdout.count("aker") == 1,
          "one version", done.stdout)


def main():
    waker, source = sys.argv[1:3]
    n = int(sys.argv[3]) if len(sys.argv) > 3 else N
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:

        def make(name, **more):
            campaign = Campaign(waker, source, os.path.join(folder, name),
                                more.pop("n", n), **more)
            campaign.environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
            return campaign

        whole = make("whole")
        whole.run()
        outcomes = [record["outcome"] for record in whole.records()]
        check(len(set(outcomes)) > 1, "more than one outcome", set(outcomes))

        for n_ranks in (2, 4):
            campaign = make(f"ranks-{n_ranks}")
            campaign.run(ranks=n_ranks, set=TWO)
            what = f"{n_ranks} ranks, 2 for each"
            check.once_each(what, campaign, n)
            like(check, what, whole, campaign)
            check(all(record["ranks"] == 2 for record in campaign.records()),
                  f"{what}: records say so")

        few = FEW if n == N else n
        chunks = make("chunks", n=few)
        for number in (2, 1):
            chunks.run("--chunk", f"{number}/2", ranks=2, set=TWO)
        check.once_each("chunks", chunks, few)
        like(check, "chunks", whole, chunks)
        check(os.path.exists(os.path.join(chunks.folder, "results.h5")),
              "the last chunk merges")

        stopped(make, whole, check)
        a_rank_dies(make, whole, check)
        snapshots_are_whole(make, check)
        all_fail(make, check)
        refusals(make, check)
        once_for_all(waker, folder, check)
    check.exit()


if __name__ == "__main__":
    main()
