#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The order check must find what it is there for."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).with_name("check_order.py")


class OrderCheck(unittest.TestCase):
    def run_on(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, "src", name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            result = subprocess.run([sys.executable, CHECK, f"{folder}/src"], capture_output=True, text=True)
            return result.returncode, result.stdout

    def test_accepts_the_one_way(self):
        code, _ = self.run_on({"grid/g.hpp": '#include "base/b.hpp"\nint f();\n', "base/b.hpp": "const int n = 1;\n"})
        self.assertEqual(code, 0)

    def test_refuses_an_include_that_points_down(self):
        code, text = self.run_on({"base/b.hpp": '#include "grid/g.hpp"\n', "grid/g.hpp": "\n"})
        self.assertEqual(code, 1)
        self.assertIn("b.hpp:1", text)

    def test_refuses_one_path_in_another_that_stands_before_it(self):
        code, _ = self.run_on({"physics/points/a.hpp": '#include "physics/solids/b.hpp"\n', "physics/solids/b.hpp": "\n"})
        self.assertEqual(code, 1)

    def test_refuses_a_circle(self):
        code, text = self.run_on({"grid/a.hpp": '#include "grid/b.hpp"\n', "grid/b.hpp": '#include "grid/a.hpp"\n'})
        self.assertEqual(code, 1)
        self.assertIn("circle", text)

    def test_refuses_a_circle_by_way_of_a_source(self):
        code, text = self.run_on({"grid/a.hpp": '#include "grid/b.hpp"\n', "grid/b.cpp": '#include "grid/a.hpp"\n',
                                  "grid/b.hpp": "\n"})
        self.assertEqual(code, 1)
        self.assertIn("circle: grid/a -> grid/b -> grid/a", text)

    def test_refuses_a_solver_that_sees_the_deck_through_a_header(self):
        code, text = self.run_on({"physics/points/a.cpp": '#include "plan/p.hpp"\n', "deck/d.hpp": "\n",
                                  "plan/p.hpp": '#include "deck/d.hpp"\n'})
        self.assertEqual(code, 1)
        self.assertIn("physics/points/a.cpp: must not see the deck", text)

    def test_refuses_a_mutable_global(self):
        for line in ("int counter = 0;", "static double x;", "std::vector<int> all{1};", "inline int n = 3;"):
            self.assertEqual(self.run_on({"base/b.cpp": line + "\n"})[0], 1, line)

    def test_refuses_two_types_of_one_name_in_a_namespace(self):
        here, there = "namespace a {\nstruct B {\n  int x;\n};\n}  // namespace a\n", "namespace a {\nclass B : public C {\n};\n}\n"
        code, text = self.run_on({"base/b.hpp": here, "grid/b.hpp": there})
        self.assertEqual(code, 1)
        self.assertIn("grid/b.hpp:2: a::B is a type of", text)
        self.assertEqual(self.run_on({"base/b.hpp": here, "grid/b.hpp": here.replace("namespace a", "namespace c")})[0], 0)
        hidden = "namespace a {\nnamespace {\nstruct B {};\n}  // namespace\n}  // namespace a\n"
        self.assertEqual(self.run_on({"base/b.cpp": hidden, "grid/b.cpp": hidden})[0], 0)
        self.assertEqual(self.run_on({"base/b.hpp": here, "grid/b.hpp": "namespace a {\nstruct B;\n}  // namespace a\n"})[0], 0)

    def test_refuses_an_empty_folder(self):
        self.assertEqual(self.run_on({"notes.txt": ""})[0], 1)


if __name__ == "__main__":
    unittest.main()
