#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the mesh of a bowl: the lower half of a spherical shell, of tetrahedra of order 2.

    write_bowl.py bowl.msh --centre .5,.55,.5 --inner .15 --outer .23 --rings 4 --layers 2
"""
import argparse
import itertools
import pathlib

import numpy

import gmsh_file


def disk(rings):
    """Nodes of a disk by (radius from 0 to 1, angle), ring after ring, and its triangles, counter-clockwise."""
    nodes, first = [(0.0, 0.0)], [0]
    for ring in range(1, rings + 1):
        first.append(len(nodes))
        nodes += [(ring / rings, 2 * numpy.pi * k / (6 * ring)) for k in range(6 * ring)]
    triangles = []
    for ring in range(1, rings + 1):
        inner, outer = max(6 * (ring - 1), 1), 6 * ring
        for sector in range(6):
            for k in range(ring):
                a, b = sector * ring + k, sector * (ring - 1) + k
                out, after = first[ring] + a, first[ring] + (a + 1) % outer
                triangles.append((first[ring - 1] + b % inner, out, after))
                if k + 1 < ring:
                    triangles.append((first[ring - 1] + b % inner, after, first[ring - 1] + (b + 1) % inner))
    return numpy.array(nodes), triangles


def shell(centre, inner, outer, rings, layers):
    """Places of the nodes of a half shell, and its tetrahedra."""
    flat, triangles = disk(rings)
    tilt = flat[:, 0] * numpy.pi / 2
    ways = numpy.stack([numpy.sin(tilt) * numpy.cos(flat[:, 1]), -numpy.cos(tilt), numpy.sin(tilt) * numpy.sin(flat[:, 1])], 1)
    places = numpy.concatenate([centre + (inner + (outer - inner) * k / layers) * ways for k in range(layers + 1)])
    tetrahedra = []
    for layer, triangle in itertools.product(range(layers), triangles):
        low = sorted(node + layer * len(flat) for node in triangle)  # so that prisms part their sides alike
        high = [node + len(flat) for node in low]
        tetrahedra += [(low[0], low[1], low[2], high[2]), (low[0], low[1], high[1], high[2]), (low[0], high[0], high[1], high[2])]
    return places, [gmsh_file.turned(places, tet) for tet in tetrahedra]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("file", type=pathlib.Path)
    options.add_argument("--centre", default=".5,.55,.5", help="of the sphere: x,y,z")
    options.add_argument("--inner", type=float, default=0.15, help="inner radius")
    options.add_argument("--outer", type=float, default=0.23, help="outer radius")
    options.add_argument("--rings", type=int, default=4, help="rings of triangles from the lowest place to the rim")
    options.add_argument("--layers", type=int, default=2, help="elements across the wall")
    given = options.parse_args()
    centre = numpy.array([float(number) for number in given.centre.split(",")])
    gmsh_file.write(given.file, *shell(centre, given.inner, given.outer, given.rings, given.layers))


if __name__ == "__main__":
    main()
