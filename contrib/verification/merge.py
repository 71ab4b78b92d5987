#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long does it take to merge a large campaign? Runs a few realisations of a
coarse base case, repeats their records under other numbers, until there are as many
as wanted, merges them with the program, and opens the store in h5py and xarray.

usage: merge.py [--waker PATH] [--source DIR] [-n 100000] [--own 40] [--folder DIR]
"""
import argparse
import glob
import json
import os
import subprocess
import tempfile
import time
import zlib

import h5py
import xarray

N_JOURNALS = 8


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    here = os.path.dirname(os.path.dirname(os.path.dirname(
        os.path.abspath(__file__))))
    parser.add_argument("--source", default=here)
    parser.add_argument("--waker", default=os.path.join(here, "build/bin/waker"))
    parser.add_argument("-n", type=int, default=100000)
    parser.add_argument("--own", type=int, default=40,
                        help="realisations that are computed")
    parser.add_argument("--folder", help="of the campaign; default: temporary")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = os.path.join(options.folder or temporary, "campaign")
        subprocess.run(
            [options.waker, "campaign",
             os.path.join(options.source, "parameters/chapter5/analysis1.prm"),
             "--realisations", f"0:{options.own}", "--set", "Grid/Cell size=0.5",
             "--set", "Materials/clay/Initial strength=9",
             "--set", f"Campaign/Realisations={options.n}",
             "--set", f"Output/Directory={folder}"],
            check=True, stdout=subprocess.DEVNULL)

        def sealed(entry, key):
            """A line of a journal, with its checksum."""
            text = json.dumps(entry, separators=(",", ":"))[:-1]
            checksum = zlib.crc32((key + text).encode())
            return f'{text},"crc":"{checksum:08x}"}}\n'

        header, records = None, []
        for path in sorted(glob.glob(os.path.join(folder, "journal-*.jsonl"))):
            with open(path, encoding="utf-8") as lines:
                for line in lines:
                    entry = json.loads(line)
                    entry.pop("crc")
                    if "realisation" in entry:
                        records.append(entry)
                    else:
                        header = entry
        assert header is not None and len(records) == options.own
        for j in range(N_JOURNALS):
            path = os.path.join(folder, f"journal-{100 + j:05d}.jsonl")
            with open(path, "w", encoding="utf-8") as journal:
                journal.write(sealed(header, ""))
                for i in range(options.own + j, options.n, N_JOURNALS):
                    records[i % options.own]["realisation"] = i
                    journal.write(sealed(records[i % options.own],
                                         header["campaign"]))

        size = sum(os.path.getsize(path) for path in
                   glob.glob(os.path.join(folder, "journal-*.jsonl")))
        start = time.perf_counter()
        subprocess.run([options.waker, "merge", folder], check=True,
                       stdout=subprocess.DEVNULL)
        merged = time.perf_counter() - start
        store = os.path.join(folder, "results.h5")
        with h5py.File(store) as file:
            outcomes = file["outcome"][:]
        assert outcomes.shape == (1, options.n) and (outcomes >= 0).all()
        with xarray.open_dataset(store, engine="h5netcdf") as data:
            assert data["residual_width"].size == options.n
        traces = sum(bool(record["trace"]) for record in records)
        print(f"{options.n} records, {100 * traces / len(records):.0f} % of them "
              f"with a trace, {size / 1e6:.0f} MB of journals: merged in "
              f"{merged:.1f} s, {os.path.getsize(store) / 1e6:.1f} MB; h5py and "
              "xarray open it")


if __name__ == "__main__":
    main()
