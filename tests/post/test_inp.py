# SPDX-License-Identifier: GPL-3.0-or-later
"""post/inp.py makes a mesh file of an .inp, and a deck runs on it with its sets as regions and sides."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

from called import FULL, call

ROOT = pathlib.Path(__file__).resolve().parents[2]

PLATE = """*HEADING
a plate of two parts
*NODE, NSET=NALL
1, 0., 0.
2, 1., 0.
3, 2., 0.
4, 0., 1.
5, 1., 1.
6, 2., 1.
*ELEMENT, TYPE=CPS4, ELSET=LEFT
1, 1, 2, 5, 4
*ELEMENT, TYPE=CPS4, ELSET=RIGHT
2, 2, 3, 6, 5
*NSET, NSET=CLAMP
1, 4
*NSET, NSET=PULL
3, 6
*NSET, NSET=TIP
6
*ELSET, ELSET=ALL
LEFT, RIGHT
"""

# A stretch of sigma/E = .1 in the left half and half of it in the right one, which is twice as stiff.
DECK = """two parts in a row
$in nx=2, ny=2, xleft=0., xright=3., ybot=0., ytop=1., tmax=1., tstep=1., wl=1, wr=1, wb=1, wt=1 $
$reg nreg=2, densir=1.,1., matr(1,1)=1.,0., matr(1,2)=2.,0. $
$mesh file='plate.msh', physical='LEFT','RIGHT' $
$fem static=.true., law='linear','linear', fix_on(1)='CLAMP', fix(1:2,1)=0.,0., load_on(1)='PULL', load(1,1)=.1 $
$points tracked_at(1,1)=1.,0., tracked_at(1,2)=2.,1. $
"""


class Inp(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def convert(self, code, *words, alone=FULL):
        done = call("inp", *words, alone=alone)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def run_deck(self):
        """The last line of the history of the deck's run."""
        subprocess.run([os.environ["TETHER"], self.folder / "plate.in", "--quiet", "--out", self.folder / "out"], check=True)
        names, *_, last = (self.folder / "out/history.txt").read_text().splitlines()
        return dict(zip(names.removeprefix("# ").split(), map(float, last.split())))

    def test_a_deck_runs_with_its_sets(self):
        (self.folder / "plate.inp").write_text(PLATE)
        (self.folder / "plate.in").write_text(DECK)
        done = self.convert(0, self.folder / "plate.inp", alone=True)
        self.assertIn("region 'LEFT', region 'RIGHT', side 'CLAMP', side 'PULL', nodes 'TIP'", done.stdout)
        self.assertIn("the element set ALL is left without elements", done.stdout)
        end = self.run_deck()
        self.assertAlmostEqual(end["point_x_1"], 1.1, 9)
        self.assertAlmostEqual(end["point_x_2"], 2.15, 9)

    def test_a_set_is_a_side_where_it_has_no_other_nodes(self):
        text = PLATE.replace("3, 6\n*NSET, NSET=TIP\n6", "3, 6, 1\n*NSET, NSET=TIP\n6\n*NSET, NSET=EVERY\n1, 2, 3, 4, 5, 6")
        (self.folder / "plate.inp").write_text(text)
        done = self.convert(0, self.folder / "plate.inp")
        for name in ("side 'CLAMP'", "nodes 'PULL'", "nodes 'TIP'", "side 'EVERY'"):
            self.assertIn(name, done.stdout)

    def test_loads_and_supports_act_on_nodes(self):
        (self.folder / "plate.inp").write_text(PLATE)
        deck = DECK.replace("load_on(1)='PULL', load(1,1)=.1", "load_on(1)='TIP', load(1:2,1)=.01,-.02, fix_on(2)='TIP', fix(2,2)=0.")
        (self.folder / "plate.in").write_text(deck)
        self.convert(0, self.folder / "plate.inp")
        end = self.run_deck()
        for column, force in (("support_force_x_1", -0.01), ("support_force_x_2", 0)):
            self.assertAlmostEqual(end[column], force, 10)
        self.assertAlmostEqual(end["support_force_y_1"] + end["support_force_y_2"], 0.02, 10)
        (self.folder / "plate.in").write_text(deck.replace("load(1:2,1)=.01,-.02", "pressure(1)=1."))
        done = subprocess.run([os.environ["TETHER"], self.folder / "plate.in"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("the pressure of load 1 has no side to push against", done.stderr)

    def test_tetrahedra_of_10_nodes(self):
        tetrahedra = ((0, 1, 2, 4), (3, 2, 1, 7), (5, 4, 7, 1), (6, 7, 4, 2), (1, 2, 4, 7))
        places = [tuple(float(n >> k & 1) for k in range(3)) for n in range(8)]
        number = {place: n for n, place in enumerate(places, 1)}
        lines = []
        for corners in tetrahedra:
            corner = [places[n] for n in corners]
            if numpy.linalg.det(numpy.subtract(corner[1:], corner[0])) < 0:
                corner[2], corner[3] = corner[3], corner[2]
            middles = [tuple((a + b) / 2 for a, b in zip(corner[i], corner[j]))
                       for i, j in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
            lines.append(", ".join(str(number.setdefault(at, len(number) + 1)) for at in corner + middles))
        text = ["*HEADING", "a cube", "*NODE, NSET=NALL", *(f"{n}, {x}, {y}, {z}" for (x, y, z), n in number.items()),
                "*ELEMENT, TYPE=C3D10, ELSET=CUBE", *(f"{n}, {line}" for n, line in enumerate(lines, 1))]
        for name, axis, at in (("CLAMP", 0, 0.0), ("PULL", 0, 1.0)):
            text += [f"*NSET, NSET={name}", ", ".join(str(n) for place, n in number.items() if place[axis] == at)]
        (self.folder / "plate.inp").write_text("\n".join([*text, ""]))
        deck = DECK.replace("nreg=2, densir=1.,1.,", "nreg=1, densir=1.,").replace(", matr(1,2)=2.,0.", "")
        deck = deck.replace("physical='LEFT','RIGHT'", "physical='CUBE'").replace("'linear','linear'", "'linear'")
        deck = deck.replace("fix(1:2,1)=0.,0.", "fix(1:3,1)=0.,0.,0.").replace(", tracked_at(1,2)=2.,1.", "")
        (self.folder / "plate.in").write_text(deck)
        self.convert(0, self.folder / "plate.inp")
        self.assertAlmostEqual(self.run_deck()["point_x_1"], 1.1, 9)

    def test_what_cannot_be_read_is_reported(self):
        self.assertIn("there is no such file", self.convert(2, self.folder / "none.inp").stderr)
        (self.folder / "odd.inp").write_text(PLATE.replace("CPS4", "M3D9"))
        self.assertIn("meshio cannot read it", self.convert(2, self.folder / "odd.inp").stderr)
        (self.folder / "plate.inp").write_text(PLATE)
        self.convert(4, self.folder / "plate.inp", "--out", self.folder / "none" / "plate.msh")


if __name__ == "__main__":
    unittest.main()
