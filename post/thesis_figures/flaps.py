# SPDX-License-Identifier: GPL-3.0-or-later
"""Two flaps in a channel (Figs. 1 to 4 of the continuum paper): scene, streamlines, the upper flap's tip."""
import numpy

import style
from scene.elements import Elements
from scene.flow import FlowMesh

END = 1.0  # a period of the inflow
ELEMENTS = (("q1q1", "--"), ("q2q1", "-"))
COLOURS = ("tab:green", "tab:orange", "tab:blue")  # of the levels, from the coarsest
MOST_PANELS = 6
VIEW = (1.0, 5.0)  # along the channel, where the flaps' vortices are


def factor(level):
    """The meshes: 64 x 16 with flaps of 1 x 10, then each twice as fine as the one before."""
    return 2**level


def level_name(level):
    return f"{64 * factor(level)} x {16 * factor(level)}"


def flapping(runs, element, level):
    k = factor(level)
    return runs.of("two-flaps", f"flow.element='{element}'", f"mesh.cells(1:2,1)={64 * k},{16 * k}",
                   f"mesh.cells(1:2,2)={k},{10 * k}", f"mesh.cells(1:2,3)={k},{10 * k}", f"in.tmax={END}")


def frame(axes, run, view=None):
    axes.set_aspect("equal")
    axes.grid(False)
    if view:
        axes.set_xlim(*view)
    axes.set_xlabel(style.label("x", run.history.units["point_x"]))
    axes.set_ylabel(style.label("y", run.history.units["point_y"]))


def scene(runs):
    """Two flaps: geometry and boundary conditions."""
    run = flapping(runs, "q1q1", 0)
    mesh = FlowMesh(run.fields("mesh"))
    length, height = mesh.x.max(), mesh.y.max()
    figure, (axes,) = style.panels(1, 1, 9.5, 3.0)
    for y in (0, height):
        axes.plot([0, length], [y, y], color="black", linewidth=2)
    Elements(run.fields("solids")).draw(axes, 0)
    places = numpy.linspace(0, height, 12)
    profile = 4 * places * (height - places) / height**2
    reach = 0.6 * profile
    axes.quiver(-reach, places, reach, 0 * places, angles="xy", scale_units="xy", scale=1, width=0.002, color="tab:blue")
    axes.plot(-reach, places, color="tab:blue")
    tips = [(run.history["point_x"][0, k], run.history["point_y"][0, k]) for k in (0, 1)]
    for name, (x, y) in zip(("tip of the upper flap", "tip of the lower flap"), tips):
        axes.plot(x, y, "ko", markersize=3)
        axes.annotate(name, (x, y), xytext=(12, 0), textcoords="offset points", va="center")
    axes.text(-0.6, height + 0.08, "inflow 5 (sin 2$\\pi$t + 1.1) y (1.61 - y)", color="tab:blue")
    axes.text(length, height / 2, " open", va="center", color="tab:green")
    axes.plot([length, length], [0, height], color="tab:green", linestyle=":")
    for y, side in ((0, "top"), (height, "bottom")):
        axes.annotate("at rest, flap clamped", (length / 2, y), xytext=(0, 4 if y else -4), textcoords="offset points",
                      ha="center", va=side)
    frame(axes, run, (-0.9, length + 0.7))
    axes.set_ylim(-0.3, height + 0.35)
    return figure


def streamlines(runs):
    """Two flaps: streamlines over a period."""
    run = flapping(runs, "q1q1", runs.levels - 1)
    mesh, solids = FlowMesh(run.fields("mesh")), Elements(run.fields("solids"))
    last = len(mesh.times) - 1
    records = numpy.unique(numpy.linspace(1, last, min(last, MOST_PANELS)).round().astype(int))
    solids.fit(records)
    figure, panels = style.panels(len(records), min(2, len(records)), 5.2, 2.5)
    for axes, record in zip(panels, records):
        mesh.draw_streamlines(axes, record)
        solids.draw(axes, record)
        frame(axes, run, VIEW)
        axes.set_title(style.at_time(mesh.times[record], run.history.units["time"]))
    style.note(figure, f"{level_name(runs.levels - 1)} elements q1q1")
    return figure


def tip(runs, component):
    figure, (axes,) = style.panels(1, 1, 6.5, 4.2)
    for element, line in ELEMENTS:
        for level in range(runs.levels):
            run = flapping(runs, element, level)
            axes.plot(run.history["time"], run.history[f"point_{component}"][:, 0], linestyle=line,
                      color=COLOURS[level], label=f"{level_name(level)} {element}")
    axes.set_xlabel(style.label("time", run.history.units["time"]))
    axes.set_ylabel(style.label(component, run.history.units[f"point_{component}"]))
    style.legend(axes)
    return figure


def tip_x(runs):
    """Two flaps: x of the tip of the upper flap."""
    return tip(runs, "x")


def tip_y(runs):
    """Two flaps: y of the tip of the upper flap."""
    return tip(runs, "y")


def path(run, times):
    """x and y of the tip of the upper flap."""
    return numpy.array([numpy.interp(times, run.history["time"], run.history[f"point_{part}"][:, 0]) for part in "xy"])


def distance(run, finest):
    """The largest between the tip's paths, over the largest way of the tip from where it began."""
    times = finest.history["time"]
    here, there = path(run, times), path(finest, times)
    largest_way = numpy.hypot(*(there - there[:, :1])).max()
    return numpy.hypot(*(here - there)).max() / largest_way


def cost(runs):
    """Two flaps: error of the tip's path over processor seconds."""
    finest = flapping(runs, "q2q1", runs.levels - 1)
    figure, (axes,) = style.panels(1, 1, 6.0, 4.0)
    for element, levels, colour in (("q1q1", runs.levels, "tab:blue"), ("q2q1", runs.levels - 1, "tab:orange")):
        made = [flapping(runs, element, level) for level in range(levels)]
        if made:
            axes.loglog([run.summary["cpu_seconds"] for run in made], [distance(run, finest) for run in made],
                        marker="o", color=colour, label=element)
    axes.axvline(finest.summary["cpu_seconds"], color="tab:orange", linestyle=":",
                 label=f"{level_name(runs.levels - 1)} q2q1")
    axes.set_xlabel("processor seconds [s]")
    axes.set_ylabel("largest distance over largest way")
    style.legend(axes)
    style.note(figure, "The largest distance from the path that the finest q2q1 mesh gives (dotted: its cost), over the\n"
                       "largest way of the tip. Seconds are those of the machine that drew this.")
    return figure


FIGURES = {"flaps-1": scene, "flaps-2": streamlines, "flaps-3": tip_x, "flaps-4": tip_y, "two-flaps-cost": cost}
