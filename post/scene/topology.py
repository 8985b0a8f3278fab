# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements as matplotlib draws them: triangles, edges and outer faces, by the order in which mesh.nc counts nodes."""
import numpy

# Of a quadrangle of 9 nodes: corners, then middles of edges, then its own.
QUARTERS = ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3))
# Of a triangle of 6 nodes: corners, then middles of edges.
PARTS_OF_TRIANGLE = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))
EDGES = {3: ((0, 1), (1, 2), (2, 0)), 6: ((0, 3), (3, 1), (1, 4), (4, 2), (2, 5), (5, 0)), 4: ((0, 1), (1, 2), (2, 3), (3, 0)),
         9: ((0, 4), (4, 1), (1, 5), (5, 2), (2, 6), (6, 3), (3, 7), (7, 0))}
# Of tetrahedra and hexahedra by their corners, counter-clockwise from outside; of those of 10 nodes with the middles.
TETRAHEDRON = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
TETRAHEDRON_10 = ((0, 2, 1, 6, 5, 4), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (2, 0, 3, 6, 7, 9))
HEXAHEDRON = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def triangles(elements):
    """Elements of the plane as triangles between their nodes."""
    if elements.shape[1] == 3:
        return elements
    if elements.shape[1] == 6:
        return numpy.concatenate([elements[:, part] for part in PARTS_OF_TRIANGLE])
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
    """Faces around elements in space, by their corners; those of tetrahedra of 10 nodes in four parts."""
    if elements.shape[1] == 10:
        return triangles(single(numpy.concatenate([elements[:, face] for face in TETRAHEDRON_10])))
    faces = TETRAHEDRON if elements.shape[1] == 4 else HEXAHEDRON
    return single(numpy.concatenate([elements[:, face] for face in faces]))
