# SPDX-License-Identifier: GPL-3.0-or-later
"""A liquid with a surface in a box of cells."""
import numpy
from matplotlib import colormaps, colors

from render import blocks
from render.picture import Surface

WATER = colors.LinearSegmentedColormap.from_list("water", colormaps["Blues"](numpy.linspace(0.35, 1, 256)))  # still water is blue
FINER = 4  # points of the picture along each side of a cell


def finer(values):
    """Values at the middles of cells, between them by lines, so many times finer; beyond the last middles constant."""
    for axis in (0, 1):
        count = values.shape[axis]
        places = (numpy.arange(FINER * count) + 0.5) / FINER - 0.5
        low = numpy.clip(numpy.floor(places).astype(int), 0, max(count - 2, 0))
        part = numpy.clip(places - low, 0, 1).reshape([-1 if a == axis else 1 for a in (0, 1)])
        values = (1 - part) * values.take(low, axis) + part * values.take(numpy.minimum(low + 1, count - 1), axis)
    return values


def filled(values, known):
    """Cells that are not known get the mean of those next to them that are, layer after layer."""
    values, known = numpy.where(known, values, 0.0), known.copy()
    for _ in range(3):
        sums, counts = numpy.zeros_like(values), numpy.zeros_like(values)
        padded, marks = numpy.pad(values * known, 1), numpy.pad(known.astype(float), 1)
        for shift in ((0, 1), (2, 1), (1, 0), (1, 2)):
            rows, columns = (slice(s, s + n) for s, n in zip(shift, values.shape))
            sums += padded[rows, columns]
            counts += marks[rows, columns]
        new = ~known & (counts > 0)
        values[new] = sums[new] / counts[new]
        known |= new
    return values


def draw_plane(axes, x, y, cells, values, scale):
    """The field in the liquid, up to its surface, which is a line."""
    wet = (cells["kind"] == 0) & numpy.isfinite(values)
    distance, fine = finer(cells["surface"]), finer(filled(values, wet))
    edges = [numpy.linspace(float(side[0]), float(side[-1]), FINER * (len(side) - 1) + 1) for side in (x, y)]
    axes.pcolormesh(*edges, numpy.ma.masked_where(distance >= 0, fine), cmap=scale.colours, norm=scale.norm, zorder=1)
    middles = [0.5 * (edge[1:] + edge[:-1]) for edge in edges]
    if distance.min() < 0 < distance.max():
        axes.contour(*middles, distance, levels=[0.0], colors="0.25", linewidths=0.7, zorder=1.2)


def at_places(places, values, wet, box):
    """What the cells with liquid next to a place's own cell have there, as a mean."""
    edges = [numpy.asarray(box.edges[name], dtype=float) for name in "xyz"]
    cell = [numpy.clip(numpy.searchsorted(edge, places[:, k]) - 1, 0, len(edge) - 2) for k, edge in enumerate(edges)]
    spread, counts = numpy.where(wet, values, 0.0), wet.astype(float)
    for axis in range(3):
        for field in (spread, counts):
            field += numpy.roll(field, 1, axis) + numpy.roll(field, -1, axis)
    mean = spread / numpy.maximum(counts, 1)
    return mean[cell[2], cell[1], cell[0]]


def surfaces(corners, cells, values, box, scale):
    """A liquid's surface in space as triangles in the field's colours, and what of the box's sides it wets."""
    wet = (cells["kind"] == 0) & numpy.isfinite(values)
    found = []
    places = numpy.stack([numpy.asarray(corners[name]) for name in "xyz"], axis=1)
    places = places[numpy.isfinite(places).all(axis=1)]
    if len(places):
        colours = scale.rgba(at_places(places, values, wet, box))[:, :3]
        found.append(Surface(places.reshape(-1, 3, 3), colours.reshape(-1, 3, 3)))
    return found + on_sides(cells["surface"], values, wet, box, scale)


def on_sides(distance, values, wet, box, scale):
    """What the liquid wets of the box's sides, each in the colour of its mean."""
    edges = [numpy.asarray(box.edges[name], dtype=float) for name in "xyz"]
    low, sizes = numpy.array([edge[0] for edge in edges]), numpy.array([edge[1] - edge[0] for edge in edges])
    found = []
    for axis in range(3):  # of the array: z, y, x
        fine = numpy.where(numpy.arange(3) == 2 - axis, sizes, sizes / FINER)
        for end, place in ((0, 0), (-1, wet.shape[axis])):
            layer = numpy.take(wet, end, axis)
            if not layer.any():
                continue
            colour = tuple(scale.rgba(numpy.array([numpy.take(values, end, axis)[layer].mean()]))[0, :3])
            below = finer(numpy.take(distance, end, axis)) < 0
            found += [blocks.face(axis, place, span, low, fine, colour) for span in blocks.rectangles(below)]
    return found
