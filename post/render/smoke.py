# SPDX-License-Identifier: GPL-3.0-or-later
"""Smoke in a regular box: light that passes through it, and what a camera sees of it, layer by layer."""
import numpy

BETWEEN = 3  # layers for each of cells


def shifted(layer, rows, columns, outside):
    """A layer at places that are so many rows and columns on, between the cells by lines; `outside` beyond it."""
    height, width = layer.shape
    padded = numpy.pad(layer, 1, constant_values=outside)
    y = numpy.clip(numpy.arange(height) + rows + 1, 0, height + 0.999)
    x = numpy.clip(numpy.arange(width) + columns + 1, 0, width + 0.999)
    y0, x0 = y.astype(int), x.astype(int)
    fy, fx = (y - y0)[:, None], (x - x0)[None, :]
    return ((1 - fy) * ((1 - fx) * padded[y0][:, x0] + fx * padded[y0][:, x0 + 1])
            + fy * ((1 - fx) * padded[y0 + 1][:, x0] + fx * padded[y0 + 1][:, x0 + 1]))


def light_in(absorption, sizes, direction):
    """Share of the light that comes through to the middle of each cell, over (z, y, x), from above: layers of y from the top
    down. `absorption` is that of a cell [1/length], `sizes` are those of cells along x, y, z, `direction` leads to the light.
    """
    way = sizes[1] / direction[1]  # from one layer to the next
    rows, columns = direction[2] * way / sizes[2], direction[0] * way / sizes[0]
    length = way * numpy.linalg.norm(direction)
    light = numpy.ones_like(absorption)
    for layer in range(absorption.shape[1] - 2, -1, -1):
        above = light[:, layer + 1] * numpy.exp(-length * absorption[:, layer + 1])
        light[:, layer] = shifted(above, rows, columns, 1.0)
    return light


def sample(field, low, sizes, points, outside=0.0):
    """A field of cells, (z, y, x), at points (..., 3), between the middles by lines."""
    padded = numpy.pad(field, 1, mode="edge")
    place = (points - low) / sizes + 0.5
    counts = numpy.array(field.shape[::-1])
    inside = ((place > 0.5) & (place < counts + 0.5)).all(axis=-1)
    place = numpy.clip(place, 0, counts + 0.999)
    x, y, z = numpy.moveaxis(place, -1, 0)
    x0, y0, z0 = (part.astype(int) for part in (x, y, z))
    found = 0
    for dz, wz in ((0, 1 - (z - z0)), (1, z - z0)):
        for dy, wy in ((0, 1 - (y - y0)), (1, y - y0)):
            for dx, wx in ((0, 1 - (x - x0)), (1, x - x0)):
                found = found + wz * wy * wx * padded[z0 + dz, y0 + dy, x0 + dx]
    return numpy.where(inside, found, outside)


def across(layer, low, sizes, x, y):
    """A layer of cells, (y, x), at places in its plane; 0 beyond it."""
    height, width = layer.shape
    padded = numpy.pad(layer, ((1, 1), (1, 1)) + ((0, 0),) * (layer.ndim - 2))
    column, row = (x - low[0]) / sizes[0] + 0.5, (y - low[1]) / sizes[1] + 0.5
    inside = (column > 0) & (column < width + 1) & (row > 0) & (row < height + 1)
    column, row = numpy.where(inside, column, 0.0), numpy.where(inside, row, 0.0)
    x0, y0 = column.astype(int), row.astype(int)
    fx, fy = column - x0, row - y0
    return ((1 - fy) * ((1 - fx) * padded[y0, x0] + fx * padded[y0, x0 + 1])
            + fy * ((1 - fx) * padded[y0 + 1, x0] + fx * padded[y0 + 1, x0 + 1])) * inside


def between(field):
    """More layers across z, by lines between the middles of cells, so that single ones do not show."""
    places = numpy.clip((numpy.arange(BETWEEN * len(field)) + 0.5) / BETWEEN - 0.5, 0, len(field) - 1)
    first = numpy.minimum(places.astype(int), len(field) - 2)
    part = (places - first)[:, None, None]
    return (1 - part) * field[first] + part * field[first + 1]


def over(picture, depth, camera, smoke, low, sizes, tints):
    """The picture with smoke in front of it, from the back to the front: `depth` is that of what stands in each pixel,
    `smoke` its absorption [1/length], its light and the share of it that has the second colour, (z, y, x), `tints` are both
    colours in full light."""
    absorption, light, second = (between(field) for field in smoke)
    tints = numpy.asarray(tints)
    rays = camera.rays()
    length = numpy.linalg.norm(rays, axis=-1) * sizes[2] / BETWEEN / numpy.maximum(-rays[..., 2], 1e-9)
    for layer in range(absorption.shape[0]):
        if not absorption[layer].any():
            continue
        z = low[2] + (layer + 0.5) * sizes[2] / BETWEEN
        ahead = (z - camera.eye[2]) / rays[..., 2]  # depth at which a ray passes the layer
        x, y = (camera.eye[k] + ahead * rays[..., k] for k in (0, 1))
        thick = across(absorption[layer], low, sizes, x, y)
        bright, share = (across(absorption[layer] * field[layer], low, sizes, x, y) / numpy.maximum(thick, 1e-12)
                         for field in (light, second))
        cover = (1 - numpy.exp(-thick * length)) * (ahead < depth)
        picture += cover[..., None] * (bright[..., None] * (tints[0] + share[..., None] * (tints[1] - tints[0])) - picture)
    return picture
