# SPDX-License-Identifier: GPL-3.0-or-later
"""post/figures.py: every figure is drawn from runs of the program, what is drawn, and which runs are made again."""
import contextlib
import dataclasses
import os
import shutil
import sys
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path.insert(0, str(POST))

import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import image, pyplot

import contact_sheet
import figures
from thesis_figures import FIGURES, appendix_a, chapter4, chapter5, cost, coupled, splitting
from thesis_figures.runs import NoProgram, RunFailed, Runs
from called import FULL, call
from small_runs import DeckTest

PROGRAM = Path(os.environ["TETHER"])


# Ends of the runs of decks that begin so: the longest would take 350,000 steps.
SHORT = {"pendulum": 0.3, "membrane-expansion-1": 0.1, "membrane-expansion": 0.01, "cyl-": 0.003, "ball-net": 0.4,
         "cylinder-expansion": 0.005, "l-block": 12.0 if FULL else 6.5, "two-flaps": 0.02, "coupled-bar": 0.07,
         "coupled": 0.2}


# The bar in space and the toy in the plane are drawn the same way.
ONLY_AT_FULL_LENGTH = {"coupled-paddle-3d", "coupled-sheets-3d", "coupled-toy-3d"}
WRITTEN = 1 if FULL else 4  # one of so many figures becomes a file: that takes longer than what is in it


class ShortRuns(Runs):
    """The long ones stop early."""

    def of(self, deck, *settings):
        ends = [end for start, end in SHORT.items() if deck.startswith(start)]
        if not ends:
            return super().of(deck, *settings)
        others = [setting for setting in settings if not setting.startswith("in.tmax")]
        return super().of(deck, *others, f"in.tmax={ends[0]}")


def coloured_share(path):
    """Share of the pixels that are neither white, grey nor black: axes and letters have no colour, data have."""
    pixels = image.imread(path)[:, :, :3]
    return float(numpy.mean(pixels.max(axis=2) - pixels.min(axis=2) > 0.2))


@contextlib.contextmanager
def less_drawn():
    """By default: the corners of the map of splitting, of one material, two runs a curve of costs, and each scene in
    space at one time."""
    one_time = {deck: dataclasses.replace(shown, times=shown.times[-1:])
                for deck, shown in coupled.SHOWN.items() if deck.endswith("3d")}
    corners = {"RATIOS": splitting.RATIOS[::5], "LENGTHS": splitting.LENGTHS[::4],
               "MATERIALS": splitting.MATERIALS[1:2]}
    costs = {name: getattr(cost, name)[:2] for name in ("SOD", "BARS", "MEMBRANES")}
    with (mock.patch.multiple(splitting, **corners), mock.patch.multiple(cost, **costs),
          mock.patch.dict(coupled.SHOWN, one_time)):
        yield


class FigureTest(DeckTest):
    @classmethod
    def setUpClass(cls):
        """One folder of runs for all tests of a class; by default with fewer pixels."""
        super().setUpClass()
        if not FULL:
            pyplot.rcParams["figure.dpi"] = 60
        cls.runs = ShortRuns(PROGRAM, ROOT / "decks", cls.folder / "runs", levels=1)

    def setUp(self):
        self.addCleanup(pyplot.close, "all")

    def lines(self, name):
        """Curves of each panel by label."""
        figure = FIGURES[name](self.runs)
        return [{line.get_label(): line.get_xydata() for line in axes.lines} for axes in figure.axes]


class Drawn(FigureTest):
    def test_every_figure_and_the_sheet_of_all(self):
        names = [name for name in FIGURES if FULL or name not in ONLY_AT_FULL_LENGTH]
        with contextlib.nullcontext() if FULL else less_drawn():
            paths = [self.written(name) for name in names[::WRITTEN]]
            for name in [name for number, name in enumerate(names) if number % WRITTEN]:
                self.assertTrue(any(axes.has_data() for axes in FIGURES[name](self.runs).axes), name)
                pyplot.close("all")
        sheet = image.imread(contact_sheet.write(paths, self.folder / "sheet.png"))
        self.assertEqual(sheet.shape[1], contact_sheet.WIDTH * contact_sheet.DPI)
        self.assertGreater(coloured_share(self.folder / "sheet.png"), 1e-3)

    def written(self, name):
        """The path of a figure that has data in it."""
        figures.draw(name, self.runs, self.folder)
        path = figures.path_of(name, self.folder)
        self.assertGreater(coloured_share(path), 1e-3, name)
        return path

    def test_titles_have_number_and_text(self):
        self.assertEqual(figures.title("17"), "Fig. 17: Gas expansion, pressure at t = 0.005")
        for name, function in FIGURES.items():
            self.assertTrue(function.__doc__.endswith("."), name)
        self.assertEqual(figures.title("cost"), "Error over processor seconds, by both methods")

    def test_figures_stand_in_the_order_of_their_numbers(self):
        numbers = [int(name) for name in FIGURES if name.isdigit()]
        self.assertEqual(numbers, sorted(numbers))
        others = [name for name in FIGURES if not name.isdigit()]
        self.assertEqual(list(FIGURES)[-len(others):], sorted(others))
        self.assertTrue({"cost", "l-block", "cavity", "cylinder", "flaps-1", "two-flaps-cost", "splitting-map"} <= set(others))

    def test_densities_of_sod_are_means_over_cells_beside_the_exact_ones(self):
        for panel, deck in zip(self.lines("13"), ("sod-cell", "sod", "sod-continuity")):
            run = self.runs.of(deck)
            points, exact = panel["points, mean of a cell"], panel["exact"]
            numpy.testing.assert_allclose(numpy.modf(points[:, 0] / 0.01)[0], 0.5, atol=1e-9)
            error = abs(points[:, 1] - numpy.interp(points[:, 0], *exact.T)).mean()
            self.assertAlmostEqual(error, run.summary["error_density"], delta=5e-4)  # interpolation across the jumps

    def test_exact_gas_points_hold_the_mass_that_they_began_with(self):
        run = chapter4.expansion(self.runs)
        radius = numpy.hypot(*chapter4.exact_places(run))
        rms = numpy.sqrt(numpy.mean(radius**2))
        self.assertAlmostEqual(rms / run.summary["exact_rms_radius"], 1, delta=5e-3)
        start = numpy.hypot(*chapter4.places(run, 0))
        self.assertTrue(numpy.all(radius > start - 1e-4))  # of gas still at rest, as far as a shell's middle tells
        self.assertLess(abs(radius - start)[start < 0.25].max(), 1e-3)

    def test_the_exact_pendulum_is_rigid_and_begins_where_the_points_do(self):
        frames = self.lines("36")
        first = self.runs.of("pendulum-320", *chapter5.SNAPSHOTS).particles
        numpy.testing.assert_allclose(frames[0]["exact, rigid"], [[first["x"][0, k], first["y"][0, k]] for k in (0, -1)],
                                      atol=1e-12)
        self.assertEqual(len(frames), len(first["time"]))
        for frame in frames:
            self.assertAlmostEqual(numpy.hypot(*numpy.diff(frame["exact, rigid"], axis=0)[0]), 0.7346, delta=1e-4)

    def test_the_spring_has_its_energies(self):
        motion, energy = self.lines("26")
        for name, panel in (("MPM", motion), ("kinetic", energy)):
            here, exact = panel[name], panel["exact"]
            self.assertEqual(len(here), len(exact))
        self.assertAlmostEqual(motion["exact"][:, 1].min(), -0.005164, delta=1e-5)
        # Drawn last is the spring's: k (2 m g/k)^2/2 at most.
        self.assertAlmostEqual(energy["exact"][:, 1].max(), 4.158, delta=1e-3)
        # The spring's cells count its stretch as a shorter one, of a period 1.6 % less: after five swings of .0026
        # that is a way of .0013.
        self.assertLess(abs(motion["MPM"] - motion["exact"]).max(), 0.0026 * 2 * numpy.pi * 5 * 0.0165)

    def test_forces_before_and_after_the_crossing_are_the_thesis(self):
        run = self.runs.of("noise", *appendix_a.EVERY_STEP)
        for record, printed in ((0, appendix_a.BEFORE), (1, appendix_a.AFTER)):
            numpy.testing.assert_allclose(appendix_a.row_forces(run, record), printed, rtol=0.04)
        self.assertEqual(len(run.fields("mesh")["time"]), 11)

    def test_only_steps_beyond_the_limit_grow(self):
        for panel, stable, growing in zip(self.lines("91"), (("1", "2"), ("0.5", "1")), (("2.2",), ("1.1",))):
            for label in stable:
                self.assertLess(panel[label][:, 1].max(), 20, label)
            for label in growing:
                self.assertGreater(panel[label][:, 1].max(), 1e5, label)


class Made(FigureTest):
    """Runs of a deck of its own in a folder that may be changed."""

    def setUp(self):
        super().setUp()
        self.here = self.folder / self.id()
        for part, name in (("decks", "stability-side.in"), ("particles", "stability-side.par")):
            (self.here / part).mkdir(parents=True)
            shutil.copy(ROOT / part / name, self.here / part)
        self.deck = self.here / "decks" / "stability-side.in"
        self.runs = Runs(PROGRAM, self.here / "decks", self.here / "runs")

    def made(self, *settings):
        run = self.runs.of("stability-side", *settings)
        return run, (run.folder / "summary.txt").stat().st_mtime_ns

    def test_a_run_is_made_once(self):
        self.assertEqual(self.made()[1], self.made()[1])

    def test_and_again_when_deck_or_points_are_newer(self):
        for source in (self.deck, self.here / "particles" / "stability-side.par"):
            before = self.made()[1]
            later = before + 1_000_000_000
            os.utime(source, ns=(later, later))
            self.assertGreater(self.made()[1], before, source.name)
            os.utime(source, (0, 0))

    def test_settings_have_runs_of_their_own(self):
        plain, shorter = self.made()[0], self.made("in.tmax=0.01")[0]
        self.assertEqual((plain.summary["time_end"], shorter.summary["time_end"]), (0.03, 0.01))
        self.assertNotEqual(plain.folder, shorter.folder)
        self.assertEqual(self.made()[0].summary["time_end"], 0.03)

    def test_failures_are_told(self):
        self.deck.write_text("nothing\n$in\nnx=1\n$\n")
        with self.assertRaisesRegex(RunFailed, "stability-side.in failed with exit code 2(.|\n)*nx"):
            self.made()
        self.runs.program = self.here / "none"
        with self.assertRaisesRegex(NoProgram, "none: is not there"):
            self.made()


class CommandLine(FigureTest):
    def call(self, *words, alone=FULL):
        return call("figures", "--out", self.folder / "out", *words, alone=alone)

    def test_draws_what_it_is_told(self):
        result = self.call("--program", PROGRAM, "104", "103", alone=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.split(), [str(self.folder / "out" / f"figure-{n}.png") for n in (104, 103)])
        self.assertEqual(sorted(path.name for path in (self.folder / "out").glob("*.png")),
                         ["figure-103.png", "figure-104.png"])

    def test_lists_them(self):
        result = self.call("--list")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(len(result.stdout.splitlines()), len(FIGURES))
        self.assertIn("Fig. 13: Sod's shock tube", result.stdout)

    def check_refused(self, code, needle, *words):
        result = self.call(*words)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertIn(needle, result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_refuses_what_it_cannot_draw(self):
        self.check_refused(2, "no figure 999, x; there are 13, 14", "13", "999", "x")
        self.check_refused(2, "none: is not there", "--program", self.folder / "none", "13")
        self.check_refused(3, "failed with exit code 1", "--program", shutil.which("false"), "13")
        (self.folder / "taken").write_text("")
        self.check_refused(4, "taken", "--program", PROGRAM, "--out", self.folder / "taken", "13")


if __name__ == "__main__":
    unittest.main()
