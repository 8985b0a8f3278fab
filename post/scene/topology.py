# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements as matplotlib draws them: triangles, edges and outer faces, by the order in which mesh.nc counts nodes."""
import numpy

# Of a quadrangle of 9 nodes: corners, then middles of edges, then its own.
QUARTERS = ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3))
EDGES = {3: ((0, 1), (1, 2), (2, 0)), 4: ((0, 1), (1, 2), (2, 3), (3, 0)),
         9: ((0, 4), (4, 1), (1, 5), (5, 2), (2, 6), (6, 3), (3, 7), (7, 0))}
# Of tetrahedra and hexahedra by their corners, counter-clockwise from outside.
TETRAHEDRON = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
HEXAHEDRON = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def triangles(elements):
    """Elements of the plane as triangles: two of each quadrangle of 4 nodes, eight of each of 9."""
    if elements.shape[1] == 3:
        return elements
    quads = elements if elements.shape[1] == 4 else numpy.concatenate([elements[:, part] for part in QUARTERS])
    return numpy.concatenate([quads[:, (0, 1, 2)], quads[:, (0, 2, 3)]])


def single(parts):
    """Of edges or faces those that one element has alone."""
    _, first, count = numpy.unique(numpy.sort(parts, axis=1), axis=0, return_index=True, return_counts=True)
    return parts[numpy.sort(first[count == 1])]


def outer_edges(elements):
    """Edges around elements of the plane, in pieces from node to node."""
    return single(numpy.concatenate([elements[:, edge] for edge in EDGES[elements.shape[1]]]))


def loops(edges):
    """The nodes of each closed line that edges make, in order."""
    following = dict(edges.tolist())
    found = []
    while following:
        start, node = following.popitem()
        loop = [start]
        while node in following:
            loop.append(node)
            node = following.pop(node)
        found.append(numpy.array(loop))
    return found


def outer_faces(elements):
    """Faces around elements in space, by their corners."""
    faces = TETRAHEDRON if elements.shape[1] == 4 else HEXAHEDRON
    return single(numpy.concatenate([elements[:, face] for face in faces]))
