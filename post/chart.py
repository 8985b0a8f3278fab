#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A chart of tether chart: python3 post/chart.py out/charts/NAME/chart.nc. Error over seconds and over memory with the runs that
none beats joined, and over the size of cells.

Exit codes: 0 done, 2 the file is no chart, 4 the figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import numpy

import command
import style
import table

# Okabe and Ito's colours, which all eyes tell apart, with a mark each for print without colour.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#F0E442")
MARKS = "osD^vPX*"
NEEDED = ("family", "of", "size", "error", "lasting_error", "cpu_seconds", "peak_memory_mb")


def front(cost, error):
    """Numbers of the runs that no other one beats, by ascending cost."""
    best = []
    for k in numpy.lexsort((error, cost)):
        if numpy.isfinite(cost[k]) and numpy.isfinite(error[k]) and (not best or error[k] < error[best[-1]]):
            best.append(int(k))
    return best


def look(number):
    """Colours begin again after eight, with the marks one further."""
    mark = (number + number // len(COLOURS)) % len(MARKS)
    return {"color": COLOURS[number % len(COLOURS)], "marker": MARKS[mark], "markersize": 4}


def draw_over_cost(axes, columns, cost, name):
    error, x = columns["error"], columns[cost]
    best = front(x, columns["lasting_error"])
    axes.plot(x[best], columns["lasting_error"][best], color="0.75", linewidth=5, solid_capstyle="round", zorder=1, label="none beats these")
    for number, family in enumerate(dict.fromkeys(columns["family"].tolist())):
        of = columns["family"] == family
        cells, steps = of & (columns["of"] == "cells"), of & (columns["of"] == "steps")
        axes.plot(x[cells], error[cells], label=family, **look(number))
        axes.plot(x[steps], error[steps], linestyle=":", fillstyle="none", **look(number))
    axes.set(xscale="log", yscale="log", xlabel=name, ylabel="error")


def draw_over_size(axes, columns):
    for number, family in enumerate(dict.fromkeys(columns["family"].tolist())):
        rows = (columns["family"] == family) & (columns["of"] == "cells")
        axes.plot(columns["size"][rows], columns["error"][rows], label=family, **look(number))
    axes.set(xscale="log", yscale="log", xlabel="size of a cell", ylabel="error")


def draw(columns, title=""):
    figure, axes = style.panels(4, 4)
    draw_over_cost(axes[0], columns, "cpu_seconds", "seconds of a processor")
    draw_over_cost(axes[1], columns, "peak_memory_mb", "memory [MB]")
    draw_over_size(axes[2], columns)
    axes[3].axis("off")  # room for the names, which would hide curves
    axes[3].legend(*axes[0].get_legend_handles_labels(), loc="center left")
    if (columns["of"] == "steps").any():
        style.note(figure, "Full: meshes; dotted, hollow: steps on one mesh.")
    figure.suptitle(title, fontsize=9)
    return figure


def read(path):
    columns, _ = table.read(path)
    missing = [name for name in NEEDED if name not in columns]
    if missing:
        raise command.Refused(f"{path} is no chart: it has no {', '.join(missing)}")
    if not numpy.any(columns["error"] > 0):
        raise command.Refused(f"{path}: no run has an error that a logarithm shows")
    return columns


def figure_of(path, _=None):
    """The figure of a chart.nc."""
    return draw(read(path), command.title_of(path))


def main(words=None):
    parser = argparse.ArgumentParser(description="Draws a chart of tether chart.")
    parser.add_argument("chart", type=Path, metavar="CHART.nc", help="chart.nc of tether chart")
    parser.add_argument("--out", type=Path, metavar="FILE.svg", help="the figure (default: chart.svg next to it)")
    chosen = parser.parse_args(words)
    return command.draw("chart", lambda: figure_of(chosen.chart), chosen.out or chosen.chart.with_name("chart.svg"))


if __name__ == "__main__":
    sys.exit(main())
