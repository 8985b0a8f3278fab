# SPDX-License-Identifier: GPL-3.0-or-later
"""A camera in front of a box, to its right and above it, that sees all of it."""
import itertools

import numpy

TOWARDS = numpy.array((0.42, 0.30, 1.0))  # from the box to the camera
DISTANCE = 3.2  # of the camera from the middle, in half diagonals of the box
MARGIN = 0.02  # of the picture, that stays free


def unit(vector):
    return vector / numpy.linalg.norm(vector)


class Camera:
    """Perspective: a point at a depth along the view is drawn at its direction, times `scale` pixels."""

    def __init__(self, low, high, pixels):
        low, high = numpy.asarray(low, dtype=float), numpy.asarray(high, dtype=float)
        self.pixels = pixels  # across, down
        self.eye = (low + high) / 2 + DISTANCE * numpy.linalg.norm(high - low) / 2 * unit(TOWARDS)
        self.forward = -unit(TOWARDS)
        self.right = unit(numpy.cross(self.forward, (0.0, 1.0, 0.0)))
        self.up = numpy.cross(self.right, self.forward)
        self.scale, self.middle = 1.0, numpy.zeros(2)
        self.fit(numpy.array(list(itertools.product(*zip(low, high)))))

    def fit(self, corners):
        """The largest scale with which all corners are in the picture, and the place of its middle."""
        places = self.project(corners)[0]
        least, most = places.min(axis=0), places.max(axis=0)
        room = (1 - 2 * MARGIN) * numpy.array(self.pixels)
        self.scale = (room / (most - least)).min()
        self.middle = numpy.array(self.pixels) / 2 - self.scale * (least + most) / 2

    def project(self, points):
        """Places in the picture [pixels, from its upper left corner], and depths along the view."""
        relative = numpy.asarray(points) - self.eye
        depth = relative @ self.forward
        places = numpy.stack([relative @ self.right, -(relative @ self.up)], axis=-1) / depth[..., None]
        return self.middle + self.scale * places, depth

    def rays(self):
        """For each pixel the way that leads one unit of depth on, (down, across, 3)."""
        across, down = (numpy.arange(count) + 0.5 for count in self.pixels)
        x = (across - self.middle[0]) / self.scale
        y = (down - self.middle[1]) / self.scale
        return self.forward + x[None, :, None] * self.right - y[:, None, None] * self.up


class LightCamera:
    """Parallel light on a box: what it sees is what is lit."""

    def __init__(self, low, high, direction, pixels):
        corners = numpy.array(list(itertools.product(*zip(low, high))))
        self.forward = -unit(numpy.asarray(direction))
        self.right = unit(numpy.cross(self.forward, (0.0, 0.0, 1.0)))
        self.up = numpy.cross(self.right, self.forward)
        flat = corners @ numpy.stack([self.right, self.up], axis=1)
        self.low, size = flat.min(axis=0), flat.max(axis=0) - flat.min(axis=0)
        self.scale = (pixels - 1) / size.max()
        self.pixels = (pixels, pixels)

    def project(self, points):
        points = numpy.asarray(points)
        flat = numpy.stack([points @ self.right, points @ self.up], axis=-1)
        return (flat - self.low) * self.scale, points @ self.forward
