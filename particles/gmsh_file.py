# SPDX-License-Identifier: GPL-3.0-or-later
"""Simplices as a file of Gmsh's format 2.2, for the scripts that write meshes."""
import numpy

EDGES = {3: ((0, 1), (1, 2), (2, 0)), 4: ((0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3))}  # in the order of Gmsh
KINDS = {3: 9, 4: 11}  # of Gmsh: triangles and tetrahedra of order 2


def volume(places, simplex):
    """Times 2 in the plane, times 6 in space."""
    ways = [places[node] - places[simplex[0]] for node in simplex[1:]]
    return numpy.linalg.det(numpy.array(ways)[:, : len(ways)])


def turned(places, simplex):
    """The same with a volume above 0."""
    return tuple(simplex) if volume(places, simplex) > 0 else (simplex[1], simplex[0], *simplex[2:])


def with_middles(places, simplices):
    """Nodes in the middles of edges, so that the elements are of order 2."""
    middles, places, found = {}, list(places), []
    for simplex in simplices:
        nodes = list(simplex)
        for i, j in EDGES[len(simplex)]:
            edge = tuple(sorted((simplex[i], simplex[j])))
            if edge not in middles:
                middles[edge] = len(places)
                places.append((places[edge[0]] + places[edge[1]]) / 2)
            nodes.append(middles[edge])
        found.append(nodes)
    return places, found


def write(path, places, simplices, sets=None):
    """Region 1 is the body, of elements of order 2; each of `sets` is a function of a place that says what it holds."""
    corners = len(simplices[0])
    places, elements = with_middles(places, simplices)
    rows = [f"{KINDS[corners]} 2 1 1 " + " ".join(str(node + 1) for node in nodes) for nodes in elements]
    names = []
    for number, (name, holds) in enumerate((sets or {}).items()):
        names.append(f'0 {number + 2} "{name}"')
        rows += [f"15 2 {number + 2} {number + 2} {k + 1}" for k, place in enumerate(places) if holds(place)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
    lines += ["$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames"] if names else []
    lines += ["$Nodes", str(len(places))]
    lines += [f"{k + 1} " + " ".join(f"{x:.9g}" for x in (*place, 0)[:3]) for k, place in enumerate(places)]
    lines += ["$EndNodes", "$Elements", str(len(rows)), *(f"{k + 1} {row}" for k, row in enumerate(rows))]
    path.write_text("\n".join(lines + ["$EndElements", ""]))
