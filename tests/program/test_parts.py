# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies by parts: --list, --part, --collect, and the scripts that --slurm writes, run by a shell in Slurm's place."""
import os
import signal
import subprocess
import unittest

import mpi
from full_length import FULL
from program import DECKS, TETHER, records
from sweeps import SweepTest, rows_of, rows_without_cost
from waiting import PATIENCE, wait_until

STUDIES = {
    "a grid with runs that fail": ("sweep", "decks='../decks/sod.in', axis(1)='in.nx=21,41,81', axis(2)='fluid.mu=0.,1.e-3'\n"
                                   "set='in.tmax=.02', quantities='error_density','dx','last(energy_total)', order='dx'",
                                   6, ("table",), 0),
    "an ensemble": ("sweep", "mode='ensemble', decks='../decks/sod.in', axis='in.nx=21,41', vary='in.tstep', fraction=.1, runs=3\n"
                    "set='in.tmax=.02', quantities='error_density'", 6, ("table", "outcome"), 0),
    "bisections": ("sweep", "mode='bisect', decks='../decks/stability-side.in', vary='mpm.cfl', low=0.5, high=2.5\n"
                   "axis='in.xright=5.,5.2', criterion='exit_code', tolerance=0.2, set='in.tstep=1.0','in.dtmax=1.0'",
                   2, ("table", "outcome"), 0),
    "a map along a border": ("map", "mode='map', decks='../decks/stability-centre.in', criterion='energy_growth', at_most=100.\n"
                             "set='limits.energy_step=0.,0.', 'limits.energy_growth=0.,0.', 'in.tstep=1.0', 'in.dtmax=1.0'\n"
                             "axis(1)='in.xleft=0.,.2,.4', axis(2)='in.xright=5.,5.2,5.4', linked(2)=1\n"
                             "axis(3)='mpm.cfl=.8,1.6,2.4'", 1, ("map", "table"), 0),
    "a chart": ("chart", "mode='chart', decks='../decks/sod.in', is='error_density', exact='0', set='in.tmax=.05'\n"
                "family(1)='points', cells(1,1)='in.nx=21,41,81'", 3, ("chart",), 0),
}
ODD = "odd 'name' \"$(hostname)\" `date`"


class Parts(SweepTest):
    def commands(self, *words):
        return self.expect(0, *words, "--list").stdout.splitlines()

    def by_a_shell(self, command):
        return subprocess.run(["sh", "-c", command], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=PATIENCE)

    def same(self, alone, parts, tables):
        for name in tables:
            rows = [rows_without_cost(folder / f"{name}.csv") for folder in (alone, parts)]
            self.assertGreater(len(rows[0]), 0)
            self.assertEqual(*rows)

    def test_their_tables_are_those_of_the_whole(self):
        for name, (command, text, count, tables, code) in STUDIES.items():
            with self.subTest(name):
                study = self.study(text, f"studies/{len(name)}.in")
                alone, parts = self.folder / f"{name} alone", self.folder / f"{name} {ODD}"
                self.expect(code, command, study, "--quiet", "--out", alone)
                words = (command, study, "--out", parts)
                lines = self.commands(*words)
                self.assertEqual(len(lines), count)
                for line in reversed(lines):
                    done = self.by_a_shell(line)
                    self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
                self.assertEqual(self.commands(*words), [])
                self.expect(code, *words, "--collect", "--quiet")
                self.same(alone, parts, tables)

    def test_what_is_not_finished_is_said_and_left_out(self):
        study = self.study(STUDIES["a grid with runs that fail"][1])
        words = ("sweep", study, "--out", self.out)
        self.assertIn("parts that are not finished: 6", self.expect(5, *words, "--collect", "--quiet").stderr)
        self.expect(0, *words, "--part", "2,6")
        self.assertFalse((self.out / "lock").exists())
        self.assertIn("parts that are not finished: 4", self.expect(5, *words, "--collect", "--quiet").stderr)
        self.assertEqual([row["run"] for row in self.table()], ["2", "6"])
        self.sweep(study)
        self.assertEqual([row["reused"] for row in self.table()], ["0", "1", "0", "0", "0", "1"])

    def test_charts_and_reproductions_that_are_not_finished(self):
        chart = self.study(STUDIES["a chart"][1])
        self.assertIn("run 3 is not finished", self.expect(5, "chart", chart, "--out", self.out, "--collect").stdout)
        report = (self.out / "chart.txt").read_text()
        self.assertIn("NOT FINISHED: what follows is of 0 runs of 3", report)
        said = self.expect(5, "reproduce", "sod", "--decks", self.folder / "decks", "--out", self.out / "r", "--collect")
        self.assertIn("0 differ", said.stdout)

    def test_a_part_whose_run_is_killed_says_so(self):
        study = self.study("decks='../decks/sod.in', quantities='dx', set='in.tmax=1000.','in.nx=801','in.tstep=1.e-6'")
        for more in (["--part", "1"], ["--quiet"]):
            process = self.start("sweep", study, "--out", self.out, *more)
            os.kill(wait_until(lambda: mpi.served_by(process.pid), "the run's process", process), signal.SIGKILL)
            said = process.communicate(timeout=PATIENCE)[1]
            self.assertEqual(process.returncode, 4, said)
            self.assertIn("runs that were killed", said)

    def test_many_may_collect_at_once(self):
        study = self.study(STUDIES["a grid with runs that fail"][1])
        self.sweep(study)
        before = rows_without_cost(self.out / "table.csv")
        words = [TETHER, "sweep", str(study), "--out", str(self.out), "--collect", "--quiet"]
        for _ in range(5 if FULL else 2):
            (self.out / "runs/index.txt").unlink(missing_ok=True)
            all_at_once = [subprocess.Popen(words, stdin=subprocess.DEVNULL) for _ in range(8)]
            self.assertEqual([process.wait(timeout=PATIENCE) for process in all_at_once], [0] * 8)
            self.assertEqual(rows_without_cost(self.out / "table.csv"), before)

    def test_parts_share_a_folder_and_a_whole_sweep_does_not(self):
        study = self.study("decks='../decks/sod.in', axis='fluid.gm1=.4,.41', quantities='dx'\n"
                           "set='in.tmax=1000.','in.nx=801','in.tstep=1.e-6'")
        parts = [self.start("sweep", study, "--out", self.out, "--part", part) for part in (1, 2)]
        wait_until(lambda: len(list(self.out.glob("runs/*/*/history.nc"))) == 2, "the history of either part", *parts)
        refused = self.expect(4, "sweep", study, "--out", self.out)
        self.assertIn("the folder is in use by process", refused.stderr)
        self.expect(5, "sweep", study, "--out", self.out, "--collect", "--quiet")
        for part in parts:
            self.stop(part)
        self.assertEqual(len(list(self.out.glob("runs/*/*/checkpoint-*.nc"))), 2)
        self.assertFalse((self.out / "lock").exists())

    def test_what_is_no_part(self):
        study = self.study(STUDIES["a chart"][1])
        said = self.expect(2, "chart", study, "--out", self.out, "--part", "2,4").stderr
        self.assertIn("there is no part 4: this command has 3", said)
        for text in ("0", "x", "2-1", "", "1-99999999999"):
            self.assertIn("is no list of numbers", self.expect(2, "chart", study, "--out", self.out, "--part", text).stderr)
        self.expect(2, "chart", study, study, "--out", self.out, "--list")
        self.expect(2, "chart", study, "--out", self.out, "--list", "--collect")
        self.assertFalse(self.out.exists())

    def test_names_that_begin_with_a_hyphen(self):
        study = STUDIES["a chart"][1].replace("../decks", "decks")
        self.write("-a.in", f"a chart\n$study\n{study}\n$\n")
        words = ["chart", "--out", "out", "--", "-a.in"]
        def say(*more):
            return subprocess.run([TETHER, words[0], *more, *words[1:]], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE)
        listed = say("--list")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        subprocess.run(["sh", "-e"], cwd=self.folder, input=listed.stdout, text=True, check=True, timeout=PATIENCE)
        self.assertEqual(say("--list").stdout, "")
        self.assertEqual(say("--collect", "--quiet").returncode, 0)

    def test_a_study_that_has_changed(self):
        text = STUDIES["a chart"][1]
        study = self.study(text)
        line = self.expect(0, "chart", study, "--out", self.out, "--list").stdout.splitlines()[0]
        self.study(text + "\n")
        result = subprocess.run(["sh", "-c", line], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 2)
        self.assertIn("the study has changed since its parts were listed", result.stderr)
        self.assertFalse((self.out / "runs").exists())

    def test_a_name_with_a_line_end_is_not_listed(self):
        study = self.study(STUDIES["a chart"][1])
        said = self.expect(2, "chart", study, "--out", self.folder / "a\nb", "--list").stderr
        self.assertIn("has a line end", said)


class Scripts(SweepTest):
    def by_bash(self, folder, **variables):
        environment = os.environ | {"SLURM_JOB_ID": "7", "SLURM_ARRAY_JOB_ID": "7", "SLURM_ARRAY_TASK_ID": "1"} | variables
        return subprocess.run(["bash", str(folder / "slurm/job.sh")], cwd="/", env=environment, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=PATIENCE)

    def test_do_all_parts(self):
        study = self.study(STUDIES["a grid with runs that fail"][1])
        self.sweep(study, out=self.folder / "alone")
        out = self.folder / f"{ODD}\nend"
        self.assertIn("parts: 6, jobs: 1", self.expect(0, "sweep", study, "--out", out, "--slurm", "--dry-run").stdout)
        self.assertEqual(self.by_bash(out).returncode, 0)
        self.assertIn("exit code 0", (out / "slurm/1.log").read_text())
        self.expect(0, "sweep", study, "--out", out, "--collect", "--quiet")
        self.assertEqual(rows_without_cost(out / "table.csv"), rows_without_cost(self.folder / "alone/table.csv"))

    def test_run_a_deck(self):
        deck = DECKS / "sod.in"
        self.expect(0, deck, "--set", "in.tmax=.02", "--out", self.out, "--slurm", "--dry-run")
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["slurm"])
        self.assertEqual(self.by_bash(self.out).returncode, 0)
        self.assertTrue((self.out / "summary.txt").exists())

    def test_a_folder_that_is_not_seen(self):
        study = self.study(STUDIES["a chart"][1])
        self.expect(0, "chart", study, "--out", self.out, "--slurm", "--dry-run")
        script = self.out / "slurm/job.sh"
        moved = self.folder / "slurm/job.sh"
        moved.parent.mkdir()
        script.rename(moved)
        script.parent.rmdir()
        result = self.by_bash(self.folder, TMPDIR=str(self.folder))
        self.assertEqual(result.returncode, 4)
        (left,) = self.folder.glob("*.tether-7")
        self.assertIn("does not see the folder of the results", left.read_text())

    def test_no_slurm(self):
        study = self.study(STUDIES["a chart"][1])
        bare = self.folder / "bare"
        bare.mkdir()
        for words in (("chart", study), (DECKS / "sod.in",)):
            result = subprocess.run([TETHER, *map(str, words), "--out", str(self.out), "--slurm"], env={"PATH": str(bare)},
                                    capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("there is no Slurm on this machine", result.stderr)
        self.assertFalse(self.out.exists())

    def test_a_job_that_slurm_still_has(self):
        """Scripts stand for Slurm's programs: the job is there as long as its file is."""
        study = self.study(STUDIES["a chart"][1])
        tools, queued = self.folder / "tools", self.folder / "queued"
        tools.mkdir()
        for name, text in (("sbatch", f"echo Submitted batch job 71 | tee '{queued}'"),
                           ("squeue", f"[ \"${{!#}}\" = --jobs=71 ] && [ -e '{queued}' ] && echo RUNNING")):
            (tools / name).write_text(f"#!/bin/bash\n{text}\n")
            (tools / name).chmod(0o755)
        environment = os.environ | {"PATH": f"{tools}:{os.environ['PATH']}"}
        for words in (("chart", study), (DECKS / "sod.in",)):
            out = self.folder / str(words[0]).rsplit("/", 1)[-1]
            words = [TETHER, *map(str, words), "--out", str(out), "--slurm"]
            submit = lambda: subprocess.run(words, env=environment, capture_output=True, text=True, timeout=PATIENCE)
            self.assertEqual(submit().returncode, 0)
            again = submit()
            self.assertEqual(again.returncode, 2, again.stderr)
            self.assertIn("Slurm still has job 71", again.stderr)
            queued.unlink()
            self.assertEqual(submit().returncode, 0)
            queued.unlink()

    def test_a_deck_that_goes_on(self):
        """--continue: from the start where there is nothing to go on from."""
        words = (DECKS / "spring-mass.in", "--set", "in.tmax=1.", "--out", self.out, "--continue", "--quiet")
        process = self.start(*words)
        wait_until(lambda: records(self.out) > 2, "a third record", process)
        self.stop(process)
        self.expect(0, *words)
        self.assertIn("goes on from", (self.out / "messages.txt").read_text())
        alone = self.run_ok(DECKS / "spring-mass.in", "--set", "in.tmax=1.", out="alone")
        self.assertEqual((self.out / "history.txt").read_bytes(), (alone / "history.txt").read_bytes())


if __name__ == "__main__":
    unittest.main()
