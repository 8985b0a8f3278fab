# SPDX-License-Identifier: GPL-3.0-or-later
"""The deck reference in decks/guide/variables is the table of variables, and the lists of columns and keys in decks/guide are those of
the program, word for word; every deck is in the guides."""
import os
import pathlib
import re
import subprocess
import unittest

GUIDE = pathlib.Path("decks/guide")
PAGES = [pathlib.Path("decks/README.md"), *sorted(GUIDE.glob("**/*.md"))]


def printed(*words):
    return subprocess.run([os.environ["TETHER"], *words], capture_output=True, text=True, check=True).stdout


class Documents(unittest.TestCase):
    def test_the_deck_reference_is_the_table(self):
        tables = printed("vars", "--markdown")
        self.assertTrue(tables.startswith("## `$in`"))
        groups = {re.match(r"## `\$(\w+)`", table)[1]: table for table in re.split(r"(?m)^(?=## )", tables) if table}
        pages = {page.stem: page.read_text() for page in (GUIDE / "variables").glob("*.md")}
        self.assertEqual(sorted(pages), sorted(groups), "a page for each group, and none without a group")
        for group, table in groups.items():
            self.assertEqual(pages[group], f"# ${group}\n\n{table.rstrip()}\n",
                             f"run: tether vars --markdown, and put the table of ${group} into variables/{group}.md")

    def test_columns_and_keys_are_those_of_the_program(self):
        for command, first in (("columns", "| column |"), ("keys", "| key |")):
            table = printed(command, "--markdown")
            self.assertTrue(table.startswith(first))
            self.assertIn("\n\n" + table + "\n", (GUIDE / f"results-{command}.md").read_text(),
                          f"run: tether {command} --markdown, and replace the table of results-{command}.md")

    def test_every_deck_is_in_the_readme(self):
        reference = "\n".join(page.read_text() for page in PAGES)
        for deck in pathlib.Path("decks").glob("*.in"):
            family = deck.stem.split("-")[0]
            self.assertIn(family, reference, deck.name)
            self.assertTrue(deck.stem in reference or f"-{deck.stem.rsplit('-', 1)[-1]}" in reference, deck.name)


if __name__ == "__main__":
    unittest.main()
