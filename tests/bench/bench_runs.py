# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of plain loops and of the program, and what they cost: CPU seconds of the process, memory."""
import os
import pathlib
import re
import subprocess
import tempfile
import time

import bench_rows
from bench_cases import DECKS, HERE

ONE_STEP = "in.tmax=1.e-9"
LONGEST = 60.0  # seconds of rounds after which a case of long runs begins no other


class Failed(Exception):
    """A run ended with another code than 0."""


def in_turns(rounds, *runs, longest=float("inf")):
    """The least of what each run gives, over rounds of one of each after the other."""
    best = [float("inf")] * len(runs)
    begin = time.monotonic()
    for _ in range(rounds):
        best = [min(least, run()) for least, run in zip(best, runs)]
        if time.monotonic() - begin > longest:
            break
    return best


def output_of(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, command))} ended with {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


class Bench:
    """A build, and a folder for what its runs write."""

    def __init__(self, build, folder):
        self.build, self.folder = pathlib.Path(build), pathlib.Path(folder)
        self.tether = self.build / "tether"

    def plain(self, case):
        """ns a point-step of the case's plain loop, one round."""
        words = [self.build / "tests" / case.loop[0], *case.plain_words(), "1"]
        return float(output_of(words).split()[0])

    def rows(self, kind):
        """A particle file, written when it is first asked for."""
        path = self.folder / f"{kind}.par"
        if not path.exists():
            bench_rows.write(path, kind)
        return path

    def summary(self, case, settings, rows, target, before=()):
        """Numbers of summary.txt after a run; `before` are words in front of the command."""
        sets = [word for setting in settings for word in ("--set", setting)]
        particles = ["--particles", self.rows(rows)] if rows else []
        output_of([*before, self.tether, HERE / f"{case.deck}.in", *sets, *particles, "--out", self.folder / "out",
                   "--quiet"], env={**os.environ, "TETHER_TARGET": target})
        return self.numbers("out")

    def numbers(self, out):
        """The numbers of summary.txt in a folder of the scratch."""
        text = (self.folder / out / "summary.txt").read_text()
        return {key: float(value) for key, value in re.findall(r"^(\w+) = ([-+.\de]+)$", text, re.M)}

    def compared(self, case, rounds, target="", longest=float("inf")):
        """ns a point-step of the plain loop and of the program; of rows in random order, rows in order take the loop's
        place."""
        steps = Steps(self, case, case.rows, target)
        if case.loop:
            plain, *ours = in_turns(rounds, lambda: self.plain(case), steps.whole, steps.first, longest=longest)
            return plain, steps.cost(*ours)
        even = Steps(self, case, "even", target)
        best = in_turns(rounds, even.whole, even.first, steps.whole, steps.first, longest=longest)
        return even.cost(*best[:2]), steps.cost(*best[2:])

    def has_set(self, target):
        """Whether the processor has these instructions."""
        deck = subprocess.run([self.tether, HERE / "disks.in", "--set", "in.tmax=1.e-9", "--set", "in.nx=21", "--set",
                               "in.ny=21", "--out", self.folder / "out", "--quiet"], capture_output=True,
                              env={**os.environ, "TETHER_TARGET": target})
        return deck.returncode == 0

    def points_and_memory(self, case):
        """How many points a run has, and the most memory that its process held [bytes]. A process counts what its parent
        held when it began: a shell is small, and this script is not."""
        ended = self.summary(case, case.settings, case.rows, "", before=("sh", "-c", '"$@"; exit $?', "sh"))
        return int(ended["points"]), 1.024e6 * ended["peak_memory_mb"]  # of Linux' kilobytes, 1024 bytes each

    def whole_deck(self, deck, tether):
        """CPU seconds of a run of a deck, with its start and outputs."""
        sets = [word for setting in deck.settings for word in ("--set", setting)]
        out = self.folder / ("whole" if tether == self.tether else "other")
        process = subprocess.Popen([tether, DECKS / f"{deck.name}.in", *sets, "--out", out, "--quiet"],
                                   stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise Failed(f"{deck.name} ended with status {status}")
        return usage.ru_utime + usage.ru_stime

    def start(self):
        """ms before the first step of the whole deck that this build ran last."""
        return 1e3 * self.numbers("whole")["setup_cpu_seconds"]

    def machine(self):
        """What roofline.cpp measures: bytes and multiplications a second, by their names."""
        out = output_of([self.build / "tests" / "roofline"])
        return {name: float(value) for name, value in (line.split()[:2] for line in out.splitlines())}


class Steps:
    """Steps of a case but the first: with a run's only step goes what is done once, start, outputs, first use of
    memory."""

    def __init__(self, bench, case, rows, target):
        self.bench, self.case, self.rows, self.target = bench, case, rows, target
        self.count = self.points = 0

    def run(self, *settings):
        """CPU seconds after the start, steps, points."""
        ended = self.bench.summary(self.case, (*self.case.settings, *settings), self.rows, self.target)
        return ended["cpu_seconds"] - ended["setup_cpu_seconds"], ended["steps"], ended["points"]

    def whole(self):
        seconds, steps, self.points = self.run()
        self.count = steps - 1
        return seconds

    def first(self):
        seconds, steps, _ = self.run(ONE_STEP)
        if steps != 1:
            raise Failed(f"{self.case.name}: {ONE_STEP} makes {steps:g} steps")
        return seconds

    def cost(self, whole, first):
        """ns a point-step."""
        return (whole - first) / self.count / self.points * 1e9


def scratch():
    return tempfile.TemporaryDirectory(prefix="bench-")
