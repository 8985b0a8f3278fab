#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The particle file of a membrane as a run left it: python3 particles/from_run.py RUN BODY > FILE.

The points of body BODY (from 1) of the last snapshot in RUN are set at equal distances along their line, each in the
middle of its piece, at rest and without stress; thickness, density and elastic constants are those of the run's deck.

Exit codes: 0 done, 2 there is no such run or body.
"""
import argparse
import sys
from pathlib import Path

import netCDF4
import numpy as np


def last_snapshot(run, body):
    """x, y, volume and mass of the body's points, and the cell's area."""
    with netCDF4.Dataset(run / "particles.nc") as points:
        points.set_auto_mask(False)
        of_body = points["body"][-1] == body
        if not of_body.any():
            raise KeyError(f"{run} has no points of body {body}")
        return [points[name][-1][of_body] for name in ("x", "y", "volume", "mass")]


def evenly(x, y):
    """As many points at equal distances: half a spacing beyond the first and the last one the line ends."""
    along = np.concatenate([[0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    wanted = np.linspace(0, along[-1], len(x))
    return np.interp(wanted, along, x), np.interp(wanted, along, y), along[-1] / (len(x) - 1)


def file_text(x, y, density, young, poisson, per_cell):
    head = [f"{density!r}", f" {young!r},{poisson!r},0.0,0.0,0.0,0.0,0.0", " 3,3,3,8", f" {len(x)}",
            f" {len(x)}, {per_cell!r}"]
    rows = [f"{a:.9f} {b:.9f} 0.0 0.0 0.0 0.0 0.0" for a, b in zip(x.tolist(), y.tolist())]
    return "\n".join(head + rows) + "\n"


def main(words):
    parser = argparse.ArgumentParser(description="Writes the particle file of a membrane as a run left it.")
    parser.add_argument("run", type=Path)
    parser.add_argument("body", type=int)
    parser.add_argument("--thickness", type=float, required=True)
    parser.add_argument("--cell", type=float, required=True, help="area of a cell of the deck that will read the file")
    parser.add_argument("--young", type=float, required=True)
    parser.add_argument("--poisson", type=float, default=0.0)
    options = parser.parse_args(words)
    try:
        x, y, volume, mass = last_snapshot(options.run, options.body)
    except (OSError, KeyError) as problem:
        print(f"from_run.py: {problem}", file=sys.stderr)
        return 2
    x, y, spacing = evenly(x, y)
    density = round(float(mass.sum() / volume.sum()), 9)
    per_cell = options.cell / (options.thickness * spacing)  # np2: V_p = dx dy / np2 = thickness spacing
    sys.stdout.write(file_text(x, y, density, options.young, options.poisson, per_cell))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
