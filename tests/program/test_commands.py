# SPDX-License-Identifier: GPL-3.0-or-later
"""check, plan, vars and the options that only talk."""
import re
import subprocess
import unittest

from program import DECKS, TETHER, ProgramTest, diagnostics, run, summary, without_cost

SOD = DECKS / "sod.in"

# Three mistakes of reading.
THREE_MISTAKES = """three mistakes
$in
 nx=1, ny=11, igen=1,
 xleft=0.0, xright=1.0, ybot=0.0, ytop=1.0,
 tmax=-1.0, tstep=1.d-3,
 wx=6
$
"""

# Read well, with three mistakes in what they ask for.
THREE_WRONG_WISHES = """three wrong wishes
$in
 nx=11, ny=11, igen=1,
 xleft=0.0, xright=1.0, ybot=0.0, ytop=1.0,
 tmax=1.0, tstep=1.d-3,
 iout(33)=1
$
$reg
 nreg=1,
 nvi=4,
 xvi(1,1)=0.0,0.5,0.5,0.0,
 yvi(1,1)=0.0,0.0,0.5,0.5,
 nprg=5,
 densir(1)=1.0,
 matr(1,1)=0.0,0.3,
 ipath(4,1)=0
$
"""


class Talk(ProgramTest):
    """Nothing of this writes a file: each call runs in an empty folder."""

    def say(self, *words):
        result = self.expect(0, *words, folder=self.folder)
        self.assertEqual(list(self.folder.iterdir()), [])
        return result

    def test_help(self):
        for words in (["--help"], ["-h"]):
            text = self.say(*words).stdout
            for option in ("--out", "--threads", "--set", "--particles", "--path", "--quiet", "--dry-run", "--restart", "--version",
                           "check", "plan", "vars", "sweep"):
                self.assertIn(option, text)
        for command in ("check", "plan", "vars", "sweep"):
            self.assertIn("--help", self.say(command, "--help").stdout)

    def test_help_by_a_word(self):
        self.assertEqual(self.say("help").stdout, self.say("--help").stdout)
        for command in ("check", "plan", "sweep", "reproduce", "vars"):
            self.assertEqual(self.say("help", command).stdout, self.say(command, "--help").stdout)

    def test_a_word_that_is_no_command_runs_nothing(self):
        """chek DECK once ran the deck, over the results that were there."""
        deck = DECKS / "stability-side.in"
        for words, hint in ((("chek", deck), "Did you mean 'check'?"), (("--out", "x", "paln", deck), "Did you mean 'plan'?"),
                            (("frobnicate",), "The commands are check, plan, sweep, chart, map, reproduce, plot, film, page, compare, decks, vars, columns, keys, help"),
                            (("help", "me"), "The commands are"), ((deck, "out"), "tether DECK runs a deck"),
                            ((deck, "check"), "tether check DECK")):
            with self.subTest(words=words):
                result = self.expect(2, *words, folder=self.folder)
                self.assertIn(hint, result.stderr)
                self.assertEqual(result.stdout, "")
                self.assertEqual(list(self.folder.iterdir()), [])
        self.assertIn("'chek' is no command and names no file; nothing was run", run("chek", deck).stderr)

    def test_options_stand_anywhere(self):
        deck, stop = DECKS / "stability-side.in", ("--set", "in.tmax=0.002")
        self.assertEqual(self.say(*stop, "check", deck).stdout, self.say("check", deck, *stop).stdout)
        self.assertEqual(without_cost(self.say("--path", "mpm", "plan", *stop, deck).stdout),
                         without_cost(self.say("plan", deck, *stop).stdout))
        self.assertEqual(self.say("--markdown", "vars").stdout, self.say("vars", "--markdown").stdout)
        self.assertIn("to run", self.say(
            "--out", "x", "--dry-run", "sweep", DECKS / "studies/stability.in").stdout)
        self.expect(0, "--quiet", *stop, "--out=y", deck, "--set=in.gravc=1.0", folder=self.folder)
        text = (self.folder / "y/deck.effective").read_text()
        self.assertIn("tmax = 0.002\n", text)
        self.assertIn("gravc = 1.0\n", text)

    def test_a_value_that_reads_like_a_command_is_none(self):
        stop = ("--set", "in.tmax=0.002", "--quiet")
        for words in (("--log", "run.log", "--out", "plot"), ("--out", "check", "--log", "sweep")):
            self.expect(0, DECKS / "sod.in", *words, *stop, folder=self.folder)
            self.expect(0, *words, *stop, DECKS / "sod.in", folder=self.folder)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"run.log", "plot", "check", "sweep"})

    def test_wrong_words_are_told_what_would_be_right(self):
        deck = DECKS / "stability-side.in"
        for words, told in (((), "a deck or a command is missing"), (("plan",), "tether plan: error: deck is required"),
                            (("plan", deck, deck), "tether plan takes one deck, not 2:"),
                            (("check", deck, "--treads", "2"), "tether check has no option '--treads'"),
                            (("--out", "x", "plan", deck), "--out requires --auto"),
                            ((deck, "--pat", "fem"), "Did you mean '--path'?"),
                            ((deck, "--threads", "0"), "--threads: Value 0 not in range 1 to 1024"),
                            ((deck, "--set", "in.tmax=.01", "mpm.cfl=.5"), "Repeat --set for each value: --set mpm.cfl=.5"),
                            (("check", deck, "mpm.cfl=.5"), "Repeat --set for each value: --set mpm.cfl=.5"),
                            ((deck, "--restart"), "--restart is not followed by a value; nothing was run"),
                            ((deck, "--restart", "--quiet"), "--restart is not followed by a value; nothing was run"),
                            (("plot", "nowhere", "--log"), "nowhere: is no folder"),  # there it has no value
                            (("plot", "--log", "nowhere"), "nowhere: is no folder"),
                            (("sweep", deck, "--log"), "--log is not followed by a value; nothing was run"),
                            ((deck, "--out"), "--out is not followed by a value; nothing was run"),
                            ((deck, "--out", ""), "--out: a folder is wanted"),
                            (("sweep", DECKS / "studies/stability.in", "--out", ""), "--out: a folder is wanted")):
            with self.subTest(words=words):
                self.assertIn(told, self.expect(2, *words, folder=self.folder).stderr)
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_threads_that_nothing_uses_are_told_of(self):
        deck, remark = DECKS / "rigid-torque.in", "remark: --threads 3 changes nothing: this path computes with one thread"
        result = self.expect(0, deck, DECKS / "rigid-free.in", "--threads", "3", folder=self.folder)
        self.assertEqual(result.stderr.count(remark), 2)
        folder = self.folder / "out/rigid-torque"
        self.assertIn(remark, (folder / "messages.txt").read_text())
        self.assertEqual(summary(folder)["threads"], "1")
        self.assertEqual(self.expect(0, "--threads", "3", "plan", deck).stderr.count(remark), 1)
        for words in ((deck, "--threads", "1"), (deck,), ("plan", deck)):
            self.assertNotIn("threads", self.expect(0, *words, folder=self.folder).stderr)
        self.assertNotIn("threads", (folder / "messages.txt").read_text())

    def test_threads_are_those_asked_for_or_as_many_as_are_worth_it(self):
        deck = DECKS / "stability-side.in"  # of few points
        for words, threads in (((), "1"), (("--threads", "3"), "3")):
            self.assertNotIn("threads", self.expect(0, deck, *words, folder=self.folder).stderr)
            self.assertEqual(summary(self.folder / "out/stability-side")["threads"], threads)

    def test_an_output_that_takes_no_text_is_told(self):
        for words in (["vars"], ["check", DECKS / "sod.in"]):
            with open("/dev/full", "w", encoding="ascii") as full:
                result = subprocess.run([TETHER, *words], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(result.returncode, 4, result.stderr)
            self.assertIn("error: ", result.stderr)

    def test_closed_streams_do_no_harm(self):
        deck = DECKS / "stability-side.in"
        result = subprocess.run(f"'{TETHER}' '{deck}' --out '{self.folder}/out' 0<&- 1>&- 2>&-", shell=True, check=False)
        self.assertEqual(result.returncode, 0)
        self.assertTrue((self.folder / "out/summary.txt").read_text().endswith("\n"))

    def test_version(self):
        lines = self.say("--version").stdout.splitlines()
        self.assertRegex(lines[0], r"^tether \d+\.\d+\.\d+ \([\w-]+\)$")
        for library in ("netcdf", "fmt", "CLI11", "Boost", "OpenSSL"):
            self.assertEqual(sum(line.startswith(library) for line in lines), 1, library)

    def test_vars(self):
        text = self.say("vars").stdout
        groups = re.findall(r"^\$(\w+)$", text, re.MULTILINE)
        self.assertEqual(groups[:4], ["in", "fluid", "regrig", "reg"])
        for group in ("points", "membrane", "mpm", "reference"):
            self.assertIn(group, groups)
        self.assertEqual(text, "".join(self.say("vars", group).stdout for group in groups))

    def test_vars_of_a_group(self):
        for name in ("mpm", "MPM"):
            text = self.say("vars", name).stdout
            self.assertRegex(text, r"^\$mpm\n")
            self.assertRegex(text, r"(?m)^  order +text .*musl, usf or usl +no default ")
            self.assertRegex(text, r"(?m)^  criterion +integer .*1, 2 or 3 +default 1 ")
            self.assertNotIn("$in", text)

    def test_vars_of_no_group(self):
        result = self.expect(2, "vars", "mpmm")
        self.assertEqual(result.stdout, "")
        self.assertIn("error: there is no group '$mpmm'", result.stderr)


class Check(ProgramTest):
    def listed(self, text, group, name):
        """The words behind a name in a group of the listing."""
        part = re.search(rf"^\${group}\b.*\n((?:  .*\n)*)", text, re.MULTILINE).group(1)
        return re.search(rf"^  {re.escape(name)} +(.*)$", part, re.MULTILINE).group(1).split()

    def test_value_origin_unit_and_place(self):
        text = self.expect(0, "check", SOD, "--all").stdout
        self.assertEqual(self.listed(text, "in", "tmax"), ["0.143", "given", "time", "9:6"])
        self.assertEqual(self.listed(text, "in", "nx"), ["101", "given", "7:4"])
        self.assertEqual(self.listed(text, "in", "tiout(39)"), ["0.05", "given", "time", "19:22"])
        self.assertEqual(self.listed(text, "in", "units"), ["'none'", "default"])
        self.assertEqual(self.listed(text, "mpm", "criterion"), ["1", "default"])
        self.assertEqual(self.listed(text, "in", "miter"), ["30", "given", "10:17", "read,", "no", "effect"])
        self.assertEqual(self.listed(text, "in", "methd"), ["-", "not", "given", "read,", "no", "effect"])
        self.assertIn("$mpm (not in the deck)\n", text)
        self.assertIn("$fluid\n", text)

    def test_what_has_its_default_is_left_out_unless_asked_for(self):
        text = self.expect(0, "check", SOD, "--set", "in.units='none'", "--set", "in.tmax=.1").stdout
        self.assertEqual(self.listed(text, "in", "tmax"), ["0.1", "given", "time", "--set", "2:9"])
        self.assertNotIn("default", text.splitlines()[0])
        self.assertNotIn("  units ", text)
        self.assertNotIn("$mpm", text)
        self.assertRegex(text, r"\d+ variables have their defaults, or are not given: --all lists them\n")
        self.assertNotIn("\033", text)

    def test_a_place_is_where_the_value_stands(self):
        text = self.expect(0, "check", SOD, "--all").stdout
        lines = SOD.read_text().splitlines()
        for name, written in (("fluid.gm1", ".4"), ("reg.densir(2)", "0.1250"), ("reg.xvi(2,1)", ".5e0")):
            place = self.listed(text, *name.split("."))[-1]
            line, column = map(int, place.split(":"))
            self.assertTrue(lines[line - 1][column - 1:].startswith(written), (name, place))

    def test_values_of_the_command_line(self):
        text = self.expect(0, "check", SOD, "--set", "in.tmax=0.5", "--set", "mpm.cfl=0.25").stdout
        self.assertEqual(self.listed(text, "in", "tmax"), ["0.5", "given", "time", "--set", "1:9"])
        self.assertEqual(self.listed(text, "mpm", "cfl"), ["0.25", "given", "--set", "2:9"])

    def test_remarks_go_to_stderr(self):
        result = self.expect(0, "check", SOD)
        self.assertIn(":12:22: remark: tiout is set for outputs that are off", result.stderr)
        self.assertNotIn("remark", result.stdout)

    def test_all_errors_at_once(self):
        for text, places in ((THREE_MISTAKES, {"3:5", "5:7", "6:2"}), (THREE_WRONG_WISHES, {"6:11", "13:7", "15:12"})):
            deck = self.write("wrong.in", text)
            for command in (["check"], ["plan"], []):
                with self.subTest(command=command, text=text[:20]):
                    result = self.expect(2, *command, deck, folder=self.folder)
                    self.assertEqual(bool(result.stdout), command == ["check"])  # which lists what it could read
                    errors = [head for head, _ in diagnostics(result.stderr) if head["severity"] == "error"]
                    self.assertEqual({f"{head['line']}:{head['column']}" for head in errors}, places)

    def test_of_several_decks_the_worst_says_how_the_command_ended(self):
        wrong = self.write("wrong.in", THREE_MISTAKES)
        self.expect(2, wrong, SOD, "--set", "in.tmax=.001", "--quiet", folder=self.folder)


class Plan(ProgramTest):
    def parts(self, *words):
        """The plan's lists of terms that are modelled and left out: {name: reason}."""
        text = self.expect(0, "plan", *words).stdout
        parts = re.search(r"^modelled:\n((?:  .*\n)*)left out:\n((?:  .*\n)*)", text, re.MULTILINE).groups()
        terms = [dict(line.strip().split(": ", 1) for line in part.splitlines()) for part in parts]
        return text, *terms

    def test_plan_and_dry_run_tell_what_theory_says_of_splitting(self):
        bar = DECKS / "coupled-bar.in"
        for densities, word in (("1000.", "fail"), ("300000.", "hold")):
            for words in (["plan", bar], [bar, "--dry-run"]):
                text = self.expect(0, *words, "--set", f"reg.densir(1)={densities}").stdout
                self.assertIn(f"\nsplitting: would {word} by theory: ", text)
        self.assertNotIn("by theory", self.expect(0, "plan", SOD).stdout)

    def test_a_shock_tube(self):
        text, modelled, left_out = self.parts(SOD)
        self.assertIn("path: mpm", text)
        self.assertIn("body 2: region 2, 450 points, ideal gas, gamma 1.4", text)
        self.assertEqual(modelled["energy equation (4.8)"], "a gas is there")
        self.assertIn("artificial viscosity (4.11)", modelled)
        self.assertEqual(left_out["gravity"], "gravc = 0")
        self.assertEqual(left_out["viscosity (4.1)"], "mu = 0")
        self.assertEqual(left_out["tangents (7.1)"], "no string")
        self.assertEqual(left_out["third dimension"], "the scene is plane, one unit deep")
        # c = sqrt(1.4 x .4 x 2.5): dx/c = .01/1.18322 = .00845154, and .143/1e-4 steps of 900 points.
        self.assertIn("step: 0.0001 at the start (deck 0.0001, limit dx/c 0.00845154, cfl 1)", text)
        self.assertIn("cost: 1430 steps, 1.287e+06 point-steps", text)

    def test_a_string(self):
        _, modelled, left_out = self.parts(DECKS / "pendulum-40.in")
        self.assertEqual(modelled["gravity"], "gravc = -20 in y")
        self.assertIn("tangents (7.1)", modelled)
        self.assertEqual(left_out["energy equation (4.8)"], "no gas")
        self.assertFalse(set(modelled) & set(left_out))

    def test_a_step_above_the_limit(self):
        words = [DECKS / "stability-side.in", "--set", "in.tstep=3e-3", "--set", "in.dtmax=3e-3"]
        text, _, _ = self.parts(*words)
        self.assertIn("warning: the deck's step 0.003 is 3.00 times the limit dx/c = 0.001 and taken as it is", text)
        text, _, _ = self.parts(*words, "--set", "mpm.cfl=0.5")
        self.assertIn("is 3.00 times the limit dx/c = 0.001: steps are limited to 0.0005, which is cfl = 0.5 times that", text)


if __name__ == "__main__":
    unittest.main()
