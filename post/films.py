#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Films of the scenes of the coupled path, from runs of their decks: films.py [NAME...] [--out FOLDER] [--frames N].

Without a NAME all of them. With ffmpeg at hand they are .mp4, without it .gif, at the speed of the run's own time. Runs
are shared with figures.py. Exit codes: 0 done, 2 no such scene, or no program to run, 3 a run failed, 4 a film could not
be written.
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from matplotlib import animation, pyplot

import tether_results
import style
from thesis_figures.coupled import SHOWN
from thesis_figures.coupled_scene import CoupledScene
from thesis_figures.runs import NoProgram, RunFailed, Runs

ROOT = Path(__file__).resolve().parents[1]
WIDTH = 6.4  # of a picture [inches]


def arguments(words):
    parser = argparse.ArgumentParser(description="Makes films of the scenes of the coupled path.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="decks of scenes (default: all)")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "figures", metavar="FOLDER",
                        help="folder for films and runs (default: out/figures)")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "release" / "tether", metavar="FILE",
                        help="the program (default: build/release/tether)")
    parser.add_argument("--frames", type=int, metavar="N", help="the first N pictures alone")
    return parser.parse_args(words)


def writer(times):
    """One second of the run is a second of the film."""
    rate = round((len(times) - 1) / (times[-1] - times[0])) if len(times) > 1 else 1
    if animation.FFMpegWriter.isAvailable():
        return animation.FFMpegWriter(fps=max(rate, 1)), ".mp4"
    return animation.PillowWriter(fps=max(rate, 1)), ".gif"


def make(deck, run, folder, count=None):
    """The path of the film of a run of this deck, of its first `count` snapshots or of all."""
    scene, shown = CoupledScene(run), SHOWN[deck]
    extent = scene.extent()
    height = WIDTH * (extent[3] - extent[2]) / (extent[1] - extent[0])
    figure, axes = pyplot.subplots(figsize=(WIDTH, height), layout="none")
    axes.set_position((0, 0, 1, 1))
    most = scene.most(shown.field)
    film, ending = writer(scene.times)
    path = folder / f"{deck}{ending}"
    with film.saving(figure, path, dpi=100):
        for record in range(min(count or len(scene.times), len(scene.times))):
            axes.clear()
            scene.draw(axes, record, shown.field, most, shown.colours)
            axes.axis("off")
            axes.text(0.02, 0.97, style.at_time(scene.times[record], scene.units["time"]), transform=axes.transAxes,
                      va="top", zorder=1000)
            film.grab_frame()
    pyplot.close(figure)
    return path


def main(words=None):
    chosen = arguments(words)
    strangers = [name for name in chosen.names if name not in SHOWN]
    if strangers:
        print(f"films: no scene {', '.join(strangers)}; there are {', '.join(SHOWN)}", file=sys.stderr)
        return 2
    style.use()
    try:
        chosen.out.mkdir(parents=True, exist_ok=True)
        runs = Runs(chosen.program, ROOT / "decks", chosen.out / "runs")
        for name in chosen.names or SHOWN:
            print(make(name, runs.of(name), chosen.out, chosen.frames), flush=True)
    except NoProgram as mistake:
        print(f"films: {mistake}", file=sys.stderr)
        return 2
    except (RunFailed, tether_results.NotARun) as failure:
        print(f"films: {failure}", file=sys.stderr)
        return 3
    except OSError as reason:
        print(f"films: {reason}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
