#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of one run: python3 post/plot.py DIR [--out FOLDER] [--time T ...] [--field NAME].

fields.png has the scene at some times, histories.png what changed over time, profiles.png a gas along x over its exact
solution. Exit codes: 0 done, 2 DIR is not the folder of a run, 4 a picture could not be written.
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot

import command
import tether_results
from scene import choose, profiles


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws pictures of a run from the files in its folder.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run, with its history.nc")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the pictures (default: DIR)")
    parser.add_argument("--time", type=float, action="append", default=[], metavar="T",
                        help="time of a panel of the scene, repeated for each")
    parser.add_argument("--field", metavar="NAME", help="what colours the scene, in place of what matters most")
    return parser.parse_args(words)


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
    return command.run("plot", lambda: pictures(chosen))


if __name__ == "__main__":
    sys.exit(main())
