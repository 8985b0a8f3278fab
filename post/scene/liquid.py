# SPDX-License-Identifier: GPL-3.0-or-later
"""A liquid with a surface in a box of cells."""
import numpy

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
