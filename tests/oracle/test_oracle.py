# SPDX-License-Identifier: GPL-3.0-or-later
"""tether reads decks as gfortran's namelist reader does, every value to the last bit: the thesis' boxes and 2,000
generated decks, at full length 10,000."""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))

from full_length import FULL
from generate import generate
from readers import GFORTRAN, TETHER, read_all

BOXES = sorted((pathlib.Path(__file__).resolve().parents[1] / "thesis-boxes").glob("*.in"))
DECKS = 10_000 if FULL else 2_000
SHOWN = 5  # decks that differ, and differences of each

OPENER = re.compile(r"\s*[$&](in|fluid|regrig|reg)\b", re.IGNORECASE)


def canonical(text):
    """A box as gfortran can read it: '$end' for a bare '$' and before an opener that closes a group, '2.00' for
    '2.00.'."""
    lines, is_open = [], False
    for line in text.splitlines():
        if OPENER.match(line):
            lines += ["$end"] if is_open else []
            is_open = True
        elif line.strip() in ("$", "&"):
            line, is_open = "$end", False
        lines.append(re.sub(r"(\d\.\d*)\.(?=\s*,)", r"\1", line))
    return "\n".join(lines + (["$end"] if is_open else [])) + "\n"


def difference(ours, theirs):
    """What differs in two readings of a deck, as a text; empty if nothing does."""
    half_read = [group for group, state in theirs.states.items()
                 if state != 0 and any(value.startswith(group + " ") for value in ours.values)]
    told = [f"tether: {error}" for error in ours.errors] + [f"gfortran: {error}" for error in theirs.errors]
    values = [f"tether alone: {value}" for value in sorted(ours.values - theirs.values)]
    values += [f"gfortran alone: {value}" for value in sorted(theirs.values - ours.values)]
    return "\n".join((told + [f"gfortran: end of file in {group}" for group in half_read] + values)[:SHOWN])


class Oracle(unittest.TestCase):
    def compare(self, what, decks):
        """decks: name -> (as tether reads it, as gfortran reads it)."""
        with tempfile.TemporaryDirectory() as folder:
            ours = read_all(TETHER, pathlib.Path(folder), [deck for deck, _ in decks.values()])
            theirs = read_all(GFORTRAN, pathlib.Path(folder), [deck for _, deck in decks.values()])
        found = {name: difference(*readings) for name, *readings in zip(decks, ours, theirs, strict=True)}
        differing = [name for name, text in found.items() if text]
        print(f"{what}: {len(decks)} decks, {sum(len(reading.values) for reading in theirs)} values, "
              f"{len(differing)} decks that differ")
        for name in differing[:SHOWN]:
            print(f"{name}:\n{found[name]}\n{decks[name][0].decode()}")
        self.assertEqual(differing, [])

    def test_boxes(self):
        self.assertEqual(len(BOXES), 12)
        self.compare("boxes", {box.name: (box.read_bytes(), canonical(box.read_text()).encode()) for box in BOXES})

    def test_generated_decks(self):
        self.compare("generated", {f"deck of seed {seed}": generate(seed) for seed in range(DECKS)})


if __name__ == "__main__":
    unittest.main()
