#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where hot code would run as a room that is compiled with less care has made it: check_levels.py MAP HOT.a...

A template's function is compiled in each source that uses it, and the linker keeps one of them. MAP is the linker's map of
the program; of what the archives of the hot rooms have compiled, theirs must be the one that was kept. Judged are functions
of tether and of Eigen: no run spends its seconds in those of strings.
"""
import pathlib
import re
import subprocess
import sys

KEPT_FROM = "Linker script and memory map"
SECTION = re.compile(r"^ \.text\.(\S+)\s+0x[0-9a-f]+\s+0x[0-9a-f]+ (.+)$", re.MULTILINE)
JUDGED = ("5Eigen", "6tether")  # as names of functions have them
WEAK = re.compile(r"^[0-9a-f]+ [WVu] (\S+)$", re.MULTILINE)


def weak_functions(archives):
    """Names of what the archives may share with other sources."""
    listing = subprocess.run(["nm", "--defined-only", *archives], capture_output=True, text=True, check=True).stdout
    return {name for name in WEAK.findall(listing) if any(space in name for space in JUDGED)}


def kept(text):
    """(function, file) of each section of code that is in the program."""
    if KEPT_FROM not in text:
        raise SystemExit("check_levels.py: this is no map of GNU ld's")
    return SECTION.findall(text[text.index(KEPT_FROM):])


def main(words):
    path, *archives = words
    hot_names = {pathlib.Path(archive).name for archive in archives}
    functions = weak_functions(archives)
    sections = [(name, file) for name, file in kept(pathlib.Path(path).read_text()) if name in functions]
    cold = [(name, file) for name, file in sections if pathlib.Path(file.partition("(")[0]).name not in hot_names]
    for name, file in cold:
        print(f"{file}: its {name} runs in place of the one that a hot room has compiled")
    if not cold:
        print(f"{len(sections)} functions that hot rooms share with others are theirs")
    return 1 if cold or not sections else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
