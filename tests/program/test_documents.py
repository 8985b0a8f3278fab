# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck reference in decks/README.md is the table of variables, and its lists of columns and keys those of the
program, word for word."""
import os
import pathlib
import subprocess
import unittest


class Documents(unittest.TestCase):
    def test_the_deck_reference_is_the_table(self):
        tables = subprocess.run([os.environ["TETHER"], "vars", "--markdown"], capture_output=True, text=True, check=True)
        self.assertTrue(tables.stdout.startswith("## `$in`"))
        reference = pathlib.Path("decks/README.md").read_text()
        self.assertTrue(reference.endswith(tables.stdout), "run: tether vars --markdown, and put it behind '# Variables'")

    def test_columns_and_keys_are_those_of_the_program(self):
        reference = pathlib.Path("decks/README.md").read_text()
        for command, first in (("columns", "| column |"), ("keys", "| key |")):
            table = subprocess.run([os.environ["TETHER"], command, "--markdown"], capture_output=True, text=True, check=True)
            self.assertTrue(table.stdout.startswith(first))
            self.assertIn("\n\n" + table.stdout + "\n", reference, f"run: tether {command} --markdown, and replace that table")

    def test_every_deck_is_in_the_readme(self):
        reference = pathlib.Path("decks/README.md").read_text()
        for deck in pathlib.Path("decks").glob("*.in"):
            family = deck.stem.split("-")[0]
            self.assertIn(family, reference, deck.name)
            self.assertTrue(deck.stem in reference or f"-{deck.stem.rsplit('-', 1)[-1]}" in reference, deck.name)


if __name__ == "__main__":
    unittest.main()
