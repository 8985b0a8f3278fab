# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in space: the room that bodies stand in, in perspective, with light and shadows."""
import numpy

from render.picture import Picture, Surface

ACROSS = 560  # pixels of a picture
CORNER = (20.0, 20.0)  # of a picture, where directions are drawn [points]
MARGIN = 0.06  # of a room around bodies that has no box, of its largest side


def pixels_of(low, high):
    """Pixels across and down for a room."""
    x, y, z = high - low
    return ACROSS, int(ACROSS * (y + 0.35 * z) / (x + 0.42 * z))


def room_around(places):
    """The lowest and the highest corner of a room for all these places."""
    low, high = numpy.min(places, axis=0), numpy.max(places, axis=0)
    margin = MARGIN * (numpy.max(high - low) or 1.0)
    return low - margin, high + margin


def surface_of(places, faces, colours):
    """Faces of three or four nodes with the colours of the nodes, red, green, blue."""
    if faces.shape[1] == 4:
        faces = numpy.concatenate([faces[:, (0, 1, 2)], faces[:, (0, 2, 3)]])
    return Surface(places[faces], colours[faces])


class Room:
    """Draws surfaces in a room from `low` to `high`."""

    def __init__(self, low, high):
        self.low, self.high = numpy.asarray(low, dtype=float), numpy.asarray(high, dtype=float)
        self.pixels = pixels_of(self.low, self.high)
        self.picture = Picture(self.low, self.high, self.pixels)

    @property
    def limits(self):
        """Of the axes that a picture is shown in."""
        return 0, self.pixels[0], 0, self.pixels[1]

    def show(self, axes, image):
        """Puts a picture into axes, with the directions of x, y and z in its corner."""
        axes.imshow(image, extent=self.limits, interpolation="antialiased", zorder=1)
        camera = self.picture.camera
        for name, right, up in zip("xyz", camera.right, camera.up):
            way = 14 * numpy.array((right, up))
            axes.annotate("", numpy.add(CORNER, way), CORNER, xycoords="axes points", textcoords="axes points",
                          arrowprops={"arrowstyle": "->", "color": "0.4", "linewidth": 0.8})
            axes.annotate(name, numpy.add(CORNER, 1.45 * way), xycoords="axes points", fontsize=7, color="0.4", ha="center",
                          va="center")
