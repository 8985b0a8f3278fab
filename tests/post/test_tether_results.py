# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python door to results: what the program wrote is read back, and what is no run is refused with a reason."""
import sys
import unittest
from pathlib import Path

import netCDF4
import numpy

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "post"), str(Path(__file__).parent)]

import tether_results
from small_runs import PROGRAM, DeckTest
from tether_results.program import in_namelist

BALLOON = {"in.tmax": 0.1, "in.nx": 21, "in.ny": 21}


class Histories(DeckTest):
    def test_columns_are_those_of_the_text(self):
        run = self.run_of("pendulum-40", {"in.tmax": 0.1})
        with open(run.folder / "history.txt") as file:
            names = file.readline().removeprefix("#").split()
            rows = numpy.loadtxt(file)
        self.assertEqual(run.history.columns, names)
        self.assertEqual(len(run.history), len(rows))
        for name, column in zip(names, rows.T):
            numpy.testing.assert_array_equal(run.history[name], column)
        numpy.testing.assert_array_equal(run.history["point_y"][:, 1], run.history["point_y_2"])

    def test_units_are_the_decks(self):
        run = self.run_of("coupled-balloon", BALLOON)
        self.assertEqual([run.history.units[name] for name in ("time", "energy_total", "body_vx_1")], ["s", "J", "m s-1"])

    def test_as_xarray_with_the_same_numbers(self):
        run = self.run_of("pendulum-40", {"in.tmax": 0.1})
        data = run.history.to_xarray()
        numpy.testing.assert_array_equal(data["point_y"], run.history["point_y"])
        self.assertEqual(data["energy_total"].attrs["units"], "1")


class Snapshots(DeckTest):
    def test_what_has_left_has_no_numbers_and_no_body(self):
        run = self.run_of("open-tube")
        first = run.fields("particles").at(0)
        gone = numpy.isnan(first["x"])
        self.assertTrue(0 < gone.sum() < len(gone))
        numpy.testing.assert_array_equal(numpy.isnan(first["body"]), gone)
        self.assertEqual(set(first["body"][~gone]), {1, 2})

    def test_no_pressure_is_known_before_the_first_step(self):
        for deck, kind, values in (("coupled-archimedes", "mesh", {"in.tmax": 0.05}), ("cavity", "mesh", {"mesh.cells(1,1)": (4, 4)})):
            fields = self.run_of(deck, values).fields(kind)
            self.assertTrue(numpy.isnan(fields.at(0)["p"]).any(), deck)
            self.assertTrue(numpy.isfinite(fields.at(-1)["p"]).all(), deck)

    def test_points_at_a_time_and_at_a_number(self):
        particles = self.run_of("sod").fields("particles")
        self.assertEqual((particles.form, len(particles)), ("points", 4))
        with netCDF4.Dataset(particles.path) as data:
            numpy.testing.assert_array_equal(particles.at(0.1)["pressure"], data["pressure"][2])
            numpy.testing.assert_array_equal(particles.at(-1)["x"], data["x"][-1])
            numpy.testing.assert_array_equal(particles.places(1)[:, 1], data["y"][1])
        self.assertEqual(set(particles.at(0, ["vx"])), {"vx"})
        with self.assertRaises(IndexError):
            particles.at(4)

    def test_one_snapshot_leaves_the_others_on_the_disk(self):
        particles = tether_results.open(self.run_of("sod").folder).fields("particles")
        particles.at(2)
        self.assertEqual(particles._whole, {})

    def test_the_grid_of_points(self):
        grid = self.run_of("sod").fields("mesh")
        self.assertEqual(grid.form, "grid")
        self.assertEqual(grid.at(0)["mass"].shape, (2, 101))
        numpy.testing.assert_allclose(grid.axes["x"], numpy.linspace(0, 1, 101))

    def test_elements_and_their_places(self):
        mesh = self.run_of("cook", {"mesh.cells(1,1)": (2, 3)}).fields("mesh")
        self.assertEqual((mesh.form, mesh.dimension, mesh.elements.shape), ("elements", 2, (6, 9)))
        numpy.testing.assert_array_equal(mesh.places(0), mesh.start)
        moved = mesh.at(1)
        numpy.testing.assert_allclose(mesh.places(1)[:, 1], mesh.start[:, 1] + moved["uy"])
        self.assertGreater(moved["uy"].max(), 1)

    def test_a_box_has_cells_by_rows(self):
        run = self.run_of("coupled-balloon", BALLOON)
        mesh = run.fields("mesh")
        self.assertEqual((mesh.form, mesh.box.shape), ("box", (20, 20)))
        numpy.testing.assert_allclose(mesh.axes["y"], numpy.arange(0.05, 2, 0.1))
        numpy.testing.assert_allclose(mesh.box.edges["x"], numpy.arange(0, 2.01, 0.1), atol=1e-12)
        kind = mesh.at(0)["kind"]
        self.assertTrue((kind[0] == 2).all())  # the floor is an obstacle, 0.1 high
        self.assertFalse((kind[1:] == 2).any())


class Texts(DeckTest):
    def test_summary_exact_deck_and_messages(self):
        run = self.run_of("sod")
        self.assertEqual((run.summary["path"], run.summary["points"]), ("mpm", 900))
        self.assertEqual(next(iter(run.exact)), "x")
        self.assertEqual(run.exact_over("time"), {})
        self.assertIn("$in", run.deck)
        self.assertEqual((run.deck_values["reg.ipath(4,2)"], run.deck_values["reference.solution"]), (9, "riemann"))
        self.assertIn("tether", run.version)
        self.assertIn("sod.in", run.command)
        self.assertIn("Sod's shock tube", run.title)

    def test_a_run_takes_values_of_python(self):
        run = self.run_of("sod", {"in.nx": 51, "mpm.method": "robust", "in.tmax": numpy.float64(0.01), "in.large": False})
        self.assertEqual((run.deck_values["in.nx"], run.deck_values["mpm.method"]), (51, "robust"))
        self.assertEqual(run.history["time"][-1], 0.01)

    def test_values_as_a_namelist_has_them(self):
        for value, text in ((True, ".true."), ("it's", '"it\'s"'), ((1, 2.5), "1,2.5"), (numpy.int64(3), "3"),
                            (numpy.array([1.0, 2.0]), "1.0,2.0")):
            self.assertEqual(in_namelist(value), text)

    def test_a_run_that_fails_says_why(self):
        with self.assertRaises(tether_results.RunFailed) as caught:
            tether_results.run(ROOT / "decks" / "sod.in", {"in.nx": "a"}, out=self.folder / "none", program=PROGRAM)
        self.assertEqual(caught.exception.exit_code, 2)
        self.assertIn("nx must be an integer", caught.exception.message)
        with self.assertRaisesRegex(tether_results.NoProgram, "nowhere: is not there"):
            tether_results.run(ROOT / "decks" / "sod.in", program=self.folder / "nowhere")


class Refused(DeckTest):
    def refused(self, path, reason):
        with self.assertRaisesRegex(tether_results.NotARun, reason):
            tether_results.open(path)

    def test_what_is_no_run(self):
        self.refused(self.folder / "nowhere", "is no folder")
        empty = self.folder / "empty"
        empty.mkdir()
        self.refused(empty, "has no history.nc")
        (empty / "history.nc").write_text("")
        self.refused(empty, "cannot be read as NetCDF")

    def test_a_run_without_records(self):
        here = self.folder / "stopped"
        here.mkdir()
        with netCDF4.Dataset(here / "history.nc", "w") as data:
            data.createDimension("time", None)
            data.createVariable("time", "f8", ("time",))
        self.refused(here, "holds no records")

    def test_fields_that_were_not_written(self):
        run = self.run_of("coupled-balloon", BALLOON)
        with self.assertRaisesRegex(tether_results.NotARun, r"particles.nc: is not there: iout\(13\)=1"):
            run.fields("particles")
        with self.assertRaisesRegex(ValueError, "there are particles, mesh, solids"):
            run.fields("dust")
        self.assertEqual([run.has(kind) for kind in ("particles", "mesh", "solids")], [False, True, True])

    def test_a_run_that_has_no_summary_yet(self):
        run = self.run_of("sod")
        (run.folder / "summary.txt").rename(run.folder / "away")
        self.addCleanup((run.folder / "away").rename, run.folder / "summary.txt")
        self.assertEqual(tether_results.open(run.folder).summary, {})


if __name__ == "__main__":
    unittest.main()
