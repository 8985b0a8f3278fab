# SPDX-License-Identifier: GPL-3.0-or-later
"""tether reproduce: the table of published numbers, what it is judged by, and what it refuses."""
import os
import pathlib
import re
import shutil
import unittest

from full_length import FULL
from program import DECKS, TETHER, diagnostics
from sweeps import SweepTest
from waiting import wait_until

QUICK = ("sod", "sod-continuity", "sod-cell", "gas-expansion", "spring-mass", "string-mass", "pendulum-20",
         "piston-m01", "piston-m1", "stability-centre", "stability-side", "noise")
COLUMNS = ["problem", "quantity", "thesis method", "robust", "published", "theory", "exact", "verdict"]


class ReproduceTest(SweepTest):
    """Calls on copies of the decks, in a temporary folder."""

    def setUp(self):
        super().setUp()
        for part in ("studies", "published"):
            shutil.copytree(DECKS / part, self.folder / "decks" / part, dirs_exist_ok=True)

    def reproduce(self, *words, code=0):
        return self.expect(code, "reproduce", *words, folder=self.folder)

    def edit(self, name, old, new):
        path = self.folder / name
        text = path.read_text()
        self.assertEqual(text.count(old), 1, (name, old))
        path.write_text(text.replace(old, new))

    def rows(self, *words, code=0):
        """The rows of the table on the terminal, by problem and quantity."""
        lines = self.reproduce(*words, code=code).stdout.splitlines()
        starts = [lines[0].index(name) for name in COLUMNS] + [None]
        cut = [[line[a:b].strip() for a, b in zip(starts, starts[1:])] for line in lines]
        self.assertEqual(cut[0], COLUMNS)
        self.assertRegex(lines[-1], rf"^{len(lines) - 2} rows: \d+ agree, \d+ differ, \d+ are undecided, \d+ are reported$")
        return {(row[0], row[1]): dict(zip(COLUMNS, row)) for row in cut[1:-1]}

    def nothing_written(self):
        return not (self.folder / "out").exists()


class Tables(ReproduceTest):
    def test_what_is_judged_agrees(self):
        rows = self.rows(*QUICK, "--jobs", "2", code=5)
        self.assertEqual({problem for problem, _ in rows}, set(QUICK))
        # The robust method's pressures are the nodes': next to a vacuum they fall over a cell.
        differ = {name for name, row in rows.items() if "differs" in row["verdict"]}
        self.assertEqual(differ, {("gas-expansion", "radius at t = 0"), ("gas-expansion", "pressure at t = 0")})
        self.assertFalse([name for name in differ if "thesis: differs" in rows[name]["verdict"]])
        period = rows["piston-m1", "period"]
        self.assertEqual((period["published"], period["theory"]), ("0.022 (Table 3)", "0.02234 (Table 3)"))
        self.assertAlmostEqual(float(period["thesis method"]), float(period["exact"]), delta=1e-4)
        self.assertIn("thesis: agrees with Table 3 within 2.3 %, agrees with exact within 0.5 %", period["verdict"])
        self.assertIn("theory: agrees with exact within 0.1 %", period["verdict"])
        self.assertEqual(rows["noise", "force at y = 1.8 after"]["robust"], "-")
        self.assertEqual(rows["gas-expansion", "cell size"]["published"], "0.025 (4.2) or 0.05 (Box 2)")
        self.assertIn("agrees with Box 2", rows["gas-expansion", "cell size"]["verdict"])
        print(sum("agrees" in row["verdict"] for row in rows.values()), "of", len(rows), "rows agree", flush=True)

    def test_exact_values_are_those_of_the_deck_that_ran(self):
        self.edit("decks/piston-m1.in", "matr(1,1)=1.58e6", "matr(1,1)=1.738e6")
        self.edit("particles/spring-mass.par", "1.d6,", "1.1d6,")
        rows = self.rows("piston-m1", "spring-mass", code=5)
        period = rows["piston-m1", "period"]
        self.assertAlmostEqual(float(period["exact"]), 0.022347 / 1.1 ** 0.5, delta=1e-5)
        self.assertIn("agrees with exact within 0.5 %", period["verdict"])  # the method follows the deck
        self.assertRegex(period["verdict"], r"thesis: differs from Table 3 by 3\.\d % \(2\.3 % allowed\)")
        self.assertRegex(period["verdict"], r"theory: differs from exact by 4\.\d % \(0\.1 % allowed\)")
        self.assertRegex(rows["spring-mass", "period"]["verdict"], r"thesis: differs from theory by 4\.\d % \(1 % allowed\)")
        self.assertAlmostEqual(float(rows["spring-mass", "period"]["exact"]), 0.020191 / 1.1 ** 0.5, delta=1e-5)
        self.assertEqual(rows["spring-mass", "cross-section"]["verdict"], "both: agrees with 5.5.2 within 0.0001 %")

    def test_every_problem_disagrees_with_a_tenth_more_of_its_modulus(self):
        """Real runs of those that are quick; the decks of all are judged by unit.studies.Stiffer."""
        for name in ("sod", "sod-continuity", "sod-cell"):
            self.edit(f"decks/{name}.in", "siep(1)=2.50, siep(2)=2.0", "siep(1)=2.75, siep(2)=2.2")
        self.edit("decks/gas-expansion.in", "siep(1)=250.0", "siep(1)=275.0")
        for name in ("spring-mass", "string-mass"):
            path = self.folder / f"particles/{name}.par"
            path.write_text(re.sub(r"1\.0?d6", "1.1d6", path.read_text(), count=1))
        path = self.folder / "particles/pendulum-20.par"
        path.write_text(re.sub(r"\b1\.0*d\+?0?6", "1.1d6", path.read_text(), count=1))
        for name in ("piston-m01", "piston-m1"):
            self.edit(f"decks/{name}.in", "matr(1,1)=1.58e6", "matr(1,1)=1.738e6")
        names = ["sod", "gas-expansion", "string-mass", "piston-m1"]
        if FULL:
            names = [name for name in QUICK if name != "noise" and not name.startswith("stability")]
        rows = self.rows(*names, "--jobs", "2", code=5)
        for name in names:
            said = [row["verdict"] for (problem, _), row in rows.items() if problem == name]
            self.assertTrue(any("differs" in verdict for verdict in said), (name, said))

    def test_a_run_that_does_not_show_it_is_no_value(self):
        self.edit("decks/spring-mass.in", "tmax=0.101d0", "tmax=1.0d-3")
        rows = self.rows("spring-mass", code=5)
        self.assertIn("no value: the run does not show it", rows["spring-mass", "period"]["verdict"])
        self.assertEqual(rows["spring-mass", "period"]["thesis method"], "-")

    def test_a_run_that_fails_is_told_with_its_reason(self):
        self.edit("decks/spring-mass.in", "xright=0.100e0", "xright=0.040e0")
        rows = self.rows("spring-mass", code=5)
        self.assertRegex(rows["spring-mass", "period"]["verdict"], r"no value: .*(grid|outside)")

    def test_chaotic_cases_are_run_ten_times(self):
        rows = self.rows("two-bar", "--jobs", "2")
        for column in ("thesis method", "robust"):
            self.assertRegex(rows["two-bar", "restitution"][column], r"^0\.\d+ \+- [\d.e-]+ \(10\)$")
        velocity = rows["two-bar", "velocity of the left bar"]
        spread = float(re.search(r"\+- (\S+)", velocity["thesis method"]).group(1))
        self.assertEqual("undecided" in velocity["verdict"], spread > 0.05)  # half of .3's last digit
        steps = set()
        for run in (self.folder / "out/reproduce/two-bar").glob("thesis-*/runs/*/*/summary.txt"):
            steps.add(re.search(r"^dt_min = (.*)$", run.read_text(), re.MULTILINE).group(1))
        self.assertEqual(len(steps), 10)

    def test_a_dry_run_lists_and_writes_nothing(self):
        listed = self.reproduce("spring-mass", "stability-side", "--dry-run").stdout.splitlines()
        self.assertTrue(self.nothing_written())
        self.assertRegex(listed[0], r"^to run   decks/spring-mass\.in mpm\.method='thesis'$")
        self.assertEqual(listed[1], "to run   decks/spring-mass.in mpm.method='robust' points.pinned(1)=.true.")
        self.reproduce("spring-mass")
        again = self.reproduce("spring-mass", "--dry-run").stdout.splitlines()
        self.assertTrue(all(line.startswith("finished ") for line in again), again)

    def test_quiet_tells_of_what_disagrees_alone(self):
        result = self.reproduce("noise", "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        self.edit("particles/noise.par", "1.8000001", "1.8100001")  # point 6 does not cross
        result = self.reproduce("noise", "--quiet", code=5)
        self.assertEqual(result.stdout, "")
        lines = result.stderr.splitlines()
        self.assertTrue(lines and all(line.startswith("reproduce: error: noise, force at y = ") for line in lines))


class Runs(ReproduceTest):
    def records(self):
        return {path: path.stat().st_mtime_ns for path in (self.folder / "out").glob("**/run.txt")}

    def test_finished_runs_are_not_run_again(self):
        first = self.rows("spring-mass")
        before = self.records()
        self.assertEqual(len(before), 2)
        self.assertEqual(self.rows("spring-mass"), first)
        self.assertEqual(self.records(), before)
        self.edit("decks/spring-mass.in", "tstep=0.18d-5", "tstep=0.17d-5")
        self.reproduce("spring-mass")
        self.assertEqual(len(self.records()), 4)

    def test_the_number_of_jobs_changes_nothing(self):
        alone = self.rows("spring-mass", "sod-continuity", "--jobs", "1", "--out", "one")
        self.assertEqual(self.rows("spring-mass", "sod-continuity", "--jobs", "3", "--out", "three"), alone)

    def test_an_interrupted_call_goes_on(self):
        process = self.start("reproduce", "spring-mass", "pendulum-320", "--jobs", "1", folder=self.folder)
        slow = self.folder / "out/reproduce/pendulum-320"
        wait_until(lambda: list(slow.glob("**/history.txt")), "the history of pendulum-320", process)
        stdout, stderr = self.stop(process)
        self.assertEqual(stdout, "")
        self.assertIn("interrupted; the same command goes on", stderr)
        self.assertEqual(len(self.records()), 2)
        self.assertEqual(len(list(slow.glob("**/checkpoint-1.nc"))), 1)


class Markdown(ReproduceTest):
    def test_names_decks_and_overrides(self):
        self.reproduce("spring-mass", "--quiet", "--write", "table.md")
        text = (self.folder / "table.md").read_text()
        self.assertIn("| problem | quantity | thesis method | robust | published | theory | exact | verdict |\n", text)
        self.assertRegex(text, r"\| spring-mass \| period \| 0\.0198\d+ \| 0\.0\d+ \| - \| 0\.019859 \(5\.11\) \| 0\.020191 \| "
                         r"thesis: agrees")
        self.assertIn("| spring-mass | thesis 5.5, Fig. 26 | spring-mass.in | as it is | points.pinned(1)=.true. |\n", text)
        self.assertIn("`" + TETHER + " reproduce spring-mass --quiet --write table.md`", text)

    def test_a_place_that_takes_no_file_is_told_before_the_first_run(self):
        for place, told in (("none/table.md", "there is no folder none"), ("decks", "decks: is a folder")):
            self.assertIn(told, self.reproduce("spring-mass", "--write", place, code=4).stderr)
        self.assertTrue(self.nothing_written())


class Refusals(ReproduceTest):
    def test_names_that_there_are_not(self):
        text = self.reproduce("sod", "pendulm-20", code=2).stderr
        self.assertIn("error: there is no published problem 'pendulm-20' (did you mean pendulum-20?)", text)
        self.assertIn("The problems are ", text)
        self.assertTrue(self.nothing_written())

    def test_a_folder_without_decks(self):
        text = self.reproduce("sod", "--decks", "nowhere", code=2).stderr
        self.assertIn("there is no folder nowhere with the decks", text)
        self.assertIn("--decks DIR", text)

    def test_decks_that_are_missing(self):
        os.remove(self.folder / "decks/sod.in")
        text = self.reproduce("sod", code=2).stderr
        self.assertIn("there is no published problem 'sod'", text)
        errors = diagnostics(self.reproduce("sod-continuity", "spring-mass", code=2).stderr)
        self.assertEqual([pathlib.Path(head["file"]).name for head, _ in errors], ["sod-continuity.in"])
        self.assertIn("decks/sod.in: cannot be opened", errors[0][0]["text"])
        self.assertTrue(self.nothing_written())

    def test_a_deck_of_ones_own(self):
        shutil.copy(self.folder / "decks/spring-mass.in", self.folder / "mine.in")
        self.edit("mine.in", "../particles", "particles")
        rows = self.rows("mine.in")
        self.assertEqual({problem for problem, _ in rows}, {"mine"})
        self.edit("mine.in", "exact(1)='exact_period'", "exact(1)='exactly_period'")
        self.assertIn("no number exactly_period", self.rows("mine.in", code=5)["mine", "period"]["verdict"])

    def test_mistakes_of_the_group(self):
        self.edit("decks/spring-mass.in", "is(1)='period'", "is(1)='lasst(time)'")
        errors = diagnostics(self.reproduce("spring-mass", code=2).stderr)
        self.assertEqual(len(errors), 1)
        self.assertIn("there is no function lasst", errors[0][0]["text"])
        self.assertTrue(self.nothing_written())

    def test_a_deck_with_mistakes(self):
        self.edit("decks/spring-mass.in", "nx=2,", "nx=1,")
        errors = [head for head, _ in diagnostics(self.reproduce("spring-mass", code=2).stderr)]
        self.assertEqual([(pathlib.Path(head["file"]).name, head["text"].split(" is ")[0]) for head in errors],
                         [("spring-mass.in", "nx = 1")])
        self.assertTrue(self.nothing_written())

    def test_help(self):
        text = self.reproduce("--help").stdout
        for option in ("--decks", "--write", "--out", "--jobs", "--quiet", "--dry-run"):
            self.assertIn(option, text)


if __name__ == "__main__":
    unittest.main()
