# SPDX-License-Identifier: GPL-3.0-or-later
"""post/chart.py on a chart made here: which runs none beats, what is drawn, and what is refused."""
import sys
import tempfile
import unittest
from pathlib import Path

import netCDF4
import numpy

POST = Path(__file__).resolve().parents[2] / "post"
sys.path.insert(0, str(POST))

import chart
from called import call

NAN = float("nan")
FAMILIES = ["points", "points", "points", "elements", "elements", "elements"]
OF = ["cells", "cells", "cells", "cells", "cells", "steps"]
NUMBERS = {"size": [.1, .05, .025, .1, .05, .01], "error": [.04, .02, .01, .03, .001, NAN],
           "lasting_error": [.04, .02, .01, .03, .001, NAN], "cpu_seconds": [1, 2, 8, 3, 6, 5], "peak_memory_mb": [20, 30, 40, 50, 60, 60]}


def write_chart(path, numbers):
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.createDimension("run", len(OF))
        data.createDimension("length", 8)
        for name, values in numbers.items():
            data.createVariable(name, "f8", ("run",))[:] = values
        for name, values in (("family", FAMILIES), ("of", OF)):
            data.createVariable(name, "S1", ("run", "length"))[:] = netCDF4.stringtochar(numpy.array(values, "S8"))


class ChartTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_the_front_has_the_runs_that_none_beats(self):
        best = chart.front(numpy.array(NUMBERS["cpu_seconds"], float), numpy.array(NUMBERS["error"], float))
        self.assertEqual(best, [0, 1, 4])

    def test_each_family_is_a_line_and_the_front_joins_the_best(self):
        write_chart(self.folder / "chart.nc", NUMBERS)
        figure = chart.draw(chart.read(self.folder / "chart.nc"))
        seconds, memory, size, names = figure.axes
        self.assertEqual([text.get_text() for text in names.get_legend().get_texts()], ["none beats these", "points", "elements"])
        drawn = {line.get_label(): (list(line.get_xdata()), list(line.get_ydata())) for line in seconds.lines}
        self.assertEqual(drawn["points"], ([1, 2, 8], [.04, .02, .01]))
        self.assertEqual(drawn["elements"], ([3, 6], [.03, .001]))
        self.assertEqual(drawn["none beats these"], ([1, 2, 6], [.04, .02, .001]))
        self.assertEqual(memory.get_xlabel(), "memory [MB]")
        self.assertEqual([list(line.get_xdata()) for line in size.lines], [[.1, .05, .025], [.1, .05]])
        self.assertEqual(len({line.get_color() for line in size.lines}), 2)
        self.assertEqual(len({line.get_marker() for line in size.lines}), 2)

    def test_the_figure_stands_beside_the_chart(self):
        write_chart(self.folder / "chart.nc", NUMBERS)
        result = call("chart", self.folder / "chart.nc", alone=True)
        self.assertEqual((result.returncode, result.stdout.strip()), (0, str(self.folder / "chart.svg")), result.stderr)
        self.assertIn("<svg", (self.folder / "chart.svg").read_text())

    def test_what_is_no_chart_is_refused(self):
        write_chart(self.folder / "table.nc", {name: values for name, values in NUMBERS.items() if name != "error"})
        result = call("chart", self.folder / "table.nc")
        self.assertEqual(result.returncode, 2)
        self.assertIn("is no chart: it has no error", result.stderr)
        write_chart(self.folder / "failed.nc", {**NUMBERS, "error": [NAN] * 6})
        self.assertEqual(call("chart", self.folder / "failed.nc").returncode, 2)
        self.assertEqual(call("chart", self.folder / "none.nc").returncode, 2)

    def test_a_figure_that_cannot_be_written_is_told(self):
        write_chart(self.folder / "chart.nc", NUMBERS)
        result = call("chart", self.folder / "chart.nc", "--out", "/dev/null/chart.svg")
        self.assertEqual(result.returncode, 4)


if __name__ == "__main__":
    unittest.main()
