# SPDX-License-Identifier: GPL-3.0-or-later
"""A run's folder: summary, history, fields, exact solution, messages and deck, each read when it is asked for."""
from functools import cached_property
from pathlib import Path

import numpy

from .datasets import NotARun
from .fields import Fields
from .history import History

SWITCHES = {"particles": "iout(13)=1 and tiout(13)", "mesh": "iout(39)=1 and tiout(39)",
            "solids": "iout(39)=1 and tiout(39) of a run with bodies in a fluid",
            "surface": "iout(39)=1 and tiout(39) of a run with a liquid",
            "flow": "iout(39)=1 and tiout(39) of a run with a fluid on a mesh"}


def read_exact(path):
    """Columns by name of `# name name ...` and rows of numbers under it."""
    try:
        lines = path.read_text().splitlines()
        names = lines[0].removeprefix("#").split()
        rows = numpy.array([line.split() for line in lines[1:]], dtype=float).reshape(-1, len(names))
    except (OSError, IndexError, ValueError) as reason:
        raise NotARun(f"{path}: is no table of numbers under a line of names: {reason}") from reason
    return dict(zip(names, rows.T))


def read_values(text):
    """What stands in lines `key = value`: numbers where they are numbers, else texts."""
    found = {}
    for line in text.splitlines():
        key, sign, value = line.partition(" = ")
        if not sign or line.startswith("#"):
            continue
        try:
            found[key] = float(value)
        except ValueError:
            found[key] = value
    return found


def deck_values(text):
    """Values of deck.effective by `group.name`, such as reg.ipath(4,1); texts without their quotes."""
    found, group = {}, ""
    for line in text.splitlines():
        if line.startswith("$"):
            group = line[1:].strip()
        elif group:
            found |= {f"{group}.{key}": value.strip("'\"") if isinstance(value, str) else value
                      for key, value in read_values(line).items()}
    return found


class Run:
    """What a run left in its folder."""

    def __init__(self, folder):
        self.folder = folder
        self.name = folder.resolve().name
        self.history = History(folder / "history.nc")
        self.body_names, self.point_names = self.history.body_names, self.history.point_names
        self._fields = {}

    def _text(self, name):
        path = self.folder / name
        return path.read_text(errors="replace") if path.is_file() else ""

    @cached_property
    def summary(self):
        """Numbers and texts of summary.txt; empty where the run did not end."""
        return read_values(self._text("summary.txt"))

    @cached_property
    def exact(self):
        """Columns of reference.txt in order; empty where there is none."""
        path = self.folder / "reference.txt"
        return read_exact(path) if path.is_file() else {}

    def exact_over(self, abscissa):
        """The exact columns when they stand over this abscissa ("time" or "x"), else none."""
        return self.exact if next(iter(self.exact), None) == abscissa else {}

    @property
    def messages(self):
        """The text of messages.txt."""
        return self._text("messages.txt")

    @property
    def deck(self):
        """The text of deck.effective: each value that the run used."""
        return self._text("deck.effective")

    @cached_property
    def deck_values(self):
        """Values of deck.effective by `group.name`."""
        return deck_values(self.deck)

    @property
    def title(self):
        """The deck's text before its groups."""
        return self.history.attributes.get("title", "")

    @property
    def command(self):
        """The command that made the run."""
        return self.history.attributes.get("history", "")

    @property
    def version(self):
        """The program that made the run, and its commit."""
        return " ".join(self.history.attributes.get(name, "") for name in ("program", "git_hash")).strip()

    def has(self, kind):
        """Whether there are fields of a kind: particles, mesh or solids."""
        try:
            self.fields(kind)
        except NotARun:
            return False
        return True

    def fields(self, kind):
        """Fields of particles, mesh or solids. Raises NotARun where the run wrote none, with what has it write them."""
        if kind not in SWITCHES:
            raise ValueError(f"fields of {kind}: there are {', '.join(SWITCHES)}")
        path = self.folder / f"{kind}.nc"
        if not path.is_file():
            raise NotARun(f"{path}: is not there: {SWITCHES[kind]} have a run write it")
        if kind not in self._fields:
            self._fields[kind] = Fields(path)
        return self._fields[kind]

    @property
    def particles(self):
        """fields("particles"), of which most is drawn."""
        return self.fields("particles")


def open(folder):
    """The run of a folder. Raises NotARun, whose text says what is missing or cannot be understood."""
    folder = Path(folder)
    if not folder.is_dir():
        raise NotARun(f"{folder}: is no folder: give the folder of a run")
    if not (folder / "history.nc").is_file():
        raise NotARun(f"{folder}: has no history.nc: give the folder of a run")
    run = Run(folder)
    _ = run.exact  # a table that cannot be understood is named here, not where it is first drawn
    return run
