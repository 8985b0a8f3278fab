#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every seeded fault must be one of src/ as it is, and a copy with faults must say what is wrong with its rows."""
import dataclasses
import pathlib
import tempfile
import unittest

import seeded_fault_runs
from seeded_faults import HEADER, SRC, Fault, WrongRow, checked, faults, with_faults, write_copy

ROW = Fault("no-sum", "a/b.cpp", "sum += part;", "if (!FAULT) sum += part;", "dropped term", "the sum is 0")


class Tables(unittest.TestCase):
    def test_every_row_is_a_fault_of_src(self):
        rows = faults()
        self.assertGreaterEqual(len(rows), 40)
        with_faults(SRC, rows)


class Copies(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.src, self.copy = pathlib.Path(folder.name, "src"), pathlib.Path(folder.name, "copy")
        (self.src / "a").mkdir(parents=True)
        (self.src / "a" / "b.cpp").write_text("// licence\nvoid f() { sum += part; }\n")
        (self.src / "c.cpp").write_text("// licence\n")

    def test_has_the_fault_to_be_chosen_and_the_other_files_as_they_are(self):
        write_copy(self.src, self.copy, [ROW])
        self.assertEqual((self.copy / "a" / "b.cpp").read_text(),
                         f'// licence\n#include "{HEADER}"\nvoid f() {{ if (!tether::seeded_fault("no-sum")) sum += part; }}\n')
        self.assertEqual((self.copy / "c.cpp").read_text(), "// licence\n")
        self.assertIn("TETHER_FAULT", (self.copy / HEADER).read_text())

    def test_touches_only_what_has_changed(self):
        write_copy(self.src, self.copy, [ROW])
        before = {path: path.stat().st_mtime_ns for path in self.copy.rglob("*.cpp")}
        (self.src / "a" / "b.cpp").write_text("// licence\nvoid g() { sum += part; }\n")
        (self.copy / "old.cpp").write_text("")
        write_copy(self.src, self.copy, [ROW])
        changed = [path.name for path, time in before.items() if path.stat().st_mtime_ns != time]
        self.assertEqual(changed, ["b.cpp"])
        self.assertFalse((self.copy / "old.cpp").exists())

    def test_refuses_a_row_whose_text_does_not_stand_there_once(self):
        for text, count in (("sum -= part;", 0), ("m", 2)):
            (self.src / "a" / "b.cpp").write_text("sum += part; m")
            with self.assertRaisesRegex(WrongRow, f"no-sum: its text stands {count} times in src/a/b.cpp"):
                with_faults(self.src, [Fault("no-sum", "a/b.cpp", text, "FAULT", "sign", "")])

    def test_refuses_a_row_that_asks_for_no_fault(self):
        with self.assertRaisesRegex(WrongRow, "FAULT must stand once"):
            checked(Fault("no-sum", "a/b.cpp", "sum += part;", "sum -= part;", "sign", ""))


class Runs(unittest.TestCase):
    def test_the_room_comes_first_then_what_is_likely_and_the_cheapest_before_the_others(self):
        expected = {"unit.physics.RigidTop.A": 9, "unit.physics.Other.A": 2, "unit.physics": 3, "cases.RigidTop.A": 8,
                    "cases.A": 0.5, "unit.base.Text.A": 1}
        fault = dataclasses.replace(ROW, file="physics/rigid/b.cpp", likely="rigid|top")
        self.assertEqual(seeded_fault_runs.in_order(sorted(expected), expected, fault), list(expected))

    def test_cheap_tests_share_a_run(self):
        costs = {"a": 1, "b": 19, "c": 25, "d": 1}
        self.assertEqual(list(seeded_fault_runs.batches(list(costs), costs)), [["a", "b"], ["c"], ["d"]])


if __name__ == "__main__":
    unittest.main()
