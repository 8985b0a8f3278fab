# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of a run. Each function takes a Run and gives a matplotlib figure, or None where the run has no data."""
import numpy
from matplotlib import pyplot

import style

MOST_SNAPSHOTS = 9
# A gas field of particles.nc: its column of reference.txt, and its name on the axis.
PROFILES = {"density": ("density", "density"), "vx": ("velocity", "velocity"), "pressure": ("pressure", "pressure"),
            "specific_energy": ("specific_energy", "specific internal energy")}


def over_time(axes, run, name, labels):
    """Draws a variable of the history (a curve for each body or point) and what reference.txt has under its names."""
    values = run.history[name].reshape(len(run.history["time"]), -1)
    exact = run.exact_over("time")
    for k, curve in enumerate(values.T):
        axes.plot(run.history["time"], curve, label=labels[k])
        column = name if run.history[name].ndim == 1 else f"{name}_{k + 1}"
        if column in exact:
            axes.plot(exact["time"], exact[column], **style.EXACT)
    axes.set_xlabel(style.label("time", run.history.units["time"]))


def energies(run):
    """Those of which there is some at any time; energy_pressure is what rounding is measured against, no exchange."""
    names = [name for name in run.history.variables
             if name.startswith("energy_") and name != "energy_pressure" and run.history[name].any()]
    if not names:
        return None
    figure, (axes,) = style.panels(1, 1)
    for name in names:
        over_time(axes, run, name, [name.removeprefix("energy_")])
    axes.set_ylabel(style.label("energy", run.history.units[names[0]]))
    style.legend(axes)
    return figure


def motion(run, kind, names):
    """Places and velocities over time of what history.nc calls `body_x`, `body_vx` ... or `point_x`, `point_vx` ..."""
    found = [part for part in ("x", "y", "z", "vx", "vy", "vz") if f"{kind}_{part}" in run.history]
    if not found:
        return None
    number = run.history[f"{kind}_{found[0]}"].shape[1]
    labels = names or [f"{kind} {k + 1}" for k in range(number)]
    figure, panels = style.panels(len(found), max(1, sum(len(part) == 1 for part in found)))
    for axes, part in zip(panels, found):
        over_time(axes, run, f"{kind}_{part}", labels)
        axes.set_ylabel(style.label(part, run.history.units[f"{kind}_{part}"]))
        style.legend(axes)
    return figure


def bodies(run):
    return motion(run, "body", run.body_names)


def points(run):
    return motion(run, "point", run.point_names)


def draw_points(axes, particles, record):
    """The points of one snapshot, a colour for each body."""
    x, y = particles["x"][record], particles["y"][record]
    body = particles["body"][record] if "body" in particles else numpy.zeros_like(x)
    for number in numpy.unique(body[numpy.isfinite(body)]):  # a record may have fewer points than others
        axes.plot(x[body == number], y[body == number], **style.POINTS)


def frame_alike(axes, particles):
    """Equal scales in x and y, and the same limits in all panels: those of all snapshots."""
    for set_limits, name in ((axes.set_xlim, "x"), (axes.set_ylim, "y")):
        low, high = numpy.nanmin(particles[name]), numpy.nanmax(particles[name])
        margin = 0.05 * (high - low) or 0.05
        set_limits(low - margin, high + margin)
    axes.set_aspect("equal", adjustable="datalim")


def positions(run):
    """Where the points stand in the snapshots: first, last, and some evenly between."""
    particles = run.particles if run.has("particles") else {}
    if "x" not in particles or "y" not in particles:
        return None
    times = particles["time"]
    chosen = numpy.unique(numpy.linspace(0, len(times) - 1, min(len(times), MOST_SNAPSHOTS)).round().astype(int))
    figure, panels = style.panels(len(chosen), min(len(chosen), 3))
    for axes, record in zip(panels, chosen):
        draw_points(axes, particles, record)
        frame_alike(axes, particles)
        axes.set_title(style.at_time(times[record], particles.units["time"]))
        axes.set_xlabel(style.label("x", particles.units["x"]))
        axes.set_ylabel(style.label("y", particles.units["y"]))
    return figure


def profiles(run):
    """The gas of the last snapshot along x, over the exact solution at its time."""
    particles, exact = run.particles if run.has("particles") else {}, run.exact_over("x")
    if not exact or not all(name in particles for name in ("x", *PROFILES)):
        return None
    figure, panels = style.panels(len(PROFILES), 2)
    for axes, (name, (column, title)) in zip(panels, PROFILES.items()):
        axes.plot(particles["x"][-1], particles[name][-1], label="points", **style.POINTS)
        if column in exact:
            axes.plot(exact["x"], exact[column], **style.EXACT)
        axes.set_xlabel(style.label("x", particles.units["x"]))
        axes.set_ylabel(style.label(title, particles.units[name]))
    style.legend(panels[0])
    figure.suptitle(style.at_time(particles["time"][-1], particles.units["time"]))
    return figure


def save_all(run, folder):
    """Writes every figure the run has data for as FOLDER/<name>.png and yields the paths."""
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (energies, bodies, points, positions, profiles):
        figure = draw(run)
        if figure is None:
            continue
        path = folder / f"{draw.__name__}.png"
        figure.savefig(path)
        pyplot.close(figure)
        yield path
