# SPDX-License-Identifier: GPL-3.0-or-later
"""Exit codes of the contract: 0 done, 2 wrong input, 3 a run that diverged or lost a point, 4 file trouble."""
import functools
import itertools
import resource
import unittest

import numpy

from full_length import FULL
from program import DECKS, ProgramTest, history, netcdf, run, sets

# An elastic block of 8 points in cells of .1 that flies to the right at 1: it passes x = .5, an open edge, at t = .325.
FLYING_BLOCK = """a block that flies to the right
$in
 nx=6, ny=2, igen=1,
 xleft=0.0, xright=0.5, ybot=0.0, ytop=0.1,
 tmax=0.1, tstep=1.d-3,
 wl=1, wr=1, wb=1, wt=1,
 iout(33)=1, tiout(33)=0.01
$
$fluid
 gm1=0.4, siep(1)=1.0
$
$reg
 nreg=1,
 nvi=4,
 xvi(1,1)=0.0,0.2,0.2,0.0,
 yvi(1,1)=0.0,0.0,0.1,0.1,
 nprg=4,
 densir(1)=1.0,
 matr(1,1)=1.0,0.0,
 ipath(1,1)=3,3,3,0,
 vrx(1)=1.0
$
$mpm
 cfl=0.0
$
"""

# The same grid with two blocks that meet in the middle of a cell, at 90% of a cell in a step each.
COLLIDING_BLOCKS = FLYING_BLOCK[:FLYING_BLOCK.index("$reg")] + """$reg
 nreg=2,
 nvi=4,4,
 xvi(1,1)=0.1,0.25,0.25,0.1,
 yvi(1,1)=0.0,0.0,0.1,0.1,
 xvi(1,2)=0.25,0.4,0.4,0.25,
 yvi(1,2)=0.0,0.0,0.1,0.1,
 nprg=4,4,
 densir(1)=1.0,1.0,
 vrx(1)=90.0,-90.0,
"""

ELASTIC = COLLIDING_BLOCKS + " matr(1,1)=1.d308, ipath(4,1)=0, matr(1,2)=1.d308, ipath(4,2)=0\n$\n$mpm\n cfl=0.0\n$\n"
GAS = COLLIDING_BLOCKS + " ipath(4,1)=7, ipath(4,2)=7\n$\n$fluid\n siep(1)=1.0,1.0\n$\n$mpm\n cfl=0.0\n$\n"


def limit_file_size(most):
    """For the child: a file that grows beyond `most` bytes cannot be written, as on a full disk."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


class Blocks(ProgramTest):
    def setUp(self):
        super().setUp()
        self.deck = self.write("block.in", FLYING_BLOCK)
        self.out = self.folder / "out"

    def readable_history(self):
        """Columns of history.txt, which history.nc must hold, too."""
        columns, variables = history(self.out), netcdf(self.out / "history.nc")
        numpy.testing.assert_array_equal(columns["time"], variables["time"])
        numpy.testing.assert_array_equal(columns["energy_total"], variables["energy_total"])
        self.assertTrue(numpy.all(numpy.diff(columns["time"]) > 0))
        return columns


class DoneAndWrongInput(Blocks):
    def test_done(self):
        self.expect(0, self.deck, "--out", self.out)
        self.assertEqual(self.readable_history()["time"][-1], 0.1)

    def test_wrong_command_lines(self):
        wrong = [[], ["--no-such-option"], [self.deck, "--threads", "0"], [self.deck, "--threads", "two"],
                 [self.deck, "--path", "sph"], [self.deck, "--out"], ["check"], ["plan"], ["vars", "no-such-group"],
                 [self.deck, "--set", "in.tmax"], [self.deck, "--set", "tmax=1"]]
        for words in wrong:
            with self.subTest(words=words):
                result = self.expect(2, *words, folder=self.folder)
                self.assertNotEqual(result.stderr, "")
                self.assertEqual([path.name for path in self.folder.iterdir()], ["block.in"])

    def test_unknown_variables_through_set(self):
        for name, message in (("in.tmx=1", "$in has no variable 'tmx'"), ("inn.tmax=1", "'inn.tmax' names no group")):
            result = self.expect(2, self.deck, "--out", self.out, "--set", name)
            self.assertIn(f"error: {message}\n  {name}\n", result.stderr)
            self.assertFalse(self.out.exists())

    def test_files_that_are_no_decks(self):
        for text in ("", "\n\n", "$in\n", "\0\1\2", "$in\n nx=3, ny=\0 3 $\n", "$" * 5000, "$in nx=" + "9" * 100000):
            with self.subTest(text=text[:20]):
                result = self.expect(2, self.write("no.in", text), "--out", self.out)
                self.assertIn("error: ", result.stderr)

    def test_two_decks_that_would_share_a_folder(self):
        (self.folder / "a").mkdir()
        twin = self.write("a/block.in", FLYING_BLOCK)
        result = self.expect(2, self.deck, twin, "--out", self.out)
        self.assertIn("two decks are named block", result.stderr)
        self.assertFalse(self.out.exists())

    def test_no_number_crashes_the_program(self):
        """Legal numbers without sense: refused, stopped or run, never ended by a signal."""
        names = ("in.xleft", "in.xright", "in.ytop", "in.tmax", "in.gravc", "reg.xvi(1,1)", "reg.nvi(1)", "reg.rex(1)",
                 "reg.densir(1)", "reg.matr(1,1)", "reg.matr(2,1)", "reg.vrx(1)", "mpm.cfl", "in.tiout(33)")
        for name in names:
            for value in ("-1e308", "0", "1e-320", "1e-300", "5", "1e308") if FULL else ("-1e308", "1e-320", "1e308"):
                self.survives(self.deck, *([] if name == "in.tmax" else sets(in__tmax=0.005)),
                              "--set", f"{name}={value}")

    def test_no_number_of_a_gas_crashes_the_program(self):
        for name in ("gm1", "siep(1)", "mu", "lambda", "coef1", "coef2"):
            for value in ("-1e308", "-1", "0", "1e-300", "1e308") if FULL else ("-1", "1e-300", "1e308"):
                self.survives(DECKS / "sod.in", *sets(in__tmax=0.001), "--set", f"fluid.{name}={value}")

    def test_a_scene_beyond_its_exact_solution(self):
        self.survives(DECKS / "piston-m1.in", "--set", "in.ny=3")
        self.survives(DECKS / "piston-m1.in", "--set", "reg.xvi(1,1)=5")

    def test_a_step_without_end(self):
        """tmax + tstep = tmax in floating point: such a run never ends."""
        self.survives(self.deck, "--set", "in.tstep=1e-300")

    def survives(self, *words):
        result = run(*words, "--quiet", "--out", self.out,
                     before=functools.partial(limit_file_size, 10**7))
        with self.subTest(words=words):
            self.assertIn(result.returncode, (0, 2, 3), result.stderr)
            self.assertEqual("error: " in result.stderr, result.returncode != 0)


class StoppedRuns(Blocks):
    def stop(self, cause, *options, deck=None):
        """A run that ends with code 3 and names point, cell, time and cause; returns its history."""
        deck = deck or self.deck
        result = self.expect(3, deck, "--quiet", "--out", self.out, *options)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, r"^\S+: error: t = \S+, step \d+: point \d+ \(body 1, .*\) at \(.*\) in "
                                        r"(cell \(-?\d\S*, -?\d\S*\)|no cell) ")
        self.assertIn(cause, result.stderr)
        self.assertNotRegex(result.stderr, r"\d{40}")  # no number of hundreds of digits
        error = result.stderr.split(": ", 1)[1].strip()  # "error: t = ..."
        self.assertEqual((self.out / "messages.txt").read_text().splitlines()[-1], error)
        self.assertFalse((self.out / "summary.txt").exists())
        return self.readable_history()

    def test_a_step_too_long(self):
        columns = self.stop("the step is 2.00 times the limit dx/c: likely cause, a step too long", *sets(
            in__tstep=2e-3, in__dtmax=2e-3, in__tmax=1), "--set", "limits.energy_step=0,0", "--set", "limits.energy_growth=0,0",
            deck=DECKS / "stability-side.in")
        self.assertGreater(len(columns["time"]), 5)
        energy = columns["energy_total"]
        self.assertGreater(energy[-1], 100 * energy[0])

    def test_a_step_too_long_is_seen_by_its_energy_first(self):
        result = self.expect(3, DECKS / "stability-side.in", "--quiet", "--out", self.out,
                             *sets(in__tstep=2e-3, in__dtmax=2e-3, in__tmax=1))
        self.assertRegex(result.stderr, r"error: t = \S+: the rise of the energy .* \(energy_step of \$limits\): likely "
                                        r"cause, steps too long")

    def test_a_point_that_leaves_an_open_grid(self):
        columns = self.stop("left the grid by the right edge (wall 1): likely cause, an open edge too near", *sets(in__tmax=1))
        # The foremost points start at x = .175 and fly freely: the last record is that of t = .32.
        self.assertEqual(len(columns["time"]), 33)
        self.assertAlmostEqual(columns["time"][-1], 0.32, delta=1e-12)
        numpy.testing.assert_allclose(columns["body_x_1"], 0.1 + columns["time"], rtol=0, atol=1e-12)

    def test_a_point_that_jumps_over_a_cell(self):
        columns = self.stop("jumped over a cell (2.5 cells in one step)", "--set", "reg.vrx(1)=250")
        self.assertEqual(columns["time"].tolist(), [0])

    def test_numbers_that_overflow(self):
        self.stop("has no finite place: its numbers overflowed", "--set", "reg.densir(1)=1e-320")

    def test_a_point_far_outside_is_told_briefly(self):
        self.stop("left the grid", "--set", "reg.vrx(1)=1e300")

    def test_stresses_that_overflow(self):
        self.stop("has a stress that is no number", deck=self.write("elastic.in", ELASTIC))

    def test_a_gas_whose_density_turns_negative(self):
        # The points of the middle cell see dt div v = -2 x .9 x .75: 1 + dt div v < 0 in (4.7).
        self.stop("has the negative density -2.85", deck=self.write("gas.in", GAS))

    def test_a_gas_whose_step_vanishes(self):
        result = self.expect(3, self.deck, "--quiet", "--out", self.out, *sets(mpm__cfl=1),
                             "--set", "fluid.siep(1)=1e30", "--set", "reg.ipath(4,1)=7")
        self.assertRegex(result.stderr, r"error: t = 0, step 1: the gas moves at c \+ \|v\| = \S+ and leaves a step of "
                                        r"\S+: likely cause")
        self.assertEqual(self.readable_history()["time"].tolist(), [0])


class FileTrouble(Blocks):
    def test_decks_that_cannot_be_read(self):
        for deck in (self.folder / "nowhere.in", self.folder):
            result = self.expect(4, deck, "--out", self.out)
            self.assertIn(f"{deck}: cannot be ", result.stderr)
            self.assertFalse(self.out.exists())

    def test_a_folder_that_cannot_be_made(self):
        file = self.write("file", "")
        result = self.expect(4, self.deck, "--out", file / "out")
        self.assertIn(f"{file / 'out'}: the folder cannot be made: Not a directory", result.stderr)

    def test_a_full_disk(self):
        """A history of far more than 560 kB on a disk that takes no more: what was written is what a run writes, also
        where a thread of its own writes it."""
        deck, many = DECKS / "spring-mass.in", ["--set", "in.tiout(33)=2e-5"]
        whole = self.run_ok(deck, *many, out="whole")
        for threads in ("1", "2"):
            with self.subTest(threads=threads):
                self.fill_the_disk(deck, whole, *many, "--threads", threads)

    def fill_the_disk(self, deck, whole, *words):
        result = self.expect(4, deck, "--quiet", "--out", self.out, *words,
                             before=functools.partial(limit_file_size, 560_000))
        self.assertIn("history.txt: cannot be written: File too large", result.stderr)
        text, all_text = (self.out / "history.txt").read_bytes(), (whole / "history.txt").read_bytes()
        self.assertTrue(all_text.startswith(text))
        self.assertTrue(text.endswith(b"\n"))
        self.assertGreater(len(text), 419_000)
        records = netcdf(self.out / "history.nc")["time"]
        self.assertGreaterEqual(len(records), text.count(b"\n") - 1)
        numpy.testing.assert_array_equal(records, netcdf(whole / "history.nc")["time"][:len(records)])
        self.assertFalse((self.out / "summary.txt").exists())

    def test_a_disk_that_is_full_at_once(self):
        for most, threads in itertools.product((0, 500, 5_000, 50_000), ("1", "2")):
            with self.subTest(most=most, threads=threads):
                result = self.expect(4, DECKS / "spring-mass.in", "--quiet", "--out", self.out / f"{most}-{threads}",
                                     "--threads", threads,
                                     before=functools.partial(limit_file_size, most))
                self.assertIn("File too large", result.stderr)


class SeveralDecks(Blocks):
    def test_all_are_run_and_the_worst_counts(self):
        good = self.write("good.in", FLYING_BLOCK)
        leaving = self.write("leaving.in", FLYING_BLOCK.replace("tmax=0.1", "tmax=1.0"))
        wrong = self.write("wrong.in", FLYING_BLOCK.replace("nx=6", "nx=1"))
        missing = self.folder / "missing.in"
        for decks, code in (([good], 0), ([wrong, good], 2), ([wrong, leaving, good], 3), ([leaving, wrong, good], 3),
                            ([missing, leaving, wrong, good], 4)):
            with self.subTest(decks=[deck.name for deck in decks]):
                out = self.folder / f"out{len(decks)}{decks[0].stem}"
                self.expect(code, *decks, "--out", out)
                done = out if len(decks) == 1 else out / "good"
                self.assertTrue((done / "summary.txt").exists())
                self.assertFalse((out / "wrong").exists())


if __name__ == "__main__":
    unittest.main()
