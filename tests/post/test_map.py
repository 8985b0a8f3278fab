# SPDX-License-Identifier: GPL-3.0-or-later
"""post/map.py and post/report.py on maps and charts made here: what is drawn, what stands on the page, what is refused."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

import netCDF4
import numpy

POST = Path(__file__).resolve().parents[2] / "post"
sys.path.insert(0, str(POST))

import map as stability_map
from called import call

NAN = float("nan")
VERDICTS = {"square": [1, 2, 3, 4, 5, 6], "in.xleft": [0, 1, 2, 0, 1, 2], "mpm.cfl": [1, 1, 1, 2, 2, 2],
            "verdict": ["holds", "holds", "holds", "holds", "grows", "inverts"], "holds": [1, 1, 1, 1, 0, 0], "own_run": [1, 0, 1, 1, 1, 0], "theory": [NAN, 1.5, 1.4, NAN, NAN, NAN]}
BISECTED = {"square": [1, 2, 3, 4], "in.nx": [5, 9, 5, 9], "mpm.order": ["musl", "musl", "usl", "usl"], "verdict": ["found"] * 4,
            "largest_holding": [2, 2.1, 1, 1.1], "smallest_failing": [2.2, 2.3, 1.2, 1.3], "theory": [2.1, 2.2, NAN, NAN]}
CHART = {"family": ["points", "points"], "of": ["cells", "cells"], "size": [.1, .05], "error": [.04, .02], "lasting_error": [.04, .02],
         "cpu_seconds": [1, 2], "peak_memory_mb": [20, 30]}


def write(path, columns, title="a <map> & more"):
    path.parent.mkdir(parents=True, exist_ok=True)
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.setncatts({"title": title, "history": "tether map x.in", "deck": "x <deck>", "program": "tether 1", "git_hash": "abc"})
        data.createDimension("square", len(next(iter(columns.values()))))
        data.createDimension("length", 24)
        for name, values in columns.items():
            if isinstance(values[0], str):
                data.createVariable(name, "S1", ("square", "length"))[:] = netCDF4.stringtochar(numpy.array(values, "S24"))
            else:
                data.createVariable(name, "f8", ("square",))[:] = values
        if "largest_holding" in columns:
            data["largest_holding"].long_name = "largest mpm.cfl that holds"
    path.with_suffix(".csv").write_text("".join(",".join(row) + "\n" for row in [list(columns)] + [list(map(str, row)) for row in zip(*columns.values())]))
    path.with_suffix(".txt").write_text("the border <here>\n")
    return path


class MapTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def draw(self, columns):
        return stability_map.draw(*stability_map.read(write(self.folder / "map.nc", columns)))

    def test_squares_have_the_colour_of_their_verdict_and_runs_a_dot(self):
        axes = self.draw(VERDICTS).axes[0]
        names = list(stability_map.VERDICTS)
        self.assertEqual([names[int(k)] for k in axes.collections[0].get_array().ravel()], VERDICTS["verdict"])
        dots = axes.lines[0]
        self.assertEqual(sorted(zip(dots.get_xdata(), dots.get_ydata())), [(0, 1), (0, 2), (1, 2), (2, 1)])
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("in.xleft", "mpm.cfl"))
        theory = {line.get_label(): line for line in axes.lines}["theory"]
        self.assertEqual(list(theory.get_ydata())[1:], [1.5, 1.4])
        shown = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(shown, ["holds", "grows", "inverts", "theory"])

    def test_bisected_values_are_lines_next_to_theory(self):
        axes = self.draw(BISECTED).axes[0]
        drawn = {line.get_label(): [round(float(y), 9) for y in line.get_ydata()] for line in axes.lines if len(line.get_ydata())}
        self.assertEqual(drawn, {"musl": [2.1, 2.2], "theory": [2.1, 2.2], "usl": [1.1, 1.2]})
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("in.nx", "largest mpm.cfl that holds"))

    def test_where_all_values_hold_the_end_is_hollow(self):
        axes = self.draw({**BISECTED, "smallest_failing": [2.2, NAN, 1.2, 1.3], "verdict": ["found", "both ends hold", "not yet", "found"]}).axes[0]
        hollow = [line for line in axes.lines if line.get_marker() == "^" and len(line.get_xdata())]
        self.assertEqual([(list(line.get_xdata()), list(line.get_ydata())) for line in hollow], [([9], [2.1])])
        usl = {line.get_label(): line for line in axes.lines}["usl"]
        self.assertTrue(numpy.isnan(usl.get_ydata()[0]))  # it was not found

    def test_theory_beyond_an_axis_is_not_drawn(self):
        axes = self.draw({**VERDICTS, "theory": [NAN, 9., 1.4, NAN, NAN, NAN]}).axes[0]
        theory = {line.get_label(): line for line in axes.lines}["theory"]
        self.assertTrue(numpy.isnan(theory.get_ydata()[1]))

    def test_the_figure_stands_next_to_the_map(self):
        path = write(self.folder / "map.nc", VERDICTS)
        result = call("map", path, alone=True)
        self.assertEqual((result.returncode, result.stdout.strip()), (0, str(path.with_suffix(".svg"))), result.stderr)
        self.assertEqual(call("map", path, "--out", "/dev/null/map.svg").returncode, 4)

    def test_what_is_no_map_is_refused(self):
        result = call("map", write(self.folder / "table.nc", CHART))
        self.assertEqual(result.returncode, 2)
        self.assertIn("is no map of tether map", result.stderr)

    def test_a_page_has_all_of_charts_and_maps_and_needs_no_other_file(self):
        write(self.folder / "one/map.nc", VERDICTS)
        write(self.folder / "two/chart.nc", CHART, "a chart")
        out = self.folder / "page/report.html"
        result = call("report", self.folder / "one", self.folder / "two", "--out", out, alone=True)
        self.assertEqual((result.returncode, result.stdout.strip()), (0, str(out)), result.stderr)
        page = out.read_text()
        for text in ("one (map)", "two (chart)", "a &lt;map&gt; &amp; more", "the border &lt;here&gt;", "x &lt;deck&gt;", "tether map x.in", "tether 1, abc", "<td>inverts</td>"):
            self.assertIn(text, page)
        self.assertEqual(page.count('src="data:image/svg+xml;base64,'), 2)
        self.assertFalse(re.search(r'(src|href)="(?!data:|#)', page))

    def test_a_chart_without_errors_has_its_words_on_the_page(self):
        write(self.folder / "one/chart.nc", {**CHART, "error": [NAN, NAN]})
        out = self.folder / "report.html"
        self.assertEqual(call("report", self.folder / "one", "--out", out).returncode, 0)
        self.assertIn("no run has an error that a logarithm shows", out.read_text())

    def test_hatches_fill_their_squares_on_any_scale(self):
        cells = {**VERDICTS, "in.xleft": [.01, .1, 1., .01, .1, 1.]}
        axes = self.draw(cells).axes[0]
        corners = axes.collections[1].get_paths()[0].vertices
        for got, want in zip((corners[:, 0].min(), corners[:, 0].max()), (.1 / 10**.5, .1 * 10**.5)):
            self.assertAlmostEqual(got, want, places=9)

    def test_folders_of_one_name_have_links_of_their_own(self):
        for part in ("charts", "maps"):
            write(self.folder / part / "sod/map.nc", VERDICTS)
        out = self.folder / "report.html"
        self.assertEqual(call("report", self.folder / "charts/sod", self.folder / "maps/sod", "--out", out).returncode, 0)
        ids = re.findall(r'<h2 id="([^"]*)"', out.read_text())
        self.assertEqual(len(set(ids)), 2)
        self.assertEqual(re.findall(r'href="#([^"]*)"', out.read_text()), ids)

    def test_a_folder_that_lacks_a_file_is_refused(self):
        write(self.folder / "one/map.nc", VERDICTS).with_suffix(".csv").unlink()
        result = call("report", self.folder / "one", "--out", self.folder / "report.html")
        self.assertEqual((result.returncode, "Traceback" in result.stderr), (2, False), result.stderr)

    def test_folders_without_either_are_refused(self):
        (self.folder / "none").mkdir()
        result = call("report", self.folder / "none")
        self.assertEqual(result.returncode, 2)
        self.assertIn("no chart.nc and no map.nc", result.stderr)


if __name__ == "__main__":
    unittest.main()
