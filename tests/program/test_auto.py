# SPDX-License-Identifier: GPL-3.0-or-later
"""`tether DECK --auto TOL`: what it finds, what it says, and what it refuses before the first run."""
import csv
import math
import pathlib
import re
import tempfile
import unittest

import numpy

from program import ROOT, run

RING = ROOT / "tests/auto/decks/ring.in"
SWING = ROOT / "tests/auto/decks/swing.in"
GROWTH = "last(point_x_1) - first(point_x_1)"
EXACT = 1.9066666666e-06  # of the ring, by Lame


def auto(deck, tolerance, out, *sets, quantity=None, before=()):
    values = list(sets) + ([f"auto.quantity='{quantity}'"] if quantity else [])
    return run(*before, deck, "--auto", tolerance, "--out", out, *[word for value in values for word in ("--set", value)])


def rows(out):
    with open(pathlib.Path(out) / "auto.csv", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def chosen(out):
    text = (pathlib.Path(out) / "auto.txt").read_text(encoding="utf-8")
    return rows(out)[int(re.search(r"chosen: run (\d+)", text)[1]) - 1]


class Auto(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.out = pathlib.Path(self.folder.name) / "out"

    def test_keeps_its_promise(self):
        costs = []
        for tolerance in (0.03, 0.003):
            done = auto(RING, tolerance, self.out, quantity=GROWTH)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertLessEqual(abs(float(chosen(self.out)["value"]) / EXACT - 1), tolerance)
            self.assertLessEqual(float(chosen(self.out)["bound"]), tolerance)
            costs.append(float(chosen(self.out)["space"]))
            order = re.search(r"order in space (\S+) \(theory 2\)", done.stdout)
            self.assertTrue(1.6 <= float(order[1]) <= 2.2, done.stdout)
        self.assertLess(costs[0], costs[1])

    def test_chosen_deck_is_the_run_in_the_folder(self):
        self.assertEqual(auto(RING, 0.01, self.out, quantity=GROWTH).returncode, 0)
        again = pathlib.Path(self.folder.name) / "again"
        done = run(self.out / "chosen.in", "--out", again)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "history.txt").read_bytes(), (self.out / "history.txt").read_bytes())

    def test_finished_runs_are_not_made_again(self):
        self.assertEqual(auto(SWING, 0.01, self.out, quantity="last(point_y_1)").returncode, 0)
        records = {path: path.stat().st_mtime_ns for path in self.out.glob("trials/*/runs/*/*/run.txt")}
        first = (self.out / "auto.csv").read_bytes()
        self.assertGreater(len(records), 3)
        self.assertEqual(auto(SWING, 0.01, self.out, quantity="last(point_y_1)").returncode, 0)
        self.assertEqual({path: path.stat().st_mtime_ns for path in self.out.glob("trials/*/runs/*/*/run.txt")}, records)
        self.assertEqual((self.out / "auto.csv").read_bytes(), first)

    def test_steps_alone_are_refined_where_there_are_no_cells(self):
        done = auto(SWING, 0.01, self.out, quantity="last(point_y_1)")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(all(float(row["space"]) == 1 for row in rows(self.out)))
        self.assertLessEqual(abs(float(chosen(self.out)["value"]) / 0.485649417622 - 1), 0.01)

    def test_cannot_promise_within_a_budget(self):
        done = auto("decks/paths/bar.in", 1e-6, self.out, "auto.budget=1.", "in.tmax=.1")
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("cannot promise", done.stderr)
        self.assertIn("of the budget", done.stderr)
        self.assertFalse((self.out / "chosen.in").exists())

    def test_own_figure_of_merit(self):
        done = auto(RING, 0.01, self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("max(point_x_1) - min(point_x_1)", done.stdout)

    def test_a_number_that_is_zero_has_no_relative_tolerance(self):
        done = auto(RING, 0.01, self.out, quantity="last(energy_kinetic)")
        self.assertEqual(done.returncode, 5, done.stdout + done.stderr)
        self.assertIn("is 0 in every run", done.stderr)

    def test_says_why_a_number_is_not_shown(self):
        for quantity, words in (("nodes_max(nofield,1,last)", "do not write what the number is read off"),
                                ("period(point_x_1,77)", "not even the deck's own one"),
                                ("scene(piston_period)", "not even the deck's own one")):
            done = auto(RING, 0.01, self.out, quantity=quantity)
            self.assertEqual(done.returncode, 5, quantity + done.stderr)
            self.assertIn(words, done.stderr)
            self.assertFalse((self.out / "chosen.in").exists())
        self.assertIn("mesh.nc: ", auto(RING, 0.01, self.out, quantity="nodes_max(nofield,1,last)").stdout)

    def test_a_number_that_depends_on_no_cells(self):
        done = auto(RING, 0.01, self.out, quantity="2*deck(in.xright)")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("neither cells nor steps change it", done.stdout)

    def test_the_model_stays_whole_where_that_is_asked_for(self):
        done = auto(RING, 0.01, self.out, "auto.simplify=.false.", quantity=GROWTH)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({row["of"] for row in rows(self.out)}, {"level"})

    def test_is_not_fooled_by_coarse_levels_that_agree(self):
        """A quantity u + a e + b e^2 of the ring's way and energy, made so that its three coarsest levels agree."""
        levels = []
        for cells in ("1,1", "1,2", "2,4"):
            out = pathlib.Path(self.folder.name) / cells
            self.assertEqual(run(RING, "--out", out, "--set", f"mesh.cells(1:2,1)={cells}").returncode, 0)
            names, *_, last = (out / "history.txt").read_text(encoding="utf-8").splitlines()
            values = dict(zip(names.split()[1:], map(float, last.split())))
            levels.append((values["point_x_1"] - 1, values["energy_strain"]))
        rows_of_system = [[e - levels[0][1], e * e - levels[0][1]**2] for _, e in levels[1:]]
        a, b = numpy.linalg.solve(rows_of_system, [levels[0][0] - u for u, _ in levels[1:]])
        energy = 0.5e-3 * EXACT * math.pi / 2  # half of pressure times way times the quarter's inner side
        exact = EXACT + a * energy + b * energy**2
        e = "last(energy_strain)"
        done = auto(RING, 0.001, self.out, quantity=f"{GROWTH} + {a:.15g}*{e} + {b:.15g}*{e}*{e}".replace("+ -", "- "))
        self.assertIn(done.returncode, (0, 5), done.stderr)
        if done.returncode == 0:
            self.assertLessEqual(abs(float(chosen(self.out)["value"]) / exact - 1), 0.001, done.stdout)

    def test_plan_of_what_was_chosen(self):
        done = run("plan", "--auto", 0.03, RING, "--out", self.out, "--set", f"auto.quantity='{GROWTH}'")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("chosen: run", done.stdout)
        self.assertIn("left out:", done.stdout)

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists())

    def test_bad_input_is_refused_before_the_first_run(self):
        for tolerance in ("0", "-0.01", "1", "nan"):
            self.refused(auto(RING, tolerance, self.out), "above 0 and below 1")
        self.refused(auto(RING, "", self.out), "--auto")
        self.refused(auto(RING, 0.01, self.out, quantity="scene(nope)"), "no scene has a number nope")
        self.refused(auto(RING, 0.01, self.out, quantity="last(point_q_1)"), "point_q_1", "auto.quantity")
        self.refused(auto(RING, 0.01, self.out, "auto.quantity=''"), "no figure of merit")
        self.refused(auto(RING, 0.01, self.out, before=("--restart", "checkpoint-1.nc")), "--restart", "--auto")
        self.refused(auto("decks/pendulum-40.in", 0.01, self.out), "points of a file")
        self.refused(auto("decks/plate-hole.in", 0.01, self.out), "mesh of a file")
        self.refused(auto("decks/coupled-piston.in", 0.01, self.out, "auto.budget=.01"), "is too small", "take about")


if __name__ == "__main__":
    unittest.main()
