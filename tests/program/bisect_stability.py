#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The longest stable step of a bar of five points (thesis section 8.5, Fig. 91), over dx/c, by bisection.

TETHER=build/release/tether python3 tests/program/bisect_stability.py
"""
import pathlib
import tempfile

from program import DECKS, history, run

LIMIT = 1e-3  # dx/c of both decks [time]
GROWTH = 100  # of the total energy within tmax: unstable
TOLERANCE = 1e-3  # of the step over dx/c


def is_unstable(deck, ratio, folder):
    """Whether the total energy grows beyond bounds with tstep = ratio dx/c; each step is recorded."""
    words = []
    for name in ("tstep", "dtmax", "tiout(33)", "tiout(34)"):
        words += ["--set", f"in.{name}={ratio * LIMIT!r}"]
    result = run(DECKS / deck, "--quiet", "--out", folder, *words)
    if result.returncode not in (0, 3):  # 3: it grew until a point was lost
        raise RuntimeError(result.stderr)
    energy = history(pathlib.Path(folder))["energy_total"]
    return result.returncode == 3 or energy.max() > GROWTH * energy[0]


def first_unstable_ratio(deck):
    """The first step over dx/c that is unstable: upwards from 0.5 by 0.1, then by bisection."""
    with tempfile.TemporaryDirectory() as folder:
        ratios = (0.1 * k for k in range(5, 40))
        high = next(ratio for ratio in ratios if is_unstable(deck, ratio, folder))
        low = high - 0.1
        while high - low > TOLERANCE:
            middle = 0.5 * (low + high)
            low, high = (low, middle) if is_unstable(deck, middle, folder) else (middle, high)
    return high


if __name__ == "__main__":
    for deck_name in ("stability-centre.in", "stability-side.in"):
        print(f"{deck_name}: unstable from {first_unstable_ratio(deck_name):.3f} dx/c on")
