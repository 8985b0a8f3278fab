# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies whose quantities or criterion are values of the runs' histories, 'last(body_vx_1)'."""
import itertools
import statistics
import unittest

import netCDF4

from program import history
from sweeps import COST, SweepTest


class HistoryValues(SweepTest):
    """Quantities that are values of history.txt."""

    COLUMNS = ("body_vy_1", "energy_kinetic", "point_y_1")
    FUNCTIONS = {"last": lambda time, of: of[-1], "max": lambda time, of: of.max(), "min": lambda time, of: of.min(),
                 "time_of_max": lambda time, of: time[of.argmax()], "time_of_min": lambda time, of: time[of.argmin()]}
    QUANTITIES = ",".join(map("'{0[0]}({0[1]})'".format, itertools.product(FUNCTIONS, COLUMNS)))
    STUDY = "decks='../decks/spring-mass.in', axis='in.gravc=-250.0,-100.0', set='in.tmax=0.03'\nquantities=" + QUANTITIES

    def test_are_those_of_the_runs_histories(self):
        self.sweep(self.study(self.STUDY))
        for row in self.table():
            records = history(self.out / row["folder"])
            for (function, of), column in itertools.product(self.FUNCTIONS.items(), self.COLUMNS):
                self.assertEqual(float(row[f"{function}_{column}"]), of(records["time"], records[column]))
        first, second = self.table()
        self.assertNotEqual(first["time_of_max_energy_kinetic"], first["time_of_min_energy_kinetic"])
        self.assertGreater(float(first["max_energy_kinetic"]), float(second["max_energy_kinetic"]))
        with netCDF4.Dataset(self.out / "table.nc") as file:
            self.assertEqual(file["max_point_y_1"].long_name, "largest record of point_y_1 in history.txt")
            self.assertEqual([str(v) for v in file["max_point_y_1"][:]], [first["max_point_y_1"], second["max_point_y_1"]])

    def test_cost_no_run_again(self):
        self.sweep(self.study(self.STUDY))
        before = self.table()
        self.sweep(self.study(self.STUDY.replace("'last(body_vy_1)'", "'last(body_y_1)','period'")))
        after = self.table()
        self.assertEqual({row["reused"] for row in after}, {"1"})
        self.assertTrue(all(row["last_body_y_1"] and row["period"] for row in after))
        self.assertEqual([row["max_point_y_1"] for row in after], [row["max_point_y_1"] for row in before])

    def test_a_history_that_is_not_whole_is_run_again(self):
        self.sweep(self.study(self.STUDY))
        before = self.table()
        path = self.out / before[1]["folder"] / "history.txt"
        whole = path.read_bytes()
        path.write_bytes(whole[:len(whole) // 2])
        self.sweep(self.study(self.STUDY))
        self.assertEqual([row["reused"] for row in self.table()], ["1", "0"])
        self.assertEqual(path.read_bytes(), whole)
        for row, old in zip(self.table(), before, strict=True):
            self.assertEqual({**row, **{k: old[k] for k in COST}}, old)

    def test_of_a_run_that_fails_there_are_none(self):
        self.sweep(self.study("decks='../decks/stability-side.in'\naxis='mpm.cfl=0.5,2.25'\n"
                              "set='in.tstep=1.0','in.dtmax=1.0'\nquantities='max(energy_total)'"))
        good, failed = self.table()
        self.assertEqual((good["max_energy_total"] == "", failed["exit_code"], failed["max_energy_total"]), (False, "3", ""))

    def test_in_an_ensemble(self):
        self.sweep(self.study("mode='ensemble', decks='../decks/spring-mass.in', set='in.tmax=2.d-3'\n"
                              "vary='in.gravc', fraction=0.5, runs=3, quantities='last(body_vy_1)'"))
        values = [float(row["last_body_vy_1"]) for row in self.table()]
        (outcome,) = self.table("outcome")
        self.assertAlmostEqual(float(outcome["mean_last_body_vy_1"]), statistics.mean(values), places=12)
        self.assertEqual(float(outcome["max_last_body_vy_1"]), max(values))
        self.assertAlmostEqual(values[0] / values[2], 1 / 3, places=3)

    def test_as_the_criterion_of_a_bisection(self):
        """Free fall but for the spring: the speed at the end is gravity times the time."""
        self.sweep(self.study("mode='bisect', decks='../decks/spring-mass.in', set='in.tmax=1.d-4'\n"
                              "vary='in.gravc', low=-300.0, high=-100.0, tolerance=1.d-3\n"
                              "criterion='last(body_vy_1)', at_most=-2.d-2"))
        (outcome,) = self.table("outcome")
        self.assertEqual(outcome["verdict"], "found")
        self.assertAlmostEqual(float(outcome["largest_holding"]), -200, delta=0.5)
        for row in self.table():
            self.assertEqual(float(row["last_body_vy_1"]) <= -2e-2,
                             float(row["in.gravc"]) <= float(outcome["largest_holding"]))

    def test_a_column_that_some_runs_lack_is_a_missing_cell(self):
        self.sweep(self.study("decks='../decks/two-bar.in', set='in.tmax=2.d-3', quantities='last(energy_contact)'\n"
                              "axis(1)=\"mpm.method='thesis','robust'\", axis(2)=\"mpm.contact='release','gap'\", linked(2)=1"))
        thesis, robust = self.table()
        self.assertEqual((thesis["last_energy_contact"], thesis["exit_code"]), ("", "0"))
        self.assertIn("warning: its history.txt has no column 'energy_contact'.", thesis["message"])
        self.assertEqual(float(robust["last_energy_contact"]), 0)  # the bars have not met

    def test_a_column_that_no_run_has_and_no_look_at_the_scenes_could_tell(self):
        study = self.study("decks='../decks/sod.in', axis='reg.nprg(1)=9,5', set='in.tmax=1.d-3'\n"
                           "quantities='steps','max(body_vx_3)'")  # 5 a cell cannot be built
        result = self.sweep(study, code=5)
        self.assertIn("error: no run's history.txt has a column 'body_vx_3'. Did you mean 'body_vx_1'?", result.stderr)
        rows = self.table()
        self.assertEqual([row["exit_code"] for row in rows], ["0", "2"])
        self.assertEqual([row["max_body_vx_3"] for row in rows], ["", ""])
        self.assertGreater(int(rows[0]["steps"]), 1)
        self.sweep(self.study("decks='../decks/sod.in', axis='reg.nprg(1)=9,5', set='in.tmax=1.d-3'\n"
                              "quantities='steps','max(body_vx_2)'"))
        self.assertEqual([row["reused"] for row in self.table()], ["1", "1"])


if __name__ == "__main__":
    unittest.main()
