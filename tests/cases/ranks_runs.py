# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of ranks_cases.py on one rank and on several: with tight tolerances,
with those that users have, and few steps for programs that look after themselves."""
import os
import tempfile

import ranks_cases
from ranks_cases import cases, tight
from ranks_compare import compare, run, statistics, summary

LIMIT = 1e-10


def path_of(source, case):
    return os.path.join(source, "parameters", case.file)


def case_settings(case, work, steps, settings=None):
    """Of that many steps, with tight tolerances unless other settings are given."""
    if settings is None:
        settings = with_tight(case.settings)
    for name, text in case.files.items():
        with open(os.path.join(work, name), "w") as file:
            file.write(text)
    end = steps * case.step
    return [setting.replace("{folder}", work) for setting in settings] + [
        f"Time stepping/Time step={case.step}", f"Time stepping/End time={end}",
        f"Output/Interval={end}", f"Output/Checkpoint interval={end}"]


def with_tight(settings):
    names = {setting.partition("=")[0] for setting in settings}
    return [setting for setting in tight
            if setting.partition("=")[0] not in names] + settings


def is_sound(case, one, many):
    """Steps find a balance on both, unless the case is of what happens if not; and
    what the case is of has happened."""
    bad = []
    unconverged = [summary(folder)["unconverged_steps"] for folder in (one, many)]
    if unconverged[0] != unconverged[1] or (
            (unconverged[0] > 0) != bool(case.unbalanced)):
        bad.append(f"{unconverged} unconverged steps")
    names, rows = statistics(one)
    bad += [f"{name} is zero" for name in case.shows
            if not abs(rows[-1, names.index(name)]) > 0.]
    if bad:
        print("BAD: " + ", ".join(bad))
    return not bad


def tight_runs(waker, source, name, counts):
    """How many of the comparisons are bad."""
    case, bad = cases[name], 0
    with tempfile.TemporaryDirectory() as work:
        settings = case_settings(case, work, case.steps)
        one = os.path.join(work, "one")
        run(waker, path_of(source, case), settings, one, 1)
        for n in counts:
            many = os.path.join(work, str(n))
            run(waker, path_of(source, case), settings, many, n)
            d, where = compare(one, many)
            print(f"{name}, {n} ranks: {d:.1e} ({where})", flush=True)
            bad += not (d < LIMIT and is_sound(case, one, many))
    return bad


def few_steps(waker, source, name):
    """Four steps on two ranks, on coarser cells, and one more on three from their
    checkpoint, for a program with assertions and sanitizers."""
    case = cases[name]
    names = {setting.partition("=")[0] for setting in case.few}
    own = [setting for setting in case.settings
           if setting.partition("=")[0] not in names] + case.few
    file, good = path_of(source, case), True
    with tempfile.TemporaryDirectory() as work:
        one, many = os.path.join(work, "one"), os.path.join(work, "many")
        begins, ends = (case_settings(case, work, steps, with_tight(own))
                        for steps in (4, 5))
        # Of explicit steps the last one before an end is shorter.
        said = run(waker, file, begins, one, 1)
        said += run(waker, file, ends, one, 1, "--resume")
        said += run(waker, file, begins, many, 2)
        said += run(waker, file, ends, many, 3, "--resume")
        for line in said.splitlines():
            if any(word in line for word in ("Sanitizer", "runtime error",
                                             "An error occurred in line")):
                print(line)
                good = False
        d, where = compare(one, many)
        print(f"{name}, 4 steps on 2 ranks and one on 3: {d:.1e} ({where})",
              flush=True)
        # What a case is of may take more steps, or finer cells.
        same = (summary(one)["unconverged_steps"] ==
                summary(many)["unconverged_steps"])
        if not same:
            print("other steps are unconverged")
    return good and same and d < LIMIT


def tolerance_of(folder):
    """Newton/Tolerance of a run."""
    section = ""
    with open(os.path.join(folder, "parameters.prm")) as file:
        for line in file:
            words = line.split("#")[0].split()
            if words[:1] == ["subsection"]:
                section = " ".join(words[1:])
            elif section == "Newton" and words[:3] == ["set", "Tolerance", "="]:
                return float(words[3])
    raise ValueError(folder + " has no tolerance")


def with_defaults(waker, source, name):
    """With the tolerances of the file, or the program's own, ranks change no more
    than the tolerance, nor than ten times of it change on one rank."""
    case, bad = cases[name], 0
    settings = [setting for setting in case.settings
                if not setting.startswith("Newton/")]
    file = path_of(source, case)
    with tempfile.TemporaryDirectory() as work:
        settings = case_settings(case, work, case.steps, settings)
        one, looser = os.path.join(work, "one"), os.path.join(work, "looser")
        run(waker, file, settings, one, 1)
        tolerance = tolerance_of(one)
        run(waker, file, settings + [f"Newton/Tolerance={10 * tolerance:g}"],
            looser, 1)
        changed = compare(one, looser)[0]
        limit = max(min(changed, tolerance), LIMIT)
        for n in (2, 3, 4):
            many = os.path.join(work, str(n))
            run(waker, file, settings, many, n)
            d, where = compare(one, many)
            print(f"{name}, tolerance {tolerance:g}, {n} ranks: {d:.1e} ({where}), "
                  f"ten times the tolerance: {changed:.1e}", flush=True)
            bad += not (d <= limit and summary(one)["unconverged_steps"] ==
                        summary(many)["unconverged_steps"])
    return bad


def to_the_end(waker, source):
    """The weak dyke at the program's tolerances, until it is flooded."""
    times = ("initial_failure_time", "initial_failure_time_thesis",
             "initial_failure_time_displacement", "flooding_time", "end_time")
    ends, bad = {}, 0
    with tempfile.TemporaryDirectory() as work:
        for n in (1, 2, 3, 4):
            folder = os.path.join(work, str(n))
            run(waker, os.path.join(source, "parameters", ranks_cases.WEAK),
                [], folder, n)
            ends[n] = summary(folder)
    one = ends[1]
    bad += one["outcome"] != "flooding" or one["flooding_time"] is None
    for n, end in ends.items():
        worst = 0.
        for name in times:
            if (end[name] is None) != (one[name] is None):
                worst = float("inf")
            elif one[name] is not None:
                worst = max(worst, abs(end[name] - one[name]) / one[name])
        print(f"to the end, {n} ranks: {end['outcome']} ({end['stop_reason']}), " +
              ", ".join(f"{name} {end[name]:.3f} s" for name in times
                        if end[name] is not None) +
              f"; times differ by {100 * worst:.2g} %", flush=True)
        bad += not (worst <= 0.01 and end["outcome"] == one["outcome"] and
                    end["stop_reason"] == one["stop_reason"])
    return bad
