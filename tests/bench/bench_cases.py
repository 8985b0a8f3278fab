# SPDX-License-Identifier: GPL-3.0-or-later
"""What bench_points.py runs: decks with the plain loop that does the same, and decks that are run as a whole."""
import pathlib
from typing import NamedTuple

HERE = pathlib.Path(__file__).resolve().parent
DECKS = HERE.parents[1] / "decks"
ROBUST, THESIS = "mpm.method='robust'", "mpm.method='thesis'"
SETS = ("avx512", "avx2", "sse2", "one")  # of instructions, TETHER_TARGET


class Case(NamedTuple):
    name: str
    loop: tuple  # the plain loop and its words; without it the program with rows in order takes its place
    deck: str  # of this folder
    settings: tuple
    rows: str = ""  # of the particle file, by bench_rows.KINDS

    def plain_words(self):
        """cells, points of a cell's side, jitter"""
        return (*self.loop[1:], "0") if len(self.loop) == 4 else self.loop[1:]


def robust(name, loop, deck, *settings, **more):
    return Case(f"robust {name}", loop, deck, (ROBUST, *settings), **more)


def thesis(name, loop, deck, *settings, **more):
    return Case(f"thesis {name}", loop, deck, (THESIS, *settings), **more)


ELASTIC, GAS, LEDGER = ("plain_robust", "elastic"), ("plain_robust", "gas"), ("plain_robust", "gas-ledger")
OF_THESIS = ("plain_thesis", "elastic")
NINE = ("in.nx=169", "in.ny=169", "reg.nprg(1)=9", "reg.nprg(2)=9")  # points a cell, of disks.in

CASES = [
    robust("elastic 1e5", (*ELASTIC, "158", "2"), "disks"),
    robust("elastic 1e5, 9 a cell", (*ELASTIC, "105", "3"), "disks", *NINE),
    robust("elastic 1e6", (*ELASTIC, "500", "2"), "disks", "in.nx=799", "in.ny=799", "in.tmax=0.004"),
    robust("elastic 1e4", (*ELASTIC, "50", "2"), "disks", "in.nx=81", "in.ny=81", "in.tmax=0.1"),
    robust("elastic irregular 1e5", (*ELASTIC, "160", "2", "0.9"), "rows", rows="irregular"),
    robust("elastic in random order 1e5", (), "rows", rows="shuffled"),
    robust("gas 1e5", (*GAS, "158", "2"), "gas_block"),
    robust("gas 1e5, 9 a cell", (*GAS, "105", "3"), "gas_block", "in.nx=107", "in.ny=107", "reg.nprg(1)=9",
           "reg.nprg(2)=9"),
    robust("gas 1e6", (*GAS, "500", "2"), "gas_block", "in.nx=501", "in.ny=501", "in.tmax=0.001"),
    robust("gas with ledger 1e5", (*LEDGER, "158", "2"), "gas_block", "mpm.ledger=.true."),
    robust("elastic about an axis 1e5", ("plain_robust", "elastic-axis", "158", "2"), "axis_solid"),
    robust("gas about an axis 1e5", ("plain_robust", "gas-axis", "158", "2"), "axis_gas"),
    robust("contact 1e5", ("plain_contact", "elastic", "252", "2"), "contact"),
    robust("membrane with gas 1e5", ("plain_membrane", "gas", "199", "2"), "membrane_gas"),
    thesis("elastic 1e5", (*OF_THESIS, "158", "2"), "disks"),
    thesis("elastic 1e5, 9 a cell", (*OF_THESIS, "105", "3"), "disks", *NINE),
    thesis("elastic 1e6", (*OF_THESIS, "500", "2"), "disks", "in.nx=799", "in.ny=799", "in.tmax=0.004"),
    thesis("elastic irregular 1e5", (*OF_THESIS, "160", "2", "0.9"), "rows", rows="irregular"),
    thesis("elastic in random order 1e5", (), "rows", rows="shuffled"),
]

# disks.in and the plain block by size: points, cells of the plain block, nodes along a side, end of the run [time].
SIZES = ((1e4, "50", 81, 0.1), (1e5, "158", 253, 0.02), (1e6, "500", 799, 0.004), (1e7, "1581", 2525, 2.5e-4))
GROWTH = [make(f"elastic {points:.0e}".replace("e+0", "e"), (*loop, cells, "2"), "disks", f"in.nx={nodes}",
               f"in.ny={nodes}", f"in.tmax={end}")
          for make, loop in ((robust, ELASTIC), (thesis, OF_THESIS)) for points, cells, nodes, end in SIZES]

BY_SETS = [case for case in CASES if case.name in ("robust elastic 1e5", "robust gas 1e5", "thesis elastic 1e5")]


class Deck(NamedTuple):
    name: str
    settings: tuple = ()


WHOLE = [Deck("membrane-expansion-4", (ROBUST,)), Deck("cyl-500", (ROBUST,)), Deck("ball-net"), Deck("sod"),
         Deck("spring-mass"), Deck("pendulum-40")]


def chosen(cases, words):
    """Those whose names hold all words."""
    return [case for case in cases if all(word in case.name for word in words)]
