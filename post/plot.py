#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of one run: python3 post/plot.py DIR [--out FOLDER].

Exit codes: 0 done, 2 DIR is not the folder of a run, 4 a figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import run_figures
import tether_results
import style


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws the figures of a run from the files in its folder.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run, with its history.nc")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the figures (default: DIR)")
    return parser.parse_args(words)


def main(words=None):
    chosen = arguments(words)
    style.use()
    try:
        run = tether_results.open(chosen.folder)
    except tether_results.NotARun as mistake:
        print(f"plot: {mistake}", file=sys.stderr)
        return 2
    try:
        for path in run_figures.save_all(run, chosen.out or chosen.folder):
            print(path)
    except OSError as reason:
        print(f"plot: {reason}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
