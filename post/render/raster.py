# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles into pixels: the nearest one of each, and what its corners have there."""
import numpy


def draw(places, nearness, values, pixels):
    """Of triangles, (n, 3, 2) in pixels, with a number for how near each corner is (it may be any that is linear in the
    picture) and k values a corner, (n, 3, k): nearness of the nearest (0 where there is none) and its values, a pixel each.
    Where `nearness` is one over the depth, values are those of a perspective picture."""
    across, down = pixels
    nearest = numpy.zeros((down, across))
    found = numpy.zeros((down, across, values.shape[-1]))
    first = numpy.maximum(numpy.floor(places.min(axis=1) - 0.5).astype(int), 0)
    last = numpy.minimum(numpy.ceil(places.max(axis=1) + 0.5).astype(int), numpy.array(pixels))
    for corners, near, of, (x0, y0), (x1, y1) in zip(places, nearness, values, first, last):
        if x1 > x0 and y1 > y0:
            fill(corners, near, of, nearest[y0:y1, x0:x1], found[y0:y1, x0:x1], (x0, y0))
    return nearest, found


def fill(corners, near, of, nearest, found, origin):
    """One triangle, in the part of the picture that holds it."""
    (ax, ay), (bx, by), (cx, cy) = corners - origin
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    if abs(area) < 1e-9:
        return
    y, x = numpy.ogrid[0.5:nearest.shape[0]:1, 0.5:nearest.shape[1]:1]
    second = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
    third = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
    weights = numpy.stack([1 - second - third, second, third], axis=-1)
    here = weights @ near
    seen = (weights >= -1e-9).all(axis=-1) & (here > nearest)
    nearest[seen] = here[seen]
    found[seen] = (weights[seen] * near) @ of / here[seen][:, None]
