#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a point takes of memory while a run goes on and writes its fields: the peak of a large run less that of a small
one, and what `plan` foretells of it."""
import os
import pathlib
import re
import subprocess
import unittest

from program import TETHER, ProgramTest, sets

DECK = pathlib.Path(__file__).resolve().parents[1] / "bench" / "disks.in"


class PointMemory(ProgramTest):
    def run_of(self, method, nodes, threads=1):
        """Peak of memory [B], and points."""
        folder = self.folder / f"{method}-{nodes}-{threads}"
        command = [TETHER, DECK, "--quiet", "--out", folder, "--threads", str(threads),
                   *sets(mpm__method=f"'{method}'", in__nx=nodes, in__ny=nodes, in__tmax=2e-4)]
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return 1024 * usage.ru_maxrss, int(re.search(r"^points = (\d+)$", (folder / "summary.txt").read_text(), re.M)[1])

    def check(self, method, most):
        (few_bytes, few), (many_bytes, many) = self.run_of(method, 161), self.run_of(method, 481)
        self.assertLess((many_bytes - few_bytes) / (many - few), most)

    def test_the_thesis_method(self):
        self.check("thesis", 190)

    def test_the_robust_method(self):
        self.check("robust", 230)

    def test_what_waits_to_be_written_by_a_thread_of_its_own_is_bounded(self):
        """Fields of 1e6 points take 140 MB at least."""
        alone, points = self.run_of("thesis", 801)
        self.assertGreater(points, 1_000_000)
        self.assertLess(self.run_of("thesis", 801, 2)[0] - alone, 200e6)

    def test_what_the_parent_holds_does_not_count(self):
        large = b"1" * 400_000_000
        folder = self.folder / "small"
        subprocess.run([TETHER, DECK, "--quiet", "--out", folder, *sets(in__nx=81, in__ny=81, in__tmax=1e-4)], check=True)
        peak = re.search(r"^peak_memory_mb = (\S+)$", (folder / "summary.txt").read_text(), re.M)[1]
        self.assertLess(float(peak), 1e-6 * len(large) / 2)


if __name__ == "__main__":
    unittest.main()
