# SPDX-License-Identifier: GPL-3.0-or-later
"""The two readers, tether's and gfortran's, run on many decks at once."""
import dataclasses
import os
import subprocess

PATIENCE = 300  # seconds after which a reader counts as hanging
TETHER, GFORTRAN = os.environ["DECK_VALUES"], os.environ["ORACLE"]


@dataclasses.dataclass
class Reading:
    """What a reader made of a deck."""
    values: set = dataclasses.field(default_factory=set)  # "in nx I 101", as both programs print them
    states: dict = dataclasses.field(default_factory=dict)  # gfortran: group -> iostat, 0 read, -1 end of file
    errors: list = dataclasses.field(default_factory=list)  # gfortran: messages; tether: "line:column: message"
    warnings: list = dataclasses.field(default_factory=list)  # of tether

    def add(self, kind, text):
        if kind == "V":
            self.values.add(text)
        elif kind == "E":
            self.errors.append(text)
        elif kind == "W":
            self.warnings.append(text)
        else:
            group, state, message = text.split(" ", 2)
            self.states[group] = int(state)
            if int(state) > 0:
                self.errors.append(f"{group}: {message}")


def parse(output):
    readings = []
    for line in output.splitlines():
        kind, _, text = line.partition(" ")
        if kind == "DECK":
            readings.append(Reading())
        else:
            readings[-1].add(kind, text)
    return readings


def read_all(program, folder, decks):
    """The readings of decks (bytes), in their order; they are written into files of the folder."""
    paths = [folder / f"{number}.in" for number in range(len(decks))]
    for path, deck in zip(paths, decks, strict=True):
        path.write_bytes(deck)
    result = subprocess.run([program], input="".join(f"{path}\n" for path in paths), capture_output=True, check=True,
                            timeout=PATIENCE, encoding="latin-1")
    readings = parse(result.stdout)
    if len(readings) != len(decks):
        raise AssertionError(f"{program} read {len(readings)} of {len(decks)} decks\n{result.stderr}")
    return readings
