#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies and runs by a real Slurm of this machine: tests/slurm/test_slurm.py, as root, with TETHER naming the program.
Needs Debian's slurm-wlm and munge."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))

from cluster import Cluster
from program import DECKS, TETHER
from sweeps import SweepTest, rows_of
from waiting import PATIENCE, entry

ODD = "odd 'name'; touch \"$(hostname)\"\nend"  # of a folder; a shell that reads it does something


def processes_of(folder):
    """Processes whose command line names the folder."""
    pids = [int(folder.name) for folder in pathlib.Path("/proc").glob("[0-9]*")]
    return [pid for pid in pids if str(folder).encode() in entry(pid, "cmdline")]


def without_cost(path):
    drop = {"cpu_seconds", "wall_seconds", "reused"}
    return [{name: cell for name, cell in row.items() if name not in drop} for row in rows_of(path)]


class Slurm(SweepTest):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.cluster = Cluster(cls.place.name)

    @classmethod
    def tearDownClass(cls):
        cls.cluster.end()
        cls.place.cleanup()

    def tether(self, *words, code=0, **environment):
        result = subprocess.run([TETHER, *map(str, words)], env=self.cluster.environment | environment, cwd=self.folder,
                                capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def logs(self, folder):
        return "\n".join(log.read_text() for log in sorted((folder / "slurm").glob("*.log")))

    def test_a_sweep_with_an_odd_name(self):
        """Two jobs: the parts are made long enough by plans of much longer runs than they are."""
        study = self.study("decks='../decks/sod.in', axis(1)='in.nx=41,81,161', axis(2)='fluid.mu=0.,1.e-3'\n"
                           "set='in.tmax=.1', quantities='error_density','dx'")
        self.sweep(study, out=self.folder / "alone")
        out = self.folder / ODD / "out"
        words = ("sweep", study, "--out", out)
        said = self.tether(*words, "--slurm").stdout
        self.assertIn("Submitted batch job", said)
        self.cluster.wait_for_no_job()
        self.tether(*words, "--quiet", "--collect")
        self.assertEqual(without_cost(out / "table.csv"), without_cost(self.folder / "alone/table.csv"))
        self.assertIn("exit code 0", self.logs(out))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         sorted(["alone", "decks", "particles", "studies", ODD]))
        self.assertIn("all is finished", self.tether(*words, "--slurm").stdout)

    def test_charts_maps_and_published_problems(self):
        chart = self.study("mode='chart', decks='../decks/sod.in', is='error_density', exact='0', set='in.tmax=.05'\n"
                           "family(1)='points', cells(1,1)='in.nx=21,41,81'", "studies/chart.in")
        border = self.study("mode='map', decks='../decks/stability-centre.in', criterion='energy_growth', at_most=100.\n"
                            "set='limits.energy_step=0.,0.', 'limits.energy_growth=0.,0.', 'in.tstep=1.0', 'in.dtmax=1.0'\n"
                            "axis(1)='in.xleft=0.,.2,.4', axis(2)='in.xright=5.,5.2,5.4', linked(2)=1\n"
                            "axis(3)='mpm.cfl=.8,1.6,2.4'", "studies/map.in")
        commands = {"chart": (("chart", chart), "chart.csv"), "map": (("map", border), "map.csv"),
                    "published": (("reproduce", "two-bar", "--decks", DECKS), None)}
        for name, (words, table) in commands.items():
            self.tether(*words, "--out", self.folder / f"{name}-alone", "--quiet")
            self.tether(*words, "--out", self.folder / name, "--slurm")
        self.cluster.wait_for_no_job()
        for name, (words, table) in commands.items():
            self.tether(*words, "--out", self.folder / name, "--quiet", "--collect")
            if table:
                tables = [re.sub(f"{self.folder}/{name}(-alone)?/", "", str(without_cost(folder / table)))
                          for folder in (self.folder / name, self.folder / f"{name}-alone")]
                tables = [re.sub(r"'peak_memory_mb': '[^']*'", "", text) for text in tables]
                self.assertEqual(*tables)

    def test_a_run_that_meets_its_time_limit(self):
        """A limit of a minute for a run of two. Slurm sends its signals up to a minute early: the run goes on often."""
        deck = self.folder / "decks/sod.in"
        sets = ("--set", "in.tmax=.1", "--set", "in.nx=1001", "--set", "in.tstep=2.4e-7")
        self.tether(deck, *sets, "--out", self.folder / "alone", "--quiet", "--threads", "1")
        out = self.folder / "run"
        self.tether(deck, *sets, "--out", out, "--slurm", SBATCH_TIMELIMIT="1", SBATCH_SIGNAL="B:TERM@5")
        self.cluster.wait_for_no_job(2 * PATIENCE)
        log = self.logs(out)
        self.assertIn("exit code 143", log)
        self.assertIn("exit code 0", log)
        self.assertIn("goes on from", (out / "messages.txt").read_text())
        self.assertEqual((out / "history.txt").read_bytes(), (self.folder / "alone/history.txt").read_bytes())

    def test_a_job_is_killed_and_the_same_command_again(self):
        study = self.study("decks='../decks/sod.in', axis='fluid.gm1=.40,.41,.42,.43,.44,.45'\n"
                           "set='in.tmax=.1','in.nx=801','in.tstep=5.e-6', quantities='error_density'")
        self.sweep(study, out=self.folder / "alone")
        words = ("sweep", study, "--out", self.out)
        self.tether(*words, "--slurm")
        self.cluster.wait_for(lambda: len(list(self.out.glob("runs/*/*/run.txt"))) >= 2, "the second run's record")
        self.assertIn("Slurm still has job", self.tether(*words, "--slurm", code=2).stderr)
        for program in processes_of(self.out):
            os.kill(program, signal.SIGKILL)
        self.cluster.wait_for_no_job()
        before = {path: path.stat().st_mtime_ns for path in self.out.glob("runs/*/*/run.txt")}
        self.assertIn("not finished", self.tether(*words, "--collect", "--quiet", code=5).stderr)
        self.assertEqual(len(self.table()), len(before))
        self.tether(*words, "--slurm")
        self.cluster.wait_for_no_job()
        self.tether(*words, "--collect", "--quiet")
        self.assertEqual(without_cost(self.out / "table.csv"), without_cost(self.folder / "alone/table.csv"))
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)

    def test_a_job_that_is_cancelled_stays_so(self):
        deck = self.folder / "decks/sod.in"
        sets = ("--set", "in.tmax=.1", "--set", "in.nx=1001", "--set", "in.tstep=1.e-6")
        out = self.folder / "run"
        job = re.search(r"Submitted batch job (\d+)", self.tether(deck, *sets, "--out", out, "--slurm").stdout)[1]
        self.cluster.wait_for(lambda: list(out.glob("history.nc")), "the run's history")
        self.cluster.say("scancel", job)
        self.cluster.wait_for_no_job()
        self.assertEqual(re.findall(r"exit code (\d+)", self.logs(out)), ["143"])
        self.assertIn("JobState=CANCELLED", self.cluster.say("scontrol", "show", "job", job))
        self.tether(deck, *sets, "--out", out, "--continue", "--quiet")
        self.assertIn("goes on from", (out / "messages.txt").read_text())

    def test_a_machine_that_does_not_see_the_folder(self):
        study = self.study("decks='../decks/sod.in', quantities='dx', set='in.tmax=.01'")
        self.tether("sweep", study, "--out", self.out, "--slurm", "--dry-run")
        script = self.out / "slurm/job.sh"
        elsewhere = self.write("job.sh", script.read_text())
        script.unlink()
        script.parent.rmdir()
        job = re.search(r"\d+", self.cluster.say("sbatch", str(elsewhere)))[0]
        self.cluster.wait_for_no_job()
        shown = self.cluster.say("scontrol", "show", "job", job)
        self.assertIn("does not see the folder of the results", shown)
        self.assertIn("ExitCode=4:0", shown)


if __name__ == "__main__":
    unittest.main()
