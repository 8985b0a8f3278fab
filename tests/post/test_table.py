# SPDX-License-Identifier: GPL-3.0-or-later
"""post/table.py on a table made here: which lines are drawn, and what is refused."""
import sys
import tempfile
import unittest
from pathlib import Path

import netCDF4
import numpy

POST = Path(__file__).resolve().parents[2] / "post"
sys.path.insert(0, str(POST))

import table
from called import FULL, call

NAN = float("nan")
NUMBERS = {"in.nx": [21, 11, 21, 11, 41], "error": [-1, 2, 3, 4, NAN], "cpu_seconds": [1, 2, 3, 4, 5]}
ORDERS = ["musl", "musl", "usl", "usl", "usl"]


def write_table(path, rows=5):
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.createDimension("run", None)
        data.createDimension("length", 4)
        data.createDimension("other", 2)
        for name, values in NUMBERS.items():
            data.createVariable(name, "f8", ("run",))[:rows] = values[:rows]
        data["cpu_seconds"].units = "s"
        data["in.nx"].long_name = "deck value"
        texts = data.createVariable("mpm.order", "S1", ("run", "length"))
        data.title = "A study of one thing. And more."
        if rows:
            texts[:rows] = netCDF4.stringtochar(numpy.array(ORDERS[:rows], "S4"))
        data.createVariable("body_x", "f8", ("run", "other"))


class TableTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.table = self.folder / "table.nc"
        write_table(self.table)

    def drawn(self, *words):
        """The axes, and its curves by label as lists of (x, y)."""
        chosen = table.complete(self.table, table.arguments([str(self.table), *words]))
        figure = table.draw(*table.read(self.table), chosen)
        self.addCleanup(table.pyplot.close, figure)
        (axes,) = figure.axes
        return axes, {line.get_label(): line.get_xydata().tolist() for line in axes.lines}

    def test_a_line_for_each_text_along_x(self):
        axes, curves = self.drawn("--x", "in.nx", "--y", "error", "--by", "mpm.order")
        self.assertEqual(curves, {"musl": [[11, 2], [21, -1]], "usl": [[11, 4], [21, 3]]})
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("in.nx", "error"))
        self.assertEqual(axes.get_legend().get_title().get_text(), "mpm.order")

    def test_a_line_for_each_number(self):
        _, curves = self.drawn("--x", "cpu_seconds", "--y", "error", "--by", "in.nx")
        self.assertEqual(curves, {"21": [[1, -1], [3, 3]], "11": [[2, 2], [4, 4]], "41": []})

    def test_one_line_without_by(self):
        axes, curves = self.drawn("--x", "cpu_seconds", "--y", "error")
        self.assertEqual(list(curves.values()), [[[1, -1], [2, 2], [3, 3], [4, 4]]])
        self.assertEqual(axes.get_xlabel(), "cpu_seconds [s]")
        self.assertIsNone(axes.get_legend())

    def test_logarithmic_scales_show_sizes(self):
        axes, curves = self.drawn("--x", "cpu_seconds", "--y", "error", "--log")
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        self.assertEqual(list(curves.values())[0][0], [1, 1])

    def test_alone_has_each_quantity_over_the_first_axis(self):
        axes, curves = self.drawn()
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("in.nx", "error"))
        self.assertEqual(list(curves.values()), [[[11, 2], [11, 4], [21, -1], [21, 3]]])
        result = call("plot", self.folder)
        self.assertEqual((result.returncode, result.stdout.strip()), (0, str(self.folder / "table.png")), result.stderr)
        self.assertIn("A study of one thing", table.command.title_of(self.table))

    def test_writes_the_figure_where_it_is_told(self):
        for words, path in (([], self.folder / "error-over-in.nx.png"),
                            (["--out", self.folder / "deep" / "f.png"], self.folder / "deep" / "f.png")):
            result = call("table", self.table, "--x", "in.nx", "--y", "error", *words, alone=FULL or not words)
            self.assertEqual((result.returncode, result.stdout.strip()), (0, str(path)), result.stderr)
            self.assertGreater(path.stat().st_size, 1000)

    def check_refused(self, code, needle, *words):
        result = call("table", self.table, *words)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn(needle, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual(list(self.folder.glob("*.png")), [])

    def test_refuses_what_is_no_column(self):
        self.check_refused(2, "no column in.ny; there are in.nx", "--x", "in.ny", "--y", "error")
        self.check_refused(2, "no column body_x", "--x", "body_x", "--y", "error")
        self.check_refused(2, "mpm.order holds no numbers", "--x", "mpm.order", "--y", "error")
        self.check_refused(2, "no column dt", "--x", "in.nx", "--y", "error", "--by", "dt")

    def test_refuses_a_table_without_rows(self):
        write_table(self.table, rows=0)
        self.check_refused(2, "no row has both in.nx and error", "--x", "in.nx", "--y", "error")

    def test_refuses_what_is_no_table(self):
        self.table.write_text("a,b\n1,2\n")
        self.check_refused(2, "cannot be read as NetCDF", "--x", "a", "--y", "b")

    def test_tells_that_it_cannot_write(self):
        (self.folder / "taken").write_text("")
        self.check_refused(4, "taken", "--x", "in.nx", "--y", "error", "--out", self.folder / "taken" / "f.png")


if __name__ == "__main__":
    unittest.main()
