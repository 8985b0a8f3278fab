# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases by which `--auto` is judged: their answers are those of their formulas, and their decks are read."""
import math
import subprocess
import sys
import unittest

from program import ROOT, run

FOLDER = ROOT / "tests/auto"
sys.path.insert(0, str(FOLDER))
import write_cases  # noqa: E402


def table():
    """Each case's (name, deck, quantity, exact answer, assignments)."""
    lines = (FOLDER / "cases.txt").read_text(encoding="utf-8").splitlines()
    return [tuple(line.split(" | ")[:4]) + (line.split(" | ")[4:],) for line in lines if not line.startswith("#")]


class AutoCases(unittest.TestCase):
    def test_answers_are_those_of_formulas(self):
        write_cases.make()
        self.assertEqual(len(write_cases.CASES), 60)
        self.assertEqual(len({case[0] for case in write_cases.CASES}), 60)
        for (name, deck, quantity, exact, sets), row in zip(write_cases.CASES, table(), strict=True):
            self.assertEqual((name, deck, quantity, list(sets)), (row[0], row[1], row[2], row[4]))
            self.assertTrue(math.isclose(exact, float(row[3]), rel_tol=1e-10), name)

    def test_decks_are_read(self):
        for name, deck, _, _, sets in table():
            done = run("check", deck, *[word for value in sets for word in ("--set", value)])
            self.assertEqual(done.returncode, 0, name + done.stderr)


if __name__ == "__main__":
    unittest.main()
