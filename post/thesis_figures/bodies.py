# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures of two bodies that meet have in common."""
import numpy

import style

from . import grid_colors

COLOURS = ("tab:blue", "tab:orange")
BY_THE_FIGURE = ("From the run's points by (9.10) and (9.11), evaluated by the figure itself,\n"
                 "at the nodes that both share.")


def nearest(run, time):
    return int(numpy.argmin(abs(run.particles["time"] - time)))


def places(run, record, body):
    chosen = run.particles["body"][record] == body
    return run.particles["x"][record][chosen], run.particles["y"][record][chosen]


def frame(axes, width, limits_x, limits_y):
    """With the lines of the grid's cells."""
    axes.set_aspect("equal")
    axes.set_xlim(*limits_x)
    axes.set_ylim(*limits_y)
    axes.grid(False)
    for line, (low, high) in ((axes.axvline, limits_x), (axes.axhline, limits_y)):
        for at in numpy.arange(numpy.ceil(low / width) * width, high + 1e-9, width):
            line(at, **style.GRID)
    axes.set_xlabel("x")
    axes.set_ylabel("y")


def title_of_time(axes, run, record):
    axes.set_title(style.at_time(run.particles["time"][record], run.particles.units["time"]))


def draw_places(axes, run, time, names, size=2.0):
    record = nearest(run, time)
    for body, (name, colour) in enumerate(zip(names, COLOURS), 1):
        axes.plot(*places(run, record, body), color=colour, label=name, **style.POINTS | {"markersize": size})
    title_of_time(axes, run, record)


def over_time(axes, run, quantity, names, **look):
    """`x` or `vx` of the bodies' centres of mass."""
    for values, name, colour in zip(run.history[f"body_{quantity}"].T, names, COLOURS):
        axes.plot(run.history["time"], values, **{"color": colour, "label": name} | look)
    axes.set_xlabel(style.label("time", run.history.units["time"]))
    axes.set_ylabel(style.label("velocity" if quantity == "vx" else "x", run.history.units[f"body_{quantity}"]))


def draw_normals(axes, run, time, names, cells):
    """Of both bodies, at the nodes to which both contribute; those alone tell whether bodies part."""
    record, width = nearest(run, time), run.summary["dx"]
    both = [places(run, record, body) for body in (1, 2)]
    shared = numpy.logical_and(*(grid_colors.touched_nodes(*at, width, cells) for at in both))
    rows, columns = numpy.nonzero(shared)
    for at, name, colour in zip(both, names, COLOURS):
        normals = grid_colors.outward_normals(*at, width, cells)[:, rows, columns]
        axes.plot(*at, color=colour, label=name, **style.POINTS | {"markersize": 1.5, "alpha": 0.6})
        axes.quiver(columns * width, rows * width, *normals, color=colour, angles="xy", scale_units="xy",
                    scale=1.2 / width, width=0.004, zorder=3)
    title_of_time(axes, run, record)
