#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps work in memory that the process has: the kernel does not clear pages for them again and again."""
import os
import subprocess
import unittest

from program import DECKS, TETHER, ProgramTest, sets



class PageFaults(ProgramTest):
    def faults(self, name, tmax, *options):
        """Pages that the kernel had to find for a run that writes no fields, on one thread: of several each takes a
        heap of its own, and which one needs how much of it differs from run to run."""
        command = [TETHER, DECKS / f"{name}.in", "--quiet", "--threads", "1", "--out", self.folder / f"{name}-{tmax}",
                   *sets(in__tmax=tmax, **{"in__iout(39)": 0}), *options]
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return usage.ru_minflt

    def check(self, name, step, few, many, most, *options):
        """At most so many new pages a step; again where it is more, since a kernel short of memory takes some away."""
        for _ in range(3):
            fewer, more = (self.faults(name, steps * step, *options) for steps in (few, many))
            if (more - fewer) / (many - few) < most:
                return
        self.fail(f"{name}: {fewer} pages in {few} steps, {more} in {many}")

    def test_steps_in_space_take_no_new_pages(self):
        self.check("plate-stream-3d", 1 / 60, 4, 8, 1000, *sets(in__nx=33, in__ny=33, coupled__nz=33))

    def test_steps_in_the_plane_take_no_new_pages(self):
        self.check("coupled-bar", 1 / 30, 15, 35, 20, *sets(in__nx=129, in__ny=65))


if __name__ == "__main__":
    unittest.main()
