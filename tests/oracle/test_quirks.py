# SPDX-License-Identifier: GPL-3.0-or-later
"""Where gfortran and tether read a deck differently on purpose: each row of the table in README.md, on both sides."""
import pathlib
import re
import struct
import tempfile
import unittest

from readers import GFORTRAN, TETHER, read_all

README = pathlib.Path(__file__).with_name("README.md")
ROW = re.compile(r"\| (\w+) \| `(.+)` \| `(.+)` \| `(.+)` \| .+ \|")

REQUIRED = "nx=11,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1"
FRAME_VALUES = re.compile(r"in (nx|ny|xleft|xright|ybot|ytop|tmax|tstep) |reg nreg ")


def in_frame(group, text):
    """A whole deck, with the text from line 4 on as items of the group. A text that opens groups itself is the deck."""
    text = text.encode().decode("unicode_escape").replace("...", REQUIRED)
    if re.search(r"[$&] ?in\b", text):
        return text.encode()
    if group == "in":
        return f"\n\n$in {REQUIRED}\n{text}\n/\n".encode()
    return f"$in {REQUIRED}\n/\n${group}{' nreg=20' * (group == 'reg')}\n{text}\n/\n".encode()


def spelled(value):
    """'iout(13)=1' of 'in iout(13) I 1'; numbers as Python writes them."""
    _, name, kind, text = value.split(" ", 3)
    if kind == "R":
        text = repr(struct.unpack(">d", bytes.fromhex(text))[0]).removesuffix(".0")
    return f"{name}={text}"


def values(reading):
    return sorted(spelled(value) for value in reading.values if not FRAME_VALUES.match(value))


def gfortran_cell(reading, group):
    state = reading.states[group]
    return (["error"] if state > 0 else ["end-of-file"] if state < 0 else []) + values(reading) or ["nothing"]


def tether_cell(reading):
    places = [f"{word} {text.split(': ')[0]}"
              for word, texts in (("error", reading.errors), ("warning", reading.warnings)) for text in texts]
    return places + values(reading) or ["nothing"]


class Quirks(unittest.TestCase):
    def test_each_is_as_the_table_says(self):
        table = [line for line in README.read_text().splitlines() if line.startswith("|")][2:]
        rows = [ROW.fullmatch(line).groups() for line in table]
        decks = [in_frame(group, text) for group, text, _, _ in rows]
        with tempfile.TemporaryDirectory() as folder:
            ours = read_all(TETHER, pathlib.Path(folder), decks)
            theirs = read_all(GFORTRAN, pathlib.Path(folder), decks)
        for (group, text, gfortran, tether), mine, other in zip(rows, ours, theirs, strict=True):
            with self.subTest(group=group, text=text):
                self.assertEqual(" ".join(gfortran_cell(other, group)), gfortran)
                self.assertEqual(" ".join(tether_cell(mine)), tether)
        print(f"{len(rows)} quirks")


if __name__ == "__main__":
    unittest.main()
