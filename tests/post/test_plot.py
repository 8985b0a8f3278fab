# SPDX-License-Identifier: GPL-3.0-or-later
"""post/plot.py on small runs made here: which figures appear, and what is drawn in them."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import netCDF4
import numpy
from matplotlib import image

POST = Path(__file__).resolve().parents[2] / "post"
sys.path.insert(0, str(POST))

import run_figures
import tether_results

TIMES = numpy.linspace(0, 1, 21)
PLACES = numpy.linspace(0, 1, 50)


def add(dataset, name, dimensions, values, units):
    variable = dataset.createVariable(name, "f8", dimensions)
    variable.units = units
    variable[:] = values


def write_history(folder, bodies=True):
    with netCDF4.Dataset(folder / "history.nc", "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.createDimension("time", None)
        add(data, "time", ("time",), TIMES, "s")
        add(data, "energy_kinetic", ("time",), TIMES, "J")
        add(data, "energy_total", ("time",), 1 + TIMES, "J")
        if not bodies:
            return
        for kind, number in (("body", 1), ("point", 2)):
            data.createDimension(kind, number)
            for part, unit in (("x", "m"), ("y", "m"), ("vx", "m s-1"), ("vy", "m s-1")):
                add(data, f"{kind}_{part}", ("time", kind), numpy.outer(TIMES, 1 + numpy.arange(number)), unit)
        data.createDimension("name_length", 3)
        data.createVariable("body_name", "S1", ("body", "name_length"))[0] = numpy.array([b"g", b"a", b"s"])


def write_particles(folder, gas=True):
    with netCDF4.Dataset(folder / "particles.nc", "w") as data:
        data.createDimension("time", None)
        data.createDimension("point", len(PLACES))
        add(data, "time", ("time",), [0, 0.5, 1], "s")
        fields = {"x": PLACES, "y": PLACES**2, "body": PLACES > 0.5}
        if gas:
            fields |= {"density": PLACES, "pressure": 2 * PLACES, "specific_energy": 3 * PLACES, "vx": 4 * PLACES}
        for name, values in fields.items():
            add(data, name, ("time", "point"), numpy.tile(values, (3, 1)), "1")


def coloured_share(path):
    """Share of the pixels that are neither white, grey nor black: axes and letters have no colour, data have."""
    pixels = image.imread(path)[:, :, :3]
    return float(numpy.mean(pixels.max(axis=2) - pixels.min(axis=2) > 0.2))


def plot(*words):
    environment = os.environ | {"MPLBACKEND": "Agg"}
    return subprocess.run([sys.executable, POST / "plot.py", *words], capture_output=True, text=True, env=environment)


class PlotTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"
        self.folder.mkdir()

    def pictures(self, folder=None):
        return sorted(path.name for path in (folder or self.folder).glob("*.png"))

    def reference(self, text):
        (self.folder / "reference.txt").write_text(text)

    def lines(self, figure, panel):
        """The curves of a panel by label, x and y as lists."""
        self.addCleanup(run_figures.pyplot.close, figure)
        return {line.get_label(): line.get_xydata() for line in figure.axes[panel].lines}


class CommandLine(PlotTest):
    def test_draws_all_figures_with_something_in_them(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# x density velocity pressure specific_energy\n0 0 0 0 0\n1 1 1 1 1\n")
        result = plot(self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.pictures(),
                         ["bodies.png", "energies.png", "points.png", "positions.png", "profiles.png"])
        for name in self.pictures():
            self.assertGreater(coloured_share(self.folder / name), 1e-3, name)

    def test_draws_only_what_there_is_and_where_it_is_told(self):
        write_history(self.folder, bodies=False)
        other = self.folder / "deep" / "figures"
        result = plot(self.folder, "--out", other)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.pictures(other), ["energies.png"])
        self.assertEqual(self.pictures(), [])
        self.assertEqual(result.stdout.split(), [str(other / "energies.png")])

    def check_refused(self, *needles):
        result = plot(self.folder)
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

    def test_tells_that_it_cannot_write(self):
        write_history(self.folder)
        (self.folder / "taken").write_text("")
        result = plot(self.folder, "--out", self.folder / "taken")
        self.assertEqual(result.returncode, 4)
        self.assertIn("taken", result.stderr)


class Drawn(PlotTest):
    def test_energies_have_their_names_and_units(self):
        write_history(self.folder)
        figure = run_figures.energies(tether_results.open(self.folder))
        curves = self.lines(figure, 0)
        self.assertEqual(list(curves), ["kinetic", "total"])
        numpy.testing.assert_array_equal(curves["total"], numpy.column_stack([TIMES, 1 + TIMES]))
        self.assertEqual(figure.axes[0].get_ylabel(), "energy [J]")
        self.assertEqual(figure.axes[0].get_xlabel(), "time [s]")

    def test_exact_path_lies_over_its_own_point_only(self):
        write_history(self.folder)
        self.reference("# time point_y_2\n0 5\n1 7\n")
        figure = run_figures.points(tether_results.open(self.folder))
        self.assertEqual([axes.get_ylabel() for axes in figure.axes], ["x [m]", "y [m]", "vx [m s-1]", "vy [m s-1]"])
        self.assertEqual(list(self.lines(figure, 0)), ["point 1", "point 2"])
        curves = self.lines(figure, 1)
        self.assertEqual(list(curves), ["point 1", "point 2", "exact"])
        numpy.testing.assert_array_equal(curves["exact"], [[0, 5], [1, 7]])

    def test_bodies_have_the_names_of_the_file(self):
        write_history(self.folder)
        self.assertEqual(list(self.lines(run_figures.bodies(tether_results.open(self.folder)), 0)), ["gas"])

    def test_profiles_pair_each_field_with_its_exact_column(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# x density velocity pressure specific_energy\n0 1 2 3 4\n1 5 6 7 8\n")
        figure = run_figures.profiles(tether_results.open(self.folder))
        for panel, (factor, exact) in enumerate([(1, (1, 5)), (4, (2, 6)), (2, (3, 7)), (3, (4, 8))]):
            curves = self.lines(figure, panel)
            numpy.testing.assert_array_equal(curves["points"][:, 1], factor * PLACES)
            numpy.testing.assert_array_equal(curves["exact"][:, 1], exact)
        self.assertEqual(figure.axes[1].get_ylabel(), "velocity")

    def test_profiles_need_gas_and_an_exact_solution_over_x(self):
        write_history(self.folder)
        write_particles(self.folder)
        self.reference("# time point_y_1\n0 1\n")
        self.assertIsNone(run_figures.profiles(tether_results.open(self.folder)))
        write_particles(self.folder, gas=False)
        self.reference("# x density velocity pressure specific_energy\n0 1 2 3 4\n")
        self.assertIsNone(run_figures.profiles(tether_results.open(self.folder)))

    def test_positions_have_equal_scales_and_a_colour_for_each_body(self):
        write_history(self.folder)
        write_particles(self.folder)
        figure = run_figures.positions(tether_results.open(self.folder))
        self.addCleanup(run_figures.pyplot.close, figure)
        self.assertEqual([axes.get_title() for axes in figure.axes], ["time 0 s", "time 0.5 s", "time 1 s"])
        for axes in figure.axes:
            self.assertEqual(axes.get_aspect(), 1)
            self.assertEqual(len({line.get_color() for line in axes.lines}), 2)
            self.assertEqual(sum(len(line.get_xdata()) for line in axes.lines), len(PLACES))


if __name__ == "__main__":
    unittest.main()
