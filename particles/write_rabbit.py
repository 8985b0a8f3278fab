#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the mesh of a sitting rabbit with long ears, made of ellipsoids, of tetrahedra (or triangles) of order 2.

    write_rabbit.py rabbit.msh --cell .045
    write_rabbit.py rabbit.msh --cell .03 --plane

It sits on y = 0, where the nodes are the set 'feet', and looks along x. A body-centred lattice of tetrahedra (in the
plane one of triangles) keeps those whose middle is in the rabbit; the nodes of its surface then go to that of the
rabbit as far as no element gets worse than it may, and the others to the middle of those next to them. After
N. Molino, R. Bridson, J. Teran, R. Fedkiw, Proc. 12th Int. Meshing Roundtable (2003) 103-114.
"""
import argparse
import itertools
import pathlib

import numpy

import gmsh_file

# Middle, radii and the angle about z of each ellipsoid; z from the plane that halves the rabbit.
PARTS = (
    ((-0.06, 0.13, 0), (0.19, 0.17, 0.16), 0.2),  # trunk
    ((-0.13, 0.07, 0.09), (0.12, 0.11, 0.07), 0),  # haunches
    ((-0.13, 0.07, -0.09), (0.12, 0.11, 0.07), 0),
    ((0.08, 0.17, 0), (0.1, 0.16, 0.11), -0.3),  # chest
    ((0.11, 0.03, 0.06), (0.09, 0.08, 0.05), 0),  # paws
    ((0.11, 0.03, -0.06), (0.09, 0.08, 0.05), 0),
    ((0.14, 0.35, 0), (0.12, 0.1, 0.095), -0.2),  # head
    ((-0.26, 0.13, 0), (0.06, 0.06, 0.06), 0),  # tail
    ((0.05, 0.55, 0.07), (0.05, 0.17, 0.045), 0.35),  # ears
    ((0.05, 0.55, -0.07), (0.05, 0.17, 0.045), 0.35),
)
ROUNDED = 0.012  # how far edges between the ellipsoids are rounded
WORST = 0.12  # of 1 for regular elements: what moves may leave


def distance(x):
    """About that of places from the surface, below 0 within."""
    x = numpy.atleast_2d(x)
    z = x[:, 2] if x.shape[1] == 3 else numpy.zeros(len(x))
    parts = []
    for (a, b, c), radii, angle in PARTS:
        along, up = x[:, 0] - a, x[:, 1] - b
        depth = z - c if x.shape[1] == 3 else 0 * z
        turned = numpy.stack([along * numpy.cos(angle) + up * numpy.sin(angle), up * numpy.cos(angle) - along * numpy.sin(angle), depth], 1)
        level = numpy.linalg.norm(turned / radii, axis=1)
        slope = numpy.linalg.norm(turned / numpy.square(radii), axis=1) / numpy.maximum(level, 1e-9)
        parts.append((level - 1) / numpy.maximum(slope, 1e-9))
    least = numpy.min(parts, axis=0)
    rounded = least - ROUNDED * numpy.log(numpy.sum(numpy.exp(-(numpy.array(parts) - least) / ROUNDED), axis=0))
    return numpy.maximum(rounded, -x[:, 1])


def lattice_of_tetrahedra(low, high, cell):
    """Corners and middles of cubes, and the four tetrahedra about each line between the middles of neighbours."""
    number = {}

    def node(*twice):
        return number.setdefault(twice, len(number))

    count = numpy.ceil((high - low) / cell).astype(int)
    found = []
    for i, j, k in itertools.product(*(range(n) for n in count)):
        here = numpy.array([2 * i + 1, 2 * j + 1, 2 * k + 1])
        for axis in range(3):
            there, one, other = here.copy(), numpy.zeros(3, int), numpy.zeros(3, int)
            there[axis] += 2
            one[(axis + 1) % 3], other[(axis + 2) % 3] = 1, 1
            face = (here + there) // 2
            corners = [face + s * one + t * other for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
            for m in range(4):
                found.append([node(*p) for p in (here, there, corners[m], corners[(m + 1) % 4])])
    return low + 0.5 * cell * numpy.array(list(number)), numpy.array(found)


def lattice_of_triangles(low, high, cell):
    count = numpy.ceil((high - low) / (cell, cell * 0.75**0.5)).astype(int) + 1
    places = numpy.array([(low[0] + (i + 0.5 * (j % 2)) * cell, low[1] + j * cell * 0.75**0.5) for j in range(count[1]) for i in range(count[0])])
    found = []
    for j, i in itertools.product(range(count[1] - 1), range(count[0] - 1)):
        a, b, c, d = (m + n * count[0] for m, n in ((i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)))
        found += [(a, b, c), (b, d, c)] if j % 2 == 0 else [(a, b, d), (a, d, c)]
    return places, numpy.array(found)


def within(places, simplices):
    """Those whose middle is in the rabbit, with the nodes that they have."""
    simplices = simplices[distance(places[simplices].mean(axis=1)) < 0]
    used, numbers = numpy.unique(simplices, return_inverse=True)
    places = places[used]
    return places, [gmsh_file.turned(places, simplex) for simplex in numbers.reshape(simplices.shape)]


def qualities(corners):
    """Of simplices by their corners' places: 1 where they are regular, below 0 where they are turned over."""
    ways = corners[:, 1:] - corners[:, :1]
    size = numpy.linalg.det(ways)
    pairs = list(itertools.combinations(range(corners.shape[1]), 2))
    mean = sum(numpy.sum((corners[:, i] - corners[:, j]) ** 2, axis=1) for i, j in pairs) / len(pairs)
    dim = corners.shape[2]
    return size * (2**0.5 if dim == 3 else 2 / 3**0.5) / mean ** (dim / 2)


def fitted(places, simplices, rounds=40):
    """Moves nodes, one after the other; those on the floor stay there."""
    simplices = numpy.array(simplices)
    sides = {}
    for simplex in simplices:
        for side in itertools.combinations(sorted(simplex), len(simplex) - 1):
            sides[side] = sides.get(side, 0) + 1
    edge = {node for side, count in sides.items() if count == 1 for node in side}
    about = [numpy.flatnonzero((simplices == node).any(axis=1)) for node in range(len(places))]
    around = [numpy.setdiff1d(simplices[own], node) for node, own in enumerate(about)]
    floor = places[:, 1] < 1e-9
    outer = [numpy.array([n for n in nodes if n in edge], int) for nodes in around]
    for _ in range(rounds):
        for node in range(len(places)):
            target = places[(outer if node in edge else around)[node]].mean(axis=0)
            target = places[node] + (0.3 if node in edge else 0.5) * (target - places[node])
            if node in edge:
                target = onto_surface(target)
            if floor[node]:
                target[1] = 0
            before = qualities(places[simplices[about[node]]]).min()
            for part in (1, 0.5, 0.25, 0.1):
                was = places[node].copy()
                places[node] = was + part * (target - was)
                if qualities(places[simplices[about[node]]]).min() >= min(before, WORST):
                    break
                places[node] = was
    return places


def onto_surface(x):
    """The place of the surface that is next to it, by three steps along the slope."""
    for _ in range(3):
        step = 1e-5 * numpy.eye(len(x))
        slope = (distance(x + step) - distance(x - step)) / 2e-5
        x = x - distance(x)[0] * slope / max(numpy.dot(slope, slope), 0.1)
    return x


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("file", type=pathlib.Path)
    options.add_argument("--cell", type=float, default=0.045, help="side of the lattice's cubes or triangles")
    options.add_argument("--at", default=".5,0,.5", help="where the middle of its floor is: x,y,z")
    options.add_argument("--plane", action="store_true", help="its outline, of triangles")
    given = options.parse_args()
    dim = 2 if given.plane else 3
    low, high = numpy.array([-0.36, 0, -0.25])[:dim], numpy.array([0.3, 0.8, 0.25])[:dim]
    lattice = lattice_of_triangles if given.plane else lattice_of_tetrahedra
    places, simplices = within(*lattice(low, high, given.cell))
    places = fitted(places, simplices)
    worst = qualities(places[numpy.array(simplices)]).min()
    print(f"{len(simplices)} elements, the worst of quality {worst:.2f}")
    middle = numpy.array([float(number) for number in given.at.split(",")])[:dim]
    gmsh_file.write(given.file, places + middle, simplices, {"feet": lambda x: x[1] < middle[1] + 1e-6})


if __name__ == "__main__":
    main()
