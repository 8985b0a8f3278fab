#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder is one run's: another that wants it is refused, and a killed one bars nobody."""
import os
import subprocess
import unittest

from program import DECKS, TETHER, ProgramTest, netcdf, sets, summary
from waiting import PATIENCE, wait_until

# A run that nobody waits for the end of.
LONG = (DECKS / "sod.in", *sets(in__nx=201, in__tstep=1e-6, in__tmax=1000), "--set", "in.iout(33)=1", "--set",
        "in.tiout(33)=1e-4", "--set", "in.iout(41)=1", "--set", "in.tiout(41)=1e-3")
SHORT = DECKS / "stability-side.in"


class FolderInUse(ProgramTest):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"

    def start_long(self):
        """The long run, once it has written a checkpoint."""
        process = self.start(*LONG, "--quiet", "--out", self.out)
        wait_until((self.out / "checkpoint-1.nc").exists, "the first checkpoint", process)
        return process

    def state(self):
        """The files of the run that owns the folder, which it opened once."""
        return {path.name: path.stat().st_ino for path in self.out.iterdir()
                if not path.name.startswith("checkpoint-") and ".pvd" not in path.name and path.is_file()}

    def test_the_second_run_is_refused_and_told_whose_the_folder_is(self):
        process = self.start_long()
        before = self.state()
        for command in ([SHORT, "--out", self.out], ["sweep", DECKS / "studies/stability.in", "--out", self.out]):
            result = self.expect(4, *command)
            self.assertIn(f"{self.out}: the folder is in use by process {process.pid} on ", result.stderr)
            self.assertRegex(result.stderr, r"sod\.in since \d{4}-\d\d-\d\d \d\d:\d\d:\d\d; wait for its end, or")
        self.assertEqual(self.state(), before)
        self.assertIsNone(process.poll())
        self.assertIn("sod", (self.out / "deck.effective").read_text().lower())

    def test_what_writes_nothing_is_not_refused(self):
        self.start_long()
        for command in (["check", SHORT], ["plan", SHORT], [SHORT, "--dry-run", "--out", self.out]):
            self.expect(0, *command, folder=self.folder)
        self.run_ok(SHORT, out="other")

    def test_a_killed_run_bars_nobody(self):
        process = self.start_long()
        process.kill()
        os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)  # it has ended, and nobody has taken note yet
        newest = sorted(self.out.glob("checkpoint-*.nc"))[-1]
        end = netcdf(newest)["state_time"][0] + 1e-3
        self.run_ok(*LONG, *sets(in__tmax=end), "--restart", newest)
        self.assertAlmostEqual(float(summary(self.out)["time_end"]), end, delta=1e-9)
        self.assertEqual([path.name for path in self.out.glob("lock*")], [])
        self.run_ok(SHORT)

    def test_of_many_at_once_one_runs(self):
        """Six runs start at the same moment: those that end well did so one after the other, and left one run's files."""
        command = [TETHER, str(SHORT), "--quiet", "--out", str(self.out)]
        several = [subprocess.Popen([*command, "--set", f"in.tmax=0.0{k}"], stderr=subprocess.PIPE, encoding="utf-8")
                   for k in range(1, 7)]
        ends = [(process.communicate(timeout=PATIENCE)[1], process.returncode) for process in several]
        for stderr, code in ends:
            self.assertIn(code, (0, 4), stderr)
            self.assertEqual("in use by" in stderr, code == 4)
        end = summary(self.out)["time_end"]
        self.assertIn(f"tmax = {end}\n", (self.out / "deck.effective").read_text())
        self.assertTrue((self.out / "history.txt").read_text().splitlines()[-1].startswith(f"{end} "))


class EarlierResults(ProgramTest):
    def test_a_second_run_into_a_folder_says_what_it_replaces(self):
        """Without a word it once took away the first one's results, and left another deck's checkpoints."""
        sparse = sets(**{"in__iout(41)": 1, "in__tiout(41)": 0.1})
        first, second = (DECKS / "spring-mass.in", *sparse), (DECKS / "stability-side.in", *sets(in__tmax=0.01))
        folder = self.folder / "out"
        told = [self.expect(0, *first, "--out", folder).stderr for _ in range(2)]
        self.assertNotIn("earlier run", told[0])
        self.assertIn(f"remark: the results of an earlier run in {folder} are replaced: a run of this deck, which came to its "
                      "end\n", told[1])
        there = sorted(folder.glob("checkpoint-*.nc"))
        self.assertEqual(len(there), 2)
        (folder / "summary.txt").unlink()
        text = self.expect(0, *second, "--out", folder).stderr
        self.assertIn("a run of another deck, or with other values, which did not come to its end; checkpoints of another "
                      "deck are removed", text)
        self.assertEqual(sorted(folder.glob("checkpoint-*.nc")), [])
        for path in there:
            self.assertIn(path.name, text)
        self.assertIn("are replaced", (folder / "messages.txt").read_text())
        self.assertEqual(self.expect(0, *first, "--out", folder, "--quiet").stderr, "")


if __name__ == "__main__":
    unittest.main()
