#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark's own logic, without timing anything: its cases have decks that are right and programs that are built,
the plain loops keep what they must, and its table goes where it belongs."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "bench"), str(ROOT / "tests" / "program")]

import bench_cases
import bench_plot
import bench_points
import bench_report
import bench_rows
import bench_runs
from full_length import FULL

TETHER = pathlib.Path(os.environ.get("TETHER", ROOT / "build" / "release" / "tether")).resolve()
ALL = bench_cases.CASES + bench_cases.GROWTH
LARGE = ("1e6", "1e7")  # parts of names
LOOPS = [("plain_robust", kind) for kind in ("elastic", "gas", "gas-ledger", "elastic-axis", "gas-axis")] + [
    ("plain_thesis", "elastic"), ("plain_thesis", "gas"), ("plain_contact", "elastic"), ("plain_membrane", "gas")]
MACHINE = {"memory": 2e10, "cache": 1e11, "multiplications": 3e10}
GROWTH = {"robust a": (1e4, 60, 15, 200), "robust b": (1e5, 61, 16, 190), "thesis a": (1e4, 40, 10, 180),
          "thesis b": (1e5, 41, 11, 170)}


def run_loop(*words):
    return subprocess.run([TETHER.parent / "tests" / words[0], *words[1:]], capture_output=True, text=True)


class Cases(unittest.TestCase):
    def test_names_are_different(self):
        for cases in (bench_cases.CASES, bench_cases.GROWTH):
            self.assertEqual(len({case.name for case in cases}), len(cases))

    def test_decks_take_the_settings(self):
        with tempfile.TemporaryDirectory() as name:
            rows = pathlib.Path(name, "rows.par")  # the benchmark's are larger
            rows.write_text("1.\n1000.,.3,0.,0.,0.,0.,0.\n3,3,3,0\n1\n1,4\n.5 .5 0. 0. 0. 0. 0.\n")
            for case in ALL:  # by default but the large ones, which set the same values of the same decks
                if not FULL and any(size in case.name for size in LARGE):
                    continue
                sets = [word for setting in (*case.settings, bench_runs.ONE_STEP) for word in ("--set", setting)]
                particles = ["--particles", rows] if case.rows else []
                done = subprocess.run([TETHER, "check", bench_cases.HERE / f"{case.deck}.in", *sets, *particles],
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, f"{case.name}: {done.stderr}")
        for deck in bench_cases.WHOLE:
            self.assertTrue((bench_cases.DECKS / f"{deck.name}.in").is_file(), deck.name)

    def test_loops_are_built_and_known(self):
        listed = (ROOT / "tests" / "CMakeLists.txt").read_text()
        quickstart = (ROOT / "quickstart").read_text()
        for case in ALL:
            if not case.loop:
                self.assertEqual(case.rows, "shuffled", case.name)
                continue
            self.assertIn(case.loop[:2], LOOPS)
            self.assertTrue((bench_cases.HERE / f"{case.loop[0]}.cpp").is_file())
            self.assertIn(case.loop[0], listed)
            self.assertIn(case.loop[0], quickstart)
            self.assertEqual(len(case.plain_words()), 4, case.name)

    def test_words_choose(self):
        names = [case.name for case in bench_cases.chosen(bench_cases.CASES, ["thesis", "1e6"])]
        self.assertEqual(names, ["thesis elastic 1e6"])


class Loops(unittest.TestCase):
    def test_they_keep_mass_momentum_and_with_the_ledger_energy(self):
        for words in LOOPS:
            for jitter in ("0", "0.9"):
                done = run_loop(*words, "30", "2", jitter, "1")
                self.assertEqual(done.returncode, 0, f"{words}: {done.stdout}{done.stderr}")
                self.assertLess(float(re.search(r"drift (\S+)", done.stdout)[1]), 1e-11, words)
        booked = run_loop("plain_robust", "gas-ledger", "30", "2", "0", "1").stdout
        self.assertGreater(float(re.search(r"energy (\S+)", booked)[1]), 1)

    def test_contact_pushes(self):
        lost = float(re.search(r"lost (\S+)", run_loop("plain_contact", "elastic", "40", "2", "0", "1").stdout)[1])
        self.assertGreater(lost, 0)

    def test_they_refuse_what_they_do_not_know(self):
        for words in LOOPS:
            self.assertEqual(run_loop(words[0], "water").returncode, 2)


class Rows(unittest.TestCase):
    def test_the_same_points_in_two_orders(self):
        even, shuffled = bench_rows.rows("even"), bench_rows.rows("shuffled")
        self.assertNotEqual(even, shuffled)
        self.assertEqual(sorted(even), sorted(shuffled))

    def test_irregular_points_stay_in_the_block(self):
        low, high = bench_rows.SIDE * bench_rows.MARGIN, 1 - bench_rows.SIDE * bench_rows.MARGIN
        for x, y, _, _ in bench_rows.rows("irregular"):
            self.assertTrue(low < x < high and low < y < high)

    def test_the_program_reads_them(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            bench_rows.write(folder / "rows.par", "shuffled")
            plan = subprocess.run([TETHER, "check", bench_cases.HERE / "rows.in", "--particles", folder / "rows.par"],
                                  capture_output=True, text=True)
            self.assertEqual(plan.returncode, 0, plan.stdout + plan.stderr)


class Report(unittest.TestCase):
    def test_turns_keep_the_least(self):
        one, other = iter([3, 1, 2]), iter([5, 7, 6])
        self.assertEqual(bench_runs.in_turns(3, lambda: next(one), lambda: next(other)), [1, 5])

    def test_long_runs_are_not_repeated(self):
        self.assertEqual(bench_runs.in_turns(3, iter([2, 1]).__next__, longest=-1), [2])

    def test_tables(self):
        self.assertIn("| a | 60.0 | 15.0 | 4.00 |", bench_report.of_points({"a": (60, 15)}))
        self.assertIn("| a | 15.0 (4.00) | 20.0 (3.00) |",
                      bench_report.of_sets({"a": {"avx2": (60, 15), "one": (60, 20)}}))
        self.assertIn("| a | 7 | 2 | 6 | 3.00 |", bench_report.of_decks({"a": [7, 2, 6]}, True))
        self.assertIn("| a | 7 | 2 |", bench_report.of_decks({"a": [7, 2]}, None))
        self.assertIn("| robust a | 1e+04 | 60.0 | 15.0 | 4.00 | 200 |", bench_report.of_growth(GROWTH))
        self.assertIn("| robust |", bench_report.of_machine(MACHINE, bench_plot.bounds(MACHINE)))

    def test_the_first_step_is_left_out(self):
        steps = bench_runs.Steps(None, bench_cases.CASES[0], "", "")
        steps.count, steps.points = 100, 1000
        self.assertAlmostEqual(steps.cost(3e-3, 1e-3), 20)

    def test_words_stand_before_or_after_options(self):
        for words in (["build", "3", "robust", "--growth"], ["build", "3", "--growth", "robust"]):
            chosen = bench_points.arguments(words)
            self.assertEqual((chosen.rounds, chosen.words, chosen.growth), (3, ["robust"], True))

    def test_the_region_alone_is_replaced(self):
        guide = f"before\n{bench_report.BEGIN}\nold\n{bench_report.END}\nafter\n"
        self.assertEqual(bench_report.with_region(guide, "new\n"),
                         f"before\n{bench_report.BEGIN}\nnew\n{bench_report.END}\nafter\n")
        for wrong in ("", guide + guide, f"{bench_report.END}{bench_report.BEGIN}"):
            self.assertRaises(bench_report.NoRegion, bench_report.with_region, wrong, "new\n")
        bench_report.with_region((ROOT / "post" / "README.md").read_text(), "")

    def test_table_and_figure_are_written_next_to_the_guide(self):
        with tempfile.TemporaryDirectory() as name:
            guide = pathlib.Path(name, "guide.md")
            guide.write_text(f"{bench_report.BEGIN}{bench_report.END}")
            chosen = bench_points.arguments(["build", "--all", "--out", f"{name}/out", "--write", str(guide)])
            bench_points.write(chosen, ["a table"], GROWTH, MACHINE)
            self.assertIn("a table\n\n![", guide.read_text())
            self.assertLess((guide.parent / bench_points.FIGURE).stat().st_size, 200_000)
            self.assertTrue((guide.parent / "out" / "table.md").is_file())

    def test_bounds_are_numbers_over_speeds(self):
        bounds = bench_plot.bounds(MACHINE)["robust"]
        self.assertAlmostEqual(bounds["memory"], 5 * bounds["second cache"])
        self.assertAlmostEqual(bounds["multiplications"], bench_plot.PRODUCTS["robust"] / 30)


if __name__ == "__main__":
    unittest.main()
