# SPDX-License-Identifier: GPL-3.0-or-later
"""The first error that `tether check` tells stands where the mistake is: line and column of each of 500 seeded ones."""
import collections
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))

from mistakes import KINDS, MistakenDeck
from program import ProgramTest, diagnostics, run

DECKS = 500
LEAST_RIGHT = 500


class Mistakes(ProgramTest):
    def check(self, name, deck):
        path = self.folder / f"{name}.in"
        path.write_bytes(deck.text.encode())
        return run("check", path)

    def first_error(self, kind, seed):
        """(place of the mistake, place of the first error) in one deck."""
        deck = MistakenDeck(kind, seed)
        result = self.check(f"{kind} {seed}", deck)
        self.assertEqual(result.returncode, 2, f"{deck.text}\n{result.stderr}")
        errors = [head for head, _ in diagnostics(result.stderr) if head["severity"] == "error"]
        return deck.place, (int(errors[0]["line"] or 0), int(errors[0]["column"] or 0))

    def test_without_a_mistake_the_decks_are_sound(self):
        for seed in range(20):
            result = self.check(f"sound {seed}", MistakenDeck("none", seed))
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_the_first_error_is_told_where_the_mistake_is(self):
        right, decks = collections.Counter(), collections.Counter()
        for number in range(DECKS):
            kind = list(KINDS)[number % len(KINDS)]
            place, told = self.first_error(kind, number // len(KINDS))
            decks[kind] += 1
            right[kind] += told == place
        for kind, count in decks.items():
            print(f"{kind}: {right[kind]} of {count}")
        print(f"{len(KINDS)} kinds, {DECKS} decks, right line and column in {right.total()}")
        self.assertGreaterEqual(right.total(), LEAST_RIGHT)


if __name__ == "__main__":
    unittest.main()
