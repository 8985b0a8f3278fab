# SPDX-License-Identifier: GPL-3.0-or-later
"""Which snapshots of points are drawn and how: evenly spaced, by the quantity that matters, and whatever is in their files."""
import os
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path[:0] = [str(POST), str(Path(__file__).parent)]

import matplotlib

matplotlib.use("Agg")

import numpy

import tether_results
import plot
from scene import choose, moments, quantities
from scene.points import Points
from small_runs import PLACES, FolderTest, write_deck, write_history, write_particles

PROGRAM = os.environ["TETHER"]


class PointsTest(FolderTest):
    def open(self):
        return tether_results.open(self.folder)


class Titles(PointsTest):
    def test_are_the_first_sentence_without_its_source(self):
        write_history(self.folder)
        run = self.open()
        for head, words in (("A ball flies (chapter 5.9, Box 8; A.1.6), and lands. More.", "A ball flies, and lands"),
                            ("A disk at (.6, .5); more", "A disk at (.6, .5)"),
                            ("A ring at rest (mu F e (x) e, mu = 1; R = .25): more", "A ring at rest"),
                            ("Gas: (density 1, p 1) on the left.", "Gas: (density 1, p 1) on the left.")):
            run.history.attributes["title"] = head
            self.assertEqual(choose.title_of(run), f"{run.name}: {words}")


class Snapshots(PointsTest):
    def test_are_evenly_spaced_or_both_ends(self):
        for times, chosen in (([0], [0]), ([0, 1], [0, 1]), (range(6), range(6)), (range(18), (0, 3, 6, 9, 12, 15)),
                              ([0, 1, 2, 2.85], [0, 3]), ([0, 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6, 1.75], (0, 2, 4, 6, 8))):
            self.assertEqual(moments.even_sets(numpy.array(list(times), dtype=float))[0], list(chosen))

    def test_of_a_swing_are_not_a_period_apart(self):
        times = numpy.linspace(0, 3, 25)
        sets = moments.even_sets(times)
        self.assertEqual(times[sets[0]].tolist(), [0, 1, 2, 3])
        variety = lambda records: numpy.sin(2 * numpy.pi * times[records]).std()
        chosen = moments.liveliest(sets, variety)
        self.assertLess(variety(sets[0]), 1e-12)
        self.assertGreater(variety(chosen), moments.LIVELY * max(map(variety, sets)) - 1e-12)
        self.assertEqual(len(set(numpy.diff(times[chosen]))), 1)
        self.assertEqual(moments.liveliest(sets, lambda records: 0.0), sets[0])

    def test_of_a_motion_that_is_over_early_are_most_while_it_lasts(self):
        times = numpy.linspace(0, 10, 101)
        moved = numpy.minimum(times, 1)
        self.assertTrue(moments.is_early(moved, times))
        self.assertFalse(moments.is_early(times, times))
        self.assertEqual(times[moments.while_it_moves(moved, times)].round(1).tolist(), [0, 0.4, 0.7, 2, 6, 10])

    def test_are_those_nearest_to_the_times_that_are_asked_for(self):
        write_history(self.folder)
        write_particles(self.folder)
        run = self.open()
        self.assertEqual(choose.records_of(run, choose.scene_of(run), (0.9, 0.4)), [1, 2])

    def test_a_gas_is_coloured_by_its_pressure_on_one_scale(self):
        write_history(self.folder)
        write_particles(self.folder)
        write_deck(self.folder, 7)
        scene = choose.scene_of(self.open())
        figure = scene.figure([0, 1, 2])
        self.assertEqual([axes.get_title() for axes in figure.axes[:3]], ["time 0 s", "time 0.5 s", "time 1 s"])
        drawn = [axes.collections[0] for axes in figure.axes[:3]]
        for points in drawn:
            numpy.testing.assert_array_equal(points.get_array(), 2 * PLACES)
            self.assertEqual((points.norm.vmin, points.norm.vmax), (drawn[0].norm.vmin, drawn[0].norm.vmax))
        self.assertEqual(figure.axes[3].get_ylabel(), "pressure")
        for axes in figure.axes[1:3]:
            self.assertEqual((axes.get_xlim(), axes.get_ylim()), (figure.axes[0].get_xlim(), figure.axes[0].get_ylim()))
            self.assertEqual(axes.get_aspect(), 1)

    def test_laws_and_normals_say_what_a_body_is(self):
        write_history(self.folder)
        for law, normal, kind in ((9, 0, "gas"), (8, 0, "fluid"), (0, 0, "solid"), (2, 1, "membrane")):
            write_particles(self.folder, normal_x=normal + 0 * PLACES, normal_y=0 * PLACES)
            write_deck(self.folder, law)
            self.assertEqual(list(Points(self.open()).kinds), [kind])

    def test_the_whole_grid_is_shown(self):
        write_history(self.folder)
        write_particles(self.folder)
        (self.folder / "deck.effective").write_text("$in\nxleft = -2\nxright = 3\nybot = 0\nytop = 4\n$\n")
        scene = choose.scene_of(self.open())
        scene.fit([0])
        self.assertLess(scene.limits[0], -2)
        self.assertGreater(scene.limits[3], 4)


class Hostile(PointsTest):
    def drawn(self):
        self.assertEqual(plot.main([str(self.folder)]), 0)
        self.assertIn("fields.png", self.pictures())
        return choose.scene_of(self.open())

    def test_a_field_of_nothing_but_nan(self):
        write_history(self.folder)
        write_particles(self.folder, pressure=numpy.nan * PLACES)
        write_deck(self.folder, 7)
        scene = self.drawn()
        scene.fit([0])
        self.assertTrue(all(numpy.isfinite((scale.low, scale.high)).all() for scale in scene.scales))

    def test_points_that_are_nowhere(self):
        write_history(self.folder)
        write_particles(self.folder, x=numpy.where(PLACES > 0.5, numpy.nan, PLACES))
        scene = self.drawn()
        scene.fit([0])
        self.assertTrue(numpy.isfinite(scene.limits).all())

    def test_one_record(self):
        write_history(self.folder)
        write_particles(self.folder, times=(0,))
        self.drawn()

    def test_snapshots_without_a_record_are_none(self):
        write_history(self.folder)
        write_particles(self.folder, times=())
        self.assertEqual(plot.main([str(self.folder)]), 0)
        self.assertEqual(self.pictures(), ["histories.png"])

    def test_a_run_that_stopped_early(self):
        run = tether_results.run(ROOT / "decks" / "sod.in", {"in.tmax": 0.02}, out=self.folder, program=PROGRAM)
        for name in ("summary.txt", "reference.txt"):
            (run.folder / name).unlink()
        self.drawn()


class Quantities(unittest.TestCase):
    def test_von_mises_of_pull_shear_and_pressure(self):
        names = ("sxx", "syy", "szz", "sxy")
        for stress, expected in (((3, 0, 0, 0), 3), ((0, 0, 0, 1), numpy.sqrt(3)), ((-2, -2, -2, 0), 0)):
            self.assertAlmostEqual(float(quantities.von_mises(dict(zip(names, map(numpy.array, stress))))), expected)

    def test_pressures_of_both_signs_have_a_scale_about_zero(self):
        scale = quantities.Scale("p", "Pa")
        scale.fit([numpy.array([-1.0, 3.0])])
        self.assertEqual((scale.low, scale.high), (-3, 3))
        scale.fit([numpy.array([0.5, 3.0])])
        self.assertEqual((scale.low, scale.high), (0, 3))

    def test_a_constant_has_a_scale(self):
        for value in (0.0, 5.0):
            scale = quantities.Scale("density", "1")
            scale.fit([numpy.full(3, value)])
            self.assertLess(scale.low, scale.high)


if __name__ == "__main__":
    unittest.main()
