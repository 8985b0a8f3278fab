# SPDX-License-Identifier: GPL-3.0-or-later
"""post/amplification.py against the thesis' Maple listing, its limits, and the steps themselves as matrices."""
import subprocess
import sys
import unittest
from pathlib import Path

import numpy
import sympy

POST = Path(__file__).resolve().parents[2] / "post"
sys.path.insert(0, str(POST))

import amplification
from amplification import C, N, c, dt, dx

V = amplification.v[0]


def zero(expression):
    return sympy.simplify(expression) == 0


class AgainstTheThesis(unittest.TestCase):
    def test_the_braking_is_what_maple_gave(self):
        """A.4.14, the output of its first simplify(f)."""
        top = V * (6 * dt**2 * V**2 * N**4 - 6 * N**2 * dx**2 + 6 * N * dx**2 + dt**2 * V**2 - 2 * dx**2
                   + 2 * N * dx * dt * V - 12 * dt**2 * V**2 * N**3 + 11 * dt**2 * V**2 * N**2
                   - 5 * dt**2 * V**2 * N - dt * V * dx)
        bottom = ((-dx + 3 * dt * V * N**2 - 3 * dt * V * N + dt * V)
                  * (dx + 3 * dt * V * N**2 - 3 * dt * V * N + dt * V))
        self.assertTrue(zero(amplification.braking() - top / bottom))

    def test_the_braking_at_sides_and_centre(self):
        """(8.31), (8.37) and Maple's f1."""
        half = sympy.Rational(1, 2)
        for place, expected in ((0, V * (dt * V - 2 * dx) / (dt * V - dx)), (1, V * (2 * dx + dt * V) / (dx + dt * V)),
                                (half, 2 * V * (dt**2 * V**2 - 4 * dx**2) / (dt**2 * V**2 - 16 * dx**2))):
            self.assertTrue(zero(amplification.braking().subs(N, place) - expected), place)

    def test_amplification_and_limits(self):
        """(8.34), (8.36), (8.38), (8.41): dx/c at the sides, 2 dx/c at the centres."""
        for place in (0, amplification.SIDE):
            self.assertTrue(zero(amplification.amplification().subs(N, place) - (1 - 2 * C**2)))
            self.assertEqual(amplification.limit(place), 1)
        self.assertTrue(zero(amplification.amplification().subs(N, amplification.CENTRE) - (1 - C**2 / 2)))
        self.assertEqual(amplification.limit(amplification.CENTRE), 2)


def growth(mapping, courant):
    """Largest growth factor a step, of points whose node velocities are `mapping` @ v and walls or period are in it."""
    strain_rate, force = mapping
    step = numpy.eye(2 * len(force))
    count = len(force)
    step[:count, count:] = courant * force
    step[count:, :] = courant * strain_rate @ step[:count, :]
    step[count:, count:] += numpy.eye(count)
    return max(abs(numpy.linalg.eigvals(step)))


def ring(place, count):
    """Strain rates of the points by their velocities, and accelerations by their stresses: cells in a circle."""
    one, after = numpy.eye(count), numpy.roll(numpy.eye(count), -1, axis=0)  # after: row p picks point p + 1
    node = place * one + (1 - place) * after.T  # left node of each point
    strain_rate = after @ node - node
    nodal_force = one - after.T
    return strain_rate, place * nodal_force + (1 - place) * after @ nodal_force


def bar(place, cells):
    """The same between fixed walls: `cells` + 1 nodes of which the two outer ones stand still."""
    shape = numpy.zeros((cells + 1, cells))
    for p in range(cells):
        shape[p, p], shape[p + 1, p] = place, 1 - place
    inner = numpy.zeros(cells + 1)
    inner[1:-1] = 1  # the masses of the inner nodes, too
    gradient = numpy.diff(numpy.eye(cells + 1), axis=0)
    return gradient @ (inner[:, None] * shape), shape.T @ (inner[:, None] * -gradient.T)


class AgainstTheSteps(unittest.TestCase):
    def check_limit(self, mapping, limit):
        self.assertLess(growth(mapping, 0.999 * limit), 1 + 1e-6)
        self.assertGreater(growth(mapping, 1.001 * limit), 1.01)

    def test_waves_grow_beyond_their_limit(self):
        """120 cells in a circle have the stiffest wave, or one as near to it as makes no difference."""
        for place in (0, sympy.Rational(1, 8), sympy.Rational(1, 4), sympy.Rational(2, 5), sympy.Rational(1, 2), 1):
            with self.subTest(N=place):
                self.check_limit(ring(float(place), 120), float(amplification.wave_limit(sympy.sympify(place))))

    def test_a_bar_between_walls_bears_a_little_more(self):
        for place in (amplification.SIDE, amplification.CENTRE):
            for cells in (3, 5, 8):
                with self.subTest(N=place, cells=cells):
                    self.check_limit(bar(float(place), cells), float(amplification.bar_limit(place, cells)))

    def test_the_bar_of_the_thesis_test(self):
        """8.5 measured 1.1 and 2.0 times dx/c."""
        self.assertAlmostEqual(float(amplification.bar_limit(amplification.SIDE, 5)), 1.0515, places=4)
        self.assertAlmostEqual(float(amplification.bar_limit(amplification.CENTRE, 5)), 2.1029, places=4)


class CommandLine(unittest.TestCase):
    def test_prints_the_limits(self):
        result = subprocess.run([sys.executable, POST / "amplification.py"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        for line in ("G = 1 - 2*C**2, |G| <= 1 for dt <= 1 dx/c", "G = 1 - C**2/2, |G| <= 1 for dt <= 2 dx/c",
                     "no wave grows for dt <= 2 dx/c, on five cells between fixed walls for dt <= 2.1029 dx/c"):
            self.assertIn(line, result.stdout)


if __name__ == "__main__":
    unittest.main()
