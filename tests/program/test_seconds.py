#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds of summary.txt: of the processor and of the clock on the wall, for the whole and its parts, over restarts."""
import unittest

import netCDF4

from program import DECKS, ProgramTest, sets, summary

PATHS = {"stability-side": (), "cantilever": ("assembly", "solve", "analysis"),
         "cylinder": ("assembly", "solve", "analysis"), "coupled-piston": ("solve",)}


def seconds(folder, name=""):
    """(cpu, wall) of a part of a run, or of the whole."""
    lines = summary(folder)
    return tuple(float(lines[f"{name}{'_' if name else ''}{clock}_seconds"]) for clock in ("cpu", "wall"))


def saved_seconds(checkpoint):
    """{part: (cpu, wall)} of a checkpoint."""
    with netCDF4.Dataset(checkpoint) as file:
        lines = [line.split(" ") for line in file.seconds.splitlines()]
    return {name: (float(cpu), float(wall)) for name, cpu, wall in lines}


class Seconds(ProgramTest):
    def test_parts_are_parts_of_the_whole_by_both_clocks(self):
        for deck, parts in PATHS.items():
            folder = self.run_ok(DECKS / f"{deck}.in", *sets(in__tmax=0.02), out=deck)
            whole = seconds(folder)
            self.assertEqual({key.removesuffix("_cpu_seconds") for key in summary(folder) if key.endswith("_cpu_seconds")}, {"setup", *parts})
            for clock in (0, 1):
                sums = {part: seconds(folder, part)[clock] for part in ("setup", *parts)}
                self.assertGreater(sums["setup"], 0)
                together = sum(taken for part, taken in sums.items() if part != "analysis")
                self.assertLess(together, whole[clock], deck)
                self.assertLessEqual(sums.get("analysis", 0), sums.get("solve", 0))

    def test_a_point_s_step_is_without_the_set_up(self):
        folder = self.run_ok(DECKS / "stability-side.in")
        lines = summary(folder)
        steps = float(lines["cpu_seconds"]) - float(lines["setup_cpu_seconds"])
        told = float(lines["ns_per_point_step"]) * int(lines["steps"]) * int(lines["points"]) * 1e-9
        self.assertAlmostEqual(told / steps, 1, delta=1e-6)

    def test_restarts_add_up(self):
        for deck, parts in PATHS.items():
            options = sets(**{"in__iout(41)": 1, "in__tiout(41)": 1})
            folder = self.run_ok(DECKS / f"{deck}.in", *options, *sets(in__tmax=0.02), out=deck)
            saved = saved_seconds(folder / "checkpoint-1.nc")
            self.assertEqual(set(saved), {"whole", "setup", *parts})
            self.run_ok(DECKS / f"{deck}.in", *options, *sets(in__tmax=0.04), "--restart", folder / "checkpoint-1.nc", out=deck)
            for part, before in saved.items():
                for clock, taken in enumerate(seconds(folder, "" if part == "whole" else part)):
                    self.assertGreater(before[clock], 0)
                    self.assertGreater(taken, before[clock], (deck, part))


if __name__ == "__main__":
    unittest.main()
