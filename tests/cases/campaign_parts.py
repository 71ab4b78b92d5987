#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A campaign is the union of its parts: one process, four ranks, three chunks
and intervals of realisations give the same merged results, and a stop rule ends
it at the same realisation.

usage: campaign_parts.py WAKER SOURCE_DIRECTORY [REALISATIONS]
"""
import json
import os
import signal
import sys
import tempfile

from campaign_case import Campaign, Checks, finish


def main():
    waker, source = sys.argv[1:3]
    n = int(sys.argv[3]) if len(sys.argv) > 3 else 8
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:

        def campaign(name, **more):
            return Campaign(waker, source, os.path.join(folder, name),
                            more.pop("n", n), **more)

        whole = campaign("whole")
        process = whole.start()
        check(whole.wait_for_records(process, 2), "it runs for a while")
        # Held, so that it is still at it when status has an answer.
        os.killpg(process.pid, signal.SIGSTOP)
        text = whole.call("status")
        check(f"of {n}" in text and process.poll() is None,
              "status while it runs", text.strip().split("\n")[0])
        os.killpg(process.pid, signal.SIGCONT)
        finish(process)
        check.once_each("one process", whole, n)
        check(f"{n} of {n}" in whole.call("status"), "status afterwards")
        reference = whole.merged()
        outcomes = [record["outcome"] for record in whole.records()]
        check(len(set(outcomes)) > 1, "more than one outcome",
              {name: outcomes.count(name) for name in sorted(set(outcomes))})

        # Snapshots: full output of chosen realisations, as the campaign has
        # them. On two ranks, and again: those that are there stay.
        snapshots = campaign("snapshots", set={
            "Snapshots/First": 1, "Snapshots/Of each outcome": 1,
            "Snapshots/Realisations": n - 1})
        snapshots.run(ranks=2)
        by_outcome = {}
        for record in sorted(whole.records(), key=lambda r: r["realisation"]):
            by_outcome.setdefault(record["outcome"], record["realisation"])
        wanted = {0, n - 1, *by_outcome.values()}
        place = os.path.join(snapshots.folder, "snapshots")
        check(set(os.listdir(place)) == {f"0-{i}" for i in wanted},
              "snapshots of those asked for", sorted(os.listdir(place)))
        widths = {record["realisation"]: record["residual_width"]
                  for record in whole.records()}
        for i in wanted:
            with open(os.path.join(place, f"0-{i}", "summary.json"),
                      encoding="utf-8") as file:
                check(json.load(file)["residual_width"] == widths[i],
                      f"snapshot {i} ends as in the campaign")
        check.same("with snapshots", reference, snapshots.merged())

        for number in (2, 4):
            ranks = campaign(f"ranks-{number}")
            ranks.run(ranks=number)
            check.once_each(f"{number} ranks", ranks, n)
            check.same(f"{number} ranks", reference, ranks.merged())

        # Two of three at a time, the first one last.
        chunks = campaign("chunks")
        pair = [chunks.start("--chunk", "3/3"), chunks.start("--chunk", "2/3")]
        for process in pair:
            finish(process)
        check(f"of {n}" in chunks.call("status"), "status between the chunks")
        chunks.run("--chunk", "1/3")
        check.once_each("3 chunks", chunks, n)
        check.same("3 chunks", reference, chunks.merged())

        if n >= 40:  # a job array that begins all at once, in a new folder
            crowd = campaign("crowd")
            for process in [crowd.start("--chunk", f"{i}/8")
                            for i in range(1, 9)]:
                finish(process)
            check.once_each("8 chunks at once", crowd, n)
            check.same("8 chunks at once", reference, crowd.merged())

        parts = campaign("parts")
        for first, last in [(n // 2, n), (0, n // 3), (n // 3, n // 2)]:
            parts.run("--realisations", f"{first}:{last}")
        check.once_each("three intervals", parts, n)
        check.same("three intervals", reference, parts.merged())

        # A stop rule. Four ranks may have computed more than is used.
        rule = {"Campaign/Target": "initial failure",
                "Campaign/Coefficient of variation": 0.5 if n < 40 else 0.25}
        one = campaign("rule-1", n=10 * n, set=rule)
        one.run()
        stopped = len(one.records())
        check(0 < stopped < 10 * n, "a rule stops the campaign early",
              f"{stopped} of {10 * n}")
        four = campaign("rule-4", n=10 * n, set=rule)
        four.run(ranks=4)
        check.same("stop rule, 4 ranks", one.merged(), four.merged())
    check.exit()


if __name__ == "__main__":
    main()
