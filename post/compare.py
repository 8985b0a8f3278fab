#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two runs, or a run and a published curve: python3 post/compare.py A B [--out FOLDER] [--column NAME ...].

B is the folder of a run, or a text file of two columns under a line `# time name`, whose name is a column of A's history.
Prints what they differ by and writes compare.csv and compare.png. Differences are A less B, at the times of the one that has
fewer records, over the range of B's column. Exit codes: 0 done, 2 there is nothing to compare, 4 a file could not be
written.
"""
import argparse
import csv
import sys
from dataclasses import dataclass
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import pyplot

import command
import style
import tether_results
from tether_results.folder import read_exact

MOST_PANELS = 12
LEFT_OUT = ("time", "dt")
CONSTANT = 1e-9  # of a size: what changes by less is constant
SPENT = ("seconds", "memory", "ns_per", "threads")  # summary keys that differ from run to run


@dataclass
class Difference:
    """A column of both: times, both curves there, and how far they are from each other over the range of the second."""

    column: str
    times: numpy.ndarray
    one: numpy.ndarray
    other: numpy.ndarray

    @property
    def reach(self):
        """The range of the second curve; of one that is constant but for rounding its size, of one that is rounding next to
        the first that one's, of zeros 1."""
        first, size = (float(numpy.nanmax(abs(curve))) for curve in (self.one, self.other))
        if size < CONSTANT * first:
            return first
        extent = float(numpy.nanmax(self.other) - numpy.nanmin(self.other))
        return (extent if extent > CONSTANT * size else size) or 1.0

    @property
    def largest(self):
        return float(numpy.nanmax(abs(self.one - self.other)))

    @property
    def rms(self):
        return float(numpy.sqrt(numpy.nanmean((self.one - self.other)**2)))


def arguments(words):
    parser = argparse.ArgumentParser(description="Compares two runs, or a run and a published curve.")
    parser.add_argument("one", type=Path, metavar="A", help="folder of a run")
    parser.add_argument("other", type=Path, metavar="B", help="folder of a run, or a file of two columns")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for compare.png and compare.csv (default: A)")
    parser.add_argument("--column", action="append", default=[], metavar="NAME", help="a column of the history (default: all)")
    return parser.parse_args(words)


def columns_of(path):
    """The columns of a run's history, or of a file."""
    if path.is_dir():
        history = tether_results.open(path).history
        return {name: history[name] for name in history.columns}
    if not path.is_file():
        raise tether_results.NotARun(f"{path}: is neither a run's folder nor a file")
    columns = read_exact(path)
    if len(columns) < 2 or next(iter(columns)) != "time" or not len(columns["time"]):
        raise tether_results.NotARun(f"{path}: has no rows of a time and a column under a line `# time name`")
    return columns


def both_times(one, other):
    """Times of the one that has fewer records, as far as both reach."""
    fewer = min(one["time"], other["time"], key=len)
    first, last = max(one["time"][0], other["time"][0]), min(one["time"][-1], other["time"][-1])
    times = fewer[(fewer >= first) & (fewer <= last)]
    if not len(times):
        raise command.Refused(f"their times have nothing in common: {one['time'][0]:g} to {one['time'][-1]:g}, and "
                              f"{other['time'][0]:g} to {other['time'][-1]:g}")
    return times


def differences(one, other, chosen=()):
    """What both have, in the order of the first; columns that are not finite anywhere are left out."""
    shared = [name for name in one if name in other and name not in LEFT_OUT]
    missing = [name for name in chosen if name not in shared]
    if missing or not shared:
        raise command.Refused(f"no column {', '.join(missing)} in both; both have {', '.join(shared) or 'none'}")
    times, found = both_times(one, other), []
    for name in chosen or shared:
        curves = [numpy.interp(times, side["time"], side[name]) for side in (one, other)]
        if numpy.isfinite(curves[0] - curves[1]).any():
            found.append(Difference(name, times, *curves))
    if not found:
        raise command.Refused("no column of both has a number in it")
    return found


def summary_differences(one, other):
    """Keys of two summaries that differ, without what a run cost."""
    keys = [key for key in {**one, **other} if not any(word in key for word in SPENT)]
    return [(key, one.get(key, "-"), other.get(key, "-")) for key in keys if one.get(key) != other.get(key)]


def text_of(found, keys):
    """Both tables as text."""
    rows = [("column", "largest difference", "rms", "largest %", "rms %")]
    rows += [(d.column, f"{d.largest:.4g}", f"{d.rms:.4g}", f"{100 * d.largest / d.reach:.3g}", f"{100 * d.rms / d.reach:.3g}")
             for d in found]
    text = aligned(rows) + "\n% of the range of B\n"
    if keys:
        text += "\n" + aligned([("summary", "A", "B"), *[tuple(map(str, row)) for row in keys]]) + "\n"
    return text


def aligned(rows):
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def write_csv(found, path):
    """The table of differences with all digits."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("column", "largest_difference", "rms_difference", "range_of_second", "records"))
        writer.writerows((d.column, repr(d.largest), repr(d.rms), repr(d.reach), len(d.times)) for d in found)


def draw(found, run, names, published):
    """Both curves of the columns that differ most; a published one is red."""
    shown = sorted(found, key=lambda d: -d.largest / d.reach)[:MOST_PANELS]
    history, units = run.history, run.history.units
    figure, panels = style.panels(len(shown), min(3, len(shown)), 4.4, 2.7)
    look = style.PUBLISHED | {"marker": "x", "markersize": 4} if published else {"color": style.OURS[1], "linestyle": "--"}
    for axes, difference in zip(panels, shown):
        axes.plot(history["time"], history[difference.column], **{"color": style.OURS[0], "label": names[0]})
        axes.plot(difference.times, difference.other, **look | {"label": names[1]})
        axes.set_title(f"at most {100 * difference.largest / difference.reach:.3g} %, rms "
                       f"{100 * difference.rms / difference.reach:.3g} %", fontsize=8)
        axes.set_ylabel(style.label(difference.column, units.get(difference.column, "1")))
        axes.set_xlabel(style.label("time", units.get("time", "1")))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper right", ncol=2)
    figure.suptitle(" and ".join(names), fontsize=9, x=0.01, ha="left")
    return figure


def write(found, run, chosen, folder):
    """Both files; yields their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    write_csv(found, folder / "compare.csv")
    yield folder / "compare.csv"
    names = [path.resolve().name for path in (chosen.one, chosen.other)]
    figure = draw(found, run, names, not chosen.other.is_dir())
    figure.savefig(folder / "compare.png")
    pyplot.close(figure)
    yield folder / "compare.png"


def compare(chosen):
    """Yields the table of what differs, and the paths of both files."""
    run = tether_results.open(chosen.one)
    found = differences(columns_of(chosen.one), columns_of(chosen.other), chosen.column)
    keys = summary_differences(run.summary, tether_results.open(chosen.other).summary) if chosen.other.is_dir() else []
    yield text_of(found, keys)
    yield from write(found, run, chosen, chosen.out or chosen.one)


def main(words=None):
    chosen = arguments(words)
    return command.run("compare", lambda: compare(chosen))


if __name__ == "__main__":
    sys.exit(main())
