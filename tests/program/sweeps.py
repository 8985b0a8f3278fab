# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps of studies that tests write, in a temporary folder with copies of the decks."""
import csv
import shutil

from program import DECKS, ProgramTest

COST = ("cpu_seconds", "wall_seconds", "reused")  # columns that differ from sweep to sweep


def rows_of(path):
    """A CSV table as a list of texts by column."""
    with open(path, newline="") as table:
        return list(csv.DictReader(table))


def rows_without_cost(path):
    """A table without what differs from one making to the next; folders from that of the table on."""
    drop = {*COST, "peak_memory_mb"}
    return [{name: cell.removeprefix(f"{path.parent}/") for name, cell in row.items() if name not in drop}
            for row in rows_of(path)]


class SweepTest(ProgramTest):
    """Studies in FOLDER/studies on decks in FOLDER/decks."""

    def setUp(self):
        super().setUp()
        for name, files in (("decks", "*.in"), ("particles", "*.par")):
            (self.folder / name).mkdir()
            for file in (DECKS.parent / name).glob(files):
                shutil.copy(file, self.folder / name)
        (self.folder / "studies").mkdir()
        self.out = self.folder / "out"

    def study(self, text, name="studies/study.in"):
        return self.write(name, f"a study\n$study\n{text}\n$\n")

    def sweep(self, study, *options, code=0, out=None):
        return self.expect(code, "sweep", study, "--quiet", "--out", out or self.out, *options)

    def table(self, name="table"):
        return rows_of(self.out / f"{name}.csv")
