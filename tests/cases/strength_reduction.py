#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A strength reduction is of all that a run can have: a trend is the same in the
material and in a field's mean, a realisation fails at the factor 1 if and only if
it fails in the campaign, and a search that was killed goes on where it was.

usage: strength_reduction.py WAKER SOURCE_DIRECTORY
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

import program
from campaign_case import COARSE, Campaign, Checks

# The middle of this bracket is 1: what a realisation of the campaign has.
BRACKET = {"Strength reduction/Lower factor": 0.5,
           "Strength reduction/Upper factor": 1.5,
           "Strength reduction/Tolerance": 0.13}


class Reduction:
    """waker strength-reduction of a file, in a folder: of a campaign, or of
    the same dyke without random fields."""

    def __init__(self, waker, source, folder, random):
        self.folder = folder
        self.words = [os.path.abspath(waker), "strength-reduction",
                      os.path.join(os.path.abspath(source), "parameters",
                                   "chapter5",
                                   "analysis1.prm" if random else "dyke.prm")]
        self.environment = dict(os.environ, OMP_NUM_THREADS="1")

    def command(self, *flags, **sets):
        words = [*self.words, *flags]
        for name, value in {**COARSE, **BRACKET,
                            "Output/Directory": self.folder,
                            **sets.pop("set", {})}.items():
            words += ["--set", f"{name}={value}"]
        return words

    def start(self, *flags, **sets):
        """In the background."""
        return subprocess.Popen(self.command(*flags, **sets), text=True,
                                env=self.environment,
                                stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE)

    def asked(self, *flags, check=False, **sets):
        """To its end, without a process to wait for or to kill."""
        words = self.command(*flags, **sets)
        return program.shared(words[0]).run(words[1:], env=self.environment,
                                            check=check)

    def run(self, *flags, **sets):
        """The same. Must succeed."""
        self.asked(*flags, check=True, **sets)
        return self.result()

    def result(self):
        with open(os.path.join(self.folder, "strength_reduction.json"),
                  encoding="utf-8") as file:
            return json.load(file)

    def trials(self):
        try:
            with open(os.path.join(self.folder, "strength_reduction.csv"),
                      encoding="utf-8") as file:
                return file.read().split("\n")[2:-1]
        except FileNotFoundError:
            return []


def main():
    waker, source = sys.argv[1:3]
    check = Checks()
    with tempfile.TemporaryDirectory(prefix="waker-") as folder:

        def reduction(name, random=True):
            return Reduction(waker, source, os.path.join(folder, name), random)

        # A trend, said in three ways. Nothing is random with the means.
        trend = "8 + 2*depth"
        in_material = {"Materials/clay/Initial strength": trend,
                       "Materials/clay/Residual strength":
                       "initial_strength/2.5"}
        own = reduction("own", False).run(set=in_material)
        mean = reduction("mean").run(
            set={"Random fields/strength/Mean": trend})
        both = reduction("both").run(set=in_material)
        check(own["factor_of_safety"] is not None, "a factor of safety",
              own["factor_of_safety"])
        for name, other in (("mean", mean), ("both", both)):
            check(all(own[key] == other[key] for key in
                      ("factor_of_safety", "failure", "trials")),
                  f"the trend in {name}: the same factor",
                  other["factor_of_safety"])
        check(own["strengths"] == "those of the materials"
              and mean["strengths"] == "means of the random fields",
              "says what it reduced", mean["strengths"])
        uniform = reduction("uniform").run()
        check(uniform["factor_of_safety"] != own["factor_of_safety"],
              "the trend counts", uniform["factor_of_safety"])

        # A random dyke's factor and its realisation in the campaign.
        n = 6
        campaign = Campaign(waker, source, os.path.join(folder, "campaign"), n)
        campaign.run()
        fails = {record["realisation"]:
                 record["outcome"] in ("initial failure", "flooding")
                 for record in campaign.records()}
        check(len(set(fails.values())) == 2, "some realisations fail",
              sum(fails.values()))
        for i, failed in sorted(fails.items()):
            found = reduction(f"realisation-{i}").run("--realisation", str(i))
            factor = found["factor_of_safety"]
            check(factor is not None and (factor < 1) == failed,
                  f"realisation {i}: fails {failed}", f"factor {factor}")
            check(found["strengths"] == f"realisation {i} of seed 1",
                  f"realisation {i}: says so", found["strengths"])

        # The trials of another realisation are not taken for its own.
        other = reduction("realisation-0")
        check.refused("resume with another realisation",
                      other.asked("--resume", "--realisation", "1"),
                      "belongs to another case")
        check.refused("a realisation of nothing random",
                      reduction("x", False).asked("--realisation", "1"),
                      "nothing is random")

        # Killed after the second trial, then resumed.
        killed = reduction("killed", False)
        process = killed.start(set=in_material)
        while len(killed.trials()) < 2 and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        before = killed.trials()
        check(2 <= len(before) < own["trials"], "killed in between",
              len(before))
        again = killed.run("--resume", set=in_material)
        check(again == own, "resumed: the same result",
              again["factor_of_safety"])
        check(set(before) <= set(killed.trials()),
              "trials made before the kill are kept", len(before))

        # Stopped while soil still moves: neither stable nor failed.
        short = reduction("short", False).run(set={
            **in_material, "Time stepping/End time": 1.2,
            "Strength reduction/Upper factor": 4})
        check(short["factor_of_safety"] is None
              and len(short["undecided_factors"]) > 0,
              "still moving at the end time: no factor",
              short["undecided_factors"])
        outcomes = {line.split(",")[3]
                    for line in reduction("short").trials()
                    if ",undecided," in line}
        check(outcomes == {"still moving"}, "and says why", outcomes)

        # Nothing converges: recorded, and not a factor.
        trouble = reduction("trouble", False)
        code = trouble.asked(set={"Newton/Tolerance": 1e-15,
                                  "Newton/Maximum iterations": 1,
                                  "Time stepping/Maximum halvings": 1}).returncode
        check(code == 3, "numerical failure: exit code", code)
        result = trouble.result()
        check(result["factor_of_safety"] is None
              and result["numerical_failures"] == 1
              and result["undecided_factors"] == [0.5],
              "numerical failure: counted, no factor", result)
        check([line.split(",")[6] for line in trouble.trials()] == ["3"],
              "with all attempts", trouble.trials())
    check.exit()


if __name__ == "__main__":
    main()
