# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands of post/ as users call them. By default most are called in the test's own process: a start of Python and of
the packages that they need takes longer than what they do."""
import contextlib
import importlib
import io
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
POST = ROOT / "post"
sys.path[:0] = [str(POST), str(ROOT / "tests" / "program")]

from full_length import FULL
from matplotlib import pyplot


def call(name, *words, alone=FULL):
    """The command post/<name>.py with these words, to its end; `alone` it has a process of its own."""
    words = [str(word) for word in words]
    if alone:
        return subprocess.run([sys.executable, POST / f"{name}.py", *words], capture_output=True, text=True)
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        try:
            code = importlib.import_module(name).main(words)
        except SystemExit as end:
            code = end.code
    pyplot.close("all")
    return subprocess.CompletedProcess([name, *words], code, out.getvalue(), error.getvalue())
