# SPDX-License-Identifier: GPL-3.0-or-later
"""One picture: surfaces in light and shadow, smoke in front of them and its shade on them."""
import numpy

from render import raster, smoke
from render.camera import Camera, LightCamera, unit

LIGHT = unit(numpy.array((0.3, 1.0, 0.55)))  # its direction
AMBIENT = 0.5  # share of the light that comes from everywhere
SHINE, SHARP = 0.12, 24  # of surfaces that mirror the light
SHADOW_PIXELS = 700
BIAS = 6e-3  # of the box, by which a surface is nearer than its own shadow
FLOOR, WALL = numpy.array((0.40, 0.40, 0.39)), numpy.array((0.36, 0.40, 0.46))
SKY = numpy.array((0.97, 0.97, 0.98))
GREY = (0.95, 0.94, 0.92)  # of smoke in full light


class Surface:
    """Triangles (n, 3, 3) with unit normals and colours of their corners."""

    def __init__(self, triangles, colours, normals=None):
        self.triangles = numpy.asarray(triangles, dtype=float)
        if normals is None:
            flat = numpy.cross(self.triangles[:, 1] - self.triangles[:, 0], self.triangles[:, 2] - self.triangles[:, 0])
            flat /= numpy.maximum(numpy.linalg.norm(flat, axis=1, keepdims=True), 1e-300)
            normals = numpy.repeat(flat[:, None], 3, axis=1)
        self.normals = normals
        self.colours = numpy.broadcast_to(colours, self.triangles.shape)


def rectangle(corner, first, second, colour, parts=1):
    """Two triangles of each part, counter-clockwise from first to second."""
    corner, first, second = (numpy.asarray(vector, dtype=float) for vector in (corner, first, second))
    square = numpy.array([(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)]).reshape(2, 3, 2)
    cells = numpy.array([(i, j) for i in range(parts) for j in range(parts)])
    places = (square[None] + cells[:, None, None, :]) / parts
    return Surface((corner + places[..., :1] * first + places[..., 1:] * second).reshape(-1, 3, 3), colour)


def room(low, high):
    """The floor, the wall at the back and that on the left."""
    x, y, z = numpy.diag(numpy.subtract(high, low))
    return [rectangle(low, z, x, FLOOR, 4), rectangle(low, x, y, WALL, 4), rectangle(low, y, z, WALL * 0.97, 4)]


class Picture:
    """A box from `low` to `high`, with surfaces, drawn with so many pixels across and down."""

    def __init__(self, low, high, pixels):
        self.low, self.high = numpy.asarray(low, dtype=float), numpy.asarray(high, dtype=float)
        self.camera = Camera(low, high, pixels)
        self.sun = LightCamera(low, high, LIGHT, SHADOW_PIXELS)
        self.pixels = pixels

    def draw(self, surfaces, fog=None, tints=2 * (GREY,), second=None):
        """Colours of the pixels, (down, across, 3), each from 0 to 1. `fog` is the absorption of cells [1/length] over
        (z, y, x), with their sizes, `tints` are its colours in full light, `second` the share of the second one."""
        light = smoke.light_in(*fog, LIGHT) if fog else None
        nearest, values = self.seen(surfaces + room(self.low, self.high))
        depth = numpy.divide(1.0, nearest, out=numpy.full_like(nearest, numpy.inf), where=nearest > 0)
        points = self.camera.eye + self.camera.rays() * numpy.where(numpy.isfinite(depth), depth, 0)[..., None]
        colours = self.lit(points, values, self.in_light(surfaces, points), light, fog)
        colours = numpy.where((nearest > 0)[..., None], colours, SKY)
        if fog:
            shades = AMBIENT + (1 - AMBIENT) * light
            share = numpy.zeros_like(light) if second is None else second
            smoke.over(colours, depth, self.camera, (fog[0], shades, share), self.low, fog[1], tints)
        return numpy.clip(colours, 0, 1)

    def seen(self, surfaces):
        """One over the depth, and colour and normal, of each pixel."""
        triangles = numpy.concatenate([surface.triangles for surface in surfaces])
        values = numpy.concatenate([numpy.concatenate([surface.colours, surface.normals], axis=-1) for surface in surfaces])
        places, depth = self.camera.project(triangles)
        ahead = (depth > 0).all(axis=1)
        return raster.draw(places[ahead], 1 / depth[ahead], values[ahead], self.pixels)

    def in_light(self, surfaces, points):
        """Whether nothing stands between each point and the light; at edges a share."""
        if not surfaces:
            return numpy.ones(points.shape[:-1])
        triangles = numpy.concatenate([surface.triangles for surface in surfaces])
        places, along = self.sun.project(triangles)
        size = numpy.linalg.norm(self.high - self.low)
        _, middle = self.sun.project(self.low)
        offset = 4 * size  # so that all are positive, and the nearest to the light the largest
        near, _ = raster.draw(places, middle + offset - along, numpy.zeros((*along.shape, 1)), self.sun.pixels)
        flat, mine = self.sun.project(points)
        mine = middle + offset - mine + BIAS * size
        lit = 0
        steps = (-1.0, 0.0, 1.0)
        for dx in steps:
            for dy in steps:
                x, y = (numpy.clip((flat[..., k] + d).astype(int), 0, SHADOW_PIXELS - 1) for k, d in ((0, dx), (1, dy)))
                lit = lit + (near[y, x] <= mine)
        return lit / len(steps)**2

    def lit(self, points, values, in_light, light, fog):
        """Colours in the light that comes to them: through smoke, past bodies, and from everywhere."""
        colours, normals = values[..., :3], values[..., 3:]
        views = self.camera.eye - points
        views /= numpy.maximum(numpy.linalg.norm(views, axis=-1, keepdims=True), 1e-300)
        normals = normals / numpy.maximum(numpy.linalg.norm(normals, axis=-1, keepdims=True), 1e-300)
        normals = numpy.where(((normals * views).sum(axis=-1) < 0)[..., None], -normals, normals)  # both sides of a sheet
        share = in_light * numpy.clip(normals @ LIGHT, 0, None)
        if fog:
            share = share * smoke.sample(light, self.low, fog[1], points + 2e-3 * views, outside=1.0)
        half = views + LIGHT
        half /= numpy.linalg.norm(half, axis=-1, keepdims=True)
        shine = SHINE * in_light * numpy.clip((normals * half).sum(axis=-1), 0, 1)**SHARP
        sky = 0.85 + 0.15 * normals[..., 1]
        return colours * (AMBIENT * sky + (1 - AMBIENT) * share)[..., None] * 1.15 + shine[..., None]
