# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendix A.1: two elastic bars that meet, with and without release."""
import style

from . import bodies

BARS = ("left bar", "right bar")
CELLS = 20
START, END = 0.0, 0.5
ROBUST = ("mpm.method='robust'", "mpm.contact='gap'")
OFTEN = ("in.tiout(13)=0.01",)
MEETING = 0.16  # on the grid, in front of the points' own meeting at .25
AFTER = (0.3, 1.7)  # velocities that the thesis prints for Fig. 95
LOSS, LOSS_NU_0 = -11.0, -2.0  # of energy in percent, from the text of Fig. 96


def positions_and_motion(run, robust=None):
    figure, axes = style.panels(4, 2, 4.6, 3.6)
    for panel, time in zip(axes, (START, END)):
        bodies.frame(panel, run.summary["dx"], (0, 5), (0, 5))
        bodies.draw_places(panel, run, time, BARS)
    axes[0].legend(loc="upper center", ncols=2, markerscale=3, frameon=True, framealpha=0.9)
    for panel, quantity in zip(axes[2:], ("vx", "x")):
        if robust:
            bodies.over_time(panel, robust, quantity, [f"{bar}, robust" for bar in BARS], linewidth=0.9, linestyle=":")
        bodies.over_time(panel, run, quantity, BARS)
    mean = run.history["momentum_x"][0] / run.history["mass"][0]
    axes[2].axhline(mean, **style.EXACT | {"label": "both together, exact", "zorder": 1})
    return figure, axes


def bars_that_stick(runs):
    """Two-bar impact without contact-release algorithm."""
    figure, axes = positions_and_motion(runs.of("two-bar-stick"))
    style.legend(axes[2], loc="upper right")
    style.note(figure, "Centres of mass. Whether and how often bars that stick come apart depends on the step to the last "
                       "bit;\nin the thesis they are apart from t = 0.35 to 0.425.")
    return figure


def bars_that_part(runs):
    """Two-bar impact with the contact-release algorithm."""
    figure, axes = positions_and_motion(runs.of("two-bar"), runs.of("two-bar", *ROBUST))
    for value in AFTER:
        axes[2].plot([0.485, 0.5], [value, value], color="tab:red", linewidth=2.5, label="thesis, after", zorder=4)
    style.legend(axes[2], loc="upper left", fontsize=7, bbox_to_anchor=(0.0, 0.9))
    return figure


def bar_normals(runs):
    """Grid normals of the two bars."""
    run = runs.of("two-bar", *OFTEN)
    figure, (axes,) = style.panels(1, 1, 5.6, 5.6)
    bodies.frame(axes, run.summary["dx"], (0.75, 4.75), (0, 5))
    bodies.draw_normals(axes, run, MEETING, BARS, CELLS)
    style.legend(axes, loc="upper left", markerscale=4)
    style.note(figure, bodies.BY_THE_FIGURE)
    return figure


def draw_change(axes, run, name, **look):
    energy = run.history["energy_total"]
    axes.plot(run.history["time"], 100 * (energy / energy[0] - 1), label=name, **look)
    axes.set_xlabel(style.label("time", run.history.units["time"]))
    axes.set_ylabel("change of total energy [%]")


def bar_energies(runs):
    """Energies of the two-bar impact."""
    run, robust = runs.of("two-bar"), runs.of("two-bar", *ROBUST)
    figure, axes = style.panels(3, 3, 4.0, 3.4)
    for part, colour in (("total", "black"), ("kinetic", "tab:blue"), ("strain", "tab:orange")):
        axes[0].plot(run.history["time"], run.history[f"energy_{part}"], color=colour, label=part)
    axes[0].set_ylabel(style.label("energy", run.history.units["energy_total"]))
    axes[0].set_xlabel(style.label("time", run.history.units["time"]))
    draw_change(axes[1], run, "thesis' method", color="tab:blue")
    draw_change(axes[1], robust, "robust", color="tab:blue", linestyle=":")
    for deck, name, colour in (("two-bar-nu0", "cells of 0.25", "tab:blue"),
                               ("two-bar-nu0-fine", "cells of 0.125", "tab:orange")):
        draw_change(axes[2], runs.of(deck), name, color=colour)
        draw_change(axes[2], runs.of(deck, *ROBUST), f"{name}, robust", color=colour, linestyle=":")
    for panel, loss in ((axes[1], LOSS), (axes[2], LOSS_NU_0)):
        panel.plot([0.48, 0.5], [loss, loss], color="tab:red", linewidth=2.5, label=f"thesis: {loss:g} %", zorder=4)
        panel.axhline(0, **style.EXACT | {"label": "exact", "zorder": 1})
    for panel, title in zip(axes, ("(a) nu = 0.3", "(a) nu = 0.3, total energy", "(b) nu = 0, total energy")):
        panel.set_title(title)
        panel.legend(fontsize=7)
    return figure


FIGURES = {"93": bars_that_stick, "94": bar_normals, "95": bars_that_part, "96": bar_energies}
