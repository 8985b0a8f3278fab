#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The check of levels must find a cold function in a hot place."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).with_name("check_levels.py")
SHARED = "namespace tether { template <class T> [[gnu::noinline]] T twice(T x) { return x + x; } }\nusing tether::twice;\n"


class LevelsCheck(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="names with spaces ")
        self.addCleanup(self.folder.cleanup)
        self.compiled("main", "int hot(int); int cold(int); int main() { return hot(1) + cold(2); }", "-O1")
        self.archive("hot", SHARED + "int hot(int x) { return twice(x); }", "-O3")
        self.archive("cold", SHARED + "int cold(int x) { return twice(x); }", "-O1")

    def run_here(self, *words):
        return subprocess.run(words, cwd=self.folder.name, capture_output=True, text=True, check=True)

    def compiled(self, name, text, level):
        pathlib.Path(self.folder.name, f"{name}.cpp").write_text(text)
        self.run_here("g++", level, "-c", f"{name}.cpp")

    def archive(self, name, text, level):
        self.compiled(name, text, level)
        self.run_here("ar", "rcs", f"lib{name}.a", f"{name}.o")

    def check_of(self, *linked):
        paths = [pathlib.Path(self.folder.name, name) for name in linked]
        self.run_here("g++", "-o", "program", "main.o", *paths, "-Wl,-Map=program.map")
        return subprocess.run([sys.executable, CHECK, "program.map", "libhot.a"], cwd=self.folder.name,
                              capture_output=True, text=True)

    def test_accepts_what_hot_rooms_have_compiled(self):
        result = self.check_of("libhot.a", "libcold.a")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("1 functions", result.stdout)

    def test_refuses_what_another_room_has_compiled(self):
        result = self.check_of("libcold.a", "libhot.a")
        self.assertEqual(result.returncode, 1)
        self.assertIn("libcold.a", result.stdout)
        self.assertIn("twice", result.stdout)

    def test_refuses_what_is_no_map(self):
        result = subprocess.run([sys.executable, CHECK, "main.cpp", "libhot.a"], cwd=self.folder.name,
                                capture_output=True, text=True)
        self.assertNotEqual(result.returncode, 0)


if __name__ == "__main__":
    unittest.main()
