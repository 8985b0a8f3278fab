# SPDX-License-Identifier: GPL-3.0-or-later
"""particles/write_bowl.py and particles/write_rabbit.py: they write the meshes of the decks that have them."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from full_length import FULL

ROOT = Path(__file__).resolve().parents[2]


def numbers(path):
    return [float(word) for word in path.read_text().split() if word[0] not in "$\""]


class WriteMeshes(unittest.TestCase):
    def is_written(self, deck, *command):
        with tempfile.TemporaryDirectory() as folder:
            mesh = Path(folder) / "a.msh"
            subprocess.run([sys.executable, ROOT / "particles" / command[0], mesh, *command[1:]], check=True, capture_output=True)
            found, shipped = numbers(mesh), numbers(ROOT / "decks" / deck)
        self.assertEqual(len(found), len(shipped))
        self.assertLess(max(abs(a - b) for a, b in zip(found, shipped)), 1e-6)

    def test_the_bowl_and_at_full_length_the_rabbit_in_the_plane(self):
        self.is_written("liquid-bowl.msh", "write_bowl.py")
        if FULL:
            self.is_written("liquid-rabbit.msh", "write_rabbit.py", "--plane", "--cell", ".035")


if __name__ == "__main__":
    unittest.main()
