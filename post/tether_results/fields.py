# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of a run over its snapshots: particles.nc, mesh.nc or solids.nc, of which one snapshot is read at a time."""
import numbers

import numpy

from . import datasets
from .box import AXES, Box, is_box


def form_of(data):
    """What a file's fields stand on: points, elements, the grid of points, or a box of cells."""
    if is_box(data):
        return "box"
    if "element_nodes" in data.variables:
        return "elements"
    return "grid" if "node_x" in data.dimensions else "points"


class Fields:
    """fields.at(0.5)["pressure"] is the pressure at the snapshot nearest to t = 0.5, fields.at(-1) the last snapshot."""

    def __init__(self, path):
        self.path = path
        with datasets.open_dataset(path) as data:
            if "time" not in data.variables or len(data["time"][:]) == 0:
                raise datasets.NotARun(f"{path}: holds no records")
            self.times = numpy.asarray(data["time"][:], dtype=float)
            self.form = form_of(data)
            self.box = Box(data) if self.form == "box" else None
            self.names = [name for name, variable in data.variables.items() if self._is_field(variable)]
            self.units = {name: getattr(data[name], "units", "1") for name in data.variables}
            self.meanings = {name: getattr(data[name], "long_name", "") for name in data.variables}
            self._constants = {name: numpy.asarray(variable[:]) for name, variable in data.variables.items()
                               if datasets.is_numeric(variable) and "time" not in variable.dimensions}
            self._shown = set(data.variables)
        self._whole = {}

    @staticmethod
    def _is_field(variable):
        return datasets.is_numeric(variable) and variable.ndim > 1 and variable.dimensions[0] == "time"

    def __len__(self):
        return len(self.times)

    def __contains__(self, name):
        return name in self._shown

    def __getitem__(self, name):
        """A variable of the file over all times. Large: at() reads one snapshot."""
        if name in self._constants:
            return self._constants[name]
        if name not in self._whole:
            with datasets.open_dataset(self.path) as data:
                self._whole[name] = datasets.numbers(data[name])
        return self._whole[name]

    def record(self, when):
        """The number of a snapshot: of an index (an int, from the end where it is negative) or nearest to a time."""
        if isinstance(when, numbers.Integral):
            if not -len(self.times) <= when < len(self.times):
                raise IndexError(f"snapshot {when}: {self.path} has {len(self.times)}")
            return int(when) % len(self.times)
        return int(abs(self.times - when).argmin())

    def at(self, when, names=None):
        """Arrays by name of one snapshot, of all fields or of these; of a box over ([z,] y, x)."""
        record = self.record(when)
        with datasets.open_dataset(self.path) as data:
            found = {name: datasets.numbers(data[name], record) for name in names or self.names}
        return {name: self.box.array(values) for name, values in found.items()} if self.box else found

    @property
    def dimension(self):
        """2 in the plane, 3 in space."""
        if self.box:
            return self.box.dimension
        return 3 if "z" in self._shown or "node_z" in self._shown else 2

    def places(self, when):
        """Places of points or of an element mesh's nodes at one snapshot, a row each."""
        axes = [axis for axis in AXES if axis in self.names]
        found = self.at(when, axes)
        return numpy.column_stack([found[axis] for axis in axes])

    @property
    def start(self):
        """Places of an element mesh's nodes in the shape without displacement."""
        return numpy.column_stack([self._constants[f"node_{axis}"] for axis in AXES[:self.dimension]])

    @property
    def elements(self):
        """Numbers of each element's nodes, from 0."""
        return self._constants["element_nodes"].astype(int)

    @property
    def regions(self):
        """The deck's region of each element, from 0."""
        return self._constants["element_region"].astype(int)

    @property
    def axes(self):
        """Places along each axis of a box (middles of cells) or of the grid of points (nodes)."""
        if self.box:
            return self.box.axes
        return {axis: self._constants[f"node_{axis}"] for axis in AXES if f"node_{axis}" in self._constants}
