# SPDX-License-Identifier: GPL-3.0-or-later
"""post/page.py in a browser without a window: what the page shows is what the run's files hold, and no deck breaks it."""
import base64
import html
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path.insert(0, str(POST))

import matplotlib

matplotlib.use("Agg")

import netCDF4
import numpy
from matplotlib import image

import page
import tether_results
from run_page import document, encode
from scene import quantities
from called import FULL, call
from small_runs import PROGRAM, DeckTest

BROWSER = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
           "--disable-background-networking", "--disable-component-update", "--disable-sync", "--allow-file-access-from-files"]
HOSTILE = "<script>document.title='taken'</script> & \"quoted\" </script> <!-- <b>bold</b>"


class PageTest(DeckTest):
    def browser(self, path, address, *words):
        with tempfile.TemporaryDirectory() as profile:
            done = subprocess.run([*BROWSER, f"--user-data-dir={profile}", *words, f"file://{path}{address}"], capture_output=True,
                                  text=True, check=True)
        return done.stdout

    def page_of(self, run):
        self.assertEqual(page.main([str(run.folder)]), 0)
        return run.folder / "page.html"

    def shown(self, run, address=""):
        """The page's elements once its scripts have run."""
        return self.browser(self.page_of(run), address, "--dump-dom")

    def pixels(self, run, address=""):
        """A picture of the page once its scripts have run."""
        picture = self.folder / "picture.png"
        self.browser(self.page_of(run), address, f"--screenshot={picture}", "--window-size=1000,900")
        return image.imread(picture)[:, :, :3]

    @staticmethod
    def text_at(dom, name):
        return html.unescape(re.search(rf'id="{name}"[^>]*>([^<]*)<', dom).group(1))

    @staticmethod
    def shapes(dom):
        return int(re.search(r'data-shapes="(\d+)"', dom).group(1))


class Numbers(PageTest):
    def test_slider_and_charts_show_what_the_files_hold(self):
        run = self.run_of("pendulum-40", {"in.tmax": 0.9})
        dom = self.shown(run, "#record=3&column=point_y_1&at=10")
        with open(run.folder / "history.txt") as file:
            names = file.readline().removeprefix("#").split()
            row = [line.split() for line in file][10]
        cell = dict(zip(names, row))
        self.assertEqual(self.text_at(dom, "reading"), f"time = {cell['time']}, point_y_1 = {cell['point_y_1']}")
        self.assertEqual(self.text_at(dom, "reading-0"), f"time = {cell['time']}, point_x_2 = {cell['point_x_2']}")
        self.assertEqual(float(self.text_at(dom, "snapshot")), float(f"{run.particles.times[3]:.6g}"))
        self.assertIn('data-record="3"', dom)

    def test_numbers_are_those_of_the_text_letter_by_letter(self):
        run = self.run_of("sod", {"in.tmax": 0.02})
        names, _, row = [line.removeprefix("#").split() for line in (run.folder / "history.txt").read_text().splitlines()[:3]]
        written = dict(zip(names, row))["energy_kinetic"]
        self.assertIn("e-0", written)  # a browser itself would write e-
        dom = self.shown(run, "#column=energy_kinetic&at=1")
        self.assertEqual(self.text_at(dom, "reading"), f"time = {row[0]}, energy_kinetic = {written}")
        self.assertGreaterEqual(self.shapes(dom), 900)

    def test_numbers_that_no_record_or_column_has_change_nothing(self):
        run = self.run_of("pendulum-40", {"in.tmax": 0.9})
        dom = self.shown(run, "#record=999&column=nothing&at=-4")
        self.assertIn(f'data-record="{len(run.particles.times) - 1}"', dom)
        self.assertIn(f"time = {run.history['time'][-1]:g}, ", self.text_at(dom, "reading"))

    def test_places_are_kept_to_a_part_in_60000(self):
        places = numpy.random.default_rng(1).uniform(-1, 2, (100, 2))
        whole = numpy.frombuffer(base64.b64decode(encode.places(places, (-1, 2, -1, 2))), "<u2").reshape(-1, 2)
        numpy.testing.assert_allclose(whole / encode.STEPS * 3 - 1, places, atol=3 / 60000)

    def test_what_is_no_number_has_no_place_and_no_shade(self):
        whole = numpy.frombuffer(base64.b64decode(encode.places([[numpy.nan, 1]], (0, 1, 0, 1))), "<u2")
        self.assertEqual(whole.tolist(), [encode.NOWHERE, encode.STEPS])
        scale = quantities.Scale("density", "1", 0, 2)
        self.assertEqual(base64.b64decode(encode.shades([0, 1, 2, 5, numpy.nan], scale)), bytes([0, 127, 254, 254, 255]))


class Fields(PageTest):
    def test_every_kind_of_scene_is_drawn(self):
        """Those of points, of elements and of pictures are in other tests."""
        decks = [("coupled-bar", {"in.tmax": 0.2}, 2048)]
        if FULL:
            decks += [("sod", {"in.tmax": 0.02}, 900),
                      ("rigid-free", {"in.tmax": 1.0, "in.iout(39)": 1, "in.tiout(39)": 0.5}, 1)]
        for deck, values, least in decks:
            with self.subTest(deck=deck):
                self.assertGreaterEqual(self.shapes(self.shown(self.run_of(deck, values))), least)

    def test_a_picture_of_the_page_has_the_colours_of_its_scale(self):
        pixels = self.pixels(self.run_of("cook", {"mesh.cells(1,1)": (4, 4)}))
        self.assertGreater(float(numpy.mean(pixels[..., 0] - pixels[..., 2] > 0.3)), 0.05)  # yellow to red

    def test_a_scene_in_space_is_a_picture_of_each_snapshot(self):
        run = self.run_of("rigid-free", {"in.tmax": 1.0, "in.iout(39)": 1, "in.tiout(39)": 0.5})
        pixels = self.pixels(run, "#record=1")
        self.assertGreater(float(numpy.mean(pixels[..., 2] - pixels[..., 0] > 0.1)), 0.01)  # the body is blue
        frames = document.scene_data(run)["parts"][0]["frames"]
        self.assertEqual(len({frame["jpeg"] for frame in frames}), 3)

    def test_a_steady_run_shows_its_last_state_first(self):
        dom = self.shown(self.run_of("cavity", {"mesh.cells(1,1)": (8, 8)}))
        self.assertIn('data-record="1"', dom)
        self.assertGreater(self.shapes(dom), 2 * 8 * 8)  # streamlines and walls, too

    def test_many_snapshots_are_thinned_and_the_page_says_so(self):
        run = self.run_of("coupled-bar", {"in.tmax": 0.4})
        count = len(run.fields("mesh").times)
        with mock.patch.object(document, "MOST_BYTES", 4000):
            text = document.page(run)
        data = json.loads(re.search(r'id="data">(.*?)</script>', text).group(1))
        kept = len(data["scene"]["times"])
        self.assertLess(kept, count)
        self.assertEqual(data["scene"]["times"], [float(run.fields("mesh").times[k]) for k in data["scene"]["records"]])
        notes = " ".join(re.findall(r'<p class="note">(.*?)</p>', text))
        self.assertIn(f"Of {count} snapshots {kept} are on this page", notes)
        self.assertIn("records are left out", notes)

    def test_a_run_without_snapshots_says_what_writes_them(self):
        run = self.run_of("l-block", {"in.tmax": 0.3, "in.iout(39)": 0})
        dom = self.shown(run, "#at=1")
        self.assertIn("iout(39)=1", dom)
        self.assertIn(f"time = {run.history['time'][1]:g}", self.text_at(dom, "reading"))

    def test_fields_of_nan_and_a_single_record(self):
        run = self.run_of("sod", {"in.tmax": 0.01})
        with netCDF4.Dataset(run.folder / "particles.nc", "a") as data:
            data["pressure"][:] = numpy.nan
        with open(run.folder / "history.txt") as file:
            lines = file.readlines()[:2]
        (run.folder / "history.txt").write_text("".join(lines))
        dom = self.shown(tether_results.open(run.folder))
        self.assertIn("time = 0, ", self.text_at(dom, "reading"))
        self.assertGreaterEqual(self.shapes(dom), 0)


class Safe(PageTest):
    def hostile(self):
        deck = (ROOT / "decks" / "sod.in").read_text().splitlines()
        path = self.folder / "hostile.in"
        path.write_text("\n".join([HOSTILE, *deck[deck.index("$in"):]]))
        return tether_results.run(path, {"in.tmax": 0.01}, out=self.folder / "<b>hostile", program=PROGRAM)

    def test_a_title_is_text_and_not_a_script(self):
        run = self.hostile()
        self.assertIn("<script>", run.title)
        dom = self.shown(run, "#at=3")
        self.assertEqual(len(re.findall(r"<script\b", dom)), 2)
        self.assertNotIn("<b>", dom)
        self.assertIn(html.escape("<b>hostile", quote=False), re.search(r"<title>(.*?)</title>", dom).group(1))
        self.assertIn(html.escape("document.title='taken'", quote=False), dom)
        self.assertIn("time = 0.003", self.text_at(dom, "reading"))
        self.assertGreater(self.shapes(dom), 0)

    def test_data_can_end_no_script(self):
        text = encode.json_in_html({"a": HOSTILE, "b": "\u2028"})
        for letter in "<>&\u2028":
            self.assertNotIn(letter, text)
        self.assertEqual(json.loads(text), {"a": HOSTILE, "b": "\u2028"})

    def test_the_page_needs_nothing_from_elsewhere(self):
        text = document.page(self.run_of("pendulum-40", {"in.tmax": 0.9}))
        self.assertIn("default-src 'none'", text)
        for word in ("src=", "href=", "@import", "url(", "fetch(", "XMLHttpRequest"):
            self.assertNotIn(word, text.split('id="data"')[0] + text.split("</script>")[-2])


class CommandLine(PageTest):
    def call(self, *words):
        result = call("page", *words)
        self.assertNotIn("Traceback", result.stderr)
        return result

    def test_refuses_what_it_cannot_show_or_write(self):
        run = self.run_of("pendulum-40", {"in.tmax": 0.9})
        (self.folder / "taken").write_text("")
        for code, needle, words in ((2, "has no history.nc", [self.folder]), (2, "no field dust", [run.folder, "--field", "dust"]),
                                    (4, "taken", [run.folder, "--out", self.folder / "taken" / "page.html"])):
            result = self.call(*words)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(needle, result.stderr)


if __name__ == "__main__":
    unittest.main()
