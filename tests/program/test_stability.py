# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps at which a bar of five points turns unstable: 2 dx/c with points at the cells' centres, dx/c at their sides."""
import tempfile
import unittest

from bisect_stability import first_unstable_ratio, is_unstable


class LongestStableStep(unittest.TestCase):
    def check(self, deck, low, high):
        ratio = first_unstable_ratio(deck)
        print(f"{deck}: unstable from {ratio:.3f} dx/c on", flush=True)
        self.assertGreater(ratio, low)
        self.assertLess(ratio, high)

    def test_points_at_the_centres(self):
        self.check("stability-centre.in", 2.0, 2.2)

    def test_points_at_the_sides(self):
        self.check("stability-side.in", 1.0, 1.1)

    def test_the_measure_tells_both(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertFalse(is_unstable("stability-centre.in", 1.5, folder))
            self.assertTrue(is_unstable("stability-side.in", 1.5, folder))


if __name__ == "__main__":
    unittest.main()
