# SPDX-License-Identifier: GPL-3.0-or-later
"""tether chart: error against cost of a scene's families of runs, and the chart decks that it refuses."""
import shutil
import unittest

from program import DECKS, ProgramTest, netcdf
from sweeps import rows_of

BAR = """decks='../paths/bar.in', mode='chart', set='in.tmax=.0948683298050514'
is='first(body_y_1) - last(body_y_1)'
"""
EXACT = "exact='1.e-3/(3*1000)'\n"  # at t = 3 L/c
ELEMENTS = """family(1)='elements', family_set(1,1)="in.path='fem'"
cells(1,1)='mesh.cells(2,1)=5,10,20,40', 'in.tstep=2.d-3,1.d-3,5.d-4,2.5d-4', space_order(1)=2.
steps(1,1)='in.tstep=4.d-3,2.d-3,1.d-3', step_order(1)=2.
"""
DEAR = """family(1)='elements', family_set(1,1)="in.path='fem'"
cells(1,1)='mesh.cells(2,1)=20,40', 'in.tstep=2.5d-4,1.25d-4', space_order(1)=2.
"""
POINTS = """family(2)='points', family_set(1,2)="in.path='mpm'"
cells(1,2)='in.ny=13,25,49', 'in.nx=2,3,5'
"""


class ChartTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "charts").mkdir()
        shutil.copytree(DECKS / "paths", self.folder / "paths")
        self.out = self.folder / "out"

    def chart(self, text, *options, code=0):
        deck = self.write("charts/chart.in", f"a chart\n$study\n{text}$\n")
        return self.expect(code, "chart", deck, "--out", self.out, *options)


class Charts(ChartTest):
    def test_families_are_set_against_cost(self):
        report = self.chart(BAR + EXACT + ELEMENTS + POINTS + "setting=1,4\n").stdout
        self.assertEqual(report, (self.out / "chart.txt").read_text())
        rows = rows_of(self.out / "chart.csv")
        self.assertEqual([(row["family"], row["of"]) for row in rows],
                         [("elements", "cells")] * 4 + [("elements", "steps")] * 3 + [("points", "cells")] * 3)
        errors = [float(row["error"]) for row in rows]
        exact = 1e-3 / 3000
        for row, error in zip(rows, errors):
            self.assertAlmostEqual(abs(float(row["value"]) - exact) / exact, error, delta=1e-9)
        self.assertGreater(errors[0] / errors[1], 3)
        self.assertGreater(errors[2] / errors[3], 3)
        self.assertLess(errors[3], .003)
        self.assertIn("answer 3.3333333e-07, exact", report)
        self.assertRegex(report, r"elements: (1\.[89]|2\.[012])\d \(2 by theory\); (1\.[89]|2\.[012])\d \(2 by theory\)")
        self.assertRegex(report, r"points: .*; not studied")
        self.assertRegex(report, r"published setting: run 4, elements: mesh\.cells\(2,1\)=40, error")
        self.assertIn("the cheapest choice for a lasting error of\n    10 %  ", report)
        table = netcdf(self.out / "chart.nc")
        self.assertEqual([float(row["error"]) for row in rows], list(table["error"]))

    def test_a_shifted_path_leaves_the_front(self):
        """Elements that cost several times as much as points leave them on the front."""
        honest = self.chart(BAR + EXACT + DEAR + POINTS, "--quiet")
        self.assertEqual(honest.stdout, "")
        front = lambda: (self.out / "chart.txt").read_text().split("and seconds:\n")[1].split("\n\n")[0]
        near = [line for line in front().splitlines() if "points" in line and float(line.split()[0]) < 3]
        self.assertNotEqual(near, [])
        shifted = POINTS.replace("""in.path='mpm'\"""", """in.path='mpm'", 'in.gravc=-1.05e-3'""")
        self.assertNotEqual(shifted, POINTS)
        self.chart(BAR + EXACT + DEAR + shifted, "--quiet")
        for line in front().splitlines():  # where elements are not yet as near, it may be the cheapest
            if "points" in line:
                self.assertGreater(float(line.split()[0]), 3)

    def test_an_answer_may_be_that_of_the_finest_runs(self):
        report = self.chart(BAR + "exact='converged'\n" + ELEMENTS).stdout
        answer = float(report.split("answer ")[1].split(" ")[0])
        self.assertAlmostEqual(answer, 1e-3 / 3000, delta=2e-3 * 1e-3 / 3000)
        self.assertRegex(report, r"answer .* \+- .*, converged: what the cells of elements lead to, by Richardson")

    def test_an_answer_that_a_family_contradicts_is_said_and_can_be_named(self):
        others = ELEMENTS.replace("(1)", "(2)").replace("(1,1)", "(1,2)").replace("'elements'", "'heavier'")
        others = others.replace('''"in.path='fem'"''', '''"in.path='fem'", 'in.gravc=-1.05e-3' ''')
        report = self.chart(BAR + "exact='converged', answer_by=1\n" + ELEMENTS + others).stdout
        self.assertRegex(report, r"answer 3\.33\d*e-07 .* of elements lead to")
        self.assertIn("heavier leads elsewhere, by more than both bounds", report)
        bound = float(report.split("+- ")[1].split(",")[0]) / 1e-3 * 3000
        lasting = [float(row["lasting_error"]) for row in rows_of(self.out / "chart.csv") if row["lasting_error"]]
        self.assertGreaterEqual(min(lasting), .97 * bound)

    def test_errors_of_an_answer_of_nothing_are_sizes(self):
        report = self.chart(BAR + "exact='0.'\n" + ELEMENTS).stdout
        self.assertIn("answer 0, exact; errors are absolute", report)
        row = rows_of(self.out / "chart.csv")[0]
        self.assertEqual(float(row["error"]), float(row["value"]))

    def test_values_that_no_run_shows_are_said(self):
        report = self.chart(BAR.replace("first(body_y_1)", "sqrt(-1.) + first(body_y_1)") + EXACT + POINTS, code=5).stdout
        self.assertIn("run 3 ended well, and does not show the number that is read off", report)

    def test_equal_runs_are_made_once(self):
        steps = POINTS + "steps(1,2)='in.tstep=5.d-4,2.5d-4,1.25d-4'\n"
        self.assertEqual(self.chart(BAR + EXACT + steps, "--dry-run").stdout.count("to run"), 5)
        self.chart(BAR + EXACT + steps, "--quiet")
        rows = rows_of(self.out / "chart.csv")
        self.assertEqual((len(rows), rows[1]["folder"]), (6, rows[3]["folder"]))

    def test_families_may_have_decks_of_their_own(self):
        (self.folder / "paths/other.in").write_text((self.folder / "paths/bar.in").read_text().replace("gravc=-1.e-3", "gravc=-2.e-3"))
        text = BAR.replace("'../paths/bar.in'", "'../paths/bar.in','../paths/other.in'") + EXACT + POINTS
        self.chart(text + "family_deck(2)=2\n", "--quiet")
        heavy = [float(row["value"]) for row in rows_of(self.out / "chart.csv")]
        self.chart(text, "--quiet")
        for twice, once in zip(heavy, rows_of(self.out / "chart.csv")):
            self.assertAlmostEqual(twice / float(once["value"]), 2, delta=.02)

    def test_steps_that_a_limit_cuts_are_said(self):
        text = POINTS + "steps(1,2)='in.tstep=4.d-1,2.d-1,1.d-1'\n"
        self.assertIn("a limit cuts the steps", self.chart(BAR + EXACT + text).stdout)

    def test_it_goes_on_where_it_was_stopped(self):
        text = BAR + EXACT + ELEMENTS
        self.assertEqual(self.chart(text, "--dry-run").stdout.count("to run"), 7)
        self.chart(text, "--quiet")
        self.assertEqual(self.chart(text, "--dry-run").stdout.count("finished"), 7)

    def test_runs_that_fail_are_told_and_count_nowhere(self):
        text = BAR.replace(".0948683298050514", "1.") + """exact='1.'
family(1)='short steps', family_set(1,1)="in.path='mpm'"
cells(1,1)='in.ny=13,25'
family(2)='too long steps', family_set(1,2)="in.path='mpm'", 'mpm.cfl=0.', 'in.tstep=.01'
cells(1,2)='in.ny=13,25'
"""
        result = self.chart(text, code=5)
        self.assertRegex(result.stdout, r"run 4 failed: ")
        self.assertNotIn("too long steps: in.ny", result.stdout)


class BadCharts(ChartTest):
    """Refused before the first run, all mistakes at once, and nothing is written."""

    CASES = (
        (BAR + EXACT + ELEMENTS.replace("cells(1,1)='mesh", "cells(1,1)='mush"), "Did you mean '$mesh'?", 7),
        (BAR + EXACT + ELEMENTS.replace("=5,10,20,40'", "=5,20,10,40'"), "10 does not make the runs finer", 7),
        (BAR + EXACT + ELEMENTS.replace(",2.5d-4'", "'"), "it has 3 values, the first of family 1 has 4", 7),
        (BAR + EXACT + ELEMENTS.replace("""'fem'\"""", """'fem'", 'in.tstep=1.'"""), "in.tstep is set by family_set(2,1), too", 7),
        (BAR + EXACT + ELEMENTS + "cells(1,4)='in.nx=5,9'\n", "there is no family 4", 9),
        (BAR + EXACT + ELEMENTS + "setting=1,5\n", "there is no such run", 9),
        (BAR + EXACT + ELEMENTS + POINTS.replace("'points'", "'elements'"), "two families are called 'elements'", 9),
        (BAR.replace("last(body_y_1)", "last(body_q_1)") + EXACT + ELEMENTS, "no run's history.txt has a column 'body_q_1'", 4),
        (BAR + "exact='1 + error_perod'\n" + ELEMENTS, "no run writes error_perod into its summary", 5),
        (BAR + EXACT + ELEMENTS.replace("family_set(1,1)", "family_deck(1)=2, family_set(1,1)"), "there is no deck 2", 6),
        (BAR + EXACT + ELEMENTS + "answer_by=1\n", "the answer is given: no family is asked for it", 9),
        (BAR.replace("set='in.tmax", "set='mesh.cells(2,1)=3', 'in.tmax") + EXACT + ELEMENTS, "mesh.cells(2,1) is set by set(1), too", 7),
        (BAR + EXACT + "family(1)='none'\n", "a study of mode 'chart' needs cells", 3),
        (BAR + ELEMENTS, "a study of mode 'chart' needs exact", 3),
        (BAR.replace("last(body_y_1)", "lost(body_y_1)") + EXACT + ELEMENTS, "Did you mean 'last'?", 4),
        (BAR + EXACT + ELEMENTS + "axis(1)='in.nx=5,9'\n", "axis is not for mode 'chart'", 9),
        (BAR + EXACT + ELEMENTS + POINTS.replace("in.path='mpm'", "reg.ipath(4,1)=7"), "family 2 cannot be run", 9),
    )

    def test_each_is_refused_at_its_place(self):
        self.assert_refused(self.CASES, lambda text: self.chart(text, code=2), self.out)

    def test_a_sweep_is_no_chart_and_a_chart_no_sweep(self):
        self.chart(BAR + EXACT + ELEMENTS, "--dry-run")
        result = self.expect(2, "sweep", self.folder / "charts/chart.in")
        self.assertIn("this study is a chart", result.stderr)
        result = self.expect(2, "chart", DECKS / "studies/stability.in")
        self.assertIn("this study is no chart", result.stderr)


class ShippedCharts(ProgramTest):
    def test_each_can_be_run(self):
        for chart in sorted((DECKS / "charts").glob("*.in")):
            with self.subTest(chart=chart.name):
                self.assertIn("to run", self.expect(0, "chart", chart, "--dry-run", folder=self.folder).stdout)


if __name__ == "__main__":
    unittest.main()
