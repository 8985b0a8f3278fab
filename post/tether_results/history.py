# SPDX-License-Identifier: GPL-3.0-or-later
"""The history of a run: one row a record, by the columns of history.txt or by the variables of history.nc."""
import numpy

from . import datasets


def numbered(name, count):
    """The columns of history.txt that a variable of so many bodies or points has."""
    return [f"{name}_{number}" for number in range(1, count + 1)]


class History:
    """history["point_y_2"] is a column of history.txt; history["point_y"] has all points' over (time, point)."""

    def __init__(self, path):
        self.path = path
        self.variables, self.units, self.meanings = {}, {}, {}
        with datasets.open_dataset(path) as data:
            for name, variable in data.variables.items():
                if datasets.is_numeric(variable):
                    self._take(name, variable)
            self.attributes = {name: str(data.getncattr(name)) for name in data.ncattrs()}
            self.body_names, self.point_names = datasets.texts(data, "body_name"), datasets.texts(data, "point_name")
        if "time" not in self.variables or len(self.variables["time"]) == 0:
            raise datasets.NotARun(f"{path}: holds no records")
        self._columns = {column: values for name in self.variables for column, values in self._split(name)}

    def _take(self, name, variable):
        self.variables[name] = datasets.numbers(variable)
        count = variable.shape[1] if variable.ndim == 2 else 0
        for known in (name, *numbered(name, count)):
            self.units[known] = getattr(variable, "units", "1")
            self.meanings[known] = getattr(variable, "long_name", "")

    def _split(self, name):
        """Columns and their values of one variable."""
        values = self.variables[name]
        if values.ndim == 1:
            return [(name, values)]
        return list(zip(numbered(name, values.shape[1]), values.T))

    @property
    def columns(self):
        """The names at the head of history.txt, in order."""
        return list(self._columns)

    def __len__(self):
        return len(self.variables["time"])

    def __contains__(self, name):
        return name in self._columns or name in self.variables

    def __getitem__(self, name):
        return self.variables[name] if name in self.variables else self._columns[name]

    def to_xarray(self):
        """The history as an xarray.Dataset, with units and the run's attributes."""
        import xarray

        with xarray.open_dataset(self.path, decode_times=False) as data:
            return data.load()
