#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of one run, or of the runs of a sweep, a chart or a map: python3 post/plot.py DIR [--out FOLDER] [--time T ...]
[--field NAME] [--x COL] [--y COL] [--by COL] [--log].

fields.png has the scene at some times, histories.png what changed over time, profiles.png a gas along x over its exact
solution. Of a sweep the columns are chosen by --x to --log, as of post/table.py.

Exit codes: 0 done, 2 DIR is no folder of results, 4 a picture could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot

import chart
import command
import map as map_of_runs
import table
import tether_results
from scene import choose, profiles


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws pictures of a run from the files in its folder.")
    parser.add_argument("folder", type=Path, metavar="DIR",
                        help="folder of the run, with its history.nc, or of a sweep, a chart or a map")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the pictures (default: DIR)")
    parser.add_argument("--time", type=float, action="append", default=[], metavar="T",
                        help="time of a panel of the scene, repeated for each")
    parser.add_argument("--field", metavar="NAME", help="what colours the scene, in place of what matters most; of a liquid also one colour")
    table.add_columns(parser.add_argument_group("of a sweep"))
    return parser.parse_args(words)


# What many runs leave in their folder, who draws it, and the picture.
STUDIES = (("chart.nc", chart, "chart.svg"), ("map.nc", map_of_runs, "map.svg"), ("table.nc", table, "table.png"))


def study_in(folder):
    """The row of what a study has left in a folder; None in that of a run, and in any other."""
    of_run = (folder / "history.nc").is_file()
    return None if of_run else next((row for row in STUDIES if (folder / row[0]).is_file()), None)


def fields(run, chosen):
    """The scene at some times, None where the run has no snapshots."""
    scene = choose.scene_of(run, chosen.field)
    return scene.figure(choose.records_of(run, scene, chosen.time)) if scene else None


FIGURES = {"fields": fields, "histories": lambda run, chosen: choose.histories_of(run),
           "profiles": lambda run, chosen: profiles.figure(run)}


def save_all(run, chosen):
    """Writes every figure that the run has data for and yields the paths."""
    folder = chosen.out or chosen.folder
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in FIGURES.items():
        figure = draw(run, chosen)
        if figure is None:
            continue
        figure.savefig(folder / f"{name}.png")
        pyplot.close(figure)
        yield folder / f"{name}.png"


def pictures(chosen):
    """Draws a study, or a run, and yields the paths, and where a run has no snapshots the switch that writes them."""
    if found := study_in(chosen.folder):
        name, drawer, picture = found
        yield from command.save((chosen.out or chosen.folder) / picture, drawer.figure_of(chosen.folder / name, chosen).savefig)
        return
    run = tether_results.open(chosen.folder)
    yield from save_all(run, chosen)
    kind = choose.kind_of(run)
    if not run.has(kind.fields):
        yield f"no snapshots: {kind.switch}"


def main(words=None):
    chosen = arguments(words)
    return command.run("plot", lambda: pictures(chosen))


if __name__ == "__main__":
    sys.exit(main())
