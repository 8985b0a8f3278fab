# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and films of the coupled path's scenes: what is drawn where, and films of two pictures."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path.insert(0, str(POST))

import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import image, pyplot

import films
import style
from thesis_figures import coupled
from thesis_figures.coupled_scene import ASLANT, OBSTACLE, CoupledScene, faces_of
from thesis_figures.runs import Runs

PROGRAM = Path(os.environ["TETHER"])


class FilmTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        style.use()
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        cls.runs = Runs(PROGRAM, ROOT / "decks", cls.folder / "runs")
        cls.addClassCleanup(pyplot.close, "all")

    def of(self, deck, end=0.1):
        return self.runs.of(deck, f"in.tmax={end}")


class Pictures(FilmTest):
    def test_every_scene_has_its_figure(self):
        decks = sorted(path.stem for path in (ROOT / "decks").glob("coupled-*.in"))
        self.assertEqual(decks, sorted(coupled.SHOWN))
        self.assertEqual(decks, sorted(coupled.FIGURES))

    def test_cells_stand_where_they_are(self):
        scene = CoupledScene(self.of("coupled-paddle-3d"))
        self.assertEqual((scene.shape, scene.dim), ((16, 24, 32), 3))
        numpy.testing.assert_allclose(scene.extent(), (0, 2, 0, 1.5), atol=1e-12)
        kind = scene.cells("kind", 0)
        self.assertTrue((kind[:, 0, :] == OBSTACLE).all())  # the floor
        self.assertFalse((kind[:, 1:, :] == OBSTACLE).any())

    def test_speeds_are_those_of_the_jet(self):
        scene = CoupledScene(self.of("coupled-sheets"))
        speed = scene.cells("speed", scene.record_at(0.1))
        rows = (scene.middles[1] > 0.2) & (scene.middles[1] < 0.35)
        self.assertTrue((abs(speed[rows, 0] / 5 - 1) < 0.3).all())

    def test_faces_of_two_tetrahedra_are_six(self):
        self.assertEqual(len(faces_of(numpy.array([[0, 1, 2, 3], [1, 2, 3, 4]]))), 6)

    def test_bodies_are_drawn_where_they_are(self):
        scene = CoupledScene(self.of("coupled-bar-3d"))
        _, (axes,) = style.panels(1, 1)
        scene.draw(axes, 0, "smoke", 1.0)
        corners = numpy.concatenate([path.vertices for faces in axes.collections for path in faces.get_paths()])
        right, down = ASLANT
        back, front = (z - scene.middles[2][0] for z in (0.3, 0.7))
        numpy.testing.assert_allclose(corners.max(axis=0), (0.8 + right * front, 0.5 + down * back), atol=1e-9)
        numpy.testing.assert_allclose(corners.min(axis=0), (0.7 + right * back, down * front), atol=1e-9)


class Films(FilmTest):
    def test_two_pictures_of_a_scene_in_the_plane_and_in_space(self):
        for deck in ("coupled-bar", "coupled-bar-3d"):
            path = films.make(deck, self.of(deck), self.folder, 2)
            self.assertEqual(path.suffix, ".mp4" if films.animation.FFMpegWriter.isAvailable() else ".gif")
            self.assertGreater(path.stat().st_size, 1000)
            if path.suffix == ".gif":
                self.assertGreater(image.imread(path).std(), 0)

    def test_refuses_what_it_cannot_film(self):
        for code, words in ((2, ["sod"]), (2, ["--program", self.folder / "none", "coupled-bar"]),
                            (3, ["--program", "/bin/false", "coupled-bar"])):
            result = subprocess.run([sys.executable, POST / "films.py", "--out", self.folder / "refused", *words],
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
