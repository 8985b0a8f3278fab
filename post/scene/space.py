# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies in space as seen from in front, from the right and from above: faces from the back to the front, in light."""
import numpy
from matplotlib import collections

TOWARDS = numpy.array((0.45, 0.4, 1.0)) / numpy.linalg.norm((0.45, 0.4, 1.0))  # the one who looks
UP = numpy.array((0.0, 1.0, 0.0))
LIGHT = numpy.array((-0.35, 0.8, 0.6)) / numpy.linalg.norm((-0.35, 0.8, 0.6))  # its direction
CORNER = (20.0, 20.0)  # of a picture, where directions are drawn [points]
DARKEST = 0.7  # of a face that looks away from the light


def frame():
    """Unit vectors of the picture to the right and up."""
    right = numpy.cross(UP, TOWARDS)
    right /= numpy.linalg.norm(right)
    return right, numpy.cross(TOWARDS, right)


def flat(places):
    """Places in the picture, and how near they are."""
    right, up = frame()
    return numpy.stack([places @ right, places @ up], axis=-1), places @ TOWARDS


def normals(corners):
    """Unit normals of faces, outwards."""
    found = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return found / numpy.maximum(numpy.linalg.norm(found, axis=1, keepdims=True), 1e-300)


def shaded(colours, directions, light=LIGHT, darkest=DARKEST):
    """Colours of faces, darker where they look away from the light."""
    colours = numpy.array(colours)
    colours[:, :3] *= (darkest + (1 - darkest) * numpy.clip(directions @ light, 0, 1))[:, None]
    return colours


def draw_faces(axes, places, faces, colours):
    """Draws the faces that show their outer side, the nearer ones last."""
    corners = places[faces]
    directions = normals(corners)
    seen = numpy.flatnonzero(directions @ TOWARDS > 0)
    pictures, depth = flat(corners[seen])
    order = numpy.argsort(depth.mean(axis=1))
    faces_colours = shaded(numpy.asarray(colours)[seen[order]], directions[seen[order]])
    axes.add_collection(collections.PolyCollection(pictures[order], facecolors=faces_colours, edgecolors="0.25",
                                                   linewidths=0.3, zorder=3))


def draw_triad(axes):
    """Directions of x, y and z in the corner of the picture."""
    right, up = frame()
    for k, name in enumerate("xyz"):
        way = 14 * numpy.array((right[k], up[k]))
        axes.annotate("", numpy.add(CORNER, way), CORNER, xycoords="axes points", textcoords="axes points",
                      arrowprops={"arrowstyle": "->", "color": "0.4", "linewidth": 0.8})
        axes.annotate(name, numpy.add(CORNER, 1.45 * way), xycoords="axes points", fontsize=7, color="0.4", ha="center",
                      va="center")
