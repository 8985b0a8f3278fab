#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the mesh of a bowl: the lower half of a spherical shell, of tetrahedra of order 2.

    write_bowl.py bowl.msh --centre .5,.55,.5 --inner .15 --outer .23 --rings 4 --layers 2
"""
import argparse
import itertools
import pathlib

import numpy


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
    return places, [turned(places, tet) for tet in tetrahedra]


def turned(places, tet):
    """The same with a volume above 0."""
    a, b, c, d = (places[node] for node in tet)
    return tet if numpy.dot(numpy.cross(b - a, c - a), d - a) > 0 else (tet[1], tet[0], tet[2], tet[3])


def with_middles(places, tetrahedra):
    """Nodes in the middles of edges, in the order of Gmsh's element 11."""
    middles, places, found = {}, list(places), []
    for tet in tetrahedra:
        nodes = list(tet)
        for i, j in ((0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3)):
            edge = tuple(sorted((tet[i], tet[j])))
            if edge not in middles:
                middles[edge] = len(places)
                places.append((places[edge[0]] + places[edge[1]]) / 2)
            nodes.append(middles[edge])
        found.append(nodes)
    return places, found


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
    places, elements = with_middles(*shell(centre, given.inner, given.outer, given.rings, given.layers))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(places))]
    lines += [f"{k + 1} {x:.9g} {y:.9g} {z:.9g}" for k, (x, y, z) in enumerate(places)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{k + 1} 11 2 1 1 " + " ".join(str(node + 1) for node in nodes) for k, nodes in enumerate(elements)]
    given.file.write_text("\n".join(lines + ["$EndElements", ""]))


if __name__ == "__main__":
    main()
