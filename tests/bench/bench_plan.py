#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near `tether plan` comes to what runs cost: memory within 1.3, CPU seconds within 1.5 of the median of three runs.

python3 tests/bench/bench_plan.py build/release/tether [words of names of decks]

Run it on an idle core. The exit code is 1 where a ratio is outside of its bounds.
"""
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

DECKS = pathlib.Path(__file__).resolve().parents[2] / "decks"
RUNS, MEMORY, SECONDS = 3, 1.3, 1.5
CASES = [  # deck, and options
    ("sod",), ("sod-continuity",), ("pendulum-40",), ("pendulum-320", "--set", "in.tmax=0.3"), ("string-mass",),
    ("two-bar",), ("gas-expansion",), ("membrane-expansion-2", "--set", "mpm.method='robust'"), ("ball-net",),
    ("cyl-200", "--set", "in.tmax=0.02"), ("pendulum-40", "--path", "fem"), ("l-block",), ("cantilever",), ("plate-hole",),
    ("rigid-top",), ("cylinder",), ("cavity",), ("two-flaps", "--set", "in.tmax=0.3"), ("disk", "--set", "in.tmax=2."),
    ("coupled-bar",), ("coupled-sheets",), ("coupled-balloon",), ("coupled-piston",),
    ("coupled-bar-3d", "--set", "in.tmax=1.5"),
]
COST = re.compile(r"cost: .* ([0-9.e+]+) MB, about ([0-9.e+-]+) CPU s on one core \((.*)\)")


def planned(tether, deck, options):
    text = subprocess.run([tether, "plan", deck, *options], check=True, capture_output=True, text=True).stdout
    memory, seconds, how = COST.search(text).groups()
    return float(memory), float(seconds), how


def taken(tether, deck, options, folder):
    """Peak of memory [MB] and CPU seconds of the whole process."""
    process = subprocess.Popen([tether, deck, *options, "--quiet", "--out", folder])
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{deck} ended with status {status}")
    return 1e-3 * usage.ru_maxrss, usage.ru_utime + usage.ru_stime


def within(ratio, bound):
    return 1 / bound <= ratio <= bound


def main():
    tether, words = sys.argv[1], sys.argv[2:]
    missed = 0
    print(f"{'deck':42} {'MB':>7} {'plan':>7} {'ratio':>6} {'CPU s':>8} {'plan':>8} {'ratio':>6}")
    for name, *options in CASES:
        if words and not any(word in name for word in words):
            continue
        deck = str(DECKS / f"{name}.in")
        memory, seconds, how = planned(tether, deck, options)
        with tempfile.TemporaryDirectory() as folder:
            runs = [taken(tether, deck, options, folder) for _ in range(RUNS)]
        real_memory, real_seconds = (statistics.median(column) for column in zip(*runs))
        ratios = memory / real_memory, seconds / real_seconds
        good = within(ratios[0], MEMORY) and within(ratios[1], SECONDS)
        missed += not good
        print(f"{' '.join([name, *options]):42} {real_memory:7.1f} {memory:7.1f} {ratios[0]:6.2f} {real_seconds:8.3f} "
              f"{seconds:8.3f} {ratios[1]:6.2f}{'' if good else '  missed'}  {how}", flush=True)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
