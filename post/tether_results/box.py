# SPDX-License-Identifier: GPL-3.0-or-later
"""A regular box of cells, in which the fluid of the coupled path is: the one place that knows how mesh.nc holds it."""
import numpy

AXES = ("x", "y", "z")


class Box:
    """Axes of a box: the middles of its cells, and the sides between them."""

    def __init__(self, data):
        names = [axis for axis in AXES if axis in data.variables]
        self.axes = {axis: numpy.asarray(data[axis][:], dtype=float) for axis in names}
        bounds = {axis: numpy.asarray(data[f"{axis}_bounds"][:], dtype=float) for axis in names}
        self.edges = {axis: numpy.append(sides[:, 0], sides[-1, 1]) for axis, sides in bounds.items()}
        self.dimension = len(names)
        self.shape = tuple(len(self.axes[axis]) for axis in reversed(names))
        self.units = {axis: getattr(data[axis], "units", "1") for axis in names}

    def array(self, values):
        """A field of one snapshot over ([z,] y, x)."""
        return numpy.asarray(values, dtype=float).reshape(self.shape)


def is_box(data):
    """Whether mesh.nc is of a box of cells, which are fluid, solid, obstacle or void."""
    return "kind" in data.variables
