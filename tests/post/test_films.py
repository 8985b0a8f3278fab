# SPDX-License-Identifier: GPL-3.0-or-later
"""Films of runs, picture by picture, and the figures of the coupled path's scenes: each has its deck."""
import os
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path.insert(0, str(POST))

import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import animation
from PIL import Image

import film
import tether_results
from scene import choose
from thesis_figures import coupled
from called import call
from small_runs import DeckTest

PROGRAM = os.environ["TETHER"]


class FilmTest(DeckTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.bar = tether_results.run(ROOT / "decks" / "coupled-bar.in", {"in.tmax": 0.3}, out=cls.folder / "bar", program=PROGRAM)
        cls.silent = tether_results.run(ROOT / "decks" / "l-block.in", {"in.tmax": 0.3, "in.iout(39)": 0}, out=cls.folder / "silent", program=PROGRAM)

    def pictures(self, path):
        """All pictures of a GIF as arrays."""
        with Image.open(path) as file:
            found = []
            for number in range(file.n_frames):
                file.seek(number)
                found.append(numpy.asarray(file.convert("RGB"), dtype=int))
        return found


class Films(FilmTest):
    def test_a_gif_has_each_snapshot_in_one_frame(self):
        path = self.folder / "film.gif"
        self.assertEqual(film.main([str(self.bar.folder), "--gif", "--out", str(path)]), 0)
        pictures = self.pictures(path)
        self.assertEqual(len(pictures), len(self.bar.fields("mesh").times))
        moved = abs(pictures[0] - pictures[-1]).sum(axis=2) > 60
        rows, columns = numpy.nonzero(moved)
        # The axes, their numbers and the colour bars stay where they are: what changes is inside the panel, and the time.
        height, width = moved.shape
        self.assertTrue(moved.any())
        self.assertLess(columns.max(), 0.8 * width)
        self.assertGreater(columns.min(), 0.08 * width)

    def test_an_mp4_has_the_length_that_its_snapshots_give_it(self):
        self.assertTrue(animation.FFMpegWriter.isAvailable(), "ffmpeg is needed")
        self.assertEqual(film.main([str(self.bar.folder)]), 0)
        words = ["ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", self.bar.folder / "film.mp4"]
        seconds = float(subprocess.run(words, capture_output=True, text=True, check=True).stdout)
        self.assertTrue(film.LEAST_SECONDS - 0.1 <= seconds <= film.MOST_SECONDS, seconds)

    def test_films_last_from_4_to_20_seconds(self):
        for count in (1, 5, 61, 151, 400, 600, 601, 5000):
            shown = film.shown_of(count)
            rate = film.rate_of(len(shown))
            repeats = max(1, int(numpy.ceil(film.LEAST_SECONDS * rate / len(shown))))
            self.assertTrue(3.9 <= repeats * len(shown) / rate <= 20.1, count)

    def test_a_steady_run_is_filmed_in_its_last_state(self):
        run = tether_results.run(ROOT / "decks" / "cavity.in", {"mesh.cells(1,1)": (8, 8)}, out=self.folder / "cavity",
                                 program=PROGRAM)
        self.assertEqual(film.records_of(run, choose.scene_of(run)), [1])

    def test_refuses_what_it_cannot_film(self):
        (self.folder / "taken").write_text("")
        for code, needle, words in ((2, "has no history.nc", [self.folder]), (2, "iout(39)=1", [self.silent.folder]),
                                    (2, "no field dust", [self.bar.folder, "--field", "dust"]),
                                    (4, "taken", [self.bar.folder, "--out", self.folder / "taken" / "film.gif"])):
            result = call("film", *words)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(needle, result.stderr)
            self.assertNotIn("Traceback", result.stderr)


class Figures(unittest.TestCase):
    def test_every_scene_of_the_coupled_path_has_its_figure(self):
        decks = sorted(path.stem for path in (ROOT / "decks").glob("coupled-*.in"))
        self.assertEqual(decks, sorted(coupled.SHOWN))
        self.assertEqual(decks, sorted(coupled.FIGURES))


if __name__ == "__main__":
    unittest.main()
