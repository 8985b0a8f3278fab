# SPDX-License-Identifier: GPL-3.0-or-later
"""Small runs: of decks, made once for all tests of a class, and of points that tests write themselves."""
import os
import tempfile
import unittest
from pathlib import Path

import netCDF4
import numpy
from matplotlib import pyplot

import style
import tether_results

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["TETHER"]

TIMES = numpy.linspace(0, 1, 21)
PLACES = numpy.linspace(0, 1, 50)


class DeckTest(unittest.TestCase):
    """Has a folder for its class, and runs of decks in it."""

    @classmethod
    def setUpClass(cls):
        style.use()
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.addClassCleanup(pyplot.close, "all")
        cls.folder, cls.done = Path(scratch.name), {}

    @classmethod
    def run_of(cls, deck, values=None):
        """A run of a deck, made once."""
        key = f"{deck} {values}"
        if key not in cls.done:
            out = cls.folder / f"run-{len(cls.done)}"
            cls.done[key] = tether_results.run(ROOT / "decks" / f"{deck}.in", values, out=out, program=PROGRAM)
        return cls.done[key]


class FolderTest(unittest.TestCase):
    """Has a folder for each test, which is to be that of a run."""

    @classmethod
    def setUpClass(cls):
        style.use()
        cls.addClassCleanup(pyplot.close, "all")

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"
        self.folder.mkdir()

    def pictures(self, folder=None):
        return sorted(path.name for path in (folder or self.folder).glob("*.png"))


def add(dataset, name, dimensions, values, units):
    variable = dataset.createVariable(name, "f8", dimensions)
    variable.units = units
    variable[:] = values


def write_history(folder, bodies=True):
    """A history of material points, which energy_transfer says that it is."""
    with netCDF4.Dataset(folder / "history.nc", "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.title = "A gas of two lines.\nMore of it."
        data.createDimension("time", None)
        add(data, "time", ("time",), TIMES, "s")
        add(data, "energy_kinetic", ("time",), TIMES, "J")
        add(data, "energy_total", ("time",), 1 + TIMES, "J")
        add(data, "energy_transfer", ("time",), 0 * TIMES, "J")
        if not bodies:
            return
        for kind, number, named in (("body", 1, "region"), ("point", 2, "point")):
            data.createDimension(kind, number)
            for part, unit in (("x", "m"), ("y", "m"), ("vx", "m s-1"), ("vy", "m s-1")):
                add(data, f"{kind}_{part}", ("time", kind), numpy.outer(TIMES, 1 + numpy.arange(number)), unit)
            data.createDimension(f"{kind}_letters", 8)
            names = numpy.array([list(f"{named} {k + 1}".ljust(8, "\0")) for k in range(number)], dtype="S1")
            data.createVariable(f"{kind}_name", "S1", (kind, f"{kind}_letters"))[:] = names


def write_particles(folder, times=(0, 0.5, 1), gas=True, **changed):
    with netCDF4.Dataset(folder / "particles.nc", "w") as data:
        data.createDimension("time", None)
        data.createDimension("point", len(PLACES))
        add(data, "time", ("time",), times, "s")
        fields = {"x": PLACES, "y": PLACES**2, "body": 1 + 0 * PLACES, "mass": 1 + 0 * PLACES, "volume": 1e-3 + 0 * PLACES}
        if gas:
            fields |= {"density": PLACES, "pressure": 2 * PLACES, "specific_energy": 3 * PLACES, "vx": 4 * PLACES, "vy": 0 * PLACES}
        for name, values in (fields | changed).items():
            add(data, name, ("time", "point"), numpy.tile(values, (len(times), 1)), "1")


def write_deck(folder, law):
    (folder / "deck.effective").write_text(f"A deck\n$reg\nipath(4,1) = {law}\n$\n")
