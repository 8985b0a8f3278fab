# SPDX-License-Identifier: GPL-3.0-or-later
"""NetCDF files as the program writes them, and what is raised where one is not."""
import os

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")  # a run that goes on holds a lock on its files

import netCDF4
import numpy


class NotARun(Exception):
    """The folder, or a file in it, is not what a run leaves behind; the text says which and why."""


def open_dataset(path):
    """The open netCDF4.Dataset of a file, whose numbers are as they stand. Raises NotARun for what is no NetCDF."""
    try:
        dataset = netCDF4.Dataset(path)
    except OSError as reason:
        raise NotARun(f"{path}: cannot be read as NetCDF: {reason.strerror or reason}") from reason
    dataset.set_auto_mask(False)
    return dataset


def is_numeric(variable):
    """Whether a variable holds numbers."""
    return variable.dtype is not str and variable.dtype.kind in "fiu"


def numbers(variable, where=slice(None)):
    """Values as floating-point numbers: not a number where there is none, also of whole numbers, such as of points that have
    left."""
    values = numpy.asarray(variable[where], dtype=float)
    if variable.dtype.kind in "iu" and "_FillValue" in variable.ncattrs():
        values[values == variable.getncattr("_FillValue")] = numpy.nan
    return values


def texts(dataset, name):
    """The strings of a character variable, [] where the file has none of that name."""
    if name not in dataset.variables:
        return []
    return [str(text) for text in netCDF4.chartostring(dataset[name][:])]
