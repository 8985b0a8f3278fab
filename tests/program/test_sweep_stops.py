# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps that are killed or interrupted in the middle and started again: nothing is lost, nothing is repeated."""
import os
import pathlib
import resource
import signal
import unittest

from full_length import FULL
from sweeps import SweepTest
from waiting import entry, wait_until


def processes_of(folder):
    """Processes whose command line names the folder."""
    pids = [int(path.name) for path in pathlib.Path("/proc").glob("[0-9]*")]
    return [pid for pid in pids if str(folder).encode() in entry(pid, "cmdline")]  # which is empty of a zombie


class Stops(SweepTest):
    """24 runs of some hundredths of a second, at full length 40, stopped in the middle."""

    COUNT = 40 if FULL else 24

    def setUp(self):
        super().setUp()
        values = ",".join(f"{-250 - k}.0" for k in range(self.COUNT))
        self.many = self.study(f"decks='../decks/spring-mass.in'\naxis='in.gravc={values}'\nset='in.tmax=0.03'\n"
                               "quantities='steps','energy_drift'")

    def test_a_full_disk_decides_no_bisection_and_is_tried_again(self):
        study = self.study("mode='bisect', decks='../decks/stability-side.in', vary='mpm.cfl', low=0.5, high=2.5\n"
                           "criterion='exit_code', tolerance=0.5, set='in.tstep=1.0','in.dtmax=1.0'", "studies/disk.in")
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (12000, 12000))
        result = self.expect(4, "sweep", study, "--quiet", "--out", self.out, before=limit)
        self.assertIn("a run ended neither well nor by diverging", result.stderr)
        self.assertIn("the same command tries them again", result.stderr)
        self.sweep(study)
        self.assertEqual([row["verdict"] for row in self.table("outcome")], ["found"])

    def test_a_caller_that_ignores_its_children_does_no_harm(self):
        study = self.study("decks='../decks/stability-side.in', quantities='steps'", "studies/one.in")
        ignore = lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN)
        self.expect(0, "sweep", study, "--quiet", "--out", self.out, before=ignore)
        self.assertEqual(len(self.table()), 1)

    def finished(self):
        """What identifies the record of each finished run."""
        return {path.parent.name: (path.stat().st_ino, path.stat().st_mtime_ns)
                for path in self.out.glob("runs/*/*/run.txt")}

    def start_many(self):
        return self.start("sweep", self.many, "--quiet", "--jobs", "2", "--out", self.out)

    def stop_in_the_middle(self, how, at_least=6):
        """Starts the sweep, and ends it by the signal when some runs are finished."""
        process = self.start_many()
        wait_until(lambda: len(self.finished()) >= at_least, f"the record of run {at_least}", process)
        self.stop(process, how)

    def test_a_run_that_is_held_hears_of_the_end(self):
        """SIGSTOP holds a run, which is long; SIGTERM to the sweep still ends both."""
        long = self.study("decks='../decks/spring-mass.in', set='in.tmax=1000.', quantities='steps'", "studies/long.in")
        process = self.start("sweep", long, "--quiet", "--out", self.out)
        runs = wait_until(lambda: [pid for pid in processes_of(self.out) if pid != process.pid], "a run's process", process)
        os.kill(runs[0], signal.SIGSTOP)
        self.stop(process)
        self.wait_for_no_process()

    def wait_for_no_process(self):
        wait_until(lambda: not processes_of(self.folder), "the end of every process")

    def go_on(self, before):
        """The same command again: every run is there, those that were finished are the same records."""
        self.sweep(self.many, "--jobs", "2")
        after = self.finished()
        self.assertEqual({name: after[name] for name in before}, before)
        rows = self.table()
        self.assertEqual((len(after), len(rows)), (self.COUNT, self.COUNT))
        self.assertEqual({row["exit_code"] for row in rows}, {"0"})
        self.assertEqual({pathlib.Path(row["folder"]).name for row in rows if row["reused"] == "1"}, set(before))

    def test_killed(self):
        self.stop_in_the_middle(signal.SIGKILL)
        self.wait_for_no_process()
        before = self.finished()
        print(f"killed with {len(before)} of {self.COUNT} runs finished", flush=True)
        self.assertTrue(6 <= len(before) < self.COUNT)
        self.go_on(before)

    def test_interrupted(self):
        for number, how in enumerate((signal.SIGTERM, signal.SIGINT)):
            self.stop_in_the_middle(how, at_least=6 + 6 * number)
            self.assertEqual(processes_of(self.folder), [])
            before = self.finished()
            print(f"interrupted with {len(before)} of {self.COUNT} runs finished", flush=True)
            self.assertTrue(6 + 6 * number <= len(before) < self.COUNT)
            self.assertEqual({pathlib.Path(row["folder"]).name for row in self.table()}, set(before))
        self.go_on(before)

    def test_a_long_run_goes_on_from_its_checkpoint(self):
        self.many = self.study("decks='../decks/spring-mass.in', set='in.tmax=1.0', quantities='steps'")
        process = self.start_many()
        wait_until(lambda: list(self.out.glob("runs/*/*/history.nc")), "the run's history", process)
        self.stop(process)
        self.assertEqual((self.finished(), self.table()), ({}, []))
        self.sweep(self.many)
        folder = self.out / self.table()[0]["folder"]
        self.assertIn("goes on from", (folder / "messages.txt").read_text())
        alone = self.run_ok(self.folder / "decks/spring-mass.in", "--set", "in.tmax=1.0", out="alone")
        self.assertEqual((folder / "history.txt").read_bytes(), (alone / "history.txt").read_bytes())

    def test_nothing_is_left_to_do(self):
        self.sweep(self.many, "--jobs", str(os.cpu_count()))
        before = self.finished()
        self.go_on(before)
        self.assertTrue(all(row["reused"] == "1" for row in self.table()))


if __name__ == "__main__":
    unittest.main()
