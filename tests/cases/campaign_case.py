# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small campaign in a folder of its own: start it in any way, read what it
left, compare it with another one. Shared by the campaign_*.py tests."""

import csv
import glob
import json
import os
import subprocess
import sys
import time

import h5py
import program

# What may differ between two campaigns with the same results.
TIMINGS = ("wall_time", "field_time")

# A coarse, weak dyke, so that a realisation takes a fraction of a second and
# all outcomes occur.
COARSE = {
    "Grid/Cell size": 0.5,
    "Time stepping/Time step": 0.02,
    "Time stepping/End time": 6,
    "Materials/clay/Initial strength": 10,
    "Materials/clay/Residual strength": 4,
    "Campaign/Batch": 4,
}


class Campaign:
    """The campaign of a .prm file with other settings, in a folder."""

    def __init__(self, waker, source, folder, n, **more):
        self.waker = os.path.abspath(waker)
        self.file = os.path.join(os.path.abspath(source), "parameters",
                                 "chapter5", "analysis1.prm")
        self.folder = folder
        self.settings = {**COARSE, "Campaign/Realisations": n,
                         "Output/Directory": folder, **more.pop("set", {})}
        self.environment = dict(
            os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
            OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
            OMPI_MCA_rmaps_base_oversubscribe="1")

    def command(self, *flags, ranks=0, **settings):
        words = ["mpirun", "-n", str(ranks)] if ranks else []
        words += [self.waker, "campaign", self.file, *flags]
        for name, value in {**self.settings,
                            **settings.pop("set", {})}.items():
            words += ["--set", f"{name}={value}"]
        return words

    def start(self, *flags, ranks=0, **more):
        """In the background, in a process group of its own."""
        process = more.pop("process", {})
        return subprocess.Popen(
            self.command(*flags, ranks=ranks, **more), text=True,
            env=self.environment, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, start_new_session=True, **process)

    def run(self, *flags, ranks=0, **more):
        """To its end. Must succeed."""
        if ranks:
            finish(self.start(*flags, ranks=ranks, **more))
        else:
            self.ask(self.command(*flags, **more), check=True)

    def ask(self, words, **more):
        """A command line of the program to its end, without a process to wait
        for or to kill."""
        return program.shared(self.waker).run(words[1:], env=self.environment,
                                              **more)

    def asked(self, *flags, **settings):
        """The campaign likewise; it may fail."""
        return self.ask(self.command(*flags, **settings))

    def call(self, command, *flags):
        """`waker status` or `merge`; must succeed. Returns what it prints."""
        words = [self.waker, command, self.folder, *flags]
        return self.ask(words, check=True).stdout

    def journals(self):
        return sorted(glob.glob(os.path.join(self.folder, "journal-*.jsonl")))

    def records(self):
        """The records of all whole, readable lines, in no order."""
        found = []
        for path in self.journals():
            with open(path, encoding="utf-8", errors="replace") as file:
                lines = file.read().split("\n")[:-1]
            for line in lines:
                try:
                    record = json.loads(line)
                except ValueError:
                    continue
                if "realisation" in record:
                    found.append(record)
        return found

    def wait_for_records(self, process, n, seconds=120):
        """Until n are in the journals. False if the process ended first."""
        end = time.monotonic() + seconds
        while len(self.records()) < n:
            if process.poll() is not None:
                return False
            if time.monotonic() > end:
                process.kill()
                sys.exit(f"fewer than {n} realisations after {seconds} s")
            time.sleep(0.01)
        return True

    def merged(self):
        """results() after merging."""
        self.call("merge")
        return self.results()

    def results(self):
        """{name: contents} of all that merging made, without timings: the
        datasets of results.h5, with type and shape, and the tables."""
        found = {}

        def add(name, item):
            if (isinstance(item, h5py.Dataset)
                    and name.split("/")[-1] not in TIMINGS):
                values = item[()]
                found["results.h5/" + name] = (
                    str(item.dtype), item.shape,
                    repr(values.tolist() if hasattr(values, "tolist")
                         else values))

        with h5py.File(os.path.join(self.folder, "results.h5"), "r") as file:
            file.visititems(add)
        for path in glob.glob(os.path.join(self.folder, "report", "*.csv")):
            with open(path, encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            for row in rows:
                for name in TIMINGS:
                    row.pop(name, None)
            found["report/" + os.path.basename(path)] = rows
        return found


def finish(process, code=0):
    """Wait for what was started, which must end with this exit code."""
    error = process.communicate()[1]
    if process.returncode != code:
        sys.exit(f"{' '.join(process.args)}\nended with {process.returncode}, "
                 f"not {code}:\n{error}")
    return error


class Checks:
    def __init__(self):
        self.made = 0
        self.failed = 0

    def __call__(self, good, what, obtained=""):
        self.made += 1
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'} {what}"
              f"{': ' if obtained != '' else ''}{obtained}", flush=True)

    def same(self, what, reference, other):
        """Are two results of merged() equal?"""
        different = sorted(set(reference) ^ set(other)) + sorted(
            name for name in set(reference) & set(other)
            if reference[name] != other[name])
        self(len(reference) > 3 and not different, f"{what}: merged results",
             f"{len(reference)} compared, {len(different)} different "
             f"{' '.join(different[:5])}")

    def once_each(self, what, campaign, n):
        """Is each realisation 0 .. n - 1 in the journals, once?"""
        numbers = sorted(record["realisation"] for record in campaign.records())
        self(numbers == list(range(n)), f"{what}: each of {n} once",
             f"{len(numbers)} records, {len(set(numbers))} realisations")

    def refused(self, what, process, problem, code=2):
        """Did a process, or a call that has ended, say in three lines what is
        wrong?"""
        if isinstance(process, subprocess.Popen):
            error = process.communicate()[1]
        else:
            error = process.stderr
        error = error.strip().split("\n")
        good = (process.returncode == code and len(error) == 3
                and problem in " ".join(error[:2])
                and error[2].startswith("allowed: "))
        self(good, what, f"exit code {process.returncode}, "
             + " | ".join(error)[:300])

    def exit(self):
        if self.made == 0:
            sys.exit("nothing was checked")
        sys.exit(1 if self.failed else 0)
