#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of a sweep's table against another: python3 post/table.py TABLE.nc [--x COL] [--y COL] [--by COL]. Without --y each
quantity of the study has a panel; without --x they are over its first axis, with a line for each value of the next.

Exit codes: 0 done, 2 the table cannot be read or has no such columns, 4 the figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import netCDF4
import numpy
from matplotlib import pyplot

import command
import tether_results
import style

AXIS, COST = "deck value", "cpu_seconds"  # what the meaning of an axis is; the first column after the quantities


def add_columns(parser):
    """The options that choose columns of a sweep."""
    parser.add_argument("--x", metavar="COL", help="column of numbers along the abscissa (default: the first axis)")
    parser.add_argument("--y", metavar="COL", help="column of numbers along the ordinate (default: each quantity)")
    parser.add_argument("--by", metavar="COL", help="a line for each value of this column")
    parser.add_argument("--log", action="store_true", help="logarithmic scales, of the numbers' sizes")


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws a column of a sweep's table against another.")
    parser.add_argument("table", type=Path, metavar="TABLE.nc", help="table.nc or outcome.nc of a sweep")
    add_columns(parser)
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


def axes_and_quantities(path):
    """Names of the columns that the study varies, and of the numbers that it reads off its runs."""
    with tether_results.open_dataset(path) as data:
        axes = [name for name, variable in data.variables.items() if getattr(variable, "long_name", "") == AXIS]
        names = list(data.variables)
        last = names.index(axes[-1]) if axes else names.index("deck") if "deck" in names else -1
        found = names[last + 1:names.index(COST)] if COST in names else []
        return axes, [name for name in found if tether_results.is_numeric(data[name])]


def complete(path, chosen):
    """The chosen columns with those that the study itself suggests."""
    axes, quantities = axes_and_quantities(path) if not (chosen.x and chosen.y) else ([], [])
    if not chosen.x and not axes:
        raise command.Refused(f"{path}: the study has no axis: name a column with --x")
    by = chosen.by if chosen.by or chosen.x or len(axes) < 2 else axes[1]
    return argparse.Namespace(x=chosen.x or axes[0], y=[chosen.y] if chosen.y else quantities or [COST], by=by, log=chosen.log)


def lines(columns, chosen, quantity):
    """(label, x, y) of each line along x: a row without either number is left out."""
    x, y = column(columns, chosen.x), column(columns, quantity)
    if not numpy.any(numpy.isfinite(x) & numpy.isfinite(y)):
        raise command.Refused(f"no row has both {chosen.x} and {quantity}")
    keys = column(columns, chosen.by, of_numbers=False) if chosen.by else numpy.full(len(x), "")
    for key in dict.fromkeys(keys.tolist()):  # in the order of the table
        rows = numpy.flatnonzero((keys == key) & numpy.isfinite(x) & numpy.isfinite(y))
        rows = rows[numpy.argsort(x[rows], kind="stable")]
        yield spelled(key), x[rows], y[rows]


def draw_panel(axes, columns, units, chosen, quantity):
    for label, x, y in lines(columns, chosen, quantity):
        if chosen.log:
            x, y = abs(x), abs(y)
        axes.plot(x, y, marker="o", markersize=4, label=label)
    if chosen.log:
        axes.set_xscale("log")
        axes.set_yscale("log")
    axes.set_xlabel(style.label(chosen.x, units[chosen.x]))
    axes.set_ylabel(style.label(quantity, units[quantity]))
    if chosen.by:
        axes.legend(title=chosen.by)


def draw(columns, units, chosen, title=""):
    """A panel for each quantity; one that no run has is left out, unless it is all there is."""
    has_rows = [quantity for quantity in chosen.y if numpy.isfinite(column(columns, quantity)).any()] or chosen.y[:1]
    figure, panels = style.panels(len(has_rows), min(2, len(has_rows)), 5, 3.6)
    for axes, quantity in zip(panels, has_rows):
        draw_panel(axes, columns, units, chosen, quantity)
    figure.suptitle(title, fontsize=9)
    return figure


def figure_of(path, chosen):
    """The figure of a table.nc or outcome.nc."""
    return draw(*read(path), complete(path, chosen), command.title_of(path))


def main(words=None):
    chosen = arguments(words)
    name = f"{chosen.y}-over-{chosen.x}.png" if chosen.x and chosen.y else "table.png"
    return command.draw("table", lambda: figure_of(chosen.table, chosen), chosen.out or chosen.table.with_name(name))


if __name__ == "__main__":
    sys.exit(main())
