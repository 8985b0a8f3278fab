# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a run that only talk, and what it says of a deck."""
import re
import unittest

from program import DECKS, ProgramTest, run, without_cost
from test_commands import THREE_WRONG_WISHES

SOD = DECKS / "sod.in"


class Options(ProgramTest):
    def test_dry_run_writes_nothing(self):
        for words in ([SOD, "--dry-run"], [SOD, "--dry-run", "--out", self.folder / "out"]):
            result = self.expect(0, *words, folder=self.folder)
            self.assertIn("cost: 1430 steps", result.stdout)
            self.assertEqual(without_cost(result.stdout), without_cost(run("plan", SOD).stdout))
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_the_default_folder_is_out_and_the_deck_s_name(self):
        self.expect(0, DECKS / "stability-side.in", "--quiet", folder=self.folder)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["out"])
        self.assertTrue((self.folder / "out/stability-side/summary.txt").exists())

    def test_quiet(self):
        deck = DECKS / "stability-side.in"
        loud = self.expect(0, deck, "--out", self.folder / "loud")
        self.assertEqual(loud.stderr.count("1 remark in "), 1)
        self.assertRegex(loud.stdout, r"stability-side.in: 30 steps, .* in \S+/loud\n$")
        quiet = self.expect(0, deck, "--out", self.folder / "quiet", "--quiet")
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))
        messages = (self.folder / "quiet/messages.txt").read_text()
        self.assertIn("remark: $regrig is there without nregrig", messages)
        self.assertEqual(messages, (self.folder / "loud/messages.txt").read_text())

    def test_known_slips_are_one_line_and_hide_no_warning(self):
        """The slips of the printed decks do no harm; what may do is reported in full, and messages.txt has both."""
        deck = self.write("slips.in", (DECKS / "piston-m1.in").read_text())
        options = ("--particles", DECKS.parent / "particles/piston.par", "--set", "in.tmax=1e-4")
        out = self.folder / "out"
        result = self.expect(0, deck, "--out", out, *options)
        lines = result.stderr.splitlines()
        self.assertEqual([line for line in lines if "remark" in line], [f"{deck}: 4 remarks in {out}/messages.txt"])
        self.assertEqual([line for line in lines if "tiout" in line or "vrx" in line or "$regrig" in line], [])
        self.assertTrue(any("warning: the deck's step" in line for line in lines), result.stderr)
        messages = (out / "messages.txt").read_text()
        for remark in ("remark: tiout is set", "remark: vrx(2) is set but nreg = 1", "remark: vry(2) is set",
                       "remark: region 1: its points hold an area of 20 where 6 is drawn"):
            self.assertRegex(messages, rf"slips\.in:\d+:\d+: {re.escape(remark)}")
        self.assertIn("warning: the deck's step", messages)
        shown = self.expect(0, "check", deck, *options).stderr
        self.assertEqual(shown.count(": remark: "), 4)
        for words in (["plan", deck], [deck, "--dry-run"]):
            told = self.expect(0, *words, *options).stderr
            self.assertIn(f"{deck}: 4 remarks shown by tether check\n", told)
            self.assertNotIn("tiout", told)

    def test_a_region_that_nreg_forgets_is_a_warning(self):
        deck = self.write("three.in", THREE_WRONG_WISHES.replace("nprg=5", "nprg=4").replace("matr(1,1)=0.0", "matr(1,1)=1.0")
                          .replace("iout(33)=1", "").replace("ipath(4,1)=0", "ipath(4,1)=0, densir(2)=1., vrx(2)=1."))
        told = self.expect(0, "plan", deck).stderr
        self.assertIn("warning: densir(2) is set but nreg = 1", told)
        self.assertIn("warning: vrx(2) is set but nreg = 1", told)

    def test_quiet_keeps_errors_and_the_run_s_warnings(self):
        deck = DECKS / "stability-side.in"
        steps = ["--set", "in.tstep=2e-3", "--set", "in.dtmax=2e-3", "--set", "mpm.cfl=1"]
        self.expect(0, deck, "--quiet", "--out", self.folder / "out", *steps)
        self.assertIn("steps are limited to 0.001\n", (self.folder / "out/messages.txt").read_text())
        result = self.expect(2, deck, "--quiet", "--set", "in.nx=1", folder=self.folder)
        self.assertIn("error: nx = 1 is out of range", result.stderr)

    def test_set_may_stand_before_the_deck(self):
        out = self.folder / "out"
        self.expect(0, "--set", "in.tmax=0.002", "--set", "in.gravc=1.0", DECKS / "stability-side.in", "--out", out)
        self.assertIn("tmax = 0.002\n", (out / "deck.effective").read_text())

    def test_particles_with_a_deck_that_reads_none(self):
        result = self.expect(0, "check", SOD, "--particles", "nowhere.par")
        self.assertIn("warning: igen = 1 reads no particle file: --particles is not used", result.stderr)

    def test_particles_that_are_not_there(self):
        result = self.expect(2, "check", DECKS / "stability-side.in", "--particles", "nowhere.par")
        self.assertIn("error: particle file: nowhere.par: cannot be opened for reading", result.stderr)


if __name__ == "__main__":
    unittest.main()
