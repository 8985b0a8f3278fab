# SPDX-License-Identifier: GPL-3.0-or-later
"""The look of all figures, in one place."""
import matplotlib
from matplotlib import collections, colors, pyplot

EXACT = {"color": "black", "linestyle": "--", "linewidth": 1.0, "label": "exact", "zorder": 3}
POINTS = {"linestyle": "none", "marker": "o", "markersize": 2.5, "markeredgewidth": 0}
PUBLISHED = {"color": "tab:red", "linestyle": "none", "marker": "|", "markersize": 14, "label": "thesis"}
GRID = {"color": "0.85", "linewidth": 0.5, "zorder": 0}  # the background grid's lines
MOST_IN_LEGEND = 10
# Curves of a run, ours: blue first, all told apart by all eyes; red is of what is published, black of what is exact.
OURS = ("#0072B2", "#E69F00", "#009E73", "#56B4E9", "#CC79A7", "#7A5195", "#8C6D31", "#5A5A5A")
BEFORE = {"color": "0.65", "linewidth": 0.7, "zorder": 2}  # the outline of a body at the start
OUTLINE = {"color": "0.15", "linewidth": 0.6, "zorder": 4}  # of a body where it is
WALL = {"color": "black", "linewidth": 0.9, "zorder": 3.5}
STREAMLINES = {"colors": OURS[0], "linewidths": 0.7, "linestyles": "solid", "zorder": 2}
MEMBRANES = ("#222222", "#CC79A7", "#009E73")
HEAVY = {"color": "black", "zorder": 5}
RIGID_MAP = colors.ListedColormap(["#9ecae1"])


def use():
    matplotlib.rcParams.update({
        "figure.constrained_layout.use": True,
        "figure.dpi": 120,
        "font.size": 9,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.alpha": 0.3,
        "lines.linewidth": 1.2,
        "axes.prop_cycle": matplotlib.cycler(color=OURS),
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


def extend(below, above):
    """What a colour bar says of numbers beyond its ends."""
    return {(True, True): "both", (True, False): "min", (False, True): "max"}.get((bool(below), bool(above)), "neither")


def draw_edges(axes, edges, **look):
    """Lines from node to node, such as a mesh's walls."""
    axes.add_collection(collections.LineCollection(edges, **WALL | look))


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


def legend_beside(axes):
    """To the right of the panel, where it hides no curve; none for a single curve, which the axis names."""
    handles, names = axes.get_legend_handles_labels()
    if len(set(names)) > 1:
        legend(axes, loc="center left", bbox_to_anchor=(1.0, 0.5), borderaxespad=0.3, handlelength=1.4)


def note(figure, text):
    """Below the panels: what a reader must know of the runs; nothing for an empty text."""
    if text:
        figure.supxlabel(text, fontsize=8, x=0.01, ha="left")
