# SPDX-License-Identifier: GPL-3.0-or-later
"""particles/write_curve.py: a run from the file that it writes begins as the run from the curves themselves."""
import subprocess
import sys
import unittest

import numpy

from program import ROOT, TETHER, ProgramTest, netcdf

SCRIPT = ROOT / "particles/write_curve.py"

# A quarter of an ellipse and a line joined to it as membrane 2, a spline as membrane 1; at places of no round numbers.
DECK = """membranes of curves
$in
 nx=17, ny=15, igen=3, {more}
 xleft=0.0, xright=1.6, ybot=0.0, ytop=1.3,
 tmax=0.01, tstep=1.d-4
$
$membrane
 curve(1)='ellipse', body(1)=2, a(1)=1.1, b(1)=0.7, from(1)=90.0, to(1)=20.0,
 curve(2)='spline', x(1,2)=0.1,0.5,0.8,1.5, y(1,2)=0.1,0.3,1.2,1.1,
 curve(3)='line', body(3)=2, x(1,3)=1.0336618828644997,1.3, y(1,3)=0.23941410032796817,0.2,
 count(1)=23, spacing(2)=0.04, {ends}
 thickness(1)=0.013,0.017, density(1)=0.3,0.7, young(1)=1.d3,2.d3, poisson(1)=0.0,0.1,
 law(2)='plane-stress'
$
"""

# The same scene, with its membrane in a particle file.
DECK_OF_FILE = """a membrane of a file
$in
 nx=17, ny=15, igen=0, {more}
 xleft=0.0, xright=1.6, ybot=0.0, ytop=1.3,
 tmax=0.01, tstep=1.d-4, iout(13)=1, tiout(13)=1.0
$
$membrane
 law(1)='{law}'
$
"""


class WriteCurve(ProgramTest):
    def written(self, deck, b, code=0):
        result = subprocess.run([sys.executable, SCRIPT, deck, str(b), "--tether", TETHER], capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def deck(self, more="", ends="", of=DECK):
        return self.write("curves.in", of.format(more=more, ends=ends))

    def first_points(self, deck, body, *options, out):
        """x, y, mass and volume of a body's points at the start."""
        points = netcdf(self.run_ok(deck, *options, out=out) / "particles.nc")
        there = points["body"][0] == body
        return [points[name][0][there] for name in ("x", "y", "mass", "volume")]

    def assert_file_is_the_curve(self, more, b, law):
        deck = self.deck(more=more)
        snapshots = ["--set", "in.iout(13)=1", "--set", "in.tiout(13)=1.0"]
        seeded = self.first_points(deck, b, *snapshots, out="curves")  # no other bodies: membrane b is body b
        file = self.write("curve.par", self.written(deck, b).stdout)
        read = self.first_points(self.write("file.in", DECK_OF_FILE.format(more=more, law=law)), 1, "--particles", file,
                                 out="file")
        self.assertGreater(len(seeded[0]), 20)
        for one, other in zip(seeded, read, strict=True):
            numpy.testing.assert_allclose(other, one, rtol=1e-12, atol=0)
        return seeded

    def test_in_the_plane(self):
        x, _, mass, volume = self.assert_file_is_the_curve("", 1, "uniaxial")
        self.assertEqual(len(x), 23)
        numpy.testing.assert_allclose(mass, 0.3 * volume, rtol=1e-15)
        self.assert_file_is_the_curve("", 2, "plane-stress")

    def test_about_an_axis(self):
        x, _, _, volume = self.assert_file_is_the_curve("cyl=1.0, wl=5,", 2, "plane-stress")
        numpy.testing.assert_allclose(volume / x, volume[0] / x[0], rtol=1e-14)

    def test_the_file_has_the_curve_s_constants(self):
        lines = self.written(self.deck(), 2).stdout.splitlines()
        self.assertEqual(lines[0].split("!")[0].strip(), "0.7")
        self.assertEqual(lines[1].split("!")[0].strip(), "2000.0,0.1,0.0,0.0,0.0,0.0,0.0")
        self.assertEqual(lines[2], "3,3,3,8")

    def test_what_a_file_cannot_say(self):
        pinned = self.written(self.deck(ends="pinned(1)='first',"), 1, code=2)
        self.assertIn("membrane 1 is pinned", pinned.stderr)
        ring = DECK.replace("curve(2)='spline'", "curve(4)='arc', xc(4)=0.5, yc(4)=0.5, a(4)=0.4").replace("count(1)=23", "count(1)=60").replace(
            "x(1,2)=0.1,0.5,0.8,1.5, y(1,2)=0.1,0.3,1.2,1.1,", "")
        closed = self.written(self.deck(of=ring), 1, code=2)
        self.assertIn("membrane 1 is closed", closed.stderr)
        self.assertEqual((pinned.stdout, closed.stdout), ("", ""))

    def test_mistakes(self):
        absent = self.written(self.deck(), 3, code=2)
        self.assertIn("has no membrane 3 of curves; its bodies: membrane 1, membrane 2", absent.stderr)
        wrong = self.written(self.deck(more="nz=1,"), 1, code=2)
        self.assertIn("$in has no variable 'nz'", wrong.stderr)


if __name__ == "__main__":
    unittest.main()
