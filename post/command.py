# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands share that read something and write files: messages, and exit codes.

Exit codes: 0 done, 2 what is to be read has nothing for the command, 4 a file could not be written.
"""
import subprocess
import sys

import style
import tether_results
import titles


class Refused(Exception):
    """The text says why nothing can be made of what was given."""


def run(name, work):
    """Prints what `work` yields, paths of files and lines of text, and returns the exit code of the command."""
    style.use()
    try:
        for path in work():
            print(path)
    except (tether_results.NotARun, Refused) as mistake:
        print(f"{name}: {mistake}", file=sys.stderr)
        return 2
    except (OSError, subprocess.CalledProcessError) as reason:
        print(f"{name}: {reason}", file=sys.stderr)
        return 4
    return 0


def title_of(path):
    """The title of a figure of a study from its file."""
    with tether_results.open_dataset(path) as data:
        return titles.title(path.absolute().parent.name, getattr(data, "title", ""))


def save(path, write):
    """Makes the folder of a file, has `write` make the file, and yields its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write(path)
    yield path


def draw(name, figure_of, path):
    """Saves the figure that `figure_of` returns, and returns the exit code of the command."""
    return run(name, lambda: save(path, figure_of().savefig))
