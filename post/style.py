# SPDX-License-Identifier: GPL-3.0-or-later
"""The look of all figures, in one place."""
import matplotlib

EXACT = {"color": "black", "linestyle": "--", "linewidth": 1.0, "label": "exact", "zorder": 3}
POINTS = {"linestyle": "none", "marker": "o", "markersize": 2.5, "markeredgewidth": 0}
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


def label(quantity, unit):
    """`energy [J]`; without brackets for pure numbers and for runs that name no units."""
    return quantity if unit == "1" else f"{quantity} [{unit}]"


def at_time(time, unit):
    """`time 0.05 s`"""
    return f"time {time:.4g}" if unit == "1" else f"time {time:.4g} {unit}"


def legend(axes):
    """One entry a name, and none at all where there are too many to tell apart."""
    handles, names = axes.get_legend_handles_labels()
    entries = dict(zip(names, handles))
    if 0 < len(entries) <= MOST_IN_LEGEND:
        axes.legend(entries.values(), entries.keys())
