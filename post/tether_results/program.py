# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs made from scripts: the program is called with a deck and values that take the place of the deck's."""
import os
import shutil
import subprocess
from pathlib import Path

from .folder import open as open_folder

ROOT = Path(__file__).resolve().parents[2]
NEAR = (ROOT / "build" / "release" / "tether", ROOT.parents[1] / "bin" / "tether")  # in a built tree, and where it is installed


class NoProgram(Exception):
    """There is no program to run; the text says how to get it."""


class RunFailed(Exception):
    """The program ended with an error; the text is the program's, exit_code its code."""

    def __init__(self, deck, exit_code, message):
        super().__init__(f"{deck} failed with exit code {exit_code}:\n{message}")
        self.exit_code, self.message = exit_code, message


def in_namelist(value):
    """A Python value as a deck has it: texts in quotes, .true., lists with commas."""
    if isinstance(value, bool):
        return ".true." if value else ".false."
    if isinstance(value, str):
        quote = '"' if "'" in value else "'"
        return f"{quote}{value}{quote}"
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist") and getattr(value, "ndim", 0):
        return ",".join(in_namelist(part) for part in value)
    return repr(value.item() if hasattr(value, "item") else value)


def find_program(program=None):
    """The path of the program: this one, that of $TETHER, the build's or the installed one, or the one that the
    shell finds."""
    given = program or os.environ.get("TETHER")
    on_path = shutil.which("tether")
    places = [Path(given)] if given else [*NEAR, *([Path(on_path)] if on_path else [])]
    found = next((place for place in places if place.is_file()), None)
    if found is None:
        raise NoProgram(f"{places[0]}: is not there; install the package, or build it with ./quickstart build")
    return found


def call(program, deck, words, out):
    """Runs a deck into a folder; words are options of the command line. Raises RunFailed."""
    done = subprocess.run([program, deck, "--quiet", "--out", out, *words], capture_output=True, text=True)
    if done.returncode != 0:
        raise RunFailed(deck, done.returncode, done.stderr.strip())


def run(deck, values=None, out=None, program=None, threads=None):
    """Runs a deck with these values in place of its own, `group.name` -> value, and returns the opened run."""
    out = Path(out) if out else Path("out") / Path(deck).stem
    words = [word for name, value in (values or {}).items() for word in ("--set", f"{name}={in_namelist(value)}")]
    if threads:
        words += ["--threads", str(threads)]
    call(find_program(program), deck, words, out)
    return open_folder(out)
