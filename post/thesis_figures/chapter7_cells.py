# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 7.6 and 7.7: the mass matrix method in single cells, evaluated by the figures themselves (mass_matrix.py)."""
import numpy

import style

from . import mass_matrix
from .mass_matrix import Linear, Quadratic

REMARK = ("No run: (7.12) to (7.19) in numpy, the extra point where the program has it.\n"
          "The thesis prints no places of points; those here follow its words.")
ARROW = 0.16


def line(angle, along):
    """Points on a straight line through the middle of the cell, and their normals."""
    t = numpy.array([numpy.cos(numpy.radians(angle)), numpy.sin(numpy.radians(angle))])
    x, y = 0.5 + numpy.outer(t, along)
    return x, y, numpy.tile([[-t[1]], [t[0]]], len(along))


def hyperbola():
    """x y + .1 x + C = 0 with C = -.25."""
    x = numpy.linspace(0.28, 0.9, 6)
    gradient = numpy.array([0.25 / x, x])  # (y + .1, x)
    return x, 0.25 / x - 0.1, gradient / numpy.hypot(*gradient)


def arc(radius, middle, angles, turned=0.0):
    """Of a circle about `middle`, turned about the cell's centre by degrees."""
    angles = numpy.radians(angles)
    normal = numpy.array([numpy.cos(angles), numpy.sin(angles)])
    c, s = numpy.cos(numpy.radians(turned)), numpy.sin(numpy.radians(turned))
    turn = numpy.array([[c, -s], [s, c]])
    places = 0.5 + turn @ (numpy.array(middle)[:, None] + radius * normal - 0.5)
    return *places, turn @ normal


def column(*scatter):
    """Points above each other, moved to the right by `scatter`."""
    y = numpy.linspace(0.1, 0.9, 5)
    return 0.5 + numpy.array(scatter), y, numpy.tile([[1.0], [0.0]], 5)


ROUNDED = column(1e-9, -1e-9, 1e-9, -1e-9, 1e-9)  # as good as exactly above each other
MOVED = column(0, 0.01, 0, 0, 0)


def arc_of_83(turned):
    return arc(0.4, (0.5, 0.15), numpy.linspace(35, 145, 8), turned)


def on_side_of(normal, exact):
    """A normal and its opposite are one: the one on the side of the exact."""
    return normal * numpy.where((normal * exact).sum(axis=0) < 0, -1, 1)


def draw_contours(axes, kind, colours):
    """Of the colour in the cell, the membrane's being 1."""
    places = numpy.linspace(0, 1, 61)
    values = 1 + numpy.array([[kind.weights(r, s) @ colours for r in places] for s in places])
    levels = axes.contour(places, places, values, numpy.linspace(values.min(), values.max(), 9), colors="0.7", linewidths=0.7)
    axes.clabel(levels, fontsize=6, fmt="%.2f")
    if values.min() < 1 < values.max():
        axes.contour(places, places, values, [1.0], colors="black", linewidths=1.2)


def draw_cell(axes, points, kind=Linear, fit=mass_matrix.plain_fit, name=""):
    x, y, exact = points
    colours = fit(kind, x, y)
    gradients = mass_matrix.gradients(kind, colours, x, y).T
    normal = on_side_of(gradients / numpy.hypot(*gradients), exact)
    draw_contours(axes, kind, colours)
    for vectors, look in ((exact, {"color": "0.6", "width": 0.014}), (normal, {"color": "tab:blue", "width": 0.006})):
        axes.quiver(x, y, *vectors, angles="xy", scale_units="xy", scale=1 / ARROW, zorder=3, **look)
    axes.plot(x, y, color="tab:red", **style.POINTS | {"markersize": 5, "zorder": 4})
    error = numpy.degrees(numpy.arccos(numpy.clip((normal * exact).sum(axis=0), -1, 1)))
    axes.set_title(f"{name}angle to the exact normal: largest {error.max():.2g}°", fontsize=9)
    axes.set_aspect("equal")
    axes.set_xlim(-0.15, 1.15)
    axes.set_ylim(-0.15, 1.27)
    axes.grid(False)
    axes.plot([0, 1, 1, 0, 0], [0, 0, 1, 1, 0], color="0.4", linewidth=0.8)
    axes.set_xlabel("r")
    axes.set_ylabel("s")


def cells(*draws):
    """A panel for each (points, words of draw_cell)."""
    figure, axes = style.panels(len(draws), min(len(draws), 2), 5.4 if len(draws) == 1 else 4.4, 5.0)
    for panel, (points, words) in zip(axes, draws):
        draw_cell(panel, points, **words)
    axes[0].plot([], [], color="black", label="colour of the membrane, 1")
    axes[0].plot([], [], color="0.6", linewidth=4, label="exact normals")
    axes[0].plot([], [], color="tab:blue", label="calculated")
    axes[0].legend(loc="upper center", ncols=3, fontsize=6.5, columnspacing=1.0)
    style.note(figure, REMARK)
    return figure


def diagonal(runs):
    """Color contours and normals: a line at 45 degrees."""
    return cells((line(45, numpy.linspace(-0.6, 0.6, 5)), {}))


def steep(runs):
    """Color contours and normals: a line at 80 degrees."""
    return cells((line(80, numpy.array([-0.45, -0.3, 0.0, 0.1, 0.4])), {}))


def bilinear(runs):
    """Color contours and normals: x y + .1 x + C = 0."""
    return cells((hyperbola(), {}))


def circular(runs):
    """Color contours and normals: radius .4."""
    return cells((arc(0.4, (0.3, 0.3), numpy.linspace(-10, 100, 6)), {}))


def vertical(runs):
    """Color contours and normals: a vertical line, and with a point moved."""
    ours = {"fit": mass_matrix.fit}
    return cells((ROUNDED, {"name": "(a) (7.12) alone, T as good as singular\n"}),
                 (MOVED, {"name": "(b) a point moved by .01, (7.12) alone\n"}),
                 (ROUNDED, {"name": "(a) as the program does it\n", **ours}),
                 (MOVED, {"name": "(b) as the program does it\n", **ours}))


def three_points(runs):
    """Three points in a cell, two of the same y."""
    return cells((arc(0.35, (0.5, 0.3), numpy.array([30.0, 90.0, 150.0])), {}))


def arcs(runs):
    """Color contours and normals: a circular arc, and turned by 30 degrees."""
    return cells((arc_of_83(0), {}), (arc_of_83(30), {"name": "turned by 30°: "}))


def turned_arcs(runs):
    """Color contours and normals: the arc turned by 60 and by 90 degrees."""
    return cells((arc_of_83(60), {"name": "by 60°: "}), (arc_of_83(90), {"name": "by 90°: "}))


def quadratic_arc(runs):
    """Quadratic shape functions: the arc turned by 90 degrees."""
    return cells((arc_of_83(90), {"kind": Quadratic, "fit": mass_matrix.fit}))


FIGURES = {"76": diagonal, "77": steep, "78": bilinear, "79": circular, "80": vertical, "82": three_points, "83": arcs,
           "84": turned_arcs, "85": quadratic_arc}
