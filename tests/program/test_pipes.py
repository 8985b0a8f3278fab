#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pipes in the place of files: nobody may write into them, ever, so none is read; and signals end every read."""
import os
import re
import signal
import subprocess
import unittest

from program import DECKS, TETHER, ProgramTest
from waiting import entry, wait_until

TOLD = "cannot be read: it is a pipe, and only regular files are read; write what comes out of it to a file"

MESH = """a mesh of a file
$in
 nx=3, ny=3, xleft=0., xright=1., ybot=0., ytop=1., tmax=1., tstep=1.e-2
$
$mesh
 file='bad.msh'
$
$reg
 nreg=1, densir(1)=1., matr(1,1)=1.,0.3
$
"""


class Pipes(ProgramTest):
    def pipe(self, name):
        os.mkfifo(self.folder / name)
        return self.folder / name

    def refused(self, code, *command):
        """Refused at once, at its own exit code, with the kind of file; nothing is written."""
        before = sorted(self.folder.iterdir())
        result = self.expect(code, *command, folder=self.folder)
        self.assertIn(TOLD, result.stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_a_deck_or_a_study(self):
        pipe = self.pipe("deck.in")
        for words in ([], ["check"], ["plan"], ["sweep"]):
            self.refused(4, *words, pipe)

    def test_a_particle_file(self):
        self.refused(2, DECKS / "pendulum-40.in", "--particles", self.pipe("points.par"))

    def test_a_mesh(self):
        self.pipe("bad.msh")
        self.refused(2, self.write("mesh.in", MESH))

    def test_a_checkpoint(self):
        self.refused(4, DECKS / "sod.in", "--restart", self.pipe("checkpoint-1.nc"))

    def test_the_standard_input(self):
        deck = (DECKS / "stability-side.in").read_bytes()
        result = subprocess.run([TETHER, "check", "/dev/stdin"], input=deck, capture_output=True, check=False)
        self.assertEqual(result.returncode, 4)
        self.assertIn(TOLD, result.stderr.decode())
        with open(DECKS / "sod.in", "rb") as file:  # a file is one by any name
            result = subprocess.run([TETHER, "check", "/dev/stdin"], stdin=file, capture_output=True, check=False)
        self.assertEqual(result.returncode, 0)

    def is_ready(self, process, number, size):
        """Whether it has taken in so many bytes, and heeds the signal."""
        read = re.search(rb"^rchar: (\d+)$", entry(process.pid, "io"), re.M)
        heeded = re.search(rb"^SigCgt:\s+([0-9a-f]+)$", entry(process.pid, "status"), re.M)
        return read and heeded and int(read[1]) > size and int(heeded[1], 16) >> number - 1 & 1

    def test_signals_end_the_reading_of_a_large_deck(self):
        """Seconds of reading, in which a signal comes."""
        items = "".join(f" tiout(13)=0.{k:06d},\n" for k in range(1, 1_000_000))
        deck = self.write("large.in", f"large\n$in\n{items}$\n")
        for number in (signal.SIGTERM, signal.SIGINT):
            for words in ([], ["check"]):
                process = self.start(*words, deck, folder=self.folder)
                wait_until(lambda: self.is_ready(process, number, len(items)), "the program with all of the deck", process)
                self.assertEqual(self.stop(process, number)[1],
                                 f"tether: interrupted by {number.name} while no run was under way\n")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["large.in"])


if __name__ == "__main__":
    unittest.main()
