# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of chapters 6, 7 and A.1: what they evaluate themselves, against the program's own results and exact ones."""
import os
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "post"))

import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import pyplot

import style
from thesis_figures import (appendix_a_bars, bodies, chapter6_airbags, chapter6_membranes, chapter7_cells, chapter7_cylinder,
                            grid_colors, mass_matrix)
from thesis_figures.runs import Runs
from small_runs import DeckTest

PROGRAM = Path(os.environ["TETHER"])
CELL, CELLS = 0.1, 15  # of normals-cylinder


class BodiesTest(DeckTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.runs = Runs(PROGRAM, ROOT / "decks", cls.folder)

    def setUp(self):
        self.addCleanup(pyplot.close, "all")


class NormalsAsTheProgramHasThem(BodiesTest):
    """The figures' numpy beside the first snapshot of a run, for the same points."""

    def program(self, method):
        return chapter7_cylinder.normals_at(
            self.runs.of("normals-cylinder", chapter7_cylinder.rule(method), chapter7_cylinder.VACUUM), 0)

    def check_cells(self, method, kind):
        x, y, *normal = self.program(method)
        normal, cell = numpy.array(normal), grid_colors.cell_of(x, CELL, CELLS) + CELLS * grid_colors.cell_of(y, CELL, CELLS)
        compared = 0
        for number in numpy.unique(cell):
            here = cell == number
            if here.sum() == 1:
                continue  # of a ghost cell
            r, s = x[here] / CELL - number % CELLS, y[here] / CELL - number // CELLS
            gradient = mass_matrix.gradients(kind, mass_matrix.fit(kind, r, s), r, s).T
            angle = chapter7_cylinder.angles_to(normal[:, here], gradient)
            self.assertLess(angle.max(), 1e-3, number)
            compared += here.sum()
        self.assertGreater(compared, 30)

    def test_mass_matrix_linear(self):
        self.check_cells("mass-linear", mass_matrix.Linear)

    def test_mass_matrix_quadratic(self):
        self.check_cells("mass-quadratic", mass_matrix.Quadratic)

    def test_colours_of_cells(self):
        x, y, *normal = self.program("quadratic")
        nodes = grid_colors.gradients(x, y, CELL, CELLS)
        i, j = grid_colors.cell_of(x, CELL, CELLS), grid_colors.cell_of(y, CELL, CELLS)
        r, s = x / CELL - i, y / CELL - j
        at = sum(wx * wy * nodes[:, j + b, i + a] for a, wx in ((0, 1 - r), (1, r)) for b, wy in ((0, 1 - s), (1, s)))
        inner = (x > 2 * CELL) & (y > 2 * CELL)  # where no wall mirrors
        self.assertGreater(inner.sum(), 25)
        self.assertLess(chapter7_cylinder.angles_to(numpy.array(normal)[:, inner], at[:, inner]).max(), 1e-6)


class SingleCells(unittest.TestCase):
    def largest_angle(self, points, kind, fit):
        x, y, exact = points
        return chapter7_cylinder.angles_to(mass_matrix.gradients(kind, fit(kind, x, y), x, y).T, exact).max()

    def test_what_linear_shape_functions_can_have_is_exact(self):
        for points in (chapter7_cells.line(45, numpy.linspace(-0.6, 0.6, 5)), chapter7_cells.hyperbola()):
            self.assertLess(self.largest_angle(points, mass_matrix.Linear, mass_matrix.plain_fit), 1e-5)

    def test_an_arc_needs_quadratic_ones(self):
        arc = chapter7_cells.arc_of_83(90)
        self.assertGreater(self.largest_angle(arc, mass_matrix.Linear, mass_matrix.plain_fit), 30)
        self.assertLess(self.largest_angle(arc, mass_matrix.Quadratic, mass_matrix.fit), 0.1)

    def test_a_point_out_of_line_loses_its_normal_without_stiffness(self):
        self.assertGreater(self.largest_angle(chapter7_cells.MOVED, mass_matrix.Linear, mass_matrix.plain_fit), 80)
        self.assertLess(self.largest_angle(chapter7_cells.MOVED, mass_matrix.Linear, mass_matrix.fit), 2)

    def test_normals_of_a_disc_point_out(self):
        places = (numpy.arange(80) + 0.5) / 40
        x, y = (values.ravel() for values in numpy.meshgrid(places, places))
        inside = numpy.hypot(x - 1, y - 1) < 0.6
        normals = grid_colors.outward_normals(x[inside], y[inside], 0.1, 20)
        for row, column, exact in ((10, 16, (1, 0)), (10, 4, (-1, 0)), (16, 10, (0, 1)), (4, 10, (0, -1))):
            numpy.testing.assert_allclose(normals[:, row, column], exact, atol=1e-9)


class WhatIsDrawn(BodiesTest):
    def lines(self, axes):
        return {line.get_label(): line.get_xydata() for line in axes.lines}

    def test_bars_part_with_the_printed_velocities(self):
        lines = self.lines(appendix_a_bars.bars_that_part(self.runs).axes[2])
        for bar, printed in zip(appendix_a_bars.BARS, appendix_a_bars.AFTER):
            self.assertAlmostEqual(lines[bar][-1, 1], printed, delta=0.05)
        both = lines["left bar"][:, 1] + lines["right bar"][:, 1]
        numpy.testing.assert_allclose(both / 2, lines["both together, exact"][0, 1], atol=1e-9)

    def test_normals_stand_where_bars_share_nodes_and_are_opposite(self):
        run = self.runs.of("two-bar", *appendix_a_bars.OFTEN)
        record = bodies.nearest(run, appendix_a_bars.MEETING)
        both = [bodies.places(run, record, body) for body in (1, 2)]
        shared = numpy.logical_and(*(grid_colors.touched_nodes(*at, 0.25, 20) for at in both))
        self.assertGreater(shared.sum(), 10)
        left, right = (grid_colors.outward_normals(*at, 0.25, 20)[:, shared] for at in both)
        self.assertTrue(numpy.all((left * right).sum(axis=0) < 0))

    def test_means_at_nodes_keep_a_constant_and_a_line(self):
        run = self.runs.of("membrane-expansion-2", "in.tmax=0.001")
        gas = ~chapter6_membranes.of_membrane(run)
        x = run.particles["x"][-1]
        constant = chapter6_membranes.of_grid(run, -1, gas, numpy.full(len(x), 7.0))
        numpy.testing.assert_allclose(constant[numpy.isfinite(constant)], 7.0)
        line = chapter6_membranes.of_grid(run, -1, gas, x)
        self.assertAlmostEqual(line[2, 1], 0.2, delta=0.02)  # a node amid gas

    def test_the_probe_starts_with_its_speed(self):
        run = self.runs.of("cyl-200", "in.tmax=0.002")
        figure, (axes,) = style.panels(1, 1)
        chapter6_airbags.draw_displacement(axes, run, "probe")
        (depth,) = (line.get_xydata() for line in axes.lines)
        self.assertAlmostEqual(depth[1, 1] / depth[1, 0], 3.9, delta=0.05)  # mm a ms
        along, out = chapter6_airbags.both_sides(run, 0, chapter6_airbags.BAG)
        self.assertAlmostEqual(out.sum(), 0)
        self.assertAlmostEqual(2 * out.max(), chapter6_airbags.WIDEST, delta=20)


if __name__ == "__main__":
    unittest.main()
