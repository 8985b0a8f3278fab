#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The particle file of a membrane that a deck gives by curves: python3 particles/write_curve.py DECK B > FILE.

It asks the program, which alone knows where the points stand: `tether check` for the deck's values and a run of one
step for its first snapshot. So its rows are the program's own, and there is no second reading of curves to keep true.

Exit codes: 0 done, 2 the deck has no such membrane, or a particle file cannot say what it is.
"""
import argparse
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4

BUILT = Path(__file__).resolve().parents[1] / "build/release/tether"
ORIGINS = ("given", "default")
MOST_CURVES = 40  # of a deck


class NoFile(Exception):
    """The text says why there is none."""


def arguments(words):
    parser = argparse.ArgumentParser(description="Writes the particle file of a membrane that a deck gives by curves.")
    parser.add_argument("deck", type=Path, metavar="DECK")
    parser.add_argument("membrane", type=int, metavar="B", help="number of the membrane, from 1")
    parser.add_argument("--tether", type=Path, default=BUILT, metavar="PROGRAM", help=f"default: {BUILT}")
    return parser.parse_args(words)


def call(program, *words):
    result = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise NoFile(f"{program.name} says:\n{result.stderr.rstrip()}")
    return result.stdout


def values(listing):
    """The deck's values, given or default, by group.name or group.name(subscript), as `tether check --all` lists them."""
    found, group = {}, ""
    for line in listing.splitlines():
        words = line.split()
        if line.startswith("$"):
            group = words[0][1:]
        elif len(words) >= 3 and words[2] in ORIGINS:
            found[f"{group}.{words[0]}"] = words[1].strip("'")
    return found


def first_snapshot(program, deck, step, name):
    """x, y and volume at the start of the points of the body of this name."""
    with tempfile.TemporaryDirectory() as folder:
        one_step = ["--set", f"in.tmax={step}", "--set", "in.iout(13)=1", "--set", f"in.tiout(13)={step}"]
        call(program, deck, "--quiet", "--out", folder, *one_step)
        with netCDF4.Dataset(Path(folder) / "history.nc") as history:
            names = [str(text) for text in netCDF4.chartostring(history["body_name"][:])]
        if name not in names:
            raise NoFile(f"{deck} has no {name} of curves; its bodies: {', '.join(names)}")
        with netCDF4.Dataset(Path(folder) / "particles.nc") as points:
            points.set_auto_mask(False)
            of_body = points["body"][0] == names.index(name) + 1
            return [points[field][0][of_body].tolist() for field in ("x", "y", "volume")]


def sections(value, x, volume):
    """What each point has of the membrane's section, thickness times distance [length2]."""
    axisymmetric = float(value["in.cyl"]) != 0
    return [v / (2 * math.pi * r if axisymmetric else 1) for v, r in zip(volume, x)]


def end_of_curve(value, k, last):
    """Where curve k begins, or ends."""
    def of_curve(name, default):
        return float(value.get(f"membrane.{name}({k})", default))

    if value[f"membrane.curve({k})"] in ("arc", "ellipse"):
        angle = math.radians(of_curve("to", 360) if last else of_curve("from", 0))
        a = of_curve("a", 0)
        b = of_curve("b", 0) if value[f"membrane.curve({k})"] == "ellipse" else a
        return of_curve("xc", 0) + a * math.cos(angle), of_curve("yc", 0) + b * math.sin(angle)
    vertex = 1
    while last and f"membrane.x({vertex + 1},{k})" in value:
        vertex += 1
    return tuple(float(value[f"membrane.{name}({vertex},{k})"]) for name in ("x", "y"))


def is_closed(value, b, length):
    """Whether the last curve of membrane b ends where its first begins, as the program sees it."""
    numbers = [k for k in range(1, MOST_CURVES + 1)
               if f"membrane.curve({k})" in value and int(value.get(f"membrane.body({k})", 1)) == b]
    gap = math.dist(end_of_curve(value, numbers[0], last=False), end_of_curve(value, numbers[-1], last=True))
    return gap <= 1e-9 * length


def refuse_what_a_file_cannot_say(value, b, section):
    if value.get(f"membrane.pinned({b})", "none") != "none":
        raise NoFile(f"membrane {b} is pinned: its end points have half the volume of the others, and a particle file "
                     "has one volume for all")
    if is_closed(value, b, sum(section) / float(value[f"membrane.thickness({b})"])):
        raise NoFile(f"membrane {b} is closed, and in a particle file the first and the last point are no neighbours")


def particle_file(value, deck, b, x, y, volume):
    """Its lines. Numbers are written so that they read back to the last bit."""
    section = sections(value, x, volume)
    refuse_what_a_file_cannot_say(value, b, section)
    dx = (float(value["in.xright"]) - float(value["in.xleft"])) / (int(value["in.nx"]) - 1)
    dy = (float(value["in.ytop"]) - float(value["in.ybot"])) / (int(value["in.ny"]) - 1)
    young, poisson = value[f"membrane.young({b})"], value.get(f"membrane.poisson({b})", "0.0")
    yield f"{value[f'membrane.density({b})']} ! density; membrane {b} of {deck.name}, by particles/write_curve.py"
    yield f"{young},{poisson},0.0,0.0,0.0,0.0,0.0 ! Young's modulus, Poisson's ratio"
    yield "3,3,3,8"
    yield f"{len(x)}"
    yield f"{len(x)},{dx * dy / section[0]!r}"
    for place in zip(x, y):
        yield "{!r} {!r} 0.0 0.0 0.0 0.0 0.0".format(*place)
    yield "The points per cell hold for the deck's own grid. Law and one-way law are the deck's law(1) and wrinkle(1)."


def main(words=None):
    chosen = arguments(words)
    try:
        value = values(call(chosen.tether, "check", "--all", chosen.deck))
        x, y, volume = first_snapshot(chosen.tether, chosen.deck, value["in.tstep"], f"membrane {chosen.membrane}")
        lines = list(particle_file(value, chosen.deck, chosen.membrane, x, y, volume))
    except (NoFile, OSError) as reason:
        print(f"write_curve: {reason}", file=sys.stderr)
        return 2
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
