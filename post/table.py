#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Any column of a sweep's table against any other: python3 post/table.py TABLE.nc --x COL --y COL [--by COL].

Exit codes: 0 done, 2 the table cannot be read or has no such columns, 4 the figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import netCDF4
import numpy
from matplotlib import pyplot

import command
import tether_results
import style


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws a column of a sweep's table against another.")
    parser.add_argument("table", type=Path, metavar="TABLE.nc", help="table.nc or outcome.nc of a sweep")
    parser.add_argument("--x", required=True, metavar="COL", help="column of numbers along the abscissa")
    parser.add_argument("--y", required=True, metavar="COL", help="column of numbers along the ordinate")
    parser.add_argument("--by", metavar="COL", help="a line for each value of this column")
    parser.add_argument("--log", action="store_true", help="logarithmic scales, of the numbers' sizes")
    parser.add_argument("--out", type=Path, metavar="FILE.png", help="the figure (default: beside the table)")
    return parser.parse_args(words)


def read(path):
    """Columns of the table by name, and the units of those that have some."""
    columns, units = {}, {}
    if path.suffix != ".nc":
        raise command.Refused(f"{path} is no table: give the sweep's table.nc or outcome.nc")
    with tether_results.open_dataset(path) as data:
        for name, variable in data.variables.items():
            if variable.dtype == "S1":
                columns[name] = netCDF4.chartostring(variable[:])
            elif tether_results.is_numeric(variable) and variable.ndim == 1:
                columns[name] = numpy.asarray(variable[:], dtype=float)
            units[name] = getattr(variable, "units", "1")
    return columns, units


def column(columns, name, of_numbers=True):
    if name not in columns:
        raise command.Refused(f"no column {name}; there are {', '.join(columns)}")
    if of_numbers and columns[name].dtype.kind != "f":
        raise command.Refused(f"column {name} holds no numbers")
    return columns[name]


def spelled(value):
    return str(value) if isinstance(value, str) else f"{value:g}"


def lines(columns, chosen):
    """(label, x, y) of each line along x: a row without either number is left out."""
    x, y = column(columns, chosen.x), column(columns, chosen.y)
    if not numpy.any(numpy.isfinite(x) & numpy.isfinite(y)):
        raise command.Refused(f"no row has both {chosen.x} and {chosen.y}")
    keys = column(columns, chosen.by, of_numbers=False) if chosen.by else numpy.full(len(x), "")
    for key in dict.fromkeys(keys.tolist()):  # in the order of the table
        rows = numpy.flatnonzero((keys == key) & numpy.isfinite(x) & numpy.isfinite(y))
        rows = rows[numpy.argsort(x[rows], kind="stable")]
        yield spelled(key), x[rows], y[rows]


def draw(columns, units, chosen):
    figure, axes = pyplot.subplots(figsize=(5, 3.6))
    for label, x, y in lines(columns, chosen):
        if chosen.log:
            x, y = abs(x), abs(y)
        axes.plot(x, y, marker="o", markersize=4, label=label)
    if chosen.log:
        axes.set_xscale("log")
        axes.set_yscale("log")
    axes.set_xlabel(style.label(chosen.x, units[chosen.x]))
    axes.set_ylabel(style.label(chosen.y, units[chosen.y]))
    if chosen.by:
        axes.legend(title=chosen.by)
    return figure


def main(words=None):
    chosen = arguments(words)
    path = chosen.out or chosen.table.with_name(f"{chosen.y}-over-{chosen.x}.png")
    return command.draw("table", lambda: draw(*read(chosen.table), chosen), path)


if __name__ == "__main__":
    sys.exit(main())
