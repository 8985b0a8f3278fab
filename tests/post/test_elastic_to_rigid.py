# SPDX-License-Identifier: GPL-3.0-or-later
"""post/elastic_to_rigid.py: distances fall like 1/E to the same steps' rigid body, not to the exact one; exit codes."""
import os
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "post"))

import elastic_to_rigid
from called import call
from matplotlib import pyplot
from thesis_figures.runs import Runs

PROGRAM = Path(os.environ["TETHER"])


class ElasticToRigid(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        runs = Runs(PROGRAM, ROOT / "decks", cls.folder / "runs")
        cls.moduli = (1e4, 1e6)
        cls.transitions = [elastic_to_rigid.Transition(runs, step, cls.moduli) for step in (0.08, 0.04)]

    def test_the_distance_falls_like_one_over_the_modulus(self):
        for of in self.transitions:
            self.assertAlmostEqual(of.same[0] / of.same[1], 100, delta=5)

    def test_the_error_of_the_steps_stays_and_is_of_second_order(self):
        long, short = (of.fine[-1] for of in self.transitions)
        self.assertAlmostEqual(long / short, 4, delta=0.6)
        self.assertGreater(short, 15 * self.transitions[1].same[-1])

    def test_the_chart_shows_them(self):
        figure = elastic_to_rigid.chart(self.transitions)
        self.addCleanup(pyplot.close, figure)
        distances, seconds, iterations = figure.axes
        self.assertEqual([list(line.get_ydata()) for line in distances.lines],
                         [numbers for of in self.transitions for numbers in (of.same, of.fine)])
        self.assertEqual(len(iterations.lines), 4)
        elastic, rigid = seconds.lines[::2], seconds.lines[1::2]
        self.assertEqual([list(line.get_ydata()) for line in elastic],
                         [of.of_summaries("cpu_seconds") for of in self.transitions])
        self.assertEqual([line.get_ydata()[0] for line in rigid],
                         [of.rigid.summary["cpu_seconds"] for of in self.transitions])

    def test_the_table_has_a_line_a_modulus(self):
        head, names, first, second = self.transitions[0].table()
        self.assertIn("unknowns 243, rigid 6", head)
        row = dict(zip(names.split(), map(float, second.split())))
        self.assertEqual(row["modulus"], 1e6)
        self.assertAlmostEqual(row["slope"], -1, delta=0.02)
        self.assertEqual(float(first.split()[2]), 0)

    def check_refused(self, code, needle, *words):
        result = call("elastic_to_rigid", "--out", self.folder / "out", *words)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn(needle, result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_refusals(self):
        self.check_refused(2, "none: is not there", "--program", self.folder / "none")
        self.check_refused(3, "failed with exit code 1", "--program", "/bin/false")


if __name__ == "__main__":
    unittest.main()
