# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of a regular box as surfaces: what of them can be seen, in as few rectangles as may be."""
import numpy

from render.picture import rectangle


def rectangles(marked):
    """Disjoint rectangles that cover what is marked: first and last rows and columns, the last ones left out."""
    left = marked.copy()
    found = []
    for row, column in zip(*numpy.nonzero(marked)):
        if not left[row, column]:
            continue
        width = run_of(left[row, column:])
        height = run_of(left[row:, column:column + width].all(axis=1))
        left[row:row + height, column:column + width] = False
        found.append((row, row + height, column, column + width))
    return found


def run_of(line):
    """How many of the first places are marked."""
    return len(line) if line.all() else int(numpy.argmin(line))


def surfaces(marked, low, sizes, colour):
    """The faces of marked cells, over (z, y, x), that border on others or on the outside."""
    found = []
    for axis in range(3):  # of the array: z, y, x
        layers = numpy.moveaxis(numpy.pad(marked, [(int(k == axis),) * 2 for k in range(3)]), axis, 0)
        for place in range(len(layers) - 1):
            for beyond in (layers[place] & ~layers[place + 1], ~layers[place] & layers[place + 1]):
                found += [face(axis, place, span, low, sizes, colour) for span in rectangles(beyond)]
    return found


def face(axis, place, span, low, sizes, colour):
    """A rectangle across an axis of the array, at a face between its cells."""
    first, second = [k for k in range(3) if k != axis]
    corner, one, other = numpy.zeros(3), numpy.zeros(3), numpy.zeros(3)
    corner[axis], corner[first], corner[second] = place, span[0], span[2]
    one[first], other[second] = span[1] - span[0], span[3] - span[2]
    corner, one, other = (vector[::-1] * sizes for vector in (corner, one, other))  # x, y, z
    return rectangle(low + corner, one, other, colour)
