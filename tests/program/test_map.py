# SPDX-License-Identifier: GPL-3.0-or-later
"""tether map: where over deck values a criterion holds, runs along the border alone, and the map decks that it refuses."""
import shutil
import signal
import unittest

from full_length import FULL
from program import DECKS, netcdf
from sweeps import SweepTest, rows_of
from waiting import wait_until

GROWTH = """mode='map', decks='../decks/stability-centre.in', criterion='energy_growth', at_most=100.
set='limits.energy_step=0.,0.', 'limits.energy_growth=0.,0.', 'in.tstep=1.0', 'in.dtmax=1.0', 'in.tiout(33)=1.d-4', 'in.tiout(34)=1.d-4'
"""
LEFT = [k / 20 for k in range(0, 10, 1 if FULL else 2)]
PLACES = (f"axis(1)='in.xleft={','.join(map(str, LEFT))}'\n"
          f"axis(2)='in.xright={','.join(str(5 + left) for left in LEFT)}', linked(2)=1\n")
STEPS = "axis(3)='mpm.cfl=.8,1.,1.2,1.4,1.6,1.8,2.,2.2,2.4,2.6'\n"
THEORY = """theory='1/sqrt(max(.3455*(1 - .3455*(1 - 4*deck(in.xleft)^2)), max(.6545*(1 - .6545*(1 - 4*deck(in.xleft)^2)),
 .9045*(1 - .9045*(1 - 4*deck(in.xleft)^2)))))'
""".replace(",\n ", ", ")


def limit(xleft):
    """Longest step by theory of points at part 0.5 - xleft of their cells."""
    parts = [.3455, .6545, .9045]
    return max(s * (1 - s * (1 - 4 * xleft**2)) for s in parts) ** -.5


class MapTest(SweepTest):
    def map(self, text, *options, code=0, out=None):
        return self.expect(code, "map", self.study(text), "--out", out or self.out, *options)


class Borders(MapTest):
    """A map of which the runs along the border alone are made."""

    STUDY = GROWTH + PLACES + STEPS

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        case = MapTest.shared_by(cls)
        cls.report = case.map(cls.STUDY, "--jobs", "4").stdout
        cls.whole = case.out

    def test_the_border_is_that_of_all_runs(self):
        few = rows_of(self.whole / "map.csv")
        self.map(self.STUDY + "coarse=1\n", "--quiet")
        full = self.table("map")
        squares = 10 * len(LEFT)
        self.assertEqual(len(few), squares)
        self.assertEqual([row["holds"] for row in few], [row["holds"] for row in full])
        self.assertTrue(all(row["own_run"] == "1" for row in full))
        runs = len(rows_of(self.whole / "table.csv"))
        self.assertEqual(sum(row["own_run"] == "1" for row in few), runs)
        self.assertLess(runs, 0.6 * squares)
        self.assertIn(f"\n{runs} runs of {squares} ({100 * runs // squares} %)", self.report)
        self.assertEqual(self.report, (self.whole / "map.txt").read_text())

    def test_each_square_names_the_run_that_decided_it(self):
        runs = rows_of(self.whole / "table.csv")
        for row in rows_of(self.whole / "map.csv"):
            by = runs[int(row["decided_by"]) - 1]
            self.assertEqual(by["verdict"], row["verdict"])
            self.assertEqual(row["holds"] == "1", row["verdict"] == "holds")
            if row["own_run"] == "1":
                self.assertEqual((by["in.xleft"], by["mpm.cfl"]), (row["in.xleft"], row["mpm.cfl"]))
        self.assertTrue({"holds", "grows"} < {row["verdict"] for row in runs})

    def test_it_goes_on_where_it_was_stopped(self):
        process = self.start("map", self.study(self.STUDY), "--out", self.out, "--jobs", "1")
        wait_until(lambda: len(list(self.out.glob("runs/*/*/run.txt"))) >= 3, "the third run's record", process)
        self.stop(process, signal.SIGINT)
        self.assertTrue((self.out / "map.txt").read_text().startswith("NOT FINISHED"))
        stopped = self.table("map")
        self.assertTrue(all(row["own_run"] == "1" for row in stopped if row["verdict"] != "tells nothing"))
        self.assertEqual(sum(row["own_run"] == "1" for row in stopped), len(self.table()))
        self.map(self.STUDY, "--quiet", "--jobs", "1")
        self.assertGreater(sum(row["reused"] == "1" for row in self.table()), 1)
        self.assertEqual(*((out / "map.csv").read_text().replace(str(out.parent), "") for out in (self.out, self.whole)))


class Maps(MapTest):
    def test_a_value_is_bisected_for_each_square_next_to_theory(self):
        report = self.map(GROWTH + PLACES + THEORY + "vary='mpm.cfl', low=.5, high=4., tolerance=2.e-3\n").stdout
        rows = self.table("map")
        self.assertEqual(len(rows), len(LEFT))
        for row in rows:
            found = (float(row["largest_holding"]) + float(row["smallest_failing"])) / 2
            exact = limit(float(row["in.xleft"]))
            self.assertLess(float(row["smallest_failing"]) - float(row["largest_holding"]), .0081)
            self.assertAlmostEqual(float(row["theory"]), exact, delta=1e-6)
            self.assertAlmostEqual(found / exact, 1, delta=.01)
        self.assertRegex(report, r"in\.xleft = 0: 2\.0\d+ to 2\.\d+, 2\.1029 by theory \(-0\.\d+ %\)")
        table = netcdf(self.out / "map.nc")
        self.assertEqual(list(table["theory"]), [float(row["theory"]) for row in rows])

    def test_words_are_taken_each_by_itself(self):
        orders = "axis(1)=\"mpm.order='musl','usl'\"\naxis(2)='mpm.cfl=.5,1.,1.5,2.,2.5,3.'\ncoarse=5\n"
        report = self.map(GROWTH + orders).stdout
        self.assertIn("mpm.order = musl: holds below 2 to 2.5", report)
        self.assertIn("mpm.order from musl to usl", report)

    def test_an_axis_may_fall(self):
        report = self.map(GROWTH + "axis(1)='mpm.cfl=4.,3.,2.5,2.,1.,.5'\ntheory='2.1029'\n").stdout
        self.assertIn("  holds below 2 to 2.5, 2.1029 by theory, between them\n", report)

    def test_each_way_to_fail_has_a_verdict(self):
        text = """mode='map', decks='../decks/stability-centre.in', criterion='exit_code', axis(1)='mpm.cfl=1.,5.'
set='in.tstep=1.0', 'in.dtmax=1.0'
"""
        self.map(text + "set(3)='limits.energy_step=0.,.01'\n", "--quiet")
        self.assertEqual([row["verdict"] for row in self.table("map")], ["holds", "contradicts its energy"])
        self.assertIn("failure = contradicts its energy", (self.out / self.table()[1]["folder"] / "run.txt").read_text())
        self.map(text + "set(3)='limits.energy_step=0.,0.', 'limits.energy_growth=0.,0.', 'in.tmax=10.'\n", "--quiet")
        self.assertEqual(self.table("map")[1]["verdict"], "loses points")

    def test_decks_have_a_map_each(self):
        text = GROWTH.replace("decks='../decks/stability-centre.in'", "decks='../decks/stability-centre.in','../decks/stability-side.in'")
        report = self.map(text + "axis(1)='mpm.cfl=.6,.9,1.2,1.5,1.8,2.1,2.4', axis(2)='in.tmax=.02,.03', coarse=3\n").stdout
        self.assertEqual(report.count("mpm.cfl from 0.6 to 2.4"), 2)
        rows = self.table("map")
        holding = [max(float(row["mpm.cfl"]) for row in rows if row["deck"].endswith(deck) and row["holds"] == "1" and row["in.tmax"] == "0.03")
                   for deck in ("centre.in", "side.in")]
        self.assertEqual(holding, [1.8, .9])
        self.assertIn("side.in, in.tmax = 0.03: holds below 0.9 to 1.2", report)

    def test_a_run_without_the_criterions_number_tells_nothing(self):
        text = """mode='map', decks='../decks/paths/bar.in', criterion='newton_iterations', at_most=1000.
axis(1)="in.path='mpm','fem'", axis(2)='in.tmax=.01,.02'
"""
        shutil.copytree(DECKS / "paths", self.folder / "decks/paths")
        report = self.map(text, code=5).stdout
        self.assertIn("tells nothing: it ended well, and has no number for newton_iterations", report)
        self.assertEqual({row["holds"] for row in self.table("map") if row["in.path"] == "mpm"}, {""})
        self.assertEqual({row["holds"] for row in self.table("map") if row["in.path"] == "fem"}, {"1"})

    def test_that_all_values_hold_or_none_is_an_answer(self):
        report = self.map(GROWTH + "axis(1)='in.nx=6,7'\nvary='mpm.cfl', low=.5, high=.6\n").stdout
        self.assertIn("in.nx = 6: above 0.6: both ends hold", report)
        self.assertIn("in.nx = 6: below 3: both ends fail", self.map(GROWTH + "axis(1)='in.nx=6,7'\nvary='mpm.cfl', low=3., high=4.\n").stdout)

    def test_each_value_is_tried_in_a_scene_before_the_first_run(self):
        text = GROWTH + "axis(1)='in.xleft=0.,.1,.2,.3,.4', axis(2)='in.xright=5.,.05,5.2,5.3,5.4', linked(2)=1\n"
        self.assertIn("this cannot be run", self.map(text + "axis(3)='mpm.cfl=1.,2.,3.'\n", code=2).stderr)


class BadMaps(MapTest):
    """Refused before the first run, all mistakes at once, and nothing is written."""

    CASES = (
        (GROWTH + "axis(1)='in.mx=5,6'\n", "Did you mean", 5),
        (GROWTH + "axis(1)='in.nx=5,6', axis(2)='in.nx=7,8'\n", "in.nx is set by", 5),
        (GROWTH + "axis(1)='in.nx=5,6', axis(2)='in.ny=2,3', axis(3)='mpm.cfl=1.,2.'\n", "a map has one or two axes, this one 3", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.,1.5'\n", "mpm.cfl turns back after 2", 5),
        (GROWTH + "axis(1)=\"mpm.order='musl','usl'\"\n", "no axis has several numbers", 5),
        (GROWTH.replace("'energy_growth'", "'energy_grows'") + "axis(1)='mpm.cfl=1.,2.'\n", "no run writes energy_grows", 3),
        (GROWTH + "theory='2.'\n", "a map without vary needs an axis", 3),
        (GROWTH + "axis(1)='in.nx=6,7', vary='mpm.cfl', low=1.\n", "a map with vary needs high", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.', low=1.\n", "low is for a map with vary", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.', tolerance=.1\n", "tolerance is for a map with vary", 5),
        (GROWTH + "axis(1)='in.nx=6,7', vary='mpm.cfl', low=1., high=2., coarse=2\n", "coarse is for a map without vary", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.', theory='2*stepz'\n", "no run writes stepz into its summary", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.', theory='2*max(energy_tolal)'\n", "Did you mean 'energy_total'", 5),
        (GROWTH + "axis(1)='mpm.cfl=1.,2.', runs=3\n", "runs is not for mode 'map'", 5),
        (GROWTH + "axis(1)=\"in.path='mpm','coupled'\", axis(2)='mpm.cfl=1.,2.'\n", "this cannot be run", 5),
        (GROWTH.replace(", criterion='energy_growth', at_most=100.", "") + "axis(1)='mpm.cfl=1.,2.'\n", "a study of mode 'map' needs criterion", 3),
    )

    def test_each_is_refused_at_its_place(self):
        self.assert_refused(self.CASES, lambda text: self.map(text, code=2), self.out)

    def test_a_right_name_is_not_called_wrong_next_to_another_mistake(self):
        result = self.map(GROWTH + "axis(1)='mpm.cfl=1.,2.,1.5', theory='energy_growth'\n", code=2)
        self.assertEqual(result.stderr.count("error:"), 1, result.stderr)

    def test_all_decks_are_read_before_the_first_is_run(self):
        good, bad = self.study(GROWTH + "axis(1)='mpm.cfl=1.,2.'\n", "studies/good.in"), self.study(GROWTH, "studies/bad.in")
        self.expect(2, "map", good, bad, "--out", self.out)
        self.assertFalse(self.out.exists())

    def test_a_sweep_is_no_map_and_a_map_no_sweep(self):
        result = self.expect(2, "sweep", self.study(GROWTH + STEPS.replace("(3)", "(1)")))
        self.assertIn("this study is a map", result.stderr)
        result = self.expect(2, "map", DECKS / "studies/stability.in")
        self.assertIn("this study is no map", result.stderr)


class ShippedMaps(MapTest):
    def test_each_can_be_run(self):
        for deck in sorted((DECKS / "maps").glob("*.in")):
            with self.subTest(deck=deck.name):
                self.assertIn("to run", self.expect(0, "map", deck, "--dry-run", folder=self.folder).stdout)

    def test_several_have_a_folder_each(self):
        names = ["step-place", "step-place-verdicts"]
        decks = [DECKS / f"maps/{name}.in" for name in names]
        if not FULL:
            decks = [self.study(GROWTH + "axis(1)='mpm.cfl=1.,3.'\n", f"studies/{name}.in") for name in names]
        self.expect(0, "map", *decks, "--out", self.out, "--quiet")
        self.assertEqual(sorted(path.parent.name for path in self.out.glob("*/map.txt")), names)


if __name__ == "__main__":
    unittest.main()
