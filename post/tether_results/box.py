# SPDX-License-Identifier: GPL-3.0-or-later
"""A regular box of cells, in which the fluid of the coupled path is: the one place that knows how mesh.nc holds it."""
import numpy

AXES = ("x", "y", "z")
# Which corners of a quadrangle or hexahedron are one cell further along ([z,] y, x), in VTK's order.
AROUND = ((0, 0), (0, 1), (1, 1), (1, 0))
CORNERS = {2: AROUND, 3: tuple((level, *corner) for level in (0, 1) for corner in AROUND)}


def edges_of(middles, bounds=None):
    """The sides of cells along an axis, one more than there are cells."""
    if bounds is not None:
        bounds = numpy.asarray(bounds, dtype=float)
        return bounds if bounds.ndim == 1 else numpy.append(bounds[:, 0], bounds[-1, 1])
    size = middles[1] - middles[0] if len(middles) > 1 else 1.0
    return numpy.append(middles - size / 2, middles[-1] + size / 2)


class Box:
    """Axes of a box, and how a field of mesh.nc becomes an array over ([z,] y, x).

    A file has the middles of the cells as coordinate variables x, y, z with their bounds; an older one has a mesh whose
    nodes are these middles."""

    def __init__(self, data):
        self.regular = is_regular(data)
        names = [axis for axis in AXES if (axis if self.regular else f"node_{axis}") in data.variables]
        self.axes = {axis: self._middles(data, axis) for axis in names}
        bounds = {axis: data[f"{axis}_bounds"][:] for axis in names if f"{axis}_bounds" in data.variables}
        self.edges = {axis: edges_of(middles, bounds.get(axis)) for axis, middles in self.axes.items()}
        self.dimension = len(names)
        self.shape = tuple(len(self.axes[axis]) for axis in reversed(names))
        self.units = {axis: getattr(data[axis], "units", "1") for axis in names}

    def _middles(self, data, axis):
        if self.regular:
            return numpy.asarray(data[axis][:], dtype=float)
        return numpy.unique(numpy.asarray(data[f"node_{axis}"][:], dtype=float).round(9))

    def array(self, values):
        """A field of one snapshot over ([z,] y, x)."""
        return numpy.asarray(values, dtype=float).reshape(self.shape)

    @property
    def places(self):
        """The middles of the cells, a row each, as `array` has them one after the other."""
        grids = numpy.meshgrid(*reversed(self.axes.values()), indexing="ij")
        return numpy.column_stack([grid.ravel() for grid in reversed(grids)])

    @property
    def elements(self):
        """Quadrangles or hexahedra between the middles of neighbouring cells, by the numbers of their corners."""
        numbers = numpy.arange(int(numpy.prod(self.shape))).reshape(self.shape)
        corners = [numbers[tuple(slice(1, None) if ahead else slice(None, -1) for ahead in corner)].ravel()
                   for corner in CORNERS[self.dimension]]
        return numpy.column_stack(corners)

    def is_field(self, name, variable):
        """Whether a variable is a field of the cells; places of an older file's nodes are none."""
        return variable.ndim > 1 and variable.dimensions[0] == "time" and name not in AXES


def is_regular(data):
    """Whether the file has the cells' middles as coordinate variables."""
    return "x" in data.variables and data["x"].dimensions == ("x",)


def is_box(data):
    """Whether mesh.nc is of a box of cells, which are fluid, solid, obstacle or void."""
    return "kind" in data.variables
