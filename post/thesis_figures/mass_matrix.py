# SPDX-License-Identifier: GPL-3.0-or-later
"""The mass matrix method in one cell, in numpy, as src/physics/points/normals_cells.hpp has it.

Places are r and s from 0 to 1 in the cell. Colours are measured from the membrane's: 0 at its points, 1 at the extra one.
"""
import itertools

import numpy

from .grid_colors import quadratic_slopes, quadratic_weights

SOFTEST = (1e-8, 1e-4)  # squares of bends and of twists beside the errors at points
STIFFER, MOST_ROUNDS = 100.0, 5
EXTRA_DISTANCE = 0.25


class Linear:
    """Colours at the four nodes, row by row from the lower left (7.13)."""

    bends, twists = numpy.array([[1.0, -1, -1, 1]]), numpy.zeros((0, 4))

    @staticmethod
    def weights(r, s):
        return numpy.array([(1 - r) * (1 - s), r * (1 - s), (1 - r) * s, r * s])

    @staticmethod
    def slopes(r, s):
        return numpy.array([[s - 1, 1 - s, -s, s], [r - 1, -r, 1 - r, r]])


def nine(along_r, along_s):
    return numpy.array([a * b for b in along_s for a in along_r])


FIRST, MIDDLE, LAST = numpy.eye(3)
RISE, NEXT_RISE, BEND = numpy.array([[-1.0, 1, 0], [0, -1, 1], [1, -2, 1]])


class Quadratic:
    """Colours at nine cells' centres, row by row from the lower left (7.18)."""

    bends = numpy.array([nine(BEND, at) for at in (FIRST, MIDDLE, LAST)] + [nine(at, BEND) for at in (FIRST, MIDDLE, LAST)] +
                        [nine(a, b) for a, b in itertools.product((RISE, NEXT_RISE), repeat=2)])
    twists = numpy.array([nine(BEND, RISE), nine(BEND, NEXT_RISE), nine(RISE, BEND), nine(NEXT_RISE, BEND), nine(BEND, BEND)])

    @staticmethod
    def weights(r, s):
        return nine(quadratic_weights(r - 0.5), quadratic_weights(s - 0.5))

    @staticmethod
    def slopes(r, s):
        by_r, by_s = quadratic_weights(r - 0.5), quadratic_weights(s - 0.5)
        return numpy.array([nine(quadratic_slopes(r - 0.5), by_s), nine(by_r, quadratic_slopes(s - 0.5))])


def extra_point(r, s):
    """A quarter of a cell off the straight line nearest to the points, on the side that lies deeper in the cell."""
    middle = numpy.array([r.mean(), s.mean()])
    normal = numpy.linalg.eigh(numpy.cov(r, s, bias=True))[1][:, 0]
    sides = [middle + sign * EXTRA_DISTANCE * normal for sign in (1, -1)]
    return min(sides, key=lambda at: abs(at - 0.5).max())


def gradients(kind, colours, r, s):
    """By point (7.14), (7.19)."""
    return numpy.array([kind.slopes(a, b) @ colours for a, b in zip(r, s)])


def go_together(of_points):
    """Whether all gradients go with their mean, at least half as far."""
    mean = of_points.mean(axis=0)
    return bool(numpy.all(of_points @ mean > 0.5 * mean @ mean))


def rows_of(kind, r, s):
    """What is asked of the colours: rows and values (7.10), whose normal equations are (7.12)."""
    places = list(zip(r, s)) + [extra_point(r, s)]
    return numpy.array([kind.weights(*at) for at in places]), numpy.array([0.0] * len(r) + [1.0])


def plain_fit(kind, r, s):
    """Nothing but T chi = f (7.12), by elimination: worthless where T is nearly singular."""
    rows, values = rows_of(kind, r, s)
    return numpy.linalg.solve(rows.T @ rows, rows.T @ values)


def fit(kind, r, s):
    """As the program does it: least bent where T is nearly singular, and stiffer where gradients turn round."""
    rows, values = rows_of(kind, r, s)
    zeros = numpy.zeros(len(kind.bends) + len(kind.twists))
    for number in range(MOST_ROUNDS + 1):
        bend, twist = (STIFFER ** (number / 2) * numpy.sqrt(softest) for softest in SOFTEST)
        matrix = numpy.concatenate((rows, bend * kind.bends, twist * kind.twists))
        colours = numpy.linalg.lstsq(matrix, numpy.concatenate((values, zeros)), rcond=None)[0]
        if go_together(gradients(kind, colours, r, s)):
            break
    return colours
