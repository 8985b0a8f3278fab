# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a steady or static run, which has no history worth a curve: a table of its last record."""
import textwrap

import numpy

import style

LONGEST = 80  # letters of what a number is
FEW = 3  # records: of no more there is a table instead of curves
LEFT_OUT = ("time", "dt", "mass", "body_mass", "energy_pressure", "nodes_inside")


def rows(run):
    """Name, number and unit of each column that is not 0 at the end and says more than the deck."""
    found = []
    for name in run.history.columns:
        value = run.history[name][-1]
        if value != 0 and numpy.isfinite(value) and not name.startswith(LEFT_OUT):
            unit = run.history.units[name]
            found.append((name, f"{value:.8g}", "" if unit == "1" else unit))
    return found


def figure(run, title=""):
    """The table, with what each number is."""
    found = rows(run)
    if not found:
        return None
    drawn, (axes,) = style.panels(1, 1, 9.5, 0.22 * len(found) + 0.7)
    axes.axis("off")
    drawn.suptitle(title, fontsize=9)
    cells = [(*row, textwrap.shorten(run.history.meanings[row[0]], LONGEST, placeholder=" ...")) for row in found]
    table = axes.table(cells, colLabels=("column", "last value", "unit", "meaning"), cellLoc="left", loc="center",
                       colWidths=(0.2, 0.13, 0.1, 0.57), edges="horizontal", bbox=(0, 0, 1, 1))
    table.auto_set_font_size(False)
    table.set_fontsize(8)
    for cell in table.get_celld().values():
        cell.set_linewidth(0.3)
    return drawn
