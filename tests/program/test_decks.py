# SPDX-License-Identifier: GPL-3.0-or-later
"""`tether decks` lists the decks that come with the program, and copies any of them so that it runs where it lands."""
import pathlib
import unittest

from full_length import FULL
from program import DECKS, ProgramTest

COMMANDS = {"charts": "chart", "maps": "map", "studies": "sweep"}
# What is copied by default: decks alone, with points, with a mesh, compared with another deck, in a folder, and studies
# of each kind. Where they stand, all decks are read by other tests.
SOME = ("ball-net", "coupled-bar", "cyl-200-tether-kept", "cylinder-file", "liquid-bowl-3d", "noise",
        "pendulum-40-two-way", "piston-m1", "plate-hole", "sod-continuity", "paths/two-bar", "charts/cantilever", "charts/sod", "maps/step-place",
        "studies/cost", "studies/stability")


def names():
    return sorted(deck.relative_to(DECKS).with_suffix("").as_posix() for deck in DECKS.rglob("*.in")
                  if deck.parent.name != "published")


class ShippedDecks(ProgramTest):
    def test_all_are_listed_with_a_line_each(self):
        lines = self.expect(0, "decks").stdout.splitlines()
        self.assertEqual(sorted(line.split()[0] for line in lines), names())
        for line in lines:
            self.assertRegex(line, r"^\S+ +[A-Z]", line)
            self.assertLess(len(line), 140, line)

    def test_each_can_be_copied_and_read_where_it_lands(self):
        for name in names() if FULL else SOME:
            with self.subTest(deck=name):
                into = self.folder / name
                copied = self.expect(0, "decks", "get", name, "--out", into).stdout.splitlines()
                self.assertEqual(pathlib.Path(copied[0]), into / (name.replace("/", "-") + ".in"))
                self.assertEqual(sorted(map(str, into.iterdir())), sorted(copied))
                command = COMMANDS.get(name.split("/")[0])
                if command is None:
                    self.expect(0, "check", copied[0])
                else:
                    self.expect(0, command, copied[0], "--dry-run", "--out", into / "out")

    def test_a_file_that_is_there_stays(self):
        (self.folder / "sod.in").write_text("mine\n")
        result = self.expect(4, "decks", "get", "sod", "--out", self.folder)
        self.assertIn("sod.in: is there already; nothing was copied", result.stderr)
        self.assertEqual((self.folder / "sod.in").read_text(), "mine\n")

    def test_a_name_that_is_none(self):
        self.assertIn("Did you mean 'cantilever' or 'charts/cantilever'", self.expect(2, "decks", "get", "canti").stderr)
        self.assertIn("Did you mean 'charts/sod'?", self.expect(2, "decks", "get", "charts/sood").stderr)
        self.assertIn("tether decks get sod", self.expect(2, "decks", "got", "sod").stderr)


if __name__ == "__main__":
    unittest.main()
