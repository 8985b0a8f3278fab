#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a sweep of 1,000 short runs costs beyond the runs, against as many calls of the program: wall and CPU seconds.

python3 tests/bench/bench_sweep.py build/release/tether [number of runs]
"""
import csv
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

DECK = pathlib.Path(__file__).resolve().parents[2] / "decks" / "spring-mass.in"
JOBS = "2"
TMAX = "in.tmax=0.01"  # of .101: 5,600 steps of ten points

STUDY = """A mass on a spring under {count} gravities.
$study
decks='decks/spring-mass.in'
axis='in.gravc={values}'
set='{tmax}'
quantities='steps'
$
"""


def cost(command, **how):
    """Wall and CPU seconds (of all its processes) of a command."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, **how)
    after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic() - start
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write_study(folder, values):
    (folder / "decks").symlink_to(DECK.parent)
    (folder / "particles").symlink_to(DECK.parents[1] / "particles")
    text = STUDY.format(count=len(values), values=",".join(values), tmax=TMAX)
    (folder / "study.in").write_text(text)


def main():
    tether = str(pathlib.Path(sys.argv[1]).resolve())
    values = [f"{-250 - 0.1 * k:.1f}" for k in range(int(sys.argv[2]) if len(sys.argv) > 2 else 1000)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_study(folder, values)
        wall, cpu = cost([tether, "sweep", "study.in", "--jobs", JOBS, "--quiet", "--out", "out"], cwd=folder)
        with open(folder / "out" / "table.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        run_wall, run_cpu = (sum(float(row[key]) for row in rows) for key in ("wall_seconds", "cpu_seconds"))
        call = [tether, DECK, "--quiet", "--set", TMAX]
        calls = ["xargs", "-P", JOBS, "-I{}", *call, "--set", "in.gravc={}", "--out", "single/{}"]
        call_wall, call_cpu = cost(calls, cwd=folder, input="\n".join(values), text=True)
    print(f"{len(rows)} runs, {JOBS} side by side")
    print(f"sweep              {wall:8.2f} s wall {cpu:8.2f} s CPU")
    print(f"its runs           {run_wall / int(JOBS):8.2f} s wall {run_cpu:8.2f} s CPU (wall over {JOBS})")
    print(f"beyond them        {100 * (wall * int(JOBS) / run_wall - 1):8.1f} %      {100 * (cpu / run_cpu - 1):8.1f} %")
    print(f"as single calls    {call_wall:8.2f} s wall {call_cpu:8.2f} s CPU")


if __name__ == "__main__":
    main()
