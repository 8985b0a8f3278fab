# SPDX-License-Identifier: GPL-3.0-or-later
"""The look of all figures, in one place."""
import matplotlib
from matplotlib import pyplot

EXACT = {"color": "black", "linestyle": "--", "linewidth": 1.0, "label": "exact", "zorder": 3}
POINTS = {"linestyle": "none", "marker": "o", "markersize": 2.5, "markeredgewidth": 0}
PUBLISHED = {"color": "tab:red", "linestyle": "none", "marker": "|", "markersize": 14, "label": "thesis"}
GRID = {"color": "0.85", "linewidth": 0.5, "zorder": 0}  # the background grid's lines
MOST_IN_LEGEND = 10


def use():
    matplotlib.rcParams.update({
        "figure.constrained_layout.use": True,
        "figure.dpi": 120,
        "font.size": 9,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.alpha": 0.3,
        "lines.linewidth": 1.2,
        "legend.frameon": False,
        "legend.fontsize": 8,
    })


def panels(count, columns, width=4.2, height=2.8):
    """A figure and its `count` panels, `columns` of them in a row, each of a width and height in inches."""
    rows = -(-count // columns)
    figure, axes = pyplot.subplots(rows, columns, squeeze=False, figsize=(width * columns, height * rows))
    for unused in axes.flat[count:]:
        unused.remove()
    return figure, list(axes.flat[:count])


def label(quantity, unit):
    """`energy [J]`; without brackets for pure numbers and for runs that name no units."""
    return quantity if unit == "1" else f"{quantity} [{unit}]"


def at_time(time, unit):
    """`time 0.05 s`"""
    return f"time {time:.4g}" if unit == "1" else f"time {time:.4g} {unit}"


def legend(axes, **look):
    """One entry a name, and none at all where there are too many to tell apart."""
    handles, names = axes.get_legend_handles_labels()
    entries = dict(zip(names, handles))
    if 0 < len(entries) <= MOST_IN_LEGEND:
        axes.legend(entries.values(), entries.keys(), **look)


def legend_above(axes, columns):
    """Outside the panel, where it hides no curve."""
    legend(axes, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=columns, borderaxespad=0.2)


def note(figure, text):
    """Below the panels: what a reader must know of the runs; nothing for an empty text."""
    if text:
        figure.supxlabel(text, fontsize=8, x=0.01, ha="left")
