#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A strip that runs as one row of points (`reduce` of $mpm): its results are those of all rows, and what is no strip is
refused. That it costs less is `./quickstart bench`'s to say."""
import re
import unittest

import netCDF4
import numpy

from program import DECKS, ProgramTest, diagnostics, history, netcdf, run, sets, summary, without_cost

REDUCE = sets(mpm__reduce=".true.")
CLOSE = 1e-12  # of the largest number of its kind
METHODS = ("thesis", "robust")

# Keys of summary.txt that may differ: what was measured, what the row adds, losses that are rounding over rounding, and
# how points run, since a body of few points runs one by one.
OWN_KEYS = re.compile(r".*seconds|peak_memory_mb|ns_per_point_step|points_of_row|threads|energy_.*|mass_drift|points_by_lanes")

# A column that falls along y, on a wall; in x it is one cell of 0.1. Its points are neo-Hookean, or it is two bodies of
# linear laws, a piston on a fluid. Points across are 2, 3 or 4.
COLUMN = """a column that falls
$in
nx=2, ny=31, xleft=0., xright=.1, ybot=0., ytop=3., wl=6, wr=4, wb=0, wt=1, gravc=-1.,
tmax=.4, tstep=2.d-3, iout(13)=1, tiout(13)=.1, iout(33)=1, tiout(33)=.01, iout(39)=1, tiout(39)=.1
$
$reg
{regions}
$
$mpm method='{method}', contact='none' $
$points tracked_at(1,1)=0.,1.5, tracked_at(1,2)=.1,.0 $
"""
NEO_HOOKEAN = """nreg=1, nvi=4, xvi(1,1)=0.,.1,.1,0., yvi(1,1)=.1,.1,1.7,1.7, nprg=16, densir=1., matr(1,1)=200.,.3,
vry(1)=-.5, ipath(4,1)=0, law(1)='neo-hookean'"""
PISTON = """nreg=2, nvi=4,4, nprg=4,9, densir=1.,3., ipath(4,1:2)=8,0, matr(1,1)=100., matr(1,2)=300.,.2,
xvi(1,1)=0.,.1,.1,0., yvi(1,1)=0.,0.,2.,2., xvi(1,2)=0.,.1,.1,0., yvi(1,2)=2.,2.,2.4,2.4"""

# Gas in a shut tube along the radius, whose right half is hotter.
RADIAL = """gas along the radius
$in
nx=41, ny=2, xleft=0., xright=1., ybot=0., ytop=.04, wl=5, wr=6, wb=4, wt=6, cyl=1,
tmax=.2, tstep=1.d-3, iout(13)=1, tiout(13)=.1, iout(33)=1, tiout(33)=.01, iout(39)=1, tiout(39)=.1
$
$fluid gm1=.4, siep(1)=1., siep(2)=2., lambda=1., coef1=1., coef2=1. $
$reg
nreg=2, nvi=4,4, nprg=9,16, densir=1.,1., ipath(4,1:2)=9,9,
xvi(1,1)=0.,.5,.5,0., yvi(1,1)=0.,0.,.04,.04, xvi(1,2)=.5,1.,1.,.5, yvi(1,2)=0.,0.,.04,.04
$
$mpm method='{method}' $
"""


def kind_of(name):
    """Columns and fields whose numbers are judged by the largest of them all: parts of one vector, tensor or sum."""
    for kind in ("energy_", "momentum_", "strain_", "force_", "body_x|body_y", "body_v", "point_v", "point_x|point_y"):
        if re.match(kind, name):
            return kind
    return {"sxx": "stress", "syy": "stress", "sxy": "stress", "szz": "stress", "pressure": "stress", "vx": "velocity",
            "vy": "velocity", "angular_momentum_z": "momentum_"}.get(name, name)


def largest(numbers):
    """The largest size of numbers, by kind."""
    sizes = {}
    for name, values in numbers.items():
        sizes[kind_of(name)] = max(sizes.get(kind_of(name), 0), numpy.nanmax(numpy.abs(values), initial=0))
    return sizes


class Reduced(ProgramTest):
    def pair(self, deck, *options):
        """Runs a deck with all its rows and as one."""
        return self.run_ok(deck, *options, out="all"), self.run_ok(deck, *options, *REDUCE, out="row")

    def assert_same(self, rows, row):
        self.assert_close(history(rows), history(row))
        for name in ("particles.nc", "mesh.nc"):
            self.assert_close(netcdf(rows / name), netcdf(row / name))
        told, by_row = summary(rows), summary(row)
        for key in told:
            if not OWN_KEYS.fullmatch(key):
                self.assert_told(key, told[key], by_row[key])
        self.assertEqual(set(by_row) - set(told), {"points_of_row"})

    def assert_close(self, numbers, others):
        self.assertEqual(list(numbers), list(others))
        sizes = largest(numbers)
        for name, values in numbers.items():
            self.assertEqual(values.shape, others[name].shape, name)
            if values.dtype.kind == "f":
                numpy.testing.assert_allclose(others[name], values, rtol=0, atol=CLOSE * sizes[kind_of(name)], err_msg=name)
            else:
                numpy.testing.assert_array_equal(others[name], values, err_msg=name)

    def assert_told(self, key, one, other):
        try:
            self.assertAlmostEqual(float(one), float(other), delta=1e-10 * abs(float(one)), msg=key)
        except ValueError:
            self.assertEqual(one, other, key)

    def test_sod(self):
        for method in METHODS:
            with self.subTest(method=method):
                rows, row = self.pair(DECKS / "sod.in", *sets(mpm__method=method))
                self.assert_same(rows, row)
                self.assertEqual(summary(row)["points"], "900")
                self.assertEqual(summary(row)["points_by_lanes"], "900")
                self.assertEqual(summary(row)["points_of_row"], "300")

    def test_sod_with_other_densities(self):
        for deck in ("sod-cell.in", "sod-continuity.in"):
            with self.subTest(deck=deck):
                self.assert_same(*self.pair(DECKS / deck))

    def test_gas_along_a_radius(self):
        for method in METHODS:
            with self.subTest(method=method):
                rows, row = self.pair(self.write("radial.in", RADIAL.format(method=method)))
                self.assert_same(rows, row)
                self.assertEqual(summary(row)["points_of_row"], "140")

    def test_columns_along_y(self):
        for method in METHODS:
            for regions, points in ((NEO_HOOKEAN, 64), (PISTON, 52)):
                with self.subTest(method=method, points=points):
                    deck = self.write("column.in", COLUMN.format(method=method, regions=regions))
                    rows, row = self.pair(deck)
                    self.assert_same(rows, row)
                    self.assertEqual(summary(row)["points_of_row"], str(points))

    def test_points_stay_where_they_lie_across(self):
        deck = self.write("column.in", COLUMN.format(method="robust", regions=PISTON))
        rows, row = self.pair(deck)
        numpy.testing.assert_array_equal(netcdf(row / "particles.nc")["x"], netcdf(rows / "particles.nc")["x"])
        for name in ("point_x_1", "point_x_2"):
            numpy.testing.assert_array_equal(history(row)[name], history(rows)[name])

    def test_same_bits_whatever_the_threads_and_with_a_stop_in_between(self):
        for method in METHODS:
            options = (*REDUCE, *sets(**{"mpm__method": method, "in__iout(41)": 1, "in__tiout(41)": 0.05}))
            with self.subTest(method=method):
                one = self.run_ok(DECKS / "sod.in", *options, "--threads", 1, out="one")
                two = self.run_ok(DECKS / "sod.in", *options, "--threads", 2, out="two")
                checkpoint = sorted(one.glob("checkpoint-*.nc"))[0]
                later = self.run_ok(DECKS / "sod.in", *options, "--restart", checkpoint, out="later")
                for other in (two, later):
                    self.assertEqual((one / "history.txt").read_bytes(), (other / "history.txt").read_bytes())
                    for name in ("particles.nc", "mesh.nc"):
                        numbers = netcdf(other / name)
                        for variable, values in netcdf(one / name).items():
                            numpy.testing.assert_array_equal(numbers[variable], values, err_msg=variable)

    def test_a_restart_does_not_change_what_runs(self):
        options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.05})
        whole = self.run_ok(DECKS / "sod.in", *options)
        checkpoint = sorted(whole.glob("checkpoint-*.nc"))[0]
        result = self.expect(2, DECKS / "sod.in", *options, *REDUCE, "--restart", checkpoint, "--out", self.folder / "other")
        self.assertIn("mpm.reduce was .false. in the run of the checkpoint", result.stderr)


class Plan(ProgramTest):
    def plan(self, *options):
        return without_cost(self.expect(0, "plan", DECKS / "sod.in", *options).stdout)

    def test_says_what_runs(self):
        line = "  one row for all of a strip: 300 of 900 points run, each for up to 3 abreast; all are written"
        self.assertIn(line, self.plan(*REDUCE))
        self.assertLess(self.plan(*REDUCE).index(line), self.plan(*REDUCE).index("left out:"))

    def test_says_what_could(self):
        line = "  one row for all of a strip: reduce=.true. of $mpm would run 300 of 900 points, with the same results"
        self.assertIn(line, self.plan())
        self.assertNotIn("strip", " ".join(self.plan(*sets(in__wb=0, reference__solution="''"))))

    def test_counts_the_points_that_run(self):
        steps = [re.search(r"([0-9.e+]+) point-steps", self.expect(0, "plan", DECKS / "sod.in", *options).stdout)[1]
                 for options in ((), REDUCE)]
        self.assertAlmostEqual(float(steps[1]) / float(steps[0]), 1 / 3, delta=1e-3)


class Refused(ProgramTest):
    """What is no strip, by Sod's tube with one change: (the change, words of the message)."""

    def refused(self, deck, words, *options):
        out = self.folder / "refused"
        result = self.expect(2, deck, "--quiet", "--out", out, *options)
        heads = [head for head, more in diagnostics(result.stderr) if words in "\n".join([head["text"], *more])]
        self.assertTrue(heads, result.stderr)
        self.assertIn("no strip that one row of points stands for", heads[0]["text"])
        self.assertFalse(out.exists())
        return heads[0]

    def test_with_its_place(self):
        text = (DECKS / "sod.in").read_text().replace("wb=6", "wb=0").replace("$reference", "$mpm\n reduce=.true.\n$\n$reference")
        head = self.refused(self.write("sod.in", text), "the bottom wall")
        line = 1 + text.splitlines().index(" reduce=.true.")
        self.assertEqual((int(head["line"]), int(head["column"])), (line, 9))

    def test_changes_of_sod(self):
        cases = (({"in__wb": 0}, "the bottom wall, along the strip, does not let it slip (wb=0)"),
                 ({"in__wt": 1}, "the top wall"),
                 ({"in__gravc": -1}, "gravc = -1 acts across it"),
                 ({"in__ny": 3}, "several cells lie across: the grid has 100 x 2"),
                 ({"reg__vry(2)": 0.1}, "moves across it, at 0.1"),
                 ({"reg__yvi(3,2)": 0.007, "reg__yvi(4,2)": 0.007}, "do not lie in pairs about the strip's middle, y = 0.005"),
                 ({"reg__xvi(2,1)": 0.496, "reg__xvi(1,2)": 0.504}, "do not lie in pairs"),
                 ({"mpm__edge(2)": "'outflow'", "reference__solution": "''"}, "gas passes an edge of the grid"))
        for change, words in cases:
            with self.subTest(change=change):
                self.refused(DECKS / "sod.in", words, *REDUCE, *sets(**change))

    def test_contact(self):
        text = COLUMN.format(method="robust", regions=PISTON).replace(", contact='none'", ", reduce=.true.")
        self.refused(self.write("column.in", text), "contact acts where points of two bodies meet")

    def test_a_string(self):
        text = COLUMN.format(method="robust", regions=NEO_HOOKEAN).replace(
            "$points", "$membrane curve(1)='line', x(1,1)=.05,.05, y(1,1)=2.2,2.8, count(1)=20, thickness(1)=.01, "
            "density(1)=1., young(1)=10. $\n$points")
        self.refused(self.write("column.in", text), "membrane", *REDUCE)

    def test_columns_about_an_axis(self):
        text = COLUMN.format(method="thesis", regions=NEO_HOOKEAN).replace("gravc=-1.", "cyl=1").replace("wl=6", "wl=5")
        self.refused(self.write("column.in", text), "points of several radii abreast", *REDUCE)

    def test_points_of_a_file(self):
        """Rows of a file run as one where they are alike; one of another velocity or a heavy one stands out."""
        rows = [f"{0.125 + 0.25 * i} {y} {vx} 0. 0. 0. 0." for y, vx in ((0.25, 1.0), (0.75, 1.0)) for i in range(12)]
        head = ("points of a file\n$in nx=6, ny=2, igen=0, xleft=0., xright=5., ybot=0., ytop=1., wb=6, wt=6, tmax=.5, "
                "tstep=1.d-2, iout(33)=1, tiout(33)=.1, iout(13)=1, tiout(13)=.1, iout(39)=1, tiout(39)=.1 $\n{groups}\n"
                "1.0\n100.,.3,0.,0.,0.,0.,0.\n3,3,3,0\n24\n24,8\n")
        deck = self.write("alike.in", head.format(groups="$mpm $") + "\n".join(rows) + "\n")
        self.assertEqual(summary(self.run_ok(deck, *REDUCE))["points_of_row"], "12")
        one = rows[:-1] + [rows[-1].replace("1.0 0.", "1.5 0.")]
        self.refused(self.write("one.in", head.format(groups="$mpm $") + "\n".join(one) + "\n"),
                     "abreast, differ in vx: 1 and 1.5", *REDUCE)
        heavy = head.format(groups="$points heavy(3)=.1 $") + "\n".join(rows) + "\n"
        self.refused(self.write("heavy.in", heavy), "abreast, differ in mass", *REDUCE)


if __name__ == "__main__":
    unittest.main()
