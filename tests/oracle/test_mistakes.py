# SPDX-License-Identifier: GPL-3.0-or-later
"""The first error that is reported stands where the mistake is: line and column of each of 500 seeded ones."""
import collections
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))

from full_length import FULL
from mistakes import KINDS, MistakenDeck
from program import ProgramTest, diagnostics

DECKS = 500
LEAST_RIGHT = 500


class Mistakes(ProgramTest):
    def write_deck(self, name, deck):
        (self.folder / f"{name}.in").write_bytes(deck.text.encode())

    def calls(self, decks):
        """The words of calls that read all of them: by default one dry run, which says the same as `tether check` of
        each."""
        if FULL:
            return [("check", f"{name}.in") for name in decks]
        return [("--dry-run", *(f"{name}.in" for name in decks))]

    def errors(self, decks):
        """The errors of each deck, in order."""
        found = {name: [] for name in decks}
        for name, deck in decks.items():
            self.write_deck(name, deck)
        for words in self.calls(decks):
            for head, _ in diagnostics(self.expect(2, *words, folder=self.folder).stderr):
                if head["severity"] == "error":
                    found[pathlib.Path(head["file"]).stem].append(head)
        return found

    def test_without_a_mistake_the_decks_are_sound(self):
        for seed in range(20):
            self.write_deck(f"sound {seed}", MistakenDeck("none", seed))
            self.expect(0, "check", self.folder / f"sound {seed}.in")

    def test_the_first_error_is_told_where_the_mistake_is(self):
        seeds = [(list(KINDS)[number % len(KINDS)], number // len(KINDS)) for number in range(DECKS)]
        decks = {f"deck-{number}": MistakenDeck(*seed) for number, seed in enumerate(seeds)}
        right, counts = collections.Counter(), collections.Counter(kind for kind, _ in seeds)
        found = self.errors(decks)
        for (kind, _), (name, deck) in zip(seeds, decks.items(), strict=True):
            self.assertTrue(found[name], deck.text)
            first = found[name][0]
            right[kind] += deck.place == (int(first["line"] or 0), int(first["column"] or 0))
        for kind, count in counts.items():
            print(f"{kind}: {right[kind]} of {count}")
        print(f"{len(KINDS)} kinds, {DECKS} decks, right line and column in {right.total()}")
        self.assertGreaterEqual(right.total(), LEAST_RIGHT)


if __name__ == "__main__":
    unittest.main()
