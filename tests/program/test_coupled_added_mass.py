#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies let go in water that stands still, in a shell that holds it: the first acceleration is exactly known.

A body of radius a in a concentric shell of radius b starts with (m - m_f) g / (m + c m_f), m_f being the fluid's mass in
its place: c = (b^2 + a^2)/(b^2 - a^2) for cylinders, (b^3 + 2 a^3)/(b^3 - a^3)/2 for spheres.
"""
import math
import unittest

from meshes_of_balls import cylinder_deck, sphere_deck
from program import ProgramTest, history, sets, summary

GRAVITY, WATER = -9.81, 1000.0
A, B = 0.1, 0.3


def exact(density, added):
    return (density - WATER) * GRAVITY / (density + added * WATER)


class AddedMass(ProgramTest):
    def error(self, deck, wanted, *options):
        run = self.run_ok(deck, *options)
        return history(run)["body_vy_1"][-1] / 1e-3 / wanted - 1

    def cylinder(self, cells, *options):
        """Hardly heavier than water: what is to be found is the hundredth part of the lift."""
        deck = cylinder_deck(self.folder, cells, A, B, 1010.0)
        return self.error(deck, exact(1010.0, (B**2 + A**2) / (B**2 - A**2)), *options)

    def sphere(self, cells, *options):
        deck = sphere_deck(self.folder, cells, A, B, 500.0)
        return self.error(deck, exact(500.0, (B**3 + 2 * A**3) / (B**3 - A**3) / 2), *options)

    def test_a_cylinder_hardly_heavier_than_water_sinks(self):
        self.assertLess(abs(self.cylinder(64)), 0.02)
        self.assertLess(abs(self.cylinder(48)), 0.015)
        self.assertLess(abs(self.cylinder(31)), 0.025)  # no line of the grid through its middle

    def test_by_whole_cells_it_rises(self):
        self.assertGreater(abs(self.cylinder(64, *sets(coupled__mode="'symmetric'"))), 1.5)

    def test_a_light_sphere_rises_by_order_two(self):
        coarse, fine = self.sphere(24), self.sphere(48)
        self.assertLess(abs(fine), 0.015)
        self.assertGreater(math.log2(coarse / fine), 1.6)


class ThinBodies(ProgramTest):
    """What is thinner than a cell is left to whole cells, and the program says so."""
    def plate(self, thickness):
        deck = self.folder / f"plate-{thickness}.in"
        low, high = 0.5037 - thickness / 2, 0.5037 + thickness / 2
        deck.write_text(
            "a plate that sinks\n$in nx=33, ny=33, xleft=0., xright=1., ybot=0., ytop=1., tmax=.02, tstep=.01, gravc=-9.81 $\n"
            f"$reg nreg=1, nvi=4, xvi(1,1)=.3,.7,.7,.3, yvi(1,1)={low},{low},{high},{high}, densir(1)=3000., "
            "matr(1,1)=1e8,.3 $\n$mesh element='p1', cells(1,1)=20,2 $\n$coupled density=1000., side(4)='open' $\n")
        return deck

    def test_what_is_thinner_than_a_cell_is_told(self):
        thin, thick = self.plate(0.02), self.plate(0.1)
        for command in ("check", "plan"):
            self.assertIn("thinner than a cell", self.expect(0, command, thin).stderr, command)
            self.assertNotIn("thinner than a cell", self.expect(0, command, thick).stderr, command)
        run = self.run_ok(thin, out="thin")
        self.assertEqual((run / "messages.txt").read_text().count("thinner than a cell"), 1)
        self.assertGreater(int(summary(run)["thin_cells"]), 0)
        run = self.run_ok(thick, out="thick")
        self.assertNotIn("thinner than a cell", (run / "messages.txt").read_text())
        self.assertEqual(int(summary(run)["thin_cells"]), 0)


if __name__ == "__main__":
    unittest.main()
