# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of splitting: what holds, what fails, and the lines between."""
import math
import os
import sys
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "post"))

import matplotlib

matplotlib.use("Agg")

from thesis_figures import splitting
from thesis_figures.runs import Runs
from small_runs import DeckTest

PROGRAM = Path(os.environ["TETHER"])


class Splitting(DeckTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.runs = Runs(PROGRAM, ROOT / "decks", cls.folder / "runs")

    def test_a_limit_is_where_the_value_is_one(self):
        self.assertAlmostEqual(splitting.limit((1, 100, 1000), [180, 1.8, 0.18]), 180)
        self.assertTrue(math.isnan(splitting.limit((1, 10), [180, 18])))
        self.assertTrue(math.isnan(splitting.limit((1, 10), [0.5, 0.05])))

    def test_the_map_tells_what_holds(self):
        with mock.patch.multiple(splitting, RATIOS=(1, 1000), LENGTHS=(1 / 30,), MATERIALS=((1e6, 0.0),), STEPS=12):
            figure = splitting.splitting_map(self.runs)
        lines = {line.get_label(): [list(values) for values in line.get_data()] for line in figure.axes[0].get_lines()}
        self.assertEqual(lines["splitting holds"][1], [1000])
        self.assertEqual(lines["splitting fails"][1], [1])
        self.assertEqual(lines["symmetric holds"][1], [1, 1000])
        self.assertEqual(lines["symmetric fails"][1], [])
        self.assertAlmostEqual(lines["limit by theory"][1][0], 180, delta=1)
        self.assertTrue(90 < lines["estimate of the plan"][1][0] < 200)


if __name__ == "__main__":
    unittest.main()
