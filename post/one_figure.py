# SPDX-License-Identifier: GPL-3.0-or-later
"""What the commands share that draw one figure of one table: messages, exit codes, where the figure goes.

Exit codes: 0 done, 2 the file has nothing to draw, 4 the figure could not be written.
"""
import sys

import tether_results
import style


class NothingToDraw(Exception):
    """The text says what the table lacks."""


def make(command, draw, path):
    """Writes the figure that `draw` returns, names its path, and returns the exit code of the command."""
    style.use()
    try:
        figure = draw()
    except (tether_results.NotARun, NothingToDraw) as mistake:
        print(f"{command}: {mistake}", file=sys.stderr)
        return 2
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path)
    except OSError as reason:
        print(f"{command}: {reason}", file=sys.stderr)
        return 4
    print(path)
    return 0
