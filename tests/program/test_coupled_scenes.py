#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of the coupled path, from their decks and shorter: what must balance, balances at every step."""
import unittest

import numpy

from full_length import FULL
from program import DECKS, ProgramTest, history, sets

GRAVITY = -9.81
# How long each runs: until what it shows has begun; by default for less in space.
SCENES = {"archimedes": 0.5, "balloon": 1.0, "bar": 1.0, "bar-3d": 0.3, "blocks": 0.25, "paddle": 1.0, "paddle-3d": 0.3,
          "piston": 1.0, "sheets": 0.5, "sheets-3d": 0.2, "toy": 1.0, "toy-3d": 0.3}
if not FULL:
    SCENES |= {"bar-3d": 0.1, "sheets-3d": 0.1, "toy-3d": 0.2}
SPRUNG = {"piston"}  # the spring's force stands in no column
WITH_WEIGHT = {"archimedes", "balloon", "blocks", "paddle", "paddle-3d", "toy", "toy-3d"}
CAVITIES = {"balloon", "toy", "toy-3d"}


class CoupledScenes(ProgramTest):
    def scene(self, name, *options):
        end = sets(in__tmax=SCENES[name])
        return history(self.run_ok(DECKS / f"coupled-{name}.in", *end, *options, out=name))

    def check_momentum(self, name, columns):
        """The forces of a step, by the fluid, by what holds the body and by its weight, are what its momentum changes.

        What is left is the rounding of the largest of them, whatever its direction."""
        bodies = sum(column.startswith("body_mass_") for column in columns)
        self.assertGreater(bodies, 0)
        weight = GRAVITY if name in WITH_WEIGHT else 0.0
        for body in range(1, bodies + 1):
            mass = columns[f"body_mass_{body}"][1:]
            left, size = {}, 0.0
            for axis in "xyz"[:3 if name.endswith("3d") else 2]:
                forces = [columns[f"body_{kind}_{axis}_{body}"][1:] for kind in ("force", "hold")]
                forces.append(mass * weight * (axis == "y"))
                change = mass * numpy.diff(columns[f"body_v{axis}_{body}"]) / columns["dt"][1:]
                size = max(size, *(abs(part).max() for part in [*forces, change]))
                if name not in SPRUNG or axis != "x":
                    left[axis] = abs(change - sum(forces)).max()
            self.assertLess(max(left.values()), 1e-10 * size, (name, body, left))

    def check_smoke(self, name, columns):
        self.assertGreater(columns["smoke_in"][-1], 0, name)
        kept = columns["smoke_in"] - columns["smoke_out"]
        self.assertLess(abs(columns["smoke_mass"] - kept).max(), 1e-9 * columns["smoke_in"][-1], name)

    def check_cavity(self, name, columns):
        """The smaller of the bodies' two sheets is the inner one: it holds the volume that it encloses."""
        self.assertNotIn("volume_sheet_3", columns, name)
        volume = min((columns[f"volume_sheet_{sheet}"] for sheet in (1, 2)), key=lambda sheet: sheet[0])
        self.assertLess(abs(volume / volume[0] - 1).max(), 0.04, name)
        self.assertTrue((columns["regions"][1:] == 1).all(), name)

    def test_balances_of_every_scene(self):
        self.assertEqual(sorted(path.stem.removeprefix("coupled-") for path in DECKS.glob("coupled-*.in")), sorted(SCENES))
        for name in SCENES:
            with self.subTest(name):
                columns = self.scene(name)
                self.assertGreater(columns["element_quality"].min(), 0)
                self.assertLess(abs(columns["interface_mismatch"]).max(), 1e-9)
                self.check_momentum(name, columns)
                if "smoke_mass" in columns:
                    self.check_smoke(name, columns)
                if name in CAVITIES:
                    self.check_cavity(name, columns)

    def test_the_piston_swings_at_one_hertz(self):
        columns = self.scene("piston")
        away, time = columns["body_x_1"] - columns["body_x_1"][0], columns["time"]
        back = numpy.flatnonzero((away[:-1] > 0) & (away[1:] <= 0))[0]
        crossed = time[back] + (time[back + 1] - time[back]) * away[back] / (away[back] - away[back + 1])
        self.assertAlmostEqual(2 * crossed, 1, delta=0.001)

    def test_water_lifts_the_block_of_archimedes(self):
        weight = 1000 * 9.81 * 0.05999736  # of the water in the block's corners, as the deck writes them
        self.assertAlmostEqual(self.scene("archimedes")["body_force_y_1"][-1] / weight, 1, delta=1e-9)
        whole_cells = self.scene("archimedes", *sets(coupled__mode="'symmetric'"))
        self.assertAlmostEqual(whole_cells["body_force_y_1"][-1] / weight, 1, delta=0.24)


if __name__ == "__main__":
    unittest.main()
