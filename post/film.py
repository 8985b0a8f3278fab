#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A film of one run's scene: python3 post/film.py DIR [--out FILE] [--gif] [--field NAME] [--frames N].

It is an .mp4, which needs ffmpeg; without ffmpeg, or with --gif, it is a .gif. It has the pictures of plot.py one after the
other, on one scale and in one frame. Exit codes: 0 done, 2 DIR is no run or has no snapshots, or an .mp4 is asked for where
ffmpeg is not there, 4 the film could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import animation, pyplot

import command
import tether_results
from scene import choose

LEAST_SECONDS, MOST_SECONDS = 4.0, 20.0  # of a film
USUAL_RATE, LEAST_RATE, MOST_RATE = 15.0, 1.0, 30.0  # pictures a second
MOST_FITTED = 40  # snapshots from which the scale is taken
DOTS = 110  # an inch
INSTALL_FFMPEG = "sudo apt-get install ffmpeg"
BITRATE = 2500  # [kbit/s]: lines stay sharp


def arguments(words):
    parser = argparse.ArgumentParser(description="Makes a film of a run's scene.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the film (default: DIR/film.mp4)")
    parser.add_argument("--gif", action="store_true", help="a .gif even where ffmpeg is at hand")
    parser.add_argument("--field", metavar="NAME", help="what colours the scene, in place of what matters most; of a liquid also one colour")
    parser.add_argument("--frames", type=int, metavar="N", help="the first N pictures alone")
    return parser.parse_args(words)


def rate_of(count):
    """Pictures a second and how many times each is shown, so that the film is neither too short nor too long."""
    rate = float(numpy.clip(USUAL_RATE, count / MOST_SECONDS, max(count / LEAST_SECONDS, LEAST_RATE)))
    return min(rate, MOST_RATE)


def shown_of(count):
    """Which snapshots of a long run are pictures: all, or evenly spaced ones that a film can hold."""
    step = -(-count // int(MOST_RATE * MOST_SECONDS))
    return list(range(0, count, step))


def records_of(run, scene, most=None):
    """The numbers of the snapshots in a film; of a steady run its last alone."""
    if choose.is_steady(run):
        return [len(scene.times) - 1]
    return shown_of(len(scene.times))[:most]


def writer_of(path, rate):
    """What joins the pictures of a file by its ending."""
    if path.suffix == ".gif":
        return animation.PillowWriter(fps=rate)
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p"]  # what players ask for
    return animation.FFMpegWriter(fps=rate, bitrate=BITRATE, extra_args=even)


def path_of(chosen):
    """Where the film goes; says so where ffmpeg is missing."""
    if chosen.gif or animation.FFMpegWriter.isAvailable():
        return chosen.out or chosen.folder / ("film.gif" if chosen.gif else "film.mp4")
    if chosen.out and chosen.out.suffix != ".gif":
        raise command.Refused(f"{chosen.out}: ffmpeg makes such films: {INSTALL_FFMPEG}, or name a .gif")
    if not chosen.out:
        print(f"film: a .gif, since there is no ffmpeg for an .mp4: {INSTALL_FFMPEG}", file=sys.stderr)
    return chosen.out or chosen.folder / "film.gif"


def make(scene, records, path):
    """Writes these snapshots of a scene as a film."""
    scene.fit([records[k] for k in numpy.unique(numpy.linspace(0, len(records) - 1, MOST_FITTED).round().astype(int))])
    sheet = scene.sheet(1)
    scene.explain(sheet)
    rate = rate_of(len(records))
    repeats = max(1, int(numpy.ceil(LEAST_SECONDS * rate / len(records))))
    joined = writer_of(path, rate)
    with joined.saving(sheet.figure, path, dpi=DOTS):
        for record in records:
            sheet.panels[0].clear()
            scene.draw(sheet.panels[0], record)
            for _ in range(repeats):
                joined.grab_frame()
    pyplot.close(sheet.figure)


def film(chosen):
    """Makes the film of a run and yields its path."""
    run = tether_results.open(chosen.folder)
    scene = choose.needed_scene(run, chosen.field)

    def write(path):
        path.touch()  # before pictures are made for what cannot be written
        make(scene, records_of(run, scene, chosen.frames), path)
    return command.save(path_of(chosen), write)


def main(words=None):
    chosen = arguments(words)
    return command.run("film", lambda: film(chosen))


if __name__ == "__main__":
    sys.exit(main())
