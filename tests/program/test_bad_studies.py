# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies that tether sweep refuses before their first run."""
import unittest

from program import DECKS, diagnostics
from sweeps import SweepTest


class BadStudies(SweepTest):
    """Refused before the first run, at their place, and nothing is written."""

    GOOD = "decks='../decks/spring-mass.in', quantities='period'\n"
    CASES = (
        (GOOD + "axis='in.nxx=51,101'", "$in has no variable 'nxx'", (4, 10)),
        (GOOD + "axis='in.nx=51,x'", "nx must be an integer, not 'x'", (4, 16)),
        (GOOD + "axis='in.nx=51,1'", "nx = 1 is out of range", (4, 16)),
        (GOOD + "axis=\"mpm.order='musl','fast'\"", "order = 'fast' is none of its choices", (4, 24)),
        (GOOD + "axis='grid.nx=51'", "'grid.nx' names no group", (4, 7)),
        (GOOD + "axis='in.nx=51,51'", "the value 51 stands there twice", (4, 6)),
        (GOOD + "axis='in.nx'", "this is no override", (4, 7)),
        (GOOD + "axis(1)='in.nx=5,7'\naxis(2)='in.NX=9'", "in.nx is set by axis(1), too", (5, 9)),
        (GOOD + "axis='in.nx=5,7'\nset='in.nx=9'", "in.nx is set by set(1), too", (4, 6)),
        (GOOD + "axis='in.tiout(33:34)=2*1.e-3'\nset='in.tiout(34)=1.'", "in.tiout(34) is set by set(1), too", (4, 6)),
        (GOOD + "axis(1)='in.nx=5,7'\naxis(2)='in.tstep=1.e-6'\nlinked(2)=1", "axis 2 has 1 values, axis 1 has 2",
         (6, 11)),
        (GOOD + "axis(1)='in.nx=5,7'\nlinked(1)=2", "axis 1 cannot move along with axis 2", (5, 11)),
        (GOOD + "axis(1)='in.nx=5,7'\nlinked(2)=1", "axis 2 cannot move along with axis 1", (5, 11)),
        (GOOD + "set='in.wl=9'", "wl = 9 is out of range", (4, 12)),
        ("decks='../decks/spring-mass.in'\nquantities='perod'", "no run writes perod", (4, 12)),
        ("decks='../decks/spring-mass.in'\nquantities='error_density'", "no run writes error_density", (4, 12)),
        ("decks='../decks/spring-mass.in'\nquantities='period','period'", "period stands there twice", (4, 21)),
        ("decks='../decks/spring-mass.in'\nquantities='cpu_seconds'", "every table has cpu_seconds", (4, 12)),
        ("decks='../decks/spring-mass.in'", "a study of mode 'grid' needs quantities", (2, 1)),
        ("quantities='steps'", "the study names no deck", (2, 1)),
        ("quantities='steps'\ndecks='../decks/none.in'", "none.in: cannot be opened", (4, 7)),
        ("quantities='steps'\ndecks='../../decks/sod.in'", "the deck's path climbs more than one folder", (4, 7)),
        ("quantities='steps'\ndecks='/decks/sod.in'", "the deck's path is absolute", (4, 7)),
        ("quantities='steps'\ndecks='../decks/sod.in','../decks/sod.in'", "this deck stands there twice", (4, 25)),
        ("quantities='steps'\ndecks='study.in'", "this deck is a study itself", (4, 7)),
        (GOOD + "vary='in.gravc'", "vary is not for mode 'grid'", (4, 6)),
        (GOOD + "order='dy'", "the table has no column dy of numbers", (4, 7)),
        (GOOD + "order='period'", "an order is reported along axis 1, and there is none", (4, 7)),
        (GOOD + "mode='ensemble', fraction=0.1, runs=3", "a study of mode 'ensemble' needs vary", (4, 6)),
        (GOOD + "mode='ensemble', fraction=0.1, runs=1, vary='in.gravc'", "runs = 1 is out of range", (4, 37)),
        (GOOD + "mode='ensemble', fraction=0.1, runs=3, vary='in.nx'", "in.nx is no real number", (4, 45)),
        (GOOD + "mode='ensemble', fraction=2.0, runs=3, vary='in.tmax'", "tmax = -0.101 is out of range", (4, 27)),
        (GOOD + "mode='ensemble', fraction=0.1, runs=3, vary='in.xleft'", "in.xleft is 0 in", (4, 45)),
        (GOOD + "mode='bisect', vary='mpm.cfl', low=1.0, high=1.0, criterion='steps', at_most=1.0",
         "a bisection's high is above its low", (4, 46)),
        (GOOD + "mode='bisect', vary='mpm.cfl', low=-1.0, high=1.0, criterion='steps', at_most=1.0",
         "cfl = -1 is out of range", (4, 36)),
        (GOOD + "mode='bisect', vary='mpm.cfl', low=0.1, high=1.0, criterion='step', at_most=1.0",
         "no run writes step into", (4, 61)),
        (GOOD + "mode='bisect', vary='mpm.cfl', low=0.1, high=1.0, criterion='steps'",
         "the criterion has no bound", (4, 61)),
        (GOOD + "mode='bisect', vary='mpm.cfl', low=0.1, high=1.0, criterion='steps', at_least=3.0, at_most=2.0",
         "nothing lies between at_least and at_most", (4, 79)),
        (GOOD + "quantities(2)='lst(energy_total)'", "there is no function 'lst' of a column", (4, 16)),
        (GOOD + "quantities(2)='last(energy_total'", "this bracket is not closed", (4, 20)),
        (GOOD + "quantities(2)='last energy_total)'", "nothing opens this bracket", (4, 33)),
        (GOOD + "quantities(2)='last(energy_total)/2'", "something stands after the bracket", (4, 34)),
        (GOOD + "quantities(2)='last( energy total )'", "'energy total' is no name of a column", (4, 22)),
        (GOOD + "quantities(2)='last()'", "'' is no name of a column", (4, 21)),
        (GOOD + "quantities(2)='last(body_vx_2)'", "no run's history.txt has a column 'body_vx_2'", (4, 21)),
        (GOOD + "quantities(2)='last(dt)','last(dt)'", "last_dt stands there twice", (4, 26)),
        (GOOD + "quantities(2)='energy_total'", "no run writes energy_total", (4, 15)),
        (GOOD + "axis=\"mpm.method='thesis','robust'\"\nquantities(2)='max(energy_heat)'",
         "no run's history.txt has a column 'energy_heat'", (5, 20)),
        (GOOD + "axis(1)='in.nx=51,52,53,54,55,56,57,58,59,60,61'\naxis(2)='in.dtmax=1,2,3,4,5,6,7,8,9,10'\n"
         "quantities(2)='last(body_vx_2)'", "no run's history.txt has a column 'body_vx_2'", (6, 21)),
        ("decks='../decks/spring-mass.in'\nmode='bisect', vary='mpm.cfl', low=0.1, high=1.0\n"
         "criterion='max(point_y_2)', at_most=1.0", "no run's history.txt has a column 'point_y_2'", (5, 16)),
        ("decks='../decks/spring-mass.in'\nmode='bisect', vary='mpm.cfl', low=0.1, high=1.0\n"
         "criterion='most(point_y_1)', at_most=1.0", "there is no function 'most'", (5, 12)),
        ("decks='../decks/spring-mass.in'\nmode='bisect', vary='mpm.cfl', low=0.1, high=1.0\n"
         "criterion='max(point_y_1)'", "the criterion has no bound", (5, 11)),
        (GOOD + "axis(1)='in.nx=5,7'\naxis(2)='in.tstep=1.e-6,1.e-6'", "the value 1.e-6 stands there twice", (5, 9)),
        (GOOD + "axis='in.nx=51,101'\nfraktion=0.1", "$study has no variable 'fraktion'", (5, 1)),
    )

    def refuse(self, study, fragment, place):
        result = self.expect(2, "sweep", study, "--out", self.out)
        self.assertFalse(self.out.exists())
        self.assertEqual(result.stdout, "")
        told = [(head, below) for head, below in diagnostics(result.stderr) if fragment in head["text"]]
        self.assertEqual(len(told), 1, f"{fragment}\n{result.stderr}")
        head, below = told[0]
        self.assertEqual((head["severity"], int(head["line"]), int(head["column"])), ("error", *place), result.stderr)
        self.assertEqual(below[1].index("^"), 2 + place[1] - 1)

    def test_each_at_its_place(self):
        for text, fragment, place in self.CASES:
            with self.subTest(fragment):
                self.refuse(self.study(text), fragment, place)
        print(f"{len(self.CASES)} bad studies refused", flush=True)

    def test_all_mistakes_at_once(self):
        study = self.study("decks='../decks/spring-mass.in'\nquantities='perod'\naxis(1)='in.nxx=1'\n"
                           "axis(2)='in.ny=0'\nset='mpm.cfl=x'")
        result = self.expect(2, "sweep", study, "--out", self.out)
        self.assertEqual([int(head["line"]) for head, _ in diagnostics(result.stderr)], [7, 5, 6, 4])

    def test_a_column_that_is_nearly_there_is_named(self):
        study = self.study(self.GOOD + "quantities(2)='last(point_vx_2)','min(nothing_of_it)'")
        told = diagnostics(self.expect(2, "sweep", study, "--out", self.out).stderr)
        self.assertIn("Did you mean 'point_vx_1'?", told[0][1][-1])
        self.assertIn("There are time, dt, energy_kinetic,", told[1][1][-1])

    def test_an_order_along_what_could_be_a_quantity_says_how(self):
        study = self.study(self.GOOD + "axis='in.nx=3,5'\norder='dx'")
        told = diagnostics(self.expect(2, "sweep", study, "--out", self.out).stderr)
        self.assertEqual([head["text"] for head, _ in told], ["the table has no column dx of numbers"])
        self.assertIn("Add 'dx' to quantities.", told[0][1][-1])

    def test_thousands_of_wrong_values_do_not_drown_the_reader(self):
        study = self.study(self.GOOD + "axis='in.nx=" + ",".join(f"x{k}" for k in range(5000)) + "'")
        told = self.expect(2, "sweep", study, "--out", self.out).stderr
        self.assertEqual(len(diagnostics(told)), 20)
        self.assertLess(len(told), 5000)

    def test_mistakes_of_a_base_deck(self):
        self.write("decks/bad.in", (DECKS / "spring-mass.in").read_text().replace("nx=2,", "nx=2, foo=1,"))
        result = self.expect(2, "sweep", self.study("decks='../decks/bad.in', quantities='steps'"), "--out", self.out)
        self.assertIn("decks/bad.in:7:7: error: $in has no variable 'foo'", result.stderr)
        self.assertFalse(self.out.exists())

    def test_a_study_is_no_run_and_a_run_no_study(self):
        study = self.study(self.GOOD)
        for words in ([study], ["plan", study], ["check", study]):
            self.assertIn("tether sweep", self.expect(2, *words, folder=self.folder).stderr)
        self.assertIn("there is no group $study", self.expect(2, "sweep", DECKS / "sod.in", "--out", self.out).stderr)
        self.write("decks/both.in", (DECKS / "sod.in").read_text() + "$study\nmode='grid'\n$\n")
        told = self.expect(2, self.folder / "decks/both.in", "--out", self.out).stderr
        self.assertIn("$study stands beside $in", told)
        self.assertIn("tether sweep", told)
        self.assertFalse(self.out.exists())

    def test_a_study_that_is_not_there(self):
        self.expect(4, "sweep", self.folder / "none.in", "--out", self.out)
        self.assertFalse(self.out.exists())

if __name__ == "__main__":
    unittest.main()
