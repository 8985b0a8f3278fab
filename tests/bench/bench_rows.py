# SPDX-License-Identifier: GPL-3.0-or-later
"""Particle files of a square block of elastic points, in the order of its cells or in none, at even places or irregular.

The block stands in the grid of rows.in, with a margin of eight cells, and is stirred as that of the plain loops is.
"""
import math
import random

CELLS, PER_SIDE, MARGIN = 160, 2, 8  # of the block; points of a cell along an axis; cells
SIDE = 1 / (CELLS + 2 * MARGIN)
YOUNG, POISSON = 1000.0, 0.3
SPEED = 0.05 * math.sqrt(1.35 * YOUNG)
JITTER = 0.9  # of the points' distance
KINDS = ("even", "irregular", "shuffled")


def places(kind, chance):
    """x, y of the points, in cells from the block's corner, cell by cell."""
    for cell in range(CELLS * CELLS):
        for point in range(PER_SIDE * PER_SIDE):
            away = [(JITTER * (chance.random() - 0.5) if kind == "irregular" else 0.0) for _ in range(2)]
            yield (cell % CELLS + (point % PER_SIDE + 0.5 + away[0]) / PER_SIDE,
                   cell // CELLS + (point // PER_SIDE + 0.5 + away[1]) / PER_SIDE)


def rows(kind):
    """x, y, vx, vy of each point."""
    chance = random.Random(1)
    found = []
    for i, j in places(kind, chance):
        x, y = i / CELLS, j / CELLS
        found.append((SIDE * (i + MARGIN), SIDE * (j + MARGIN), SPEED * math.sin(6 * x) * math.cos(5 * y),
                      SPEED * math.cos(4 * x) * math.sin(7 * y)))
    if kind == "shuffled":
        chance.shuffle(found)
    return found


def write(path, kind):
    """A particle file, as particles/README.md says."""
    found = rows(kind)
    head = ["1.0", f"{YOUNG},{POISSON},0.,0.,0.,0.,0.", "3,3,3,0", f"{len(found)}", f"{len(found)},{PER_SIDE ** 2}"]
    lines = [f"{x:.15g} {y:.15g} {vx:.15g} {vy:.15g} 0. 0. 0." for x, y, vx, vy in found]
    path.write_text("\n".join(head + lines) + "\n")
