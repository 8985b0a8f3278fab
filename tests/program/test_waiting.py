# SPDX-License-Identifier: GPL-3.0-or-later
"""How tests wait: for what is to be seen, and nothing else of them sleeps."""
import pathlib
import re
import subprocess
import sys
import unittest

from waiting import wait_until

TESTS = pathlib.Path(__file__).resolve().parents[1]
SLEEP = re.compile(r"\b(u|nano)?sleep(_for|_until)?\(")
SLEEPERS = {TESTS / "program/waiting.py", TESTS / "unit/waiting.hpp"}


class Waiting(unittest.TestCase):
    def process(self, text):
        process = subprocess.Popen([sys.executable, "-c", text], stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        for end in (process.stderr.close, process.stdin.close, process.wait, process.kill):  # the last one first
            self.addCleanup(end)
        return process

    def test_the_value_that_was_awaited_comes_back(self):
        values = iter((0, [], "this"))
        self.assertEqual(wait_until(lambda: next(values), "a text", self.process("input()")), "this")

    def test_what_does_not_come_is_named(self):
        with self.assertRaisesRegex(AssertionError, "^a third record was not seen within 0.01 seconds$"):
            wait_until(lambda: False, "a third record", self.process("input()"), patience=0.01)

    def test_the_end_of_a_process_is_said_with_its_exit_code_and_what_it_wrote(self):
        process = self.process("import sys; sys.exit('no such file')")
        with self.assertRaisesRegex(AssertionError, rf"(?s)^a record was not seen before process {process.pid} ended with "
                                                    r"exit code 1: .*\nno such file\n$"):
            wait_until(lambda: False, "a record", process)

    def test_what_a_process_did_last_counts(self):
        process = self.process("")
        self.assertEqual(wait_until(lambda: process.returncode is not None, "its end", process), True)

    def test_nothing_else_sleeps(self):
        sources = [path for path in TESTS.rglob("*") if path.suffix in (".py", ".cpp", ".hpp")]
        self.assertLess(SLEEPERS, set(sources))
        self.assertEqual([path for path in sources if SLEEP.search(path.read_text(encoding="utf-8"))
                          and path not in SLEEPERS | {pathlib.Path(__file__).resolve()}], [])


if __name__ == "__main__":
    unittest.main()
