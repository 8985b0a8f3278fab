# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run left in its folder: history.nc, particles.nc and reference.txt as numpy arrays, summary.txt's numbers."""
from dataclasses import dataclass, field
from pathlib import Path

import netCDF4
import numpy


class NotARun(Exception):
    """The folder, or a file in it, is not what a run leaves behind; the text says which and why."""


@dataclass
class Fields:
    """Variables of a NetCDF file by name: time first, then bodies or points where a variable has them."""

    values: dict = field(default_factory=dict)
    units: dict = field(default_factory=dict)

    def __contains__(self, name):
        return name in self.values

    def __getitem__(self, name):
        return self.values[name]


@dataclass
class Run:
    name: str
    folder: Path
    history: Fields
    particles: Fields = None  # None where the run wrote no snapshots
    exact: dict = field(default_factory=dict)  # columns of reference.txt in order; empty where there is none
    body_names: list = field(default_factory=list)
    point_names: list = field(default_factory=list)
    summary: dict = field(default_factory=dict)  # numbers of summary.txt; empty where the run did not end


def is_numeric(variable):
    return variable.dtype is not str and variable.dtype.kind in "fiu"


def texts(dataset, name):
    """The strings of a character variable, [] where the file has none of that name."""
    if name not in dataset.variables:
        return []
    return [str(text) for text in netCDF4.chartostring(dataset[name][:])]


def fields_of(dataset, path):
    found = Fields()
    for name, variable in dataset.variables.items():
        if is_numeric(variable):
            found.values[name] = numpy.asarray(variable[:], dtype=float)
            found.units[name] = getattr(variable, "units", "1")
    if "time" not in found or len(found["time"]) == 0:
        raise NotARun(f"{path}: holds no records")
    return found


def open_dataset(path):
    try:
        dataset = netCDF4.Dataset(path)
    except OSError as reason:
        raise NotARun(f"{path}: cannot be read as NetCDF: {reason.strerror or reason}") from reason
    dataset.set_auto_mask(False)  # numbers as they stand: a run writes no fill values
    return dataset


def read_fields(path):
    """All numbers of particles.nc or mesh.nc."""
    with open_dataset(path) as dataset:
        return fields_of(dataset, path)


def read_exact(path):
    """Columns by name of `# name name ...` and rows of numbers under it."""
    try:
        lines = path.read_text().splitlines()
        names = lines[0].removeprefix("#").split()
        rows = numpy.array([line.split() for line in lines[1:]], dtype=float).reshape(-1, len(names))
    except (OSError, IndexError, ValueError) as reason:
        raise NotARun(f"{path}: is no table of numbers under a line of names: {reason}") from reason
    return dict(zip(names, rows.T))


def read_summary(path):
    """The numbers among its lines `key = value`."""
    numbers = {}
    for line in path.read_text().splitlines():
        key, _, value = line.partition(" = ")
        try:
            numbers[key] = float(value)
        except ValueError:
            continue  # a remark, or a text
    return numbers


def read(folder):
    """The run of a folder (a Path). Raises NotARun without history.nc, or for a file that cannot be understood."""
    if not (folder / "history.nc").is_file():
        raise NotARun(f"{folder}: has no history.nc: give the folder of a run")
    with open_dataset(folder / "history.nc") as dataset:
        run = Run(folder.resolve().name, folder, fields_of(dataset, folder / "history.nc"))
        run.body_names, run.point_names = texts(dataset, "body_name"), texts(dataset, "point_name")
    if (folder / "particles.nc").is_file():
        run.particles = read_fields(folder / "particles.nc")
    if (folder / "reference.txt").is_file():
        run.exact = read_exact(folder / "reference.txt")
    if (folder / "summary.txt").is_file():
        run.summary = read_summary(folder / "summary.txt")
    return run


def exact_over(run, abscissa):
    """The exact columns when they stand over this abscissa ("time" or "x"), else none."""
    return run.exact if next(iter(run.exact), None) == abscissa else {}
