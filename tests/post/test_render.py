# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures in space against what can be said exactly of them: perspective, nearness, light through smoke, shadows."""
import pathlib
import sys
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "post"))

from render import raster, smoke
from render.camera import Camera
from render.picture import LIGHT, Picture, Surface, rectangle

BOX = (numpy.zeros(3), numpy.array((2.0, 1.5, 1.0)))


class CameraSeesTheBox(unittest.TestCase):
    def test_all_of_it_and_as_large_as_can_be(self):
        for pixels in ((640, 480), (300, 700)):
            camera = Camera(*BOX, pixels)
            corners = numpy.array([[x, y, z] for x in (0, 2) for y in (0, 1.5) for z in (0, 1)])
            places, depth = camera.project(corners)
            least, most = places.min(axis=0), places.max(axis=0)
            self.assertTrue((least >= 0).all() and (most <= pixels).all() and (depth > 0).all())
            self.assertAlmostEqual(max((most - least) / pixels), 0.96, 9)
            numpy.testing.assert_allclose((least + most) / 2, numpy.array(pixels) / 2, rtol=0, atol=1e-9)

    def test_a_ray_leads_to_what_its_pixel_shows(self):
        camera = Camera(*BOX, (64, 48))
        points = camera.eye + 3.7 * camera.rays()
        places, depth = camera.project(points)
        numpy.testing.assert_allclose(depth, 3.7, rtol=1e-12)
        numpy.testing.assert_allclose(places[10, 20], (20.5, 10.5), rtol=0, atol=1e-9)


class Raster(unittest.TestCase):
    def test_values_are_those_of_the_place_and_not_of_the_picture(self):
        camera = Camera(*BOX, (200, 150))
        triangle = numpy.array([[[0, 0, 0], [2, 0, 0], [0, 0, 1]]], dtype=float)  # the floor, seen aslant
        places, depth = camera.project(triangle)
        nearest, values = raster.draw(places, 1 / depth, triangle, camera.pixels)
        seen = nearest > 0
        points = camera.eye + camera.rays()[seen] / nearest[seen][:, None]
        self.assertGreater(seen.sum(), 500)
        numpy.testing.assert_allclose(values[seen], points, rtol=0, atol=1e-9)

    def test_the_nearer_one_is_seen_whatever_the_order(self):
        far = numpy.array([[0.0, 0], [9, 0], [0, 9]])
        places, ones = numpy.stack([far, far]), numpy.ones((2, 3))
        for order in ((0, 1), (1, 0)):
            near = ones * numpy.array([0.5, 0.25])[list(order), None]
            colours = numpy.ones((2, 3, 1)) * numpy.array([5.0, 7.0])[list(order), None, None]
            nearest, values = raster.draw(places, near, colours, (10, 10))
            self.assertAlmostEqual(values[nearest > 0].min(), 5.0, 12)
            self.assertAlmostEqual(values[nearest > 0].max(), 5.0, 12)


class Smoke(unittest.TestCase):
    def test_light_falls_off_along_its_way(self):
        sizes = numpy.array((0.1, 0.05, 0.2))
        straight = smoke.light_in(numpy.full((3, 8, 4), 2.0), sizes, (0.0, 1.0, 0.0))
        numpy.testing.assert_allclose(straight[1, :, 2], numpy.exp(-2.0 * 0.05 * numpy.arange(7, -1, -1)), rtol=1e-12)
        slant = smoke.light_in(numpy.full((3, 8, 40), 2.0), sizes, (0.6, 0.8, 0.0))
        numpy.testing.assert_allclose(slant[1, :, 2], numpy.exp(-2.0 * 0.05 / 0.8 * numpy.arange(7, -1, -1)), rtol=1e-12)

    def test_the_shade_lies_on_the_side_away_from_the_light(self):
        fog = numpy.zeros((1, 6, 20))
        fog[0, 5, 10] = 50.0
        light = smoke.light_in(fog, numpy.ones(3), (1.0, 1.0, 0.0))
        self.assertLess(light[0, 0, 5], 1e-6)
        self.assertEqual(light[0, 0, 15], 1.0)

    def test_a_layer_covers_as_much_as_it_is_thick(self):
        camera = Camera(*BOX, (60, 45))
        fog = numpy.full((4, 6, 8), 1.3)
        sizes = numpy.array((0.25, 0.25, 0.25))
        smoke_there = fog, numpy.ones_like(fog), numpy.full_like(fog, 0.25)
        picture = smoke.over(numpy.zeros((45, 60, 3)), numpy.full((45, 60), numpy.inf), camera, smoke_there, numpy.zeros(3),
                             sizes, ((0.9, 0.8, 0.7), (0.1, 0.4, 0.7)))
        places, _ = camera.project(numpy.array((1.0, 0.75, 0.5)))
        across, down = places.astype(int)
        ray = camera.rays()[down, across]
        through = numpy.linalg.norm(ray) / -ray[2]  # from the front to the back, along the ray
        cover = 1 - numpy.exp(-1.3 * through)
        numpy.testing.assert_allclose(picture[down, across], cover * numpy.array((0.7, 0.7, 0.7)), rtol=1e-6)

    def test_what_stands_in_front_is_not_covered(self):
        camera = Camera(*BOX, (60, 45))
        fog = numpy.full((4, 6, 8), 1.3)
        picture = smoke.over(numpy.zeros((45, 60, 3)), numpy.zeros((45, 60)), camera, (fog, numpy.ones_like(fog), 0 * fog),
                             numpy.zeros(3), numpy.full(3, 0.25), 2 * ((1.0, 1.0, 1.0),))
        self.assertEqual(picture.max(), 0.0)


class Shadows(unittest.TestCase):
    def brightness(self, picture, camera, point):
        across, down = camera.project(numpy.asarray(point))[0].astype(int)
        return picture[down, across].mean()

    def test_a_plate_darkens_the_floor_where_it_keeps_the_light_off(self):
        scene = Picture(*BOX, (320, 240))
        plate = rectangle((0.8, 0.5, 0.3), (0, 0, 0.4), (0.4, 0, 0), (0.5, 0.5, 0.5))
        bare, shaded = scene.draw([]), scene.draw([plate])
        middle = numpy.array((1.0, 0.5, 0.5)) - 0.5 / LIGHT[1] * LIGHT  # the plate's middle along the light, on the floor
        self.assertLess(self.brightness(shaded, scene.camera, middle), 0.8 * self.brightness(bare, scene.camera, middle))
        aside = middle + (0.6, 0, 0)
        self.assertAlmostEqual(self.brightness(shaded, scene.camera, aside), self.brightness(bare, scene.camera, aside), 6)

    def test_a_surface_does_not_shade_itself(self):
        scene = Picture(*BOX, (160, 120))
        table = Surface(rectangle((0, 0.3, 0), (0, 0, 1), (2, 0, 0), (0.6, 0.6, 0.6)).triangles, (0.6, 0.6, 0.6))
        points = numpy.array([[0.3, 0.3, 0.2], [1.1, 0.3, 0.7], [1.9, 0.3, 0.9]])
        numpy.testing.assert_allclose(scene.in_light([table], points), 1.0)

    def test_smoke_shades_the_floor(self):
        scene = Picture(*BOX, (160, 120))
        fog = numpy.zeros((10, 15, 20))
        fog[:, 12:, :10] = 30.0
        sizes = numpy.full(3, 0.1)
        points = numpy.array([[0.3, 0.06, 0.1], [1.8, 0.06, 0.1]])
        dark = smoke.sample(smoke.light_in(fog, sizes, LIGHT), BOX[0], sizes, points, 1.0)
        self.assertLess(dark[0], 0.15)  # layer by layer light spreads a little
        self.assertGreater(dark[1], 0.99)
        self.assertEqual(scene.draw([], (fog, sizes)).shape, (120, 160, 3))


if __name__ == "__main__":
    unittest.main()
