# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run on several ranks that is killed again and again."""
import glob
import os
import random
import signal
import subprocess
import time

from ranks_compare import ENVIRONMENT, command, compare, run, statistics


def ranks_of(process):
    """The ranks that an mpirun has started."""
    return [int(word) for word in
            subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True,
                           text=True).stdout.split()]


def kill(process, alone=None):
    """By SIGKILL, all ranks or the one of this number; and wait: a rank that is left
    would still have the folder."""
    ranks = ranks_of(process)
    for pid in (ranks + [process.pid] if alone is None else
                [ranks[alone % len(ranks)]]):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    while any(os.path.exists(f"/proc/{pid}/exe") for pid in ranks):
        time.sleep(0.01)


def n_steps_in(folder):
    try:
        return len(statistics(folder)[1]) - 1
    except (OSError, ValueError, IndexError):
        return -1


def checkpoints(folder):
    """When they were written."""
    times = []
    for name in glob.glob(os.path.join(folder, "checkpoints", "*.bin")):
        try:
            times.append(os.stat(name).st_mtime_ns)
        except OSError:
            pass
    return sorted(times)


def kill_and_resume(waker, path, settings, work, counts, n_steps, seed):
    """Each but the last of these numbers of ranks is killed, at a moment that the
    seed chooses; of two of many one rank alone, for which MPI ends the others."""
    one, many = os.path.join(work, "one"), os.path.join(work, "resumed")
    run(waker, path, settings, one, 1)
    # Each step a checkpoint: what a kill leaves behind is that of some step.
    settings = [setting for setting in settings
                if not setting.startswith("Output/Checkpoint")]
    settings.append("Output/Checkpoint interval=1e-6")
    rng = random.Random(seed)
    n_kills = len(counts) - 1
    # A run makes some steps more while it is looked at.
    moments = sorted(rng.sample(range(1, n_steps * 3 // 4), n_kills))
    several = [k for k in range(n_kills) if counts[k] > 1]
    single = set(rng.sample(several, 2)) if n_kills > 2 else set()
    killed_at = []
    for k, n in enumerate(counts[:-1]):
        # Killed before its first checkpoint it begins anew.
        flags = ([] if not os.path.isdir(many) else
                 ["--resume"] if checkpoints(many) else ["--overwrite"])
        before = checkpoints(many)
        pause, alone = 0.02 * rng.random(), rng.randrange(n)
        process = subprocess.Popen(
            ["mpirun", "-n", str(n)] + command(waker, path, settings, many, *flags),
            env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True)
        # It has gone on itself.
        while process.poll() is None and not (
                checkpoints(many) != before and n_steps_in(many) >= moments[k]):
            time.sleep(0.002)
        time.sleep(pause)
        if process.poll() is None:
            kill(process, alone if k in single else None)
            if process.returncode != 0:
                killed_at.append((n_steps_in(many), n, k in single))
    run(waker, path, settings, many, counts[-1], "--resume")
    d, where = compare(one, many)
    print(f"seed {seed}: killed after step " +
          ", ".join(f"{step} on {n}" + (" (one of them)" if one_rank else "")
                    for step, n, one_rank in killed_at) +
          f", ended on {counts[-1]}: {d:.1e} ({where})", flush=True)
    return (d < 1e-10 and len(killed_at) == n_kills and
            sum(one_rank for *_, one_rank in killed_at) == len(single))
