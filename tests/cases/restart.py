#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run that is killed and resumed leaves the same files, bit for bit, as one
that was not.

usage: restart.py WAKER SOURCE_DIRECTORY [SEED]

Kills with SIGKILL: several times at moments of a failing dyke that a seed
chooses, once inside the window of a stop rule (the dyke is at rest, but not
yet for long enough), and while a load programme grows, waits and has been stopped. Also ends a run with SIGTERM, which writes a checkpoint of
its own, and takes the folder of the checkpoints away from one.
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

import program

# Coarse, so that a run takes seconds; a checkpoint every 0.1 s, so that the
# kills fall between checkpoints that are not all the same.
coarse = ["Grid/Cell size=0.5", "Output/Interval=0.2",
          "Output/Checkpoint interval=0.1", "Output/Top view=true"]
failing = coarse + ["Materials/clay/Initial strength=8",
                    "Materials/clay/Residual strength=3"]
# Comes to rest; the window of the rule is made long, the checks are in it.
resting = coarse + ["Materials/clay/Initial strength=13",
                    "Materials/clay/Residual strength=5",
                    "Stop rules/Rest duration=3"]
# Points soften by their surroundings.
surrounded = failing + ["Materials/clay/Regularisation=nonlocal",
                        "Materials/clay/Averaging length=0.5",
                        "Materials/clay/Softening modulus=-300"]
# The load waits from about 0.5 s on and is stopped soon after.
loading = ["Grid/Cell size=0.25", "Output/Interval=0.1",
           "Output/Checkpoint interval=0.05", "Time stepping/End time=1.5"]


def command(waker, folder, settings, *flags):
    """`waker`: program and .prm file."""
    words = [waker[0], "run", waker[1], "--set", "Output/Directory=" + folder, *flags]
    for setting in settings:
        words += ["--set", setting]
    return words


def start(waker, folder, settings, *flags):
    return subprocess.Popen(command(waker, folder, settings, *flags),
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def complete(waker, folder, settings, *flags, check=False):
    """To its end, without a process to wait for or to kill."""
    return program.shared(waker[0]).run(
        command(waker, folder, settings, *flags)[1:], check=check)


def simulated_time(folder):
    """Time in the last complete row of the statistics on disk."""
    try:
        with open(os.path.join(folder, "statistics")) as file:
            rows = file.read().split("\n")[:-1]
        return float(rows[-1].split()[1])
    except (OSError, IndexError, ValueError):
        return 0.


def has_checkpoint(folder):
    slots = os.path.join(folder, "checkpoints")
    return os.path.isdir(slots) and any(
        name.endswith(".bin") for name in os.listdir(slots))


def kill_and_resume(waker, folder, settings, moments, kill, rng):
    """Kill at each simulated moment (s), resume, and finally let it end.
    Returns the times up to which the statistics were on disk at the kills."""
    kills, flags = [], ()
    for moment in moments:
        run = start(waker, folder, settings, *flags)
        while run.poll() is None and not (
                has_checkpoint(folder) and simulated_time(folder) >= moment):
            time.sleep(0.002)
        time.sleep(0.03 * rng.random())
        run.send_signal(kill)
        run.communicate()
        code = run.returncode
        if code == 0:  # it was faster
            return kills
        if code != (143 if kill == signal.SIGTERM else -kill):
            sys.exit(f"signal {kill}: ended with {code}")
        kills.append(simulated_time(folder))
        # As if it had been killed between writing a file and renaming it.
        open(os.path.join(folder, "surface.pvd.tmp"), "w").close()
        flags = ("--resume",)
    complete(waker, folder, settings, *flags, check=True)
    return kills


def files(folder):
    """Everything that must be equal, by name."""
    found = {}
    for base, _, names in os.walk(folder):
        if "checkpoints" in base:
            continue
        for name in names:
            if name in ("log.txt", "parameters.prm"):
                continue  # the log tells of the resumption; the folder differs
            with open(os.path.join(base, name), "rb") as file:
                found[os.path.relpath(os.path.join(base, name), folder)] = (
                    file.read())
    summary = json.loads(found.pop("summary.json"))
    summary.pop("wall_time")
    found["summary.json"] = json.dumps(summary)
    return found


def compare(name, reference, resumed, kills, n_kills):
    a, b = files(reference), files(resumed)
    different = sorted(set(a) ^ set(b)) + sorted(
        key for key in set(a) & set(b) if a[key] != b[key])
    print(f"{name}: {len(kills)} of {n_kills} kills, {len(a)} files, "
          f"{len(different)} different {different[:4]}")
    return len(kills) == n_kills and len(a) > 20 and not different


def last_state(folder):
    """The newest checkpoint holds the final state."""
    slots = os.path.join(folder, "checkpoints")
    return max((os.path.join(slots, name) for name in os.listdir(slots)),
               key=os.path.getmtime)


def damaged_fields(waker, folder):
    """Field files of before the checkpoint that are not what was written are
    told, and are no reason to end."""
    run = start(waker, folder, failing)
    while run.poll() is None and simulated_time(folder) < 1.:
        time.sleep(0.002)
    run.send_signal(signal.SIGTERM)
    run.wait()
    first, second = (os.path.join(folder, "solution", f"particles-{k:05d}.vtu")
                     for k in (0, 1))
    with open(first, "r+b") as file:
        file.seek(-200, os.SEEK_END)
        byte = file.read(1)
        file.seek(-200, os.SEEK_END)
        file.write(bytes([byte[0] ^ 1]))
    os.remove(second)
    done = complete(waker, folder, failing, "--resume")
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        warnings = " ".join(json.load(file)["warnings"])
    ok = (done.returncode == 0 and "2 field files" in warnings and
          "solution/particles-00000.vtu" in warnings)
    print(f"damaged field files {'told' if ok else 'NOT TOLD'}: "
          f"{done.returncode}, {warnings}")
    return ok


def damaged_statistics(waker, folder):
    """Rows of before the checkpoint that are gone are told; a header that is not
    that of the rows is a reason to end."""
    complete(waker, folder, failing + ["Time stepping/End time=0.3"], check=True)
    path = os.path.join(folder, "statistics")
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    n_header = sum(line.startswith("#") for line in lines)

    def resumed(changed, end):
        if changed is None:
            os.remove(path)
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write("\n".join(changed))
        done = complete(waker, folder, failing + [f"Time stepping/End time={end}"],
                        "--resume")
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            return done, " ".join(json.load(file)["warnings"])

    ok = True
    for name, changed in (("a row", lines[:n_header + 7] + lines[n_header + 8:]),
                          ("the rest", lines[:n_header + 7] + [""]),
                          ("garbage", lines[:n_header + 7] + ["x 7 7"] +
                           lines[n_header + 8:])):
        done, warnings = resumed(changed, 0.4 + 0.1 * ok)
        good = done.returncode == 0 and "the first is that of step 7" in warnings
        print(f"damaged statistics, {name}: {done.returncode}, {warnings}")
        ok = ok and good
    done, _ = resumed(lines[3:], 0.6)
    print(f"damaged header: {done.returncode}, {done.stderr}")
    ok = ok and done.returncode == 2 and "header of" in done.stderr
    done, warnings = resumed(None, 0.6)
    print(f"no statistics: {done.returncode}, {warnings}")
    return ok and done.returncode == 0 and "the first is that of step 0" in warnings


def folder_goes_bad(waker, folder):
    """In place of the checkpoints' folder there is a file: not the input's fault."""
    settings = [setting for setting in failing if "Checkpoint" not in setting]
    settings.append("Output/Checkpoint interval=0.01")
    process = start(waker, folder, settings)
    while not has_checkpoint(folder) and process.poll() is None:
        time.sleep(0.01)
    checkpoints = os.path.join(folder, "checkpoints")
    os.rename(checkpoints, checkpoints + "-aside")
    with open(checkpoints, "w"):
        pass
    error = process.communicate()[1].decode()
    if process.returncode != 4 or "Not a directory" not in error or \
            folder not in error:
        sys.exit(f"a folder that goes bad ends with {process.returncode}:\n{error}")
    os.remove(checkpoints)
    os.rename(checkpoints + "-aside", checkpoints)
    settings.append("Time stepping/End time=0.5")
    done = complete(waker, folder, settings, "--resume")
    if done.returncode != 0:
        sys.exit("it does not go on when the folder is good again: "
                 f"{done.returncode}")
    print("a folder that goes bad: told, and goes on")


def main():
    parameters = os.path.join(sys.argv[2], "parameters")
    dyke = (sys.argv[1], os.path.join(parameters, "chapter5", "dyke_weak.prm"))
    slope = (sys.argv[1],
             os.path.join(parameters, "chapter6", "foundation_2d.prm"))
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    print(f"seed {seed}")
    rng = random.Random(seed)
    ok, wholes = True, []
    with tempfile.TemporaryDirectory() as folder:
        for name, waker, settings, moments, kill in [
                ("killed at random while failing", dyke, failing,
                 sorted(rng.uniform(0.2, 4.) for _ in range(3)),
                 signal.SIGKILL),
                ("killed in the window of the stop rule", dyke, resting,
                 [rng.uniform(1.5, 3.5)], signal.SIGKILL),
                ("killed under a load that grows", slope, loading,
                 sorted(rng.uniform(0.1, 1.4) for _ in range(3)),
                 signal.SIGKILL),
                ("killed while softening is nonlocal", dyke, surrounded,
                 sorted(rng.uniform(0.5, 3.) for _ in range(2)),
                 signal.SIGKILL),
                ("ended with SIGTERM", dyke, failing, [rng.uniform(0.5, 3.)],
                 signal.SIGTERM)]:
            parts = os.path.join(folder, name.replace(" ", "_"))
            # Two share one that was not killed.
            if settings not in wholes:
                wholes.append(settings)
                complete(waker, os.path.join(folder, f"whole-{len(wholes) - 1}"),
                         settings, check=True)
            whole = os.path.join(folder, f"whole-{wholes.index(settings)}")
            kills = kill_and_resume(waker, parts, settings, moments, kill, rng)
            ok = compare(name, whole, parts, kills, len(moments)) and ok
            if settings is resting:
                end = simulated_time(whole)
                inside = all(end - 3 < kill < end for kill in kills)
                print(f"  killed at {kills} s, "
                      f"{'in' if inside else 'NOT IN'} the 3 s before {end} s")
                ok = ok and inside
            with open(last_state(whole), "rb") as a, open(last_state(parts),
                                                          "rb") as b:
                same = a.read() == b.read()
            print(f"  final checkpoint {'equal' if same else 'DIFFERENT'}")
            ok = ok and same
        ok = damaged_fields(dyke, os.path.join(folder, "damaged")) and ok
        ok = damaged_statistics(dyke, os.path.join(folder, "rows")) and ok
        folder_goes_bad(dyke, os.path.join(folder, "bad"))
    return 0 if ok else 1


if __name__ == "__main__":
    sys.exit(main())
