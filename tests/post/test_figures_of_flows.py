# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of flows: their meshes as triangles, what is read from them, and the curves that are drawn."""
import os
import sys
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "post"))

import matplotlib

matplotlib.use("Agg")

import numpy

import figures
import style
from thesis_figures import flaps, flows
from scene.elements import Elements
from scene.flow import FlowMesh
from thesis_figures.runs import Runs
from small_runs import DeckTest

PROGRAM = Path(os.environ["TETHER"])
SHORT = "in.tmax=0.05"


class FlowsTest(DeckTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.runs = Runs(PROGRAM, ROOT / "decks", cls.folder / "runs", levels=1)

    def cavity(self, element):
        return FlowMesh(self.runs.of("cavity", f"flow.element='{element}'", "mesh.cells(1,1)=32,32").fields("mesh"))

    def coarse_flaps(self, *cells):
        fluid, along = cells
        return self.runs.of("two-flaps", "flow.element='q1q1'", f"mesh.cells(1:2,1)={4 * fluid},{fluid}",
                            f"mesh.cells(2,2:3)={along},{along}", SHORT)


class Meshes(FlowsTest):
    def test_triangles_cover_the_fluid_once(self):
        for element, of_each in (("q1q1", 2), ("q2q1", 8)):
            mesh = self.cavity(element)
            a, b, c = (numpy.array((mesh.x, mesh.y))[:, corner] for corner in mesh.triangles.triangles.T)
            areas = 0.5 * ((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0])
            numpy.testing.assert_allclose(areas, 1 / (of_each * 32**2), rtol=1e-9)
            self.assertEqual(len(areas), of_each * 32**2)

    def test_a_line_through_the_fluid_runs_from_wall_to_lid(self):
        for element, nodes in (("q1q1", 33), ("q2q1", 65)):
            places, values = self.cavity(element).on_line("vx", -1, "x", 0.5)
            numpy.testing.assert_allclose(places, numpy.linspace(0, 1, nodes), atol=1e-12)
            self.assertEqual((values[0], values[-1]), (0, 1))
            self.assertAlmostEqual(values.min() / flows.LEAST_U, 1, delta=0.01)

    def test_solids_are_drawn_where_they_are(self):
        run = self.coarse_flaps(8, 5)
        figure, (axes,) = style.panels(1, 1)
        Elements(run.fields("solids")).draw(axes, -1)
        corners = numpy.concatenate(axes.collections[-1].get_segments())
        for k in (0, 1):
            tip = [run.history[f"point_{part}"][-1, k] for part in "xy"]
            self.assertLess(numpy.hypot(*(corners - tip).T).min(), 1e-12)


class Curves(FlowsTest):
    def test_errors_of_the_cylinder_fall_with_what_they_cost(self):
        figure = flows.cylinder_cost(self.runs)
        for axes in figure.axes:
            linear, quadratic = axes.lines
            for line in (linear, quadratic):
                cost, error = line.get_data()
                self.assertEqual(len(cost), 2)
                self.assertLess(cost[0], cost[1])
                self.assertLess(error[1], error[0])
            self.assertLess(quadratic.get_ydata()[1], linear.get_ydata()[1])

    def test_the_path_of_a_tip_begins_at_the_flap(self):
        run = self.coarse_flaps(8, 5)
        numpy.testing.assert_allclose(flaps.path(run, [0.0])[:, 0], (1.9788, 0.91))

    def test_the_distance_is_none_to_itself_and_small_to_another_mesh(self):
        one, other = self.coarse_flaps(8, 5), self.coarse_flaps(12, 5)
        self.assertEqual(flaps.distance(one, one), 0)
        self.assertTrue(0.001 < flaps.distance(one, other) < 0.3)
        over = numpy.hypot(other.history["point_x"][:, 0] - 1.9788, other.history["point_y"][:, 0] - 0.91).max()
        between = numpy.hypot(*(flaps.path(one, [0.05]) - flaps.path(other, [0.05])))[0]
        self.assertGreaterEqual(flaps.distance(one, other) * over, between)

    def test_each_level_is_twice_as_fine(self):
        asked = []
        runs = mock.Mock(levels=3, of=lambda deck, *settings: asked.append(settings))
        for level in (0, 1, 2):
            flaps.flapping(runs, "q1q1", level)
        self.assertIn("mesh.cells(1:2,1)=64,16", asked[0])
        self.assertIn("mesh.cells(1:2,3)=2,20", asked[1])
        self.assertIn("mesh.cells(1:2,1)=256,64", asked[2])
        self.assertEqual(flaps.level_name(2), "256 x 64")

    def test_the_finest_level_is_asked_for(self):
        for words, levels in (([], 2), (["--full"], 3)):
            with mock.patch.object(figures, "draw_all", return_value=[]) as drawn:
                self.assertEqual(figures.main(["cavity", *words]), 0)
            self.assertEqual(drawn.call_args.args[1].levels, levels)


if __name__ == "__main__":
    unittest.main()
