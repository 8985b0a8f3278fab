# SPDX-License-Identifier: GPL-3.0-or-later
"""The guides: their links lead somewhere, pages and cells are short, their words are plain, and the decks of the tutorial can be read."""
import pathlib
import re
import shutil
import subprocess
import unittest

from program import DECKS, ROOT, ProgramTest

GUIDE = DECKS / "guide"
GUIDES = [DECKS / "README.md", *sorted(GUIDE.glob("**/*.md"))]
GENERATED = [*sorted((GUIDE / "variables").glob("*.md")), GUIDE / "results-columns.md", GUIDE / "results-keys.md"]
LINKING = [*GUIDES, *(ROOT / name for name in ("README.md", "post/README.md", "particles/README.md", "tests/README.md", "CONTRIBUTING.md")
                      if (ROOT / name).exists())]
TUTORIAL = GUIDE / "tutorial.md"

FORBIDDEN = (r"\bbehind\b", r"\btells?\b", r"(?<!let )\bgo(es)? by\b", r"(?<![\w.)\]])\.\d")
WORDS_OF_THE_FIELD = ",".join(("fo", "nd"))  # that codespell may take for slips: names in decks, "2nd" parted from its number


def name_of(page):
    return str(page.relative_to(ROOT))


def without_code(text):
    """The lines of a page in which its blocks of code are empty, and what stands in backticks is a space."""
    lines, inside = [], False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = not inside
            line = ""
        lines.append("" if inside or line.startswith("    ") else re.sub(r"`[^`]*`", " ", line))
    return lines


def anchors(page):
    """What headings are called in links: lower case, no marks, hyphens for blanks."""
    headings, inside = [], False
    for line in page.read_text().splitlines():
        inside ^= line.startswith("```")
        if not inside and line.startswith("#"):
            headings.append(re.sub(r"[^\w\- ]", "", line.lstrip("#").strip().lower()).replace(" ", "-"))
    return headings


def tables(page):
    """The rows of each table, as cells."""
    rows = []
    for line in [*page.read_text().splitlines(), ""]:
        if line.startswith("|"):
            rows.append([cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]])
        elif rows:
            yield rows
            rows = []


class Guides(unittest.TestCase):
    def test_links_lead_somewhere(self):
        dead = []
        for page in LINKING:
            for link in re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", re.sub(r"(?ms)^```.*?^```", "", page.read_text())):
                if "://" in link:
                    continue
                path, _, anchor = link.partition("#")
                there = (page.parent / path).resolve() if path else page
                if not there.exists() or (anchor and anchor not in anchors(there)):
                    dead.append((name_of(page), link))
        self.assertEqual(dead, [])

    def test_every_page_is_linked_from_the_index_or_a_page_of_it(self):
        linked = {(page.parent / link).resolve() for page in GUIDES
                  for link in re.findall(r"\]\(([^)#\s]+)", page.read_text()) if "://" not in link}
        self.assertEqual([name_of(page) for page in GUIDES[1:] if page.resolve() not in linked], [])

    def test_pages_are_short(self):
        lengths = {name_of(page): len(page.read_text().split()) for page in GUIDES}
        self.assertEqual({page: words for page, words in lengths.items() if words >= 3000}, {})
        self.assertLess(lengths["decks/README.md"], 1500)

    def test_cells_are_short(self):
        long = [(name_of(page), cell) for page in GUIDES if page not in GENERATED for rows in tables(page)
                if rows[0] != ["function", "is"]  # which a test holds to the program
                for row in rows for cell in row if len(cell.split()) > 30]
        self.assertEqual(long, [])

    def test_words_are_plain(self):
        found = [(name_of(page), number, line) for page in GUIDES if page not in GENERATED
                 for number, line in enumerate(without_code(page.read_text()), 1)
                 for word in FORBIDDEN if re.search(word, line)]
        self.assertEqual(found, [])

    def test_words_are_spelt_right(self):
        found = subprocess.run(["codespell", "--ignore-words-list", WORDS_OF_THE_FIELD, ROOT / "README.md", *GUIDES],
                               capture_output=True, text=True)
        self.assertEqual((found.stdout, found.stderr, found.returncode), ("", "", 0))


class Tutorial(ProgramTest):
    """Its files, written into a folder of their own."""

    def setUp(self):
        super().setUp()
        (self.folder / "mine").mkdir()
        shutil.copy(DECKS / "plate-hole.msh", self.folder / "mine")
        self.files = re.findall(r"(?ms)^file: (\S+)\n\n```\n(.*?)^```$", TUTORIAL.read_text())
        for name, text in self.files:
            self.write(name, text)

    def test_each_block_that_is_a_file_is_found(self):
        self.assertEqual(len(self.files), len(re.findall(r"(?m)^file: ", TUTORIAL.read_text())))
        self.assertGreater(len(self.files), 5)

    def test_each_deck_can_be_read(self):
        for name, text in self.files:
            if not name.endswith(".in"):
                continue
            with self.subTest(name):
                mode = re.search(r"mode='(\w+)'", text)
                if not mode:
                    self.expect(0, "check", name, folder=self.folder)
                elif mode[1] in ("chart", "map"):
                    self.expect(0, mode[1], name, "--dry-run", folder=self.folder)
                else:
                    self.expect(0, "sweep", name, "--dry-run", folder=self.folder)


if __name__ == "__main__":
    unittest.main()
