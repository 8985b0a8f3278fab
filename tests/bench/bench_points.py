#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of a point-step against plain loops, in turns in one run: CPU time of the process, the best of some rounds.

python3 tests/bench/bench_points.py build/release [rounds [words of names of cases]]

Give the machine nothing else to do. The ratio says how many times as fast as the plain loop the program is.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROBUST, THESIS = "mpm.method='robust'", "mpm.method='thesis'"
CASES = [  # name; the plain loop and its words; deck and what is set in it
    ("robust elastic 1e5", ("plain_robust", "elastic", "158", "2"), "disks", (ROBUST,)),
    ("robust elastic 1e5, 9 a cell", ("plain_robust", "elastic", "105", "3"), "disks",
     (ROBUST, "in.nx=169", "in.ny=169", "reg.nprg(1)=9", "reg.nprg(2)=9")),
    ("robust elastic 1e6", ("plain_robust", "elastic", "500", "2"), "disks",
     (ROBUST, "in.nx=799", "in.ny=799", "in.tmax=0.004")),
    ("robust elastic 1e4", ("plain_robust", "elastic", "50", "2"), "disks",
     (ROBUST, "in.nx=81", "in.ny=81", "in.tmax=0.1")),
    ("robust gas 1e5", ("plain_robust", "gas", "158", "2"), "gas_block", (ROBUST,)),
    ("robust gas 1e5, 9 a cell", ("plain_robust", "gas", "105", "3"), "gas_block",
     (ROBUST, "in.nx=107", "in.ny=107", "reg.nprg(1)=9", "reg.nprg(2)=9")),
    ("robust gas 1e6", ("plain_robust", "gas", "500", "2"), "gas_block",
     (ROBUST, "in.nx=501", "in.ny=501", "in.tmax=0.0004")),
    ("robust gas with ledger 1e5", ("plain_robust", "gas", "158", "2"), "gas_block", (ROBUST, "mpm.ledger=.true.")),
    ("thesis elastic 1e5", ("plain_thesis", "elastic", "158", "2"), "disks", (THESIS,)),
    ("thesis elastic 1e6", ("plain_thesis", "elastic", "500", "2"), "disks",
     (THESIS, "in.nx=799", "in.ny=799", "in.tmax=0.004")),
]


def plain(build, words):
    """ns a point-step of a plain loop."""
    out = subprocess.run([build / "tests" / words[0], *words[1:], "0", "1"], capture_output=True, text=True, check=True)
    return float(out.stdout.split()[0])


def program(build, deck, settings, folder):
    """ns a point-step of the program, without its start."""
    sets = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([build / "tether", HERE / f"{deck}.in", *sets, "--out", folder, "--quiet"], check=True,
                   capture_output=True)
    told = dict(re.findall(r"^(\w+) = (\S+)$", (folder / "summary.txt").read_text(), re.M))
    seconds = float(told["cpu_seconds"]) - float(told["setup_cpu_seconds"])
    return seconds / float(told["steps"]) / float(told["points"]) * 1e9


def main():
    build = pathlib.Path(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    words = sys.argv[3:]
    print(f"{'case':30} {'plain':>8} {'tether':>8} {'ratio':>6}   [ns a point-step]")
    with tempfile.TemporaryDirectory() as folder:
        for name, loop, deck, settings in CASES:
            if any(word not in name for word in words):
                continue
            best = [1e300, 1e300]
            for _ in range(rounds):
                best[0] = min(best[0], plain(build, loop))
                best[1] = min(best[1], program(build, deck, settings, pathlib.Path(folder) / "out"))
            print(f"{name:30} {best[0]:8.2f} {best[1]:8.2f} {best[0] / best[1]:6.2f}", flush=True)


if __name__ == "__main__":
    main()
