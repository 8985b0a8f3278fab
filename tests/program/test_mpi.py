# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies under mpirun: the same tables as without, whatever dies in the middle."""
import os
import pathlib
import shutil
import signal
import unittest

import mpi
from full_length import FULL
from program import DECKS, ROOT, TETHER
from sweeps import SweepTest, rows_of, rows_without_cost
from waiting import PATIENCE, wait_until


class Equal(SweepTest):
    """Each command once alone and once by three programs."""

    def both(self, *words, code=0):
        """Folders of both."""
        out = [self.folder / "alone", self.folder / "by-three"]
        self.expect(code, *words, "--quiet", "--out", out[0])
        result = mpi.run(*words, "--quiet", "--out", out[1])
        self.assertEqual(result.returncode, code, result.stderr)
        return out

    def same(self, folders, *names):
        for name in names:
            alone, by_three = (rows_without_cost(folder / name) for folder in folders)
            self.assertGreater(len(alone), 0)
            self.assertEqual(alone, by_three)

    def test_sweeps_with_runs_that_fail(self):
        study = self.study("decks='../decks/sod.in', axis(1)='in.nx=21,41,81', axis(2)='fluid.mu=0.,1.e-3', set='in.tmax=.05'\n"
                           "quantities='error_density','dx','last(energy_total)', order='dx'")
        folders = self.both("sweep", study)
        self.same(folders, "table.csv")
        rows = rows_of(folders[1] / "table.csv")
        self.assertEqual([row["exit_code"] for row in rows], ["0"] * 3 + ["2"] * 3)

    def test_bisections(self):
        study = self.study("mode='bisect', decks='../decks/stability-side.in', vary='mpm.cfl', low=0.5, high=2.5\n"
                           "axis='in.xright=5.,5.2', criterion='exit_code', tolerance=0.05, set='in.tstep=1.0','in.dtmax=1.0'")
        self.same(self.both("sweep", study), "table.csv", "outcome.csv")

    def test_maps(self):
        study = self.study("mode='map', decks='../decks/stability-centre.in', criterion='energy_growth', at_most=100.\n"
                           "set='limits.energy_step=0.,0.', 'limits.energy_growth=0.,0.', 'in.tstep=1.0', 'in.dtmax=1.0'\n"
                           "axis(1)='in.xleft=0.,.1,.2,.3,.4', axis(2)='in.xright=5.,5.1,5.2,5.3,5.4', linked(2)=1\n"
                           f"axis(3)='mpm.cfl={'.8,1.2,1.6,2.,2.4,2.8' if FULL else '.8,1.6,2.4'}'")
        folders = self.both("map", study)
        self.same(folders, "map.csv", "table.csv")

    def test_charts(self):
        study = self.study("mode='chart', decks='../decks/sod.in', is='error_density', exact='0', set='in.tmax=.05'\n"
                           "family(1)='points', cells(1,1)='in.nx=21,41,81'")
        self.same(self.both("chart", study), "chart.csv")

    def test_published_problems(self):
        problems, tables = ("sod", "two-bar" if FULL else "noise"), []
        for command in (self.expect, lambda code, *words: mpi.run(*words, folder=DECKS.parent)):
            name = self.folder / f"{len(tables)}.md"
            command(0, "reproduce", *problems, "--quiet", "--out", self.folder / f"r{len(tables)}", "--write", name)
            tables.append([line for line in name.read_text().splitlines() if "--write" not in line])
        self.assertGreater(len(tables[0]), 10)
        self.assertEqual(*tables)

    def test_settings_found(self):
        ring = (ROOT / "tests/auto/decks/ring.in", "--set", "auto.quantity='last(point_x_1) - first(point_x_1)'")
        deck = (DECKS / "bar-vibration.in",) if FULL else ring
        alone, by_three = self.both(*deck, "--auto", ".03", "--threads", "1")
        values = []  # which runs are made depends on what runs cost; what they come to does not
        for folder in (alone, by_three):
            self.assertTrue((folder / "chosen.in").exists())
            values.append({(row["space"], row["time"], row["settings"]): row["value"] for row in rows_of(folder / "auto.csv")})
        common = values[0].keys() & values[1].keys()
        self.assertGreater(len(common), 2)
        self.assertEqual(*({key: each[key] for key in common} for each in values))


class Deaths(SweepTest):
    """Twelve runs of some tenths of a second; something is killed when the first ones have ended."""

    END = ".1" if FULL else ".05"

    @classmethod
    def setUpClass(cls):
        """The study and its table by one program, once for all tests."""
        super().setUpClass()
        case = SweepTest.shared_by(cls)
        cls.slow = case.study("decks='../decks/sod.in', axis='fluid.gm1=.40,.41,.42,.43,.44,.45,.46,.47,.48,.49,.50,.51'\n"
                              f"set='in.tmax={cls.END}','in.nx=401','in.tstep=4.e-5', quantities='error_density'")
        case.sweep(cls.slow)
        cls.whole = rows_without_cost(case.out / "table.csv")

    def setUp(self):
        super().setUp()
        self.words = ("sweep", self.slow, "--quiet", "--out", self.out)

    def finished(self):
        return {path.parent.name: path.stat().st_mtime_ns for path in self.out.rglob("run.txt")}

    def killed(self, victim, *options, how=signal.SIGKILL):
        """Its exit code, and the records that stood then."""
        with mpi.start(*self.words, options=options) as process:
            wait_until(lambda: len(self.finished()) >= 2, "the second run's record", process)
            os.kill(victim(), how)
            before = self.finished()
            self.said = process.communicate(timeout=PATIENCE)[1]
        return process.returncode, before

    def is_whole(self):
        self.assertEqual(rows_without_cost(self.out / "table.csv"), self.whole)

    def test_a_program_that_does_runs(self):
        code, before = self.killed(lambda: mpi.served_by(mpi.carriers()[2]))
        self.assertEqual(code, 0)
        self.is_whole()
        after = self.finished()
        self.assertEqual({name: after[name] for name in before}, before)

    if FULL:  # each rank that is lost takes the 20 seconds of its silence: by default the first one alone
        def test_a_rank_with_recovery(self):
            code, before = self.killed(lambda: mpi.carriers()[1], "--enable-recovery")
            self.assertEqual(code, 0)
            self.is_whole()
            after = self.finished()
            self.assertEqual({name: after[name] for name in before}, before)

    def test_a_program_in_the_first_of_two_charts(self):
        """The second chart has one program less."""
        first, second = (self.study("mode='chart', decks='../decks/sod.in', is='error_density', exact='0'\n"
                                    f"set='in.tmax={self.END}','in.tstep=4.e-5','fluid.gm1={gm1}'\n"
                                    "family(1)='points', cells(1,1)='in.nx=201,401,411,421,431,441'", f"studies/{name}.in")
                         for name, gm1 in (("a", ".4"), ("b", ".41")))
        self.words = ("chart", first, second, "--quiet", "--out", self.out)
        code, _ = self.killed(lambda: mpi.served_by(mpi.carriers()[2]))
        self.assertEqual(code, 0)
        for name in ("a", "b"):
            self.assertEqual([row["exit_code"] for row in rows_of(self.out / name / "chart.csv")], ["0"] * 6)

    def test_the_first_rank_with_recovery(self):
        """The others end by themselves, and say why: the exit code of mpirun is 0 with recovery, whatever happens."""
        code, before = self.killed(lambda: mpi.carriers()[0], "--enable-recovery")
        self.assertLess(len(before), 12)
        self.assertEqual(self.said.count("the first program of this command is lost"), 2, self.said)
        wait_until(lambda: not mpi.carriers(), "the end of every rank")
        self.assertEqual(mpi.run(*self.words).returncode, 0)
        self.is_whole()

    def test_an_exit_code_with_recovery(self):
        study = self.study("decks='../decks/sod.in', quantities='dx', set='in.tmax=.01','in.nx=21,31'", "studies/wrong.in")
        result = mpi.run("sweep", study, "--out", self.out, options=["--enable-recovery"])
        self.assertIn("tether: ends with exit code 2, though mpirun with --enable-recovery ends with 0", result.stderr)

    def test_the_first_program_then_the_same_command_again(self):
        code, before = self.killed(lambda: mpi.served_by(mpi.carriers()[0]))
        self.assertNotEqual(code, 0)
        self.assertLess(len(before), 12)
        wait_until(lambda: not mpi.carriers(), "the end of every rank")
        before = self.finished()
        result = mpi.run(*self.words)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.is_whole()
        after = self.finished()
        self.assertEqual({name: after[name] for name in before}, before)
        reused = {pathlib.Path(row["folder"]).name for row in self.table() if row["reused"] == "1"}
        self.assertEqual(reused, set(before))


class Refusals(SweepTest):
    def setUp(self):
        super().setUp()
        self.one = self.study("decks='../decks/stability-side.in', quantities='steps'")

    def test_a_build_without_mpi(self):
        alone = shutil.copy(TETHER, self.folder / "tether")
        result = mpi.run("sweep", self.one, "--out", self.out, program=str(alone))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("this build of tether has no MPI", result.stderr)
        self.assertIn("libboost-mpi-dev", result.stderr)
        self.assertFalse(self.out.exists())

    def test_a_single_run(self):
        result = mpi.run(DECKS / "sod.in", "--out", self.out)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("a single run shares its work among --threads"), 1)
        self.assertFalse(self.out.exists())

    def test_a_single_run_whose_first_program_comes_last(self):
        """mpirun ends all programs once one has failed: the others must not fail before the first has said why."""
        others_ended = self.folder / "others-ended"
        os.mkfifo(others_ended)
        deck = DECKS / "sod.in"
        result = self.two(("sh", "-c", f"read _ < '{others_ended}'; exec '{TETHER}' '{deck}'"),
                          ("sh", "-c", f"'{TETHER}' '{deck}'; code=$?; echo > '{others_ended}'; exit $code"),
                          OMPI_MCA_odls_base_sigkill_timeout="0")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("a single run shares its work among --threads"), 1)

    def test_a_machine_that_does_not_see_the_folder(self):
        """Another folder of work stands for another machine."""
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        words = (TETHER, "sweep", self.one, "--quiet", "--out", "here")
        result = self.two(("-wdir", self.folder, *words), ("-wdir", elsewhere, *words))
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("does not see the folder", result.stderr)
        self.assertIn(str(elsewhere / "here"), result.stderr)
        self.assertEqual(list(elsewhere.iterdir()), [])

    def two(self, first, second, **settings):
        """A command of two programs, each with words of its own in front of it, by these settings of mpirun's."""
        command = [*mpi.MPIRUN, "-n", "1", *map(str, first), ":", "-n", "1", *map(str, second)]
        return mpi.subprocess.run(command, env=mpi.ENVIRONMENT | settings, capture_output=True, text=True, timeout=PATIENCE)

    def test_programs_with_other_words(self):
        other = self.study("decks='../decks/stability-side.in', quantities='steps','dx'", "studies/other.in")
        result = self.two((TETHER, "sweep", self.one, "--out", self.out), (TETHER, "sweep", other, "--out", self.out))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("mpirun has started different programs", result.stderr)
        self.assertIn(f"{other}' as number 1", result.stderr)
        self.assertFalse(self.out.exists())

    def test_a_machine_with_other_particles(self):
        """Folders of work with the same deck and other particle files stand for machines that share no folder of decks."""
        study = "$study\ndecks='a.in', quantities='steps'\n$\n"
        deck = "$in\nnx=5,ny=5,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.1,tstep=.01,igen=0,particles='a.par'\n$\n"
        for name, x in (("one", ".5"), ("other", ".51")):
            (self.folder / name).mkdir()
            self.write(f"{name}/study.in", study)
            self.write(f"{name}/a.in", deck)
            self.write(f"{name}/a.par", f"1.\n1,0,0,0,0,0,0\n3,3,3,0\n1\n1,1\n{x} .5 0 0 0 0 0\n")
        words = (TETHER, "sweep", "study.in", "--quiet", "--out", self.out)
        result = self.two(*(("-wdir", self.folder / name, *words) for name in ("one", "other")))
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("sees other particles or another mesh", result.stderr)
        self.assertEqual(list(self.out.rglob("run.txt")), [])

    def test_mistakes_are_said_once(self):
        result = mpi.run("sweep", self.study("decks='../decks/none.in'", "studies/bad.in"), "--out", self.out)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("cannot be opened for reading"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
