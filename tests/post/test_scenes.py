# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of flows, boxes and elements: levels of streamlines, one scale over all panels, bodies where they are."""
import shutil
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "post"), str(Path(__file__).parent)]

import matplotlib

matplotlib.use("Agg")

import netCDF4
import numpy
from matplotlib import collections

import tether_results
from render import blocks
from scene import choose, liquid, quantities, topology
from scene.box import OBSTACLE, BoxScene
from scene.flow import FlowMesh
from small_runs import DeckTest

PADDLE, BAR = {"in.tmax": 0.1}, {"in.tmax": 0.3}


class Streamlines(DeckTest):
    def check_symmetric(self, mesh, record=-1):
        stream = mesh.fields.at(record)["stream"]
        middle = mesh.middle(stream)
        for levels in mesh.levels(stream):
            numpy.testing.assert_allclose(levels - middle, (middle - levels)[::-1], atol=1e-15)
        return stream, middle

    def test_levels_of_the_cylinder_are_symmetric_about_its_wall(self):
        mesh = FlowMesh(self.run_of("cylinder").fields("mesh"))
        stream, middle = self.check_symmetric(mesh)
        wall = numpy.hypot(mesh.x - 0.2, mesh.y - 0.2) < 0.05 + 1e-6
        numpy.testing.assert_allclose(stream[wall], middle, rtol=1e-4)

    def test_both_eddies_of_the_cylinder_are_drawn(self):
        mesh = FlowMesh(self.run_of("cylinder").fields("mesh"))
        stream = mesh.fields.at(-1)["stream"]
        lines = mesh.closed(stream, mesh.levels(stream)[1])
        heights = [line[:, 1].mean() - 0.2 for line in lines if 0.25 < line[:, 0].mean() < 0.35]
        self.assertGreaterEqual(sum(height > 0.005 for height in heights), 2)
        self.assertEqual(sum(height > 0.005 for height in heights), sum(height < -0.005 for height in heights))

    def test_corners_of_the_cavity_are_drawn_about_its_walls(self):
        mesh = FlowMesh(self.run_of("cavity").fields("mesh"))
        stream, middle = self.check_symmetric(mesh)
        self.assertAlmostEqual(middle, 0, delta=1e-5)
        lines = mesh.closed(stream, mesh.levels(stream)[1])
        self.assertTrue(any((line.min(axis=0) > (0.8, 0)).all() and line[:, 1].max() < 0.2 for line in lines))

    def test_levels_are_the_same_in_all_panels(self):
        run = self.run_of("two-flaps", {"flow.element": "q1q1", "mesh.cells(1:2,1)": (32, 8), "mesh.cells(2,2:3)": (5, 5),
                                        "in.tmax": 0.2})
        scene = choose.scene_of(run)
        scene.fit([0, 1, 2])
        flow = scene.layers[0]
        spacings = []
        for record in (1, 2):
            main, _ = flow.mesh.levels(flow.fields.at(record)["stream"], reach=flow.reach)
            spacings.append(numpy.diff(main).max())
            self.check_symmetric(flow.mesh, record)
        self.assertAlmostEqual(spacings[0], spacings[1])

    def test_a_fluid_at_rest_has_no_lines(self):
        mesh = FlowMesh(self.run_of("cavity").fields("mesh"))
        self.assertEqual([len(levels) for levels in mesh.levels(numpy.zeros_like(mesh.x))], [0, 0])


class Boxes(DeckTest):
    def test_cells_stand_where_they_are(self):
        scene = BoxScene(self.run_of("coupled-paddle-3d", PADDLE))
        self.assertEqual((scene.shape, scene.dim), ((16, 24, 32), 3))
        numpy.testing.assert_allclose(scene.in_space.low, 0, atol=1e-12)
        numpy.testing.assert_allclose(scene.in_space.picture.high, (2, 1.5, 1), atol=1e-12)
        kind = scene.cells("kind", 0)
        self.assertTrue((kind[:, 0, :] == OBSTACLE).all())  # the floor
        self.assertFalse((kind[:, 1:, :] == OBSTACLE).any())

    def test_speeds_are_those_of_the_jet(self):
        scene = BoxScene(self.run_of("coupled-sheets", PADDLE))
        speed = scene.cells("speed", scene.record_at(0.1))
        rows = (scene.box.axes["y"] > 0.2) & (scene.box.axes["y"] < 0.35)
        self.assertTrue((abs(speed[rows, 0] / 5 - 1) < 0.3).all())

    def test_one_scale_one_frame_and_a_bar_for_bodies_over_all_panels(self):
        scene = choose.scene_of(self.run_of("coupled-bar", BAR))
        figure = scene.figure([1, 3, 4])
        panels, bars = figure.axes[:3], figure.axes[3:]
        self.assertEqual([axes.get_ylabel() for axes in bars], ["density of smoke", "energy density [Pa]"])
        for kind in (collections.QuadMesh, collections.TriMesh):
            scales = {(mesh.norm.vmin, mesh.norm.vmax) for axes in panels for mesh in axes.collections
                      if isinstance(mesh, kind) and mesh.cmap.N > 1}
            self.assertEqual(len(scales), 1, kind)
        self.assertEqual(len({(axes.get_xlim(), axes.get_ylim()) for axes in panels}), 1)
        self.assertEqual(len({tuple(axes.get_position().size.round(9)) for axes in panels}), 1)

    def test_what_matters_in_a_box(self):
        for deck, values, field in (("coupled-bar", BAR, "smoke"), ("coupled-archimedes", {"in.tmax": 0.05}, "p"),
                                    ("coupled-balloon", {"in.tmax": 0.1}, "speed"), ("liquid-drop", {"in.tmax": 0.1}, "speed")):
            self.assertEqual(choose.scene_of(self.run_of(deck, values)).layers[0].name, field)

    def test_bodies_in_space_are_drawn_where_they_are(self):
        scene = BoxScene(self.run_of("coupled-bar-3d", {"in.tmax": 0.05}))
        camera, kind = scene.in_space.picture.camera, scene.cells("kind", 0)
        nothing = numpy.zeros(kind.shape)
        with_bar, bare = (scene.in_space.draw(kind, nothing, surfaces, quantities.Scale("smoke", "1"), False) for surfaces in (scene.surfaces(0), []))
        for point, seen in (((0.8, 0.25, 0.5), True), ((0.75, 0.5, 0.5), True), ((1.6, 0.45, 0.5), False)):
            across, down = camera.project(numpy.array(point))[0].astype(int)
            self.assertEqual(abs(with_bar - bare)[down, across].max() > 0.05, seen, point)

    def test_a_liquid_is_drawn_up_to_its_surface(self):
        scene = choose.scene_of(self.run_of("liquid-drop", {"in.tmax": 0.1}))
        axes = scene.figure([0]).axes[0]
        mesh = next(mesh for mesh in axes.collections if isinstance(mesh, collections.QuadMesh))
        drawn = ~numpy.ma.getmaskarray(mesh.get_array()).reshape(256, 256)
        area = 0.3 + numpy.pi * 0.12**2
        self.assertAlmostEqual(drawn.mean(), area, delta=0.01 * area)

    def test_a_liquid_in_space_is_closed_by_the_sides_of_the_box(self):
        scene = BoxScene(self.run_of("liquid-bowl-3d", {"in.tmax": 0.02, "in.nx": 17, "in.ny": 17, "coupled.nz": 17,
                                                        "in.tiout(39)": 0.01}))
        cells = scene.fluid.at(0)
        scale = quantities.Scale("speed", "1")
        surfaces = liquid.surfaces(scene.surface.at(0), cells, quantities.value_of(cells, "speed"), scene.box, scale)
        floor = [surface.triangles for surface in surfaces if (surface.triangles[..., 1] == 0).all()]
        sides = numpy.concatenate(floor)[:, 1:] - numpy.concatenate(floor)[:, :1]
        self.assertAlmostEqual(numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=-1).sum() / 2, 1.0)
        top = surfaces[0].triangles  # of the surface itself: that of the pool, and of the water in the bowl
        self.assertTrue((abs(top[..., 1] - 0.15) < 0.03).any() and (abs(top[..., 1] - 0.55) < 0.05).any())

    def test_obstacles_have_few_faces_that_cover_what_is_seen(self):
        marked = numpy.zeros((3, 4, 5), dtype=bool)
        marked[:, 0, :] = True
        found = blocks.surfaces(marked, numpy.zeros(3), numpy.array((1.0, 2.0, 3.0)), (1, 1, 1))
        self.assertEqual(len(found), 6)
        area = 0
        for surface in found:
            sides = surface.triangles[:, 1:] - surface.triangles[:, :1]
            area += numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=-1).sum() / 2
        self.assertAlmostEqual(area, 2 * (5 * 9 + 5 * 2 + 9 * 2))


class Hostile(DeckTest):
    def test_fields_of_nan_leave_a_picture_with_the_scale_of_the_rest(self):
        for deck, values in (("coupled-bar", BAR), ("cylinder", None), ("ball-net", {"in.tmax": 0.21}),
                             ("rigid-free", {"in.tmax": 1.0, "in.iout(39)": 1, "in.tiout(39)": 0.5})):
            with self.subTest(deck=deck):
                other = self.folder / f"nan {deck}"
                shutil.copytree(self.run_of(deck, values).folder, other)
                for path in [path for name in ("mesh", "solids", "particles") for path in other.glob(f"{name}.nc")]:
                    spoil(path)
                scene = choose.scene_of(tether_results.open(other))
                scene.figure(list(range(len(scene.times)))).canvas.draw()
                self.assertTrue(numpy.isfinite(scene.limits).all())
                for scale in scene.scales:
                    self.assertTrue(numpy.isfinite((scale.low, scale.high)).all())


def spoil(path):
    """Makes each number of a file's last snapshot a NaN, but for integers, which know none."""
    with netCDF4.Dataset(path, "a") as data:
        for variable in data.variables.values():
            if variable.ndim > 1 and variable.dimensions[0] == "time" and variable.dtype.kind == "f":
                variable[-1] = numpy.nan


class Elements(DeckTest):
    def test_are_where_they_are_over_where_they_were(self):
        run = self.run_of("cook", {"mesh.cells(1,1)": (4, 4)})
        scene = choose.scene_of(run)
        self.assertEqual(choose.records_of(run, scene), [1])  # static: the first snapshot says nothing
        figure = scene.figure([1])
        outlines = [lines for lines in figure.axes[0].collections if isinstance(lines, collections.LineCollection)]
        start, now = (numpy.concatenate(lines.get_segments()) for lines in outlines)
        numpy.testing.assert_allclose(start.max(axis=0), (48, 60))
        mesh = run.fields("mesh")
        numpy.testing.assert_allclose(now.max(axis=0), mesh.places(1).max(axis=0))
        drawn = next(mesh for mesh in figure.axes[0].collections if isinstance(mesh, collections.TriMesh))
        self.assertAlmostEqual(drawn.norm.vmax, scene.layers[0].values(1).max())
        self.assertEqual(figure.axes[1].get_ylabel(), "von Mises stress")

    def test_rigid_bodies_have_no_scale(self):
        run = self.run_of("rigid-free", {"in.tmax": 1.0, "in.iout(39)": 1, "in.tiout(39)": 0.5})
        scene = choose.scene_of(run)
        self.assertEqual(scene.scales, [])
        figure = scene.figure([0, 1])
        self.assertEqual(len(figure.axes), 2)
        for axes in figure.axes:
            self.assertEqual(len(axes.images), 1)

    def test_outlines_and_faces_are_those_of_one_element(self):
        self.assertEqual(len(topology.outer_faces(numpy.array([[0, 1, 2, 3], [1, 2, 3, 4]]))), 6)
        self.assertEqual(len(topology.outer_faces(numpy.array([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]]))), 10)
        self.assertEqual(len(topology.outer_faces(numpy.arange(10)[None])), 16)
        pair = numpy.array([[0, 1, 2, 3, 4, 5], [2, 1, 6, 4, 7, 8]])
        self.assertEqual(len(topology.triangles(pair)), 8)
        self.assertEqual([sorted(loop.tolist()) for loop in topology.loops(topology.outer_edges(pair))],
                         [[0, 1, 2, 3, 5, 6, 7, 8]])
        edges = topology.outer_edges(numpy.array([[0, 1, 4, 3], [1, 2, 5, 4]]))
        self.assertEqual([sorted(loop.tolist()) for loop in topology.loops(edges)], [[0, 1, 2, 3, 4, 5]])

    def test_in_space_are_where_they_are(self):
        run = self.run_of("rigid-free", {"in.tmax": 1.0, "in.iout(39)": 1, "in.tiout(39)": 0.5})
        layer = choose.scene_of(run).layers[0]
        layer.fit([0, 1])
        picture, camera = layer.image(0), layer.room.picture.camera
        for point, seen in (((0.0, -1.0, 0.25), True), ((-1.3, 0.25, 0.25), True), ((-1.0, -1.0, 0.25), False)):
            across, down = camera.project(numpy.array(point))[0].astype(int)
            red, _, blue = picture[down, across]
            self.assertEqual(blue > 0.5 > red, seen, point)  # the body is bright blue, the room of a dark grey


if __name__ == "__main__":
    unittest.main()
