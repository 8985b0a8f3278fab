#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when a source is not formatted as .clang-format says, lacks its licence line, or is longer than it may be."""
import pathlib
import subprocess
import sys

LONGEST_FILE = 300


def main():
    sources = sorted(p for folder in ("src", "tests") for s in ("*.hpp", "*.cpp") for p in pathlib.Path(folder).rglob(s))
    scripts = sorted(p for folder in ("post", "tests") for p in pathlib.Path(folder).rglob("*.py"))
    found = []
    for path in sources + scripts:
        lines = path.read_text().splitlines()
        if "SPDX-License-Identifier: GPL-3.0-or-later" not in "\n".join(lines[:2]):
            found.append(f"{path}:1: no SPDX line")
        if len(lines) > LONGEST_FILE:
            found.append(f"{path}: {len(lines)} lines, more than {LONGEST_FILE}")
    result = subprocess.run(["clang-format", "--dry-run", "-Werror", *map(str, sources)], capture_output=True, text=True)
    found += result.stderr.splitlines()
    print("\n".join(found) if found else f"{len(sources)} sources, {len(scripts)} scripts")
    return 1 if found or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
