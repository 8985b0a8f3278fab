# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs on meshes from files: what they leave runs again to the same numbers, and another mesh is told."""
import shutil
import unittest

from program import DECKS, ROOT, ProgramTest, diagnostics, history, run, sets

DECK = """a square that rings
$in
nx=2, ny=2, xleft=-1., xright=9., ybot=-1., ytop=9., wl=1, wr=1, wb=1, wt=1,
tmax=1., tstep=.1, iout(33)=1, tiout(33)=.1, iout(41)=1, tiout(41)=.5
$
$reg nreg=1, densir(1)=1., matr(1,1)=10.,.3 $
$mesh file='plate.msh', physical(1)='plate' $
$fem fix_on(1)='left', fix(1,1)=0.,0., load_on(1)='physical 8', load(2,1)=1., load_expression(1)='sin(2*pi*t)' $
$points tracked_at(1,1)=2.,1. $
"""


FLAG = """a flag that is a block, at a cylinder of a mesh file
$in
nx=2, ny=2, xleft=0., xright=2.2, ybot=0., ytop=.41, wl=1, wr=1, wb=1, wt=1,
tmax=.03, tstep=.005, iout(33)=1, tiout(33)=.005, iout(41)=1, tiout(41)=.015
$
$reg nreg=2, densir=1000.,1000., matr(1,1)=1., matr(1,2)=1.4e6,.4, nvi(2)=4,
xvi(1,2)=.24899,.4,.4,.24899, yvi(1,2)=.19,.19,.21,.21 $
$mesh file='plate.msh', physical(1)='fluid', element='q2', cells(1,2)=20,4, edge(4,2)='arc', edge_xc(4,2)=.2,
edge_yc(4,2)=.2 $
$fem law='fluid','svk', fix_on='2.left', fix(1,1)=0.,0. $
$flow boundary_on='inflow','outflow', boundary='inflow','open', boundary_u='1.2*y*(.41-y)/.41^2', force_on='cylinder' $
"""


class MeshFiles(ProgramTest):
    def setUp(self):
        super().setUp()
        self.deck = self.write("ring.in", DECK)
        self.mesh = self.folder / "plate.msh"
        shutil.copy(ROOT / "tests" / "meshes" / "plate-22.msh", self.mesh)

    def test_a_run_leaves_all_that_it_takes_to_run_again(self):
        first = self.run_ok(self.deck)
        self.assertEqual((first / "deck.effective.msh").read_bytes(), self.mesh.read_bytes())
        self.assertGreater(abs(history(first)["point_y_1"] - 1).max(), 1e-3)
        self.mesh.unlink()
        second = self.run_ok(first / "deck.effective", out="again")
        self.assertEqual((second / "history.txt").read_bytes(), (first / "history.txt").read_bytes())
        self.assertEqual((second / "deck.effective").read_bytes(), (first / "deck.effective").read_bytes())
        # Into the folder that it stands in, too.
        self.assertEqual(run(first / "deck.effective", "--quiet", "--out", first).returncode, 0)
        self.assertEqual((second / "history.txt").read_bytes(), (first / "history.txt").read_bytes())

    def test_a_fluid_of_a_file_and_a_body_of_the_deck_run_again_and_go_on(self):
        deck = self.write("flag.in", FLAG)
        shutil.copy(DECKS / "cylinder.msh", self.mesh)
        first = self.run_ok(deck)
        self.assertGreater(abs(history(first)["side_force_x_1"]).max(), 0)
        second = self.run_ok(first / "deck.effective", out="again")
        self.assertEqual((second / "history.txt").read_bytes(), (first / "history.txt").read_bytes())
        self.assertEqual((second / "messages.txt").read_bytes(), (first / "messages.txt").read_bytes())
        on = self.folder / "on"
        self.expect(0, deck, "--restart", first / "checkpoint-1.nc", "--out", on)
        self.assertEqual((on / "history.txt").read_text().splitlines()[-1],
                         (first / "history.txt").read_text().splitlines()[-1])

    def test_another_mesh_is_told(self):
        out = self.run_ok(self.deck)
        copy = out / "deck.effective.msh"
        copy.write_text(copy.read_text().replace("2 2 0 0", "2 2.5 0 0"))
        self.assertIn("is not the mesh file that was meant", self.expect(2, out / "deck.effective").stderr)
        checkpoint = sorted(out.glob("checkpoint-*.nc"))[0]
        again = ("--restart", checkpoint, "--out", self.folder / "restarted")
        self.expect(0, self.deck, *again)
        self.mesh.write_text(self.mesh.read_text().replace("2 2 0 0", "2 2.5 0 0"))
        self.assertIn("file_sha256", self.expect(2, self.deck, *again).stderr)

    def test_a_mistake_stands_at_the_line_of_the_mesh(self):
        lines = self.mesh.read_text().splitlines()
        lines[lines.index("$Nodes") + 3] += " 5x"
        self.mesh.write_text("\n".join(lines))
        result = self.expect(2, self.deck, "--out", self.folder / "none")
        (head, below), = diagnostics(result.stderr)
        self.assertEqual((head["file"], int(head["line"])), (str(self.mesh), lines.index("$Nodes") + 4))
        self.assertEqual(below[1].index("^") - 2, lines[int(head["line"]) - 1].index("5x"))
        self.assertFalse((self.folder / "none").exists())

    def test_an_expression_without_a_value_ends_the_run(self):
        result = self.expect(3, self.deck, "--out", self.folder / "out",
                             *sets(**{"fem__load_expression(1)": "'1/(t-.25)'"}))
        self.assertIn("t = 0.25: the expression of load 1, '1/(t-.25)', gives inf", result.stderr)

    def test_blocks_beside_a_file_are_told(self):
        result = run(DECKS / "plate-hole.in", "--out", self.folder / "out", *sets(**{"mesh__cells(1,1)": "2,2"}))
        self.assertEqual(result.returncode, 0)
        self.assertIn("cells has no effect: the mesh is that of the file", result.stderr)


if __name__ == "__main__":
    unittest.main()
