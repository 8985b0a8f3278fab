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
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run, with its history.nc, or of a sweep, a chart or a map")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the pictures (default: DIR)")
    parser.add_argument("--time", type=float, action="append", default=[], metavar="T",
                        help="time of a panel of the scene, repeated for each")
    parser.add_argument("--field", metavar="NAME", help="what colours the scene, in place of what matters most")
    for name, meaning in (("--x", "abscissa"), ("--y", "ordinate"), ("--by", "lines")):
        parser.add_argument(name, metavar="COL", help=f"of a sweep: the column of the {meaning}")
    parser.add_argument("--log", action="store_true", help="of a sweep: logarithmic scales")
    return parser.parse_args(words)


# What many runs leave in their folder, who draws it, and where.
STUDIES = (("chart.nc", chart.main, "chart.svg"), ("map.nc", map_of_runs.main, "map.svg"), ("table.nc", table.main, "table.png"))


def study(chosen):
    """Draws a study and returns the exit code; None where the folder is not that of one."""
    for name, draw, figure in STUDIES:
        if (chosen.folder / name).is_file() and not (chosen.folder / "history.nc").is_file():
            words = [str(chosen.folder / name), *(["--out", str(chosen.out / figure)] if chosen.out else [])]
            return draw(words + words_for_table(chosen) if draw is table.main else words)
    return None


def words_for_table(chosen):
    """The words that choose columns."""
    named = [(f"--{name}", getattr(chosen, name)) for name in ("x", "y", "by")]
    return [word for option, column in named if column for word in (option, column)] + (["--log"] if chosen.log else [])


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
    """Draws the run and yields the paths, and where there are no snapshots the switch that writes them."""
    run = tether_results.open(chosen.folder)
    yield from save_all(run, chosen)
    kind = choose.kind_of(run)
    if not run.has(kind.fields):
        yield f"no snapshots: {kind.switch}"


def main(words=None):
    chosen = arguments(words)
    done = study(chosen)
    return command.run("plot", lambda: pictures(chosen)) if done is None else done


if __name__ == "__main__":
    sys.exit(main())
