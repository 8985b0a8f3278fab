# SPDX-License-Identifier: GPL-3.0-or-later
"""The ball that flies into a net: chapter 5.9 (plane strain ball) and appendix A.1.6 (plane stress ball, uniaxial net)."""
import style

from . import bodies

NAMES = ("ball", "net")
CELLS = 40
RELEASE = ("mpm.contact='release'", "mpm.criterion=3")
ROBUST = ("mpm.method='robust'", "mpm.contact='gap'")
THICK = ("membrane.thickness=0.125",)
# With the printed thickness the ball breaks through by the thesis' method and pushes the net off the grid.
THIN = ("in.tmax=2.4",)
TIMES = (0.0, 0.8, 1.6, 2.4, 2.8, 4.0)
BALL_AFTER = {"release": -0.7, "none": -0.1}  # its velocity in the end: 5.9, A.1.6
THICKNESS = "The net is .125 thick, not .0125 as the thesis prints for A.1.6: see Figs. 98 and 99."
THICK_AND_THIN = ("The net is ten times as thick as printed (.125). With the printed .0125 the ball breaks through: the "
                  "panels on the right.")


def frame(axes, run):
    bodies.frame(axes, run.summary["dx"], (3, 10), (0, 10))


def shapes(axes, run, times):
    for panel, time in zip(axes, times):
        frame(panel, run)
        bodies.draw_places(panel, run, time, NAMES, 1.5)


def net_shapes(runs):
    """Ball and net at various times."""
    figure, axes = style.panels(12, 6, 2.1, 3.2)
    for row, (name, settings) in enumerate((("thesis' method", RELEASE), ("robust", ROBUST))):
        shapes(axes[6 * row:], runs.of("ball-net", *settings), TIMES)
        axes[6 * row].set_ylabel(f"{name}\ny")
    style.legend(axes[0], loc="lower left", markerscale=3)
    style.note(figure, THICKNESS)
    return figure


def velocity_and_position(axes, runs_by_name, printed):
    for panel, quantity in zip(axes, ("vx", "x")):
        for (name, run), line in zip(runs_by_name.items(), ("-", ":")):
            bodies.over_time(panel, run, quantity, [f"{body}, {name}" for body in NAMES], linestyle=line)
    axes[0].plot([3.85, 4.02], [printed, printed], color="tab:red", linewidth=2.5, label="ball, thesis, in the end", zorder=4)
    for panel in axes:
        style.legend_above(panel, 2)


def net_motion(runs):
    """Velocities and positions of the ball's and the net's centres of mass."""
    figure, axes = style.panels(2, 2, 5.0, 3.8)
    velocity_and_position(axes, {"thesis' method": runs.of("ball-net", *RELEASE), "robust": runs.of("ball-net", *ROBUST)},
                          BALL_AFTER["release"])
    style.note(figure, THICKNESS)
    return figure


def energies_of(axes, run):
    for part, colour in (("total", "black"), ("kinetic", "tab:blue"), ("strain", "tab:orange")):
        axes.plot(run.history["time"], run.history[f"energy_{part}"], color=colour, label=part)
    axes.set_xlabel(style.label("time", run.history.units["time"]))
    axes.set_ylabel(style.label("energy", run.history.units["energy_total"]))
    style.legend_above(axes, 3)


def without_release(runs):
    """Ball and net without contact-release algorithm."""
    thick, thin = runs.of("ball-net-orig", *THICK), runs.of("ball-net-orig", *THIN)
    figure, axes = style.panels(8, 4, 2.9, 3.9)
    shapes(axes, thick, (0.0, 1.6, 4.0))
    shapes(axes[3:], thin, (2.4,))
    axes[3].set_title("printed thickness, time 2.4")
    bodies.over_time(axes[4], thick, "vx", NAMES)
    axes[4].plot([3.8, 4.02], [BALL_AFTER["none"]] * 2, color="tab:red", linewidth=2.5, label="thesis: ball", zorder=4)
    bodies.over_time(axes[5], thick, "x", NAMES)
    energies_of(axes[6], thick)
    bodies.over_time(axes[7], thin, "vx", NAMES)
    axes[7].set_title("printed thickness")
    for panel in (axes[4], axes[5]):
        style.legend_above(panel, 3)
    style.note(figure, THICK_AND_THIN)
    return figure


def release_shapes(runs):
    """Ball and net with contact-release algorithm."""
    thick, thin = runs.of("ball-net-orig", *THICK, *RELEASE), runs.of("ball-net-orig", *THIN, *RELEASE)
    figure, axes = style.panels(7, 7, 2.0, 3.4)
    shapes(axes, thick, TIMES)
    shapes(axes[6:], thin, (2.4,))
    axes[6].set_title("printed thickness,\ntime 2.4")
    style.legend(axes[0], loc="lower left", markerscale=3)
    style.note(figure, THICK_AND_THIN.replace("panels", "panel"))
    return figure


def release_motion(runs):
    """Velocities and energies of ball and net with contact-release algorithm."""
    thick, robust = runs.of("ball-net-orig", *THICK, *RELEASE), runs.of("ball-net-orig", *THICK, *ROBUST)
    figure, axes = style.panels(2, 2, 5.0, 3.8)
    for name, run, line in (("thesis' method", thick, "-"), ("robust", robust, ":")):
        bodies.over_time(axes[0], run, "vx", [f"{body}, {name}" for body in NAMES], linestyle=line)
    style.legend_above(axes[0], 2)
    energies_of(axes[1], thick)
    axes[1].plot(robust.history["time"], robust.history["energy_total"], color="black", linestyle=":", label="total, robust")
    style.legend_above(axes[1], 4)
    style.note(figure, "The net is ten times as thick as printed (.125).")
    return figure


def net_normals(runs):
    """Ball and net normals at time 1."""
    run = runs.of("ball-net-orig", *THICK, *RELEASE)
    figure, (axes,) = style.panels(1, 1, 5.2, 6.6)
    bodies.frame(axes, run.summary["dx"], (4.5, 9.5), (1.5, 8.5))
    bodies.draw_normals(axes, run, 1.0, NAMES, CELLS)
    style.legend(axes, loc="upper left", markerscale=4)
    style.note(figure, bodies.BY_THE_FIGURE)
    return figure


FIGURES = {"41": net_shapes, "42": net_motion, "98": without_release, "99": release_shapes, "100": release_motion,
           "101": net_normals}
