# SPDX-License-Identifier: GPL-3.0-or-later
"""post/plot.py on small runs made here and on runs of the program: which pictures appear, and what is drawn in them."""
import os
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path[:0] = [str(POST), str(Path(__file__).parent)]

import matplotlib

matplotlib.use("Agg")

import netCDF4
import numpy
from matplotlib import image

import tether_results
from called import call
from scene import choose, profiles
from small_runs import FolderTest, PLACES, TIMES, write_history, write_particles

PROGRAM = os.environ["TETHER"]


def coloured_share(path):
    """Share of the pixels that are neither white, grey nor black: axes and letters have no colour, data have."""
    pixels = image.imread(path)[:, :, :3]
    return float(numpy.mean(pixels.max(axis=2) - pixels.min(axis=2) > 0.2))


class PlotTest(FolderTest):
    def reference(self, text):
        (self.folder / "reference.txt").write_text(text)

    def open(self):
        return tether_results.open(self.folder)

    def panel(self, title):
        """The curves of the panel of histories.png with this title, by label; and the whole title."""
        for axes in choose.histories_of(self.open()).axes:
            if axes.get_title().startswith(title):
                return {line.get_label(): line.get_xydata() for line in axes.lines}, axes
        self.fail(f"no panel {title}")


class CommandLine(PlotTest):
    def test_draws_all_pictures_with_something_in_them(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# x density velocity pressure specific_energy\n0 0 0 0 0\n1 1 1 1 1\n")
        result = call("plot", self.folder, alone=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.pictures(), ["fields.png", "histories.png", "profiles.png"])
        for name in self.pictures():
            self.assertGreater(coloured_share(self.folder / name), 1e-3, name)

    def test_draws_only_what_there_is_where_it_should_and_says_what_is_missing(self):
        write_history(self.folder, bodies=False)
        other = self.folder / "deep" / "figures"
        result = call("plot", self.folder, "--out", other)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.pictures(other), ["histories.png"])
        self.assertEqual(self.pictures(), [])
        path, missing = result.stdout.splitlines()
        self.assertEqual(path, str(other / "histories.png"))
        self.assertIn("iout(13)=1", missing)

    def check_refused(self, *needles, words=()):
        result = call("plot", self.folder, *words)
        self.assertEqual(result.returncode, 2, result.stderr)
        for needle in needles:
            self.assertIn(needle, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual(self.pictures(), [])

    def test_refuses_a_folder_without_history(self):
        write_particles(self.folder)
        self.check_refused(str(self.folder), "has no history.nc")

    def test_refuses_a_file_that_is_no_netcdf(self):
        (self.folder / "history.nc").write_text("time,energy\n0,1\n")
        self.check_refused("history.nc", "cannot be read as NetCDF")

    def test_refuses_a_history_without_records(self):
        with netCDF4.Dataset(self.folder / "history.nc", "w") as data:
            data.createDimension("time", None)
            data.createVariable("time", "f8", ("time",))
        self.check_refused("history.nc", "no records")

    def test_refuses_a_reference_that_is_no_table(self):
        write_history(self.folder)
        for text in ("", "# time a\n0 one\n", "# time a\n0 1\n2\n", "#\n0 1\n"):
            self.reference(text)
            self.check_refused("reference.txt", "no table of numbers")

    def test_refuses_a_field_that_is_not_there(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.check_refused("no field dust; there are speed, body", words=("--field", "dust"))

    def test_reports_that_it_cannot_write(self):
        write_history(self.folder)
        (self.folder / "taken").write_text("")
        result = call("plot", self.folder, "--out", self.folder / "taken")
        self.assertEqual(result.returncode, 4)
        self.assertIn("taken", result.stderr)


class Histories(PlotTest):
    def test_energies_are_changes_with_their_names_and_units(self):
        write_history(self.folder)
        curves, axes = self.panel("energies")
        self.assertEqual(list(curves), ["kinetic", "total"])
        numpy.testing.assert_allclose(curves["total"], numpy.column_stack([TIMES, TIMES]))
        self.assertEqual((axes.get_ylabel(), axes.get_xlabel()), ("change of energy [J]", "time [s]"))

    def test_exact_path_lies_over_its_own_point_alone_in_broken_black(self):
        write_history(self.folder)
        self.reference("# time point_y_2\n0 0\n1 2.2\n")
        self.assertEqual(list(self.panel("x of tracked")[0]), ["point 1", "point 2"])
        curves, axes = self.panel("y of tracked")
        self.assertEqual(list(curves), ["point 1", "point 2", "exact"])
        numpy.testing.assert_array_equal(curves["exact"], [[0, 0], [1, 2.2]])
        exact = axes.lines[-1]
        self.assertEqual((exact.get_color(), exact.get_linestyle()), ("black", "--"))
        # From 2 t to 2.2 t it is .2 at most, over a range of 2.2.
        self.assertIn(f"at most {100 * 0.2 / 2.2:.3g} %", axes.get_title())

    def test_an_exact_column_of_no_scene_has_a_panel_all_the_same(self):
        write_history(self.folder, bodies=False)
        self.reference("# time energy_transfer\n0 0\n1 1\n")
        self.assertIn("exact", self.panel("energy transfer")[0])

    def test_what_does_not_move_is_left_out(self):
        write_history(self.folder)
        with netCDF4.Dataset(self.folder / "history.nc", "a") as data:
            data["point_y"][:] = 1e-9 * data["point_x"][:]
        titles = [axes.get_title() for axes in choose.histories_of(self.open()).axes]
        self.assertIn("x of tracked points", titles)
        self.assertNotIn("y of tracked points", titles)

    def test_a_run_of_two_records_has_a_table_of_the_last(self):
        run = tether_results.run(ROOT / "decks" / "cook.in", {"mesh.cells(1,1)": (4, 4)}, out=self.folder, program=PROGRAM)
        (axes,) = choose.histories_of(run).axes
        cells = {key: cell.get_text().get_text() for key, cell in axes.tables[0].get_celld().items()}
        row = next(row for (row, column), text in cells.items() if text == "point_y_1")
        self.assertEqual(cells[row, 1], f"{run.history['point_y_1'][-1]:.8g}")


class Profiles(PlotTest):
    def test_pair_each_field_with_its_exact_column(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# x density velocity pressure specific_energy\n0 1 2 3 4\n1 5 6 7 8\n")
        panels = profiles.figure(self.open()).axes
        for axes, (factor, exact) in zip(panels, [(1, (1, 5)), (4, (2, 6)), (2, (3, 7)), (3, (4, 8))]):
            curves = {line.get_label(): line.get_ydata() for line in axes.lines}
            numpy.testing.assert_array_equal(curves["points"], factor * PLACES)
            numpy.testing.assert_array_equal(curves["exact"], exact)
        self.assertEqual(panels[1].get_ylabel(), "velocity")

    def test_need_gas_and_an_exact_solution_over_x(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# time point_y_1\n0 1\n")
        self.assertIsNone(profiles.figure(self.open()))
        write_particles(self.folder, gas=False)
        self.reference("# x density velocity pressure specific_energy\n0 1 2 3 4\n")
        self.assertIsNone(profiles.figure(self.open()))


if __name__ == "__main__":
    unittest.main()
