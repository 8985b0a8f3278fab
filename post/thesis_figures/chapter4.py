# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 4: fluids. Sod's shock tube and the expansion of a gas into a vacuum."""
import numpy

import style

# What the profiles show: field of the points, column of the exact solution, name on the axis.
SOD_FIELDS = (("density", "density", "density"), ("pressure", "pressure", "pressure"),
              ("vx", "velocity", "velocity"), ("specific_energy", "specific_energy", "specific internal energy"))
SYMBOLS = {"linestyle": "none", "marker": "o", "markersize": 2.5, "markerfacecolor": "none", "markeredgewidth": 0.6}
CORNER = 0.5  # the axis of the gas expansion: xleft and ybot of its deck
END_OF_EXPANSION = 0.005
RADIAL = "radial, 1,600 shells"  # the reference for it, in place of the thesis' FLIP


def cell_means(run, name):
    """Middles of the columns of cells that hold points, and the mean of those, at the end."""
    width = run.summary["dx"]
    column = numpy.floor(run.particles["x"][-1] / width).astype(int)
    held = numpy.unique(column)
    return (held + 0.5) * width, numpy.array([run.particles[name][-1][column == c].mean() for c in held])


def profile(axes, run, field, column, name):
    axes.plot(*cell_means(run, field), color="tab:blue", label="points, mean of a cell", **SYMBOLS)
    exact = run.exact_over("x")
    axes.plot(exact["x"], exact[column], **style.EXACT | {"linestyle": "-", "linewidth": 0.8, "zorder": 1})
    axes.set_xlabel(style.label("x", run.particles.units["x"]))
    axes.set_ylabel(style.label(name, run.particles.units[field]))


def sod_densities(runs):
    """Sod's shock tube, density at t = 0.143 by three ways to calculate it."""
    figure, axes = style.panels(3, 3, 3.6, 3.0)
    for panel, (deck, name) in zip(axes, (("sod-cell", "cell density"), ("sod", "quadratic interpolation"),
                                          ("sod-continuity", "continuity equation"))):
        run = runs.of(deck)
        profile(panel, run, *SOD_FIELDS[0])
        panel.set_title(f"{name}, L1 error {run.summary['error_density']:.3f}")
        panel.set_ylim(0, 1.15)
    style.legend(axes[0])
    return figure


def sod_results(runs):
    """Sod's shock tube at t = 0.143 without and with artificial viscosity."""
    figure, axes = style.panels(8, 4, 3.2, 2.6)
    for row, (name, settings) in enumerate((("(a) without", ["fluid.lambda=0."]), ("(b) with", []))):
        run = runs.of("sod", *settings)
        for panel, fields in zip(axes[4 * row:], SOD_FIELDS):
            profile(panel, run, *fields)
        axes[4 * row].set_title(name, loc="left")
    for without, panel in zip(axes[:4], axes[4:]):
        panel.set_ylim(without.get_ylim())
    style.legend(axes[2], loc="upper left")
    return figure


def expansion(runs):
    return runs.of("gas-expansion", f"in.tmax={END_OF_EXPANSION}", "reference.solution='radial-gas'")


def places(run, record):
    return run.particles["x"][record] - CORNER, run.particles["y"][record] - CORNER


def exact_places(run):
    """Where the radial solution takes the points: straight out, each with the mass that is nearer to the axis than it."""
    x, y = places(run, 0)
    start = numpy.hypot(x, y)
    area = numpy.sum(run.particles["volume"][0])
    inside = numpy.pi / 4 * start**2 / area  # share of a quarter of a cylinder as heavy as the points
    inside = numpy.minimum(inside, 1 - 0.5 / len(start))  # some points of a lattice are outside of that
    end = numpy.interp(inside, run.exact["mass_inside"], run.exact["radius"])
    return x * end / start, y * end / start


def frame_expansion(axes, run):
    width = run.summary["dx"]
    axes.set_aspect("equal")
    axes.set_xlim(0, 0.6)
    axes.set_ylim(0, 0.6)
    for at in numpy.arange(0, 0.6, width):
        axes.axvline(at, **style.GRID)
        axes.axhline(at, **style.GRID)
    axes.grid(False)
    axes.set_xlabel(style.label("x from the axis", run.particles.units["x"]))
    axes.set_ylabel(style.label("y from the axis", run.particles.units["y"]))


def circle(axes, radius, **look):
    angle = numpy.linspace(0, numpy.pi / 2, 91)
    axes.plot(radius * numpy.cos(angle), radius * numpy.sin(angle), **look)


def expansion_places(runs):
    """Gas expansion at t = 0.005, material points."""
    run = expansion(runs)
    figure, axes = style.panels(2, 2, 4.2, 4.2)
    for panel, (x, y), name in zip(axes, (places(run, -1), exact_places(run)), ("MPM", RADIAL)):
        frame_expansion(panel, run)
        panel.plot(x, y, color="tab:blue", **style.POINTS)
        circle(panel, run.summary["exact_radius_95"], color="black", linestyle="--", linewidth=0.8,
               label=f"radial: 95 % of the mass within {run.summary['exact_radius_95']:.3f}")
        circle(panel, run.summary["radius_95"], color="tab:red", linewidth=0.8,
               label=f"MPM: {run.summary['radius_95']:.3f}")
        panel.set_title(name)
    style.legend(axes[1])
    return figure


def expansion_field(runs, field, name):
    run = expansion(runs)
    figure, axes = style.panels(3, 3, 4.2, 3.9)
    x, y = places(run, -1)
    exact_x, exact_y = exact_places(run)
    exact = numpy.interp(numpy.hypot(exact_x, exact_y), run.exact["radius"], run.exact[field])
    here = run.particles[field][-1]
    scale = {"vmin": 0, "vmax": max(here.max(), exact.max()), "cmap": "viridis", "s": 16}
    for panel, *drawn, title in ((axes[0], x, y, here, "MPM"), (axes[1], exact_x, exact_y, exact, RADIAL)):
        frame_expansion(panel, run)
        colours = panel.scatter(drawn[0], drawn[1], c=drawn[2], **scale)
        panel.set_title(title)
    figure.colorbar(colours, ax=axes[:2], shrink=0.8)
    axes[2].plot(numpy.hypot(x, y), here, label="MPM, points", **style.POINTS)
    axes[2].plot(run.exact["radius"], run.exact[field], **style.EXACT | {"label": RADIAL})
    axes[2].set_xlim(0, 0.6)
    axes[2].set_xlabel(style.label("distance from the axis", run.particles.units["x"]))
    axes[2].set_ylabel(style.label(name, run.particles.units[field]))
    style.legend(axes[2])
    return figure


def expansion_pressure(runs):
    """Gas expansion, pressure at t = 0.005."""
    return expansion_field(runs, "pressure", "pressure")


def expansion_energy(runs):
    """Gas expansion, specific internal energy at t = 0.005."""
    return expansion_field(runs, "specific_energy", "specific internal energy")


FIGURES = {"13": sod_densities, "14": sod_results, "16": expansion_places, "17": expansion_pressure,
           "18": expansion_energy}
