#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of results of the thesis and of flows, from runs made for them: figures.py [NAME...] [--out FOLDER] [--full].

Without a NAME all of them, and a sheet of all. Runs stay in FOLDER/runs and are made again when the program, their deck
or a particle file is newer. Exit codes: 0 done, 2 no such figure, or no program to run, 3 a run failed, 4 a figure could
not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot

import contact_sheet
import tether_results
import style
from thesis_figures import FIGURES
from thesis_figures.runs import NoProgram, RunFailed, Runs

ROOT = Path(__file__).resolve().parents[1]


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws figures of results of the thesis and of flows.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="numbers of figures in the thesis, or names (default: all)")
    parser.add_argument("--list", action="store_true", help="list the figures")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "figures", metavar="FOLDER",
                        help="folder for figures and runs (default: out/figures)")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "release" / "tether", metavar="FILE",
                        help="the program (default: build/release/tether)")
    parser.add_argument("--full", action="store_true", help="the flaps on their finest meshes, too: half an hour")
    return parser.parse_args(words)


def title(name):
    text = FIGURES[name].__doc__.splitlines()[0].rstrip(".")
    return f"Fig. {name}: {text}" if name.isdigit() else text


def path_of(name, folder):
    return folder / f"figure-{name}.png"


def draw(name, runs, folder):
    figure = FIGURES[name](runs)
    figure.suptitle(title(name))
    figure.savefig(path_of(name, folder))
    pyplot.close(figure)


def draw_all(names, runs, folder):
    """Draws them, yields the paths of what was written."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or FIGURES:
        draw(name, runs, folder)
        yield path_of(name, folder)
    if not names:
        yield contact_sheet.write([path_of(name, folder) for name in FIGURES], folder / "contact-sheet.png")


def unknown(names):
    strangers = [name for name in names if name not in FIGURES]
    if strangers:
        print(f"figures: no figure {', '.join(strangers)}; there are {', '.join(FIGURES)}", file=sys.stderr)
    return strangers


def main(words=None):
    chosen = arguments(words)
    if chosen.list:
        print("\n".join(title(name) for name in FIGURES))
        return 0
    if unknown(chosen.names):
        return 2
    style.use()
    try:
        runs = Runs(chosen.program, ROOT / "decks", chosen.out / "runs", levels=3 if chosen.full else 2)
        for path in draw_all(chosen.names, runs, chosen.out):
            print(path, flush=True)
    except NoProgram as mistake:
        print(f"figures: {mistake}", file=sys.stderr)
        return 2
    except (RunFailed, tether_results.NotARun) as failure:
        print(f"figures: {failure}", file=sys.stderr)
        return 3
    except OSError as reason:
        print(f"figures: {reason}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
