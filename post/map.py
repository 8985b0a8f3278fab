#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A map of tether map: python3 post/map.py out/maps/NAME/map.nc. Verdicts over two axes, the squares that were run dotted,
theory as a broken line; or the largest value that holds over one axis, a line for each value of the other, hollow
where all values hold.

Exit codes: 0 done, 2 the file is no map, 4 the figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

import command
import tether_results
import style
import table
from chart import look

# What holds is light, so that it shows without colour, too; each way to fail has a hatch of its own.
VERDICTS = {"holds": ("#E8F3FA", ""), "grows": ("#D55E00", "//"), "falls short": ("#E69F00", "\\\\"), "diverges": ("#555555", "xx"),
            "loses points": ("#CC79A7", "oo"), "inverts": ("#0072B2", ".."), "does not converge": ("#009E73", "++"),
            "contradicts its energy": ("#F0E442", "--"), "tells nothing": ("#FFFFFF", "")}
RESULTS = {"square", "deck", "verdict", "holds", "decided_by", "own_run", "theory", "largest_holding", "smallest_failing"}


def axes_of(columns):
    """Names of the axes that move by themselves, the fastest first."""
    names = [name for name in columns if name not in RESULTS]
    if not names:
        return []
    first = columns[names[0]]
    same = numpy.flatnonzero(first == first[0])
    return names[:1] + [name for name in names[1:] if len(set(columns[name][same].tolist())) > 1][:1]


def places(values):
    """Where the values of an axis stand: as they are where they are evenly spaced, or by their logarithms; else, and of
    words, by their numbers. With the scale's name."""
    if values.dtype.kind != "f" or len(values) < 2:
        return numpy.arange(len(values), dtype=float), "number"
    steps = numpy.diff(values)
    if numpy.ptp(steps) <= 1e-3 * abs(steps).max():
        return values, "linear"
    if (values > 0).all() and numpy.ptp(numpy.diff(numpy.log(values))) <= 0.1 * abs(numpy.diff(numpy.log(values))).max():
        return values, "log"
    return numpy.arange(len(values), dtype=float), "number"


def edges(at, scale):
    """Between the places, and half a step beyond the first and the last."""
    at = numpy.log(at) if scale == "log" else at
    step = at[1] - at[0] if len(at) > 1 else 1.0
    end = at[-1] - at[-2] if len(at) > 1 else 1.0
    between = numpy.concatenate([[at[0] - step / 2], (at[:-1] + at[1:]) / 2, [at[-1] + end / 2]])
    return numpy.exp(between) if scale == "log" else between


def name_axis(axis, name, values, at, scale):
    axis.set_label_text(name)
    if scale == "number":
        every = max(1, len(values) // 8)
        axis.set_ticks(at[::every], [table.spelled(value) for value in values.tolist()][::every])


def draw_verdicts(axes, columns, names, rows):
    values = [numpy.array(list(dict.fromkeys(columns[name][rows].tolist()))) for name in names] + [numpy.zeros(1)] * (2 - len(names))
    (x, x_scale), (y, y_scale) = map(places, values)
    shape = (len(y), len(x))
    verdict = columns["verdict"][rows].reshape(shape)
    ex, ey = edges(x, x_scale), edges(y, y_scale)
    number = numpy.array([[list(VERDICTS).index(each) for each in line] for line in verdict])
    axes.pcolormesh(ex, ey, number, cmap=ListedColormap([colour for colour, _ in VERDICTS.values()]), vmin=-0.5, vmax=len(VERDICTS) - 0.5)
    for name, (_, hatch) in VERDICTS.items():
        if hatch and (verdict == name).any():
            axes.add_collection(PolyCollection(squares(ex, ey, verdict == name), facecolors="none", linewidths=0, hatch=hatch))
    own = columns["own_run"][rows].reshape(shape) == 1
    gx, gy = numpy.meshgrid(x, y)
    axes.plot(gx[own], gy[own], "o", color="black", markersize=2.5, markeredgecolor="white", markeredgewidth=0.5)
    holds = columns["holds"][rows].reshape(shape)
    upward = values[1].dtype.kind == "f" and (abs(numpy.diff(holds, axis=0)) == 1).any()
    draw_theory(axes, columns["theory"][rows].reshape(shape), x, y, values, upward)
    axes.set_xscale("log" if x_scale == "log" else "linear")
    axes.set_yscale("log" if y_scale == "log" else "linear")
    axes.set(xlim=(ex[0], ex[-1]), ylim=(ey[0], ey[-1]))
    axes.grid(False)
    name_axis(axes.xaxis, names[0], values[0], x, x_scale)
    if len(names) > 1:
        name_axis(axes.yaxis, names[1], values[1], y, y_scale)
    else:
        axes.set_yticks([])
    return sorted(set(verdict.ravel().tolist()), key=list(VERDICTS).index)


def squares(ex, ey, of):
    """Corners of the squares that are so, whatever the scales."""
    return [[(ex[i], ey[j]), (ex[i + 1], ey[j]), (ex[i + 1], ey[j + 1]), (ex[i], ey[j + 1])] for j, i in zip(*numpy.nonzero(of))]


def draw_theory(axes, theory, x, y, values, upward):
    """Along the axis that the border was read along: upward where the verdict changes so, else across."""
    if not numpy.isfinite(theory).any():
        return
    if upward:
        found = numpy.array([line[numpy.isfinite(line)][:1] if numpy.isfinite(line).any() else [numpy.nan] for line in theory.T])[:, 0]
        axes.plot(x, standing(found, values[1], y), **{**style.EXACT, "label": "theory"})
    else:
        found = numpy.array([line[numpy.isfinite(line)][:1] if numpy.isfinite(line).any() else [numpy.nan] for line in theory])[:, 0]
        axes.plot(standing(found, values[0], x), y, **{**style.EXACT, "label": "theory", "marker": "|", "markersize": 10})


def standing(found, values, places):
    """Where numbers between the values of an axis stand; those beyond its ends are not drawn."""
    order = numpy.argsort(values)
    return numpy.interp(found, values[order], places[order], left=numpy.nan, right=numpy.nan)


def draw_bisected(axes, columns, names, rows, meaning):
    values, scale = places(columns[names[0]][rows]) if not names[1:] else places(numpy.array(list(dict.fromkeys(columns[names[0]][rows].tolist()))))
    lines = dict.fromkeys(columns[names[1]][rows].tolist()) if names[1:] else {None: None}
    for number, key in enumerate(lines):
        mine = rows if key is None else rows[columns[names[1]][rows] == key]
        low, high = columns["largest_holding"][mine], columns["smallest_failing"][mine]
        label = None if key is None else table.spelled(key)
        found, open_ended = columns["verdict"][mine] == "found", columns["verdict"][mine] == "both ends hold"
        axes.plot(values, numpy.where(found, (low + high) / 2, numpy.nan), label=None if open_ended.all() else label, **look(number))
        axes.plot(values[open_ended], low[open_ended], linestyle="none", fillstyle="none", label=label if open_ended.all() else None,
                  **{**look(number), "marker": "^", "markersize": 6})
        if numpy.isfinite(columns["theory"][mine]).any():
            axes.plot(values, columns["theory"][mine], **{**style.EXACT, "label": "theory"})
    axes.set_xscale("log" if scale == "log" else "linear")
    name_axis(axes.xaxis, names[0], numpy.array(list(dict.fromkeys(columns[names[0]][rows].tolist()))), values, scale)
    axes.set_ylabel(meaning)
    style.legend(axes, title=names[1] if names[1:] else None)


def draw(columns, meaning, title=""):
    names = axes_of(columns)
    bisected = "largest_holding" in columns
    if bisected and not names:
        raise command.Refused("the map has one square: there is nothing to draw")
    decks = columns.get("deck", numpy.full(len(columns["verdict"]), ""))
    count = len(set(decks.tolist()))
    figure, panels = style.panels(count, min(count, 2), width=5.4, height=3.6)
    seen = []
    for axes, deck in zip(panels, dict.fromkeys(decks.tolist())):
        rows = numpy.flatnonzero(decks == deck)
        if bisected:
            draw_bisected(axes, columns, names, rows, meaning)
        else:
            seen += draw_verdicts(axes, columns, names, rows)
        if len(panels) > 1:
            axes.set_title(Path(deck).stem)
    if seen:
        marks = [Patch(facecolor=VERDICTS[name][0], hatch=VERDICTS[name][1], edgecolor="black", linewidth=.5, label=name) for name in VERDICTS if name in seen]
        lines = [line for axes in panels for line in axes.lines if line.get_label() == "theory"][:1]
        panels[0].legend(handles=marks + lines, loc="lower left", bbox_to_anchor=(0, 1.06), ncols=3)
    figure.suptitle(title, fontsize=9)
    return figure


def read(path):
    """The columns, and what is bisected."""
    columns, _ = table.read(path)
    if "verdict" not in columns or not ({"own_run", "largest_holding"} & set(columns)):
        raise command.Refused(f"{path} is no map of tether map")
    with tether_results.open_dataset(path) as data:
        meaning = getattr(data.variables.get("largest_holding"), "long_name", "")
    return columns, meaning


def figure_of(path, _=None):
    """The figure of a map.nc."""
    return draw(*read(path), command.title_of(path))


def main(words=None):
    parser = argparse.ArgumentParser(description="Draws a map of tether map.")
    parser.add_argument("map", type=Path, metavar="MAP.nc", help="map.nc of tether map")
    parser.add_argument("--out", type=Path, metavar="FILE.svg", help="the figure (default: map.svg next to it)")
    chosen = parser.parse_args(words)
    return command.draw("map", lambda: figure_of(chosen.map), chosen.out or chosen.map.with_name("map.svg"))


if __name__ == "__main__":
    sys.exit(main())
