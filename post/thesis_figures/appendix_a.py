# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendix A: the noise of a point that changes cells."""
import numpy

import style

HEIGHTS = (1.9, 1.8, 1.7)  # of the rows of nodes whose forces the thesis prints
BEFORE, AFTER = (66, 111, 3114), (2183, -3940, 5123)  # in Fig. 103 and in Fig. 104
# Stresses that it prints, by the number of the point.
STRESS_BEFORE = dict.fromkeys((4, 5, 6), 123034) | dict.fromkeys((7, 8), 181170)
STRESS_AFTER = dict.fromkeys((5, 6), 123274) | dict.fromkeys((7, 8), 179802)
EVERY_STEP = ("in.tmax=1.8d-5", "in.tiout(13)=1.8d-6")
LARGEST = 6000.0  # force along the axis


def row_forces(run, record):
    """Of the rows of nodes at HEIGHTS; the two nodes of a row share its force."""
    mesh = run.fields("mesh")
    rows = [int(numpy.argmin(abs(mesh["node_y"] - height))) for height in HEIGHTS]
    return mesh["force_y"][record][rows].sum(axis=-1)


def draw_points(axes, run, record, published):
    """Each with its number and stress to the left, the thesis' stress to the right."""
    y, stress = run.particles["y"][record], run.particles["syy"][record]
    axes.plot(numpy.zeros_like(y), y, color="tab:blue", **style.POINTS | {"markersize": 6})
    text = {"textcoords": "offset points", "va": "center", "fontsize": 8}
    for number, (height, value) in enumerate(zip(y, stress), 1):
        axes.annotate(f"{number}:  {value:,.0f}", (0, height), xytext=(-8, 0), ha="right", **text)
        if number in published:
            axes.annotate(f"{published[number]:,}", (0, height), xytext=(8, 0), ha="left", color="tab:red", **text)
    axes.set_title("points: stress syy (red: thesis)", fontsize=9)
    axes.set_xlim(-1, 1)
    axes.set_xticks([])
    axes.set_ylabel(style.label("y", run.particles.units["y"]))


def draw_forces(axes, forces, published):
    axes.barh(HEIGHTS, forces, height=0.008, color="tab:blue", label="MPM")
    for height, force, printed in zip(HEIGHTS, forces, published):
        axes.text(0, height + 0.012, f"{force:,.0f} (thesis {printed:,})", ha="center", fontsize=8)
    axes.plot(published, HEIGHTS, **style.PUBLISHED)
    axes.axvline(0, color="black", linewidth=0.6)
    axes.set_xlim(-LARGEST, LARGEST)
    axes.set_xticks((-5000, 0, 5000))
    axes.set_title("rows of nodes: force fy", fontsize=9)
    axes.set_xlabel("force, upwards to the right")
    style.legend(axes, loc="lower left")


def forces_and_stresses(runs, record, stresses, forces):
    run = runs.of("noise", *EVERY_STEP)
    figure, axes = style.panels(2, 2, 3.6, 4.8)
    draw_points(axes[0], run, record, stresses)
    draw_forces(axes[1], row_forces(run, record), forces)
    for panel in axes:
        panel.grid(False)
        panel.set_ylim(1.62, 2.02)
        for side in (1.7, 1.8, 1.9, 2.0):
            panel.axhline(side, **style.GRID | {"color": "0.7"})
    return figure


def before(runs):
    """Forces and stresses before material point 6 crosses a cell boundary."""
    return forces_and_stresses(runs, 0, STRESS_BEFORE, BEFORE)


def after(runs):
    """Forces and stresses after material point 6 has crossed a cell boundary."""
    return forces_and_stresses(runs, 1, STRESS_AFTER, AFTER)


FIGURES = {"103": before, "104": after}
