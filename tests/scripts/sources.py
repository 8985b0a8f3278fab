# SPDX-License-Identifier: GPL-3.0-or-later
"""What the checks of sources share: the files, and how a check ends."""
import pathlib
import sys


def sources():
    """The folder that the command line names, src without one, and its sources in order."""
    src = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "src")
    return src, sorted(path for pattern in ("*.hpp", "*.cpp") for path in src.rglob(pattern))


def end(found, files, praise):
    """Prints what was found, else the praise, and returns the exit code; 1 where there was nothing to look at, too."""
    if not files:
        found = ["no sources"]
    print("\n".join(found) if found else f"{len(files)} files {praise}")
    return 1 if found else 0
