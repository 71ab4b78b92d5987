#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of doc/verification/restart.md: a failing dyke that is killed with SIGKILL
at random moments and resumed, on top of one that was not.

    /usr/bin/python3 contrib/verification/restart.py [--waker PATH]
"""

import os
import random
import signal
import subprocess

import numpy as np
from common import ROOT, plt, save
from dyke_runs import workspace, write_csv
import restart as test  # tests/cases/restart.py
import runs

with workspace(__doc__) as work:
    waker = (work.waker, os.path.join(ROOT, "parameters", "chapter5",
                                      "dyke_weak.prm"))
    whole, parts = (os.path.join(work.folder, name)
                    for name in ("whole", "parts"))
    subprocess.run(test.command(waker, whole, test.failing), check=True,
                   stdout=subprocess.DEVNULL)
    rng = random.Random(2026)
    moments = sorted(rng.uniform(0.2, 4.) for _ in range(6))
    kills = test.kill_and_resume(waker, parts, test.failing, moments,
                                 signal.SIGKILL, rng)
    equal = test.compare("killed at random", whole, parts, kills,
                         len(moments))
    a, b = runs.statistics(whole), runs.statistics(parts)

times, width = a["Time (s)"], a["Dyke width W (m)"]
write_csv("restart", {"time_s": times, "width_m": width,
                      "width_killed_and_resumed_m": b["Dyke width W (m)"]}, 10)
figure, axes = plt.subplots(figsize=(7, 3.2))
axes.plot(times, width, lw=4, alpha=0.35, label="not killed")
axes.plot(b["Time (s)"], b["Dyke width W (m)"], "k--", lw=1,
          label="killed and resumed")
axes.plot(kills, np.interp(kills, times, width), "rx", label="SIGKILL")
axes.set_xlabel("time (s)")
axes.set_ylabel("dyke width W (m)")
axes.set_title("all files equal" if equal else "FILES DIFFER")
axes.legend()
save(figure, "restart")
