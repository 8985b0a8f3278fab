# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck reference in decks/README.md is the table of variables, and its list of columns that of the physics, word for
word."""
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

    def test_the_columns_are_those_of_the_tables_of_the_physics(self):
        table = subprocess.run([os.environ["TETHER"], "columns", "--markdown"], capture_output=True, text=True, check=True)
        self.assertTrue(table.stdout.startswith("| column |"))
        reference = pathlib.Path("decks/README.md").read_text()
        self.assertIn("\n\n" + table.stdout + "\n", reference, "run: tether columns --markdown, and put it below 'The history's columns'")

    def test_every_deck_is_in_the_readme(self):
        reference = pathlib.Path("decks/README.md").read_text()
        for deck in pathlib.Path("decks").glob("*.in"):
            family = deck.stem.split("-")[0]
            self.assertIn(family, reference, deck.name)
            self.assertTrue(deck.stem in reference or f"-{deck.stem.rsplit('-', 1)[-1]}" in reference, deck.name)


if __name__ == "__main__":
    unittest.main()
