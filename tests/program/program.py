# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program that the environment variable TETHER names, and reads what it wrote."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

import netCDF4
import numpy

from waiting import PATIENCE

ROOT = pathlib.Path(__file__).resolve().parents[2]
DECKS = ROOT / "decks"
TETHER = str(pathlib.Path(os.environ["TETHER"]).resolve())
HANGS = "hangs"  # the exit code of a call that does not end within PATIENCE

# Head of a diagnostic; file, line and column may be missing.
HEAD = re.compile(r"(?:(?P<file>[^\s:][^:\n]*):(?:(?P<line>\d+):)?(?:(?P<column>\d+):)? )?"
                  r"(?P<severity>error|warning|remark): (?P<text>.*)")


def run(*arguments, folder=ROOT, before=None):
    """One call of the program in `folder`; `before` is done in the child before the program starts."""
    command = [TETHER, *map(str, arguments)]
    try:
        return subprocess.run(command, cwd=folder, capture_output=True, timeout=PATIENCE, stdin=subprocess.DEVNULL,
                              preexec_fn=before, encoding="utf-8", errors="surrogateescape")
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, HANGS, "", "")


def sets(**values):
    """--set options from group__name=value, as in sets(in__tmax=0.1)."""
    return [word for name, value in values.items() for word in ("--set", f"{name.replace('__', '.')}={value}")]


def summary(folder):
    """summary.txt as texts by key."""
    lines = (folder / "summary.txt").read_text().splitlines()
    return dict(line.split(" = ", 1) for line in lines if not line.startswith("#"))


def history(folder, killed=False):
    """history.txt as columns by name; of a killed run without the last line, where the kill left a part of it."""
    lines = (folder / "history.txt").read_text().splitlines(keepends=True)
    if killed and not lines[-1].endswith("\n"):
        del lines[-1]
    lines = [line.removesuffix("\n") for line in lines]
    names = lines[0].removeprefix("# ").split(" ")
    rows = numpy.array([[float(word) for word in line.split(" ")] for line in lines[1:]])
    return dict(zip(names, rows.T, strict=True))


def records(folder):
    """The number of whole records in history.txt, below its line of names; 0 before there is one."""
    try:
        return max(0, (folder / "history.txt").read_bytes().count(b"\n") - 1)
    except FileNotFoundError:
        return 0


def netcdf(path):
    """All variables of a NetCDF file, unmasked."""
    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        return {name: variable[:] for name, variable in file.variables.items()}


def diagnostics(stderr):
    """[(match of HEAD, lines that follow it)] of the program's messages."""
    found = []
    for line in stderr.splitlines():
        head = HEAD.fullmatch(line)
        if head:
            found.append((head, []))
        elif found:
            found[-1][1].append(line)
    return found


def without_cost(plan):
    """The lines of a plan but for what was measured."""
    return [line for line in plan.splitlines() if not line.startswith("cost: ")]


class ProgramTest(unittest.TestCase):
    """A test with a temporary folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    @classmethod
    def shared_by(cls, tests):
        """One of this kind for what the tests of a class share: its folder stays until the last of them has ended."""
        case = cls()
        case.setUp()
        tests.addClassCleanup(case.doCleanups)
        return case

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def start(self, *words, folder=None):
        """A call of the program that the test goes on beside; it does not outlive the test."""
        process = subprocess.Popen([TETHER, *map(str, words)], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        for end in (process.stdout.close, process.stderr.close, process.wait, process.kill):  # the last one first
            self.addCleanup(end)
        return process

    def stop(self, process, number=signal.SIGTERM):
        """Ends a process by a signal; its exit code must say so. Returns its standard output and error."""
        process.send_signal(number)
        stdout, stderr = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, -number if number == signal.SIGKILL else 128 + number, stderr)
        return stdout, stderr

    def run_ok(self, deck, *options, out="out"):
        """A run that must end well and, with --quiet, say nothing; returns its folder."""
        folder = self.folder / out
        result = run(deck, "--quiet", "--out", folder, *options)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""), deck)
        return folder

    def expect(self, code, *arguments, **how):
        """A call that must end with this exit code; returns the call's result."""
        result = run(*arguments, **how)
        self.assertEqual(result.returncode, code, f"{arguments}\n{result.stderr}")
        return result

    def assert_said_at(self, stderr, message, line):
        """Some message, or the lines that go with it, has these words, and stands at this line of its deck."""
        found = diagnostics(stderr)
        heads = [head for head, more in found if message in "\n".join([head["text"], *more])]
        self.assertTrue(heads, found)
        self.assertEqual(int(heads[0]["line"]), line)

    def assert_refused(self, cases, call, out):
        """Each (text, words of the message, its line) is refused by call(text), and nothing is written to `out`."""
        for text, message, line in cases:
            with self.subTest(message=message):
                self.assert_said_at(call(text).stderr, message, line)
                self.assertFalse(out.exists())
