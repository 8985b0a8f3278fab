# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours that a body's points lend to the grid and their gradients, as src/physics/points/normals_grid.cpp has them."""
import numpy


def quadratic_weights(r):
    """Of the cells before, around and behind a point at r from the cell's centre, in parts of a cell: (A.3.2)."""
    return numpy.array([0.5 * (0.5 - r) ** 2, 0.75 - r**2, 0.5 * (0.5 + r) ** 2])


def quadratic_slopes(r):
    """Their derivatives."""
    return numpy.array([r - 0.5, -2 * r, r + 0.5])


def cell_of(place, width, cells):
    """What stands on the last edge, or a rounding error outside, is in the cell beside it."""
    return numpy.clip(numpy.floor(place / width).astype(int), 0, cells - 1)


def cell_colours(x, y, width, cells):
    """By row and column of the cells, all points having colour 1 (9.10), with a row and column behind each edge."""
    colours = numpy.zeros((cells + 2, cells + 2))
    i, j = cell_of(x, width, cells), cell_of(y, width, cells)
    along_x, along_y = quadratic_weights(x / width - i - 0.5), quadratic_weights(y / width - j - 0.5)
    for b in range(3):
        for a in range(3):
            numpy.add.at(colours, (j + b, i + a), along_x[a] * along_y[b])
    return colours


def gradients(x, y, width, cells):
    """Of the cells' colours at the nodes, times the cell's width, by row and column (7.5), (9.11)."""
    colours = cell_colours(x, y, width, cells)
    sw, se, nw, ne = colours[:-1, :-1], colours[:-1, 1:], colours[1:, :-1], colours[1:, 1:]
    return 0.5 * numpy.array([se - sw + ne - nw, nw - sw + ne - se])


def outward_normals(x, y, width, cells):
    """Unit vectors at the nodes, zero where the body is far: the colour grows into the body."""
    inward = gradients(x, y, width, cells)
    length = numpy.hypot(*inward)
    return numpy.where(length > 1e-9, -inward / numpy.maximum(length, 1e-9), 0.0)


def touched_nodes(x, y, width, cells):
    """Whether points contribute to the nodes by their linear shape functions."""
    touched = numpy.zeros((cells + 1, cells + 1), dtype=bool)
    i, j = cell_of(x, width, cells), cell_of(y, width, cells)
    for b in (0, 1):
        for a in (0, 1):
            touched[j + b, i + a] = True
    return touched
