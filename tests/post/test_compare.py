# SPDX-License-Identifier: GPL-3.0-or-later
"""post/compare.py on histories whose differences are known, and on two runs of the program."""
import csv
import os
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path.insert(0, str(POST))

import netCDF4
import numpy

import tether_results
from called import FULL, call

PROGRAM = os.environ["TETHER"]
TIMES = numpy.linspace(0, 1, 11)


def write_run(folder, summary="", times=TIMES, **columns):
    folder.mkdir(parents=True, exist_ok=True)
    with netCDF4.Dataset(folder / "history.nc", "w") as data:
        data.createDimension("time", None)
        for name, values in ({"time": times} | columns).items():
            data.createVariable(name, "f8", ("time",))[:] = values
    (folder / "summary.txt").write_text(summary)
    return folder


class CompareTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def compare(self, *words, code=0, alone=FULL):
        result = call("compare", *words, alone=alone)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        return result

    def rows(self, folder):
        with open(folder / "compare.csv", newline="") as file:
            return {row["column"]: row for row in csv.DictReader(file)}

    def test_largest_and_rms_differences_over_the_range(self):
        one = write_run(self.folder / "one", height=2 * TIMES + 0.5 * (TIMES == 1), alone=TIMES)
        other = write_run(self.folder / "other", height=2 * TIMES, mass=TIMES)
        result = self.compare(one, other, "--out", self.folder / "out", alone=True)
        row = self.rows(self.folder / "out")["height"]
        self.assertEqual(float(row["largest_difference"]), 0.5)
        self.assertAlmostEqual(float(row["rms_difference"]), 0.5 / numpy.sqrt(11))
        self.assertEqual(float(row["range_of_second"]), 2)
        self.assertEqual(list(self.rows(self.folder / "out")), ["height"])
        self.assertRegex(result.stdout, r"height +0\.5 +0\.1508 +25 +7\.54")
        self.assertTrue((self.folder / "out" / "compare.png").is_file())

    def test_times_of_the_one_with_fewer_records(self):
        fine = numpy.linspace(0, 1, 101)
        one = write_run(self.folder / "one", times=fine, height=fine)
        other = write_run(self.folder / "other", height=TIMES)
        for pair in ((one, other), (other, one)):
            self.compare(*pair, "--out", self.folder)
            row = self.rows(self.folder)["height"]
            self.assertEqual(int(row["records"]), 11)
            self.assertLess(float(row["largest_difference"]), 1e-15)

    def test_what_is_constant_but_for_rounding_is_taken_by_its_size(self):
        one = write_run(self.folder / "one", energy=5 + 0 * TIMES + 0.1)
        other = write_run(self.folder / "other", energy=5 + 1e-15 * TIMES)
        self.compare(one, other)
        self.assertAlmostEqual(float(self.rows(one)["energy"]["range_of_second"]), 5)

    def test_summary_keys_that_differ_without_what_the_run_cost(self):
        one = write_run(self.folder / "one", "steps = 4\nmode = a\nwall_seconds = 1\nsame = 1\nonly = 2\n", a=TIMES)
        other = write_run(self.folder / "other", "steps = 5\nmode = b\nwall_seconds = 2\nsame = 1\n", a=TIMES)
        text = self.compare(one, other).stdout
        self.assertRegex(text, r"steps +4\.0 +5\.0\nmode +a +b\nonly +2\.0 +-\n")
        self.assertNotIn("wall_seconds", text)
        self.assertNotIn("same", text)

    def test_a_published_curve(self):
        one = write_run(self.folder / "one", height=2 * TIMES)
        curve = self.folder / "curve.txt"
        curve.write_text("# time height\n0 0\n0.5 1.1\n2 9\n")
        self.compare(one, curve)
        row = self.rows(one)["height"]
        self.assertAlmostEqual(float(row["largest_difference"]), 0.1)
        self.assertEqual(int(row["records"]), 2)

    def test_two_runs_of_the_program_and_one_with_itself(self):
        runs = [tether_results.run(ROOT / "decks" / "sod.in", {"in.tmax": 0.02, "mpm.method": method}, out=self.folder / method,
                                   program=PROGRAM).folder for method in ("thesis", "robust")]
        text = self.compare(*runs, "--column", "body_vx_1").stdout
        self.assertEqual(list(self.rows(runs[0])), ["body_vx_1"])
        self.assertGreater(float(self.rows(runs[0])["body_vx_1"]["largest_difference"]), 0)
        self.assertIn("error_density", text)
        self.compare(runs[0], runs[0])
        self.assertTrue(all(float(row["largest_difference"]) == 0 for row in self.rows(runs[0]).values()))

    def test_columns_of_nothing_but_nan_are_left_out(self):
        one = write_run(self.folder / "one", a=TIMES, b=numpy.nan * TIMES)
        self.compare(one, one)
        self.assertEqual(list(self.rows(one)), ["a"])

    def test_refuses_what_cannot_be_compared(self):
        one, other = write_run(self.folder / "one", a=TIMES), write_run(self.folder / "other", b=TIMES)
        later = write_run(self.folder / "later", times=TIMES + 5, a=TIMES)
        bad = self.folder / "bad.txt"
        bad.write_text("a b\n1 two\n")
        for words, needle in (((one, other), "both have none"), ((one, later), "nothing in common"), ((one, bad), "no table"),
                              ((one, self.folder / "nowhere"), "neither a run's folder nor a file"),
                              ((self.folder, one), "no history.nc"), ((one, one, "--column", "z"), "no column z in both")):
            self.assertIn(needle, self.compare(*words, code=2).stderr)

    def test_reports_that_it_cannot_write(self):
        one = write_run(self.folder / "one", a=TIMES)
        (self.folder / "taken").write_text("")
        self.assertIn("taken", self.compare(one, one, "--out", self.folder / "taken", code=4).stderr)


if __name__ == "__main__":
    unittest.main()
