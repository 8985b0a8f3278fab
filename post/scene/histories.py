# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories as panels of curves: places, energies as changes, forces, volumes, each over the exact curve where there is one."""
from dataclasses import dataclass, field

import numpy

import style

MOST_CURVES = 8
SMALL = 1e-3  # of the largest change of its like: what changes less is left out
SHORT = 0.02  # of a number: what changes by less is drawn as a change
ROUNDED = 1e-9  # of the largest change of an energy: exchanges that are all smaller are rounding
MOST_TICKS = 6  # along time, so that long numbers do not meet
KEPT = 1e-6  # of the energies: a total that changes by less is kept
LEAST_VOLUME = 1e-4  # per cent
# Of energies: those that something holds; energy_pressure is what rounding is measured against, energy_fluid a part of another.
NO_EXCHANGE = ("pressure", "fluid")
STORED = ("kinetic", "strain", "internal", "potential", "ambient", "step", "total")


@dataclass
class Curve:
    label: str
    column: str
    values: numpy.ndarray


@dataclass
class Panel:
    """Curves over time with one label of their axis; `exact` has columns of reference.txt by the name of theirs."""

    title: str
    label: str
    curves: list
    exact: dict = field(default_factory=dict)


def unit_of(run, name):
    return run.history.units[name]


def extent(values):
    """How far a curve goes."""
    values = values[numpy.isfinite(values)]
    return float(numpy.ptp(values)) if len(values) else 0.0


def panel_of(run, what, name, labels, least):
    """A panel of a variable's curves that go further than `least`, one a body or point; None without any."""
    columns = [f"{name}_{k + 1}" for k in range(len(labels))]
    curves = [Curve(label, column, run.history[column]) for label, column in zip(labels, columns)]
    curves, exact = [curve for curve in curves if extent(curve.values) > least], run.exact_over("time")
    if not curves:
        return None
    if all(extent(curve.values) < SHORT * abs(curve.values[0]) for curve in curves):
        curves = [Curve(curve.label, curve.column, curve.values - curve.values[0]) for curve in curves]
        exact, what = changed(exact), f"change of {what}"
    return Panel(what, style.label(what, unit_of(run, name)), curves, exact)


def of_each(kind, names_of, what):
    """Panels of what bodies or tracked points have, by the ends of their columns, such as x of body_x."""
    def panels(run):
        labels = names_of(run)
        names = {f"{kind}_{end}": title for end, title in what.items() if f"{kind}_{end}" in run.history.variables}
        if not labels or len(labels) > MOST_CURVES:
            return []
        least = SMALL * max((extent(curve) for name in names for curve in run.history[name].T), default=0)
        return [panel_of(run, title, name, labels, least) for name, title in names.items()]
    return panels


def along(words, stem=""):
    """Titles by the ends of columns for each axis."""
    return {f"{stem}{axis}": words.format(axis) for axis in "xyz"}


tracked = of_each("point", lambda run: run.point_names, along("{} of tracked points"))
bodies = of_each("body", lambda run: run.body_names, along("{} of centres of mass"))
velocities = of_each("body", lambda run: run.body_names, along("velocity {} of centres of mass", "v"))
forces = of_each("body", lambda run: run.body_names, along("force of the fluid on bodies, {}", "force_"))


def places(run):
    """Tracked points, or without them the centres of mass."""
    return tracked(run) if any(tracked(run)) else bodies(run)


def exchange(title, what, chosen):
    """A panel of energies as changes from the start, of those that this function chooses by their names."""
    def panels(run):
        names = [name for name in run.history.variables if name.startswith("energy_") and chosen(name.removeprefix("energy_"))]
        changes = {name: run.history[name] - run.history[name][0] for name in names}
        sizes = {name: numpy.nanmax(abs(change), initial=0) for name, change in changes.items()}
        largest = max(sizes.values(), default=0)
        shown = sorted((name for name in names if sizes[name] > SMALL * largest), key=lambda name: -sizes[name])[:MOST_CURVES]
        if not shown or not largest > ROUNDED * largest_change(run):
            return []
        curves = [Curve(name.removeprefix("energy_"), name, changes[name]) for name in names if name in shown]
        return [Panel(title + kept(run, names), style.label(what, unit_of(run, names[0])), curves, changed(run.exact_over("time")))]
    return panels


def largest_change(run):
    """Of any energy from its start."""
    return max((numpy.nanmax(abs(run.history[name] - run.history[name][0]), initial=0) for name in run.history.variables
                if name.startswith("energy_")), default=0)


def kept(run, names):
    """How well the total is kept, where it is."""
    size = max(numpy.nanmax(abs(run.history[name]), initial=0) for name in names)
    change = extent(run.history["energy_total"])
    return f" (the total changes by {change / size:.1g} of the largest)" if "energy_total" in names and change < KEPT * size else ""


def changed(exact):
    """Exact columns as changes from the start."""
    return {name: values if name == "time" else values - values[0] for name, values in exact.items()}


energies = exchange("energies", "change of energy", lambda name: name in STORED)
works = exchange("work and losses", "energy given or taken", lambda name: name not in (*STORED, *NO_EXCHANGE))


def volumes(run):
    """Relative changes of what bodies and closed surfaces hold."""
    curves = []
    for name in run.history.columns:
        if name.startswith(("body_volume", "volume_", "fluid_volume")):
            values = run.history[name]
            change = values / values[0] - 1 if values[0] else values * 0
            if extent(100 * change) > LEAST_VOLUME:
                curves.append(Curve(name.replace("_", " "), name, 100 * change))
    return [Panel("volumes", "change of volume [%]", curves[:MOST_CURVES])] if curves else []


def numbered(title, what, stem):
    """A panel of columns that are numbered one by one, such as drag_1 and drag_2."""
    def panels(run):
        names = [name for name in run.history.columns if name.startswith(stem) and name[len(stem):].isdigit()]
        if not any(extent(run.history[name]) > 0 for name in names):
            return []
        return [Panel(title, style.label(what, unit_of(run, names[0])),
                      [Curve(name.replace("_", " "), name, run.history[name]) for name in names[:MOST_CURVES]],
                      run.exact_over("time"))]
    return panels


def together(title, what, names):
    """A panel of several variables of one unit."""
    def panels(run):
        found = [name for name in names if name in run.history and extent(run.history[name]) > 0]
        if not found:
            return []
        return [Panel(title, style.label(what, unit_of(run, found[0])),
                      [Curve(name.replace("_", " "), name, run.history[name]) for name in found], run.exact_over("time"))]
    return panels


drag = numbered("drag", "drag coefficient", "drag_")
lift = numbered("lift", "lift coefficient", "lift_")
pressure_differences = numbered("differences of pressure", "difference of pressure", "pressure_difference_")
smoke = together("smoke", "smoke", ("smoke_mass", "smoke_in", "smoke_out"))
spin = together("spin", "angular velocity", ("omega_x", "omega_y", "omega_z"))


def error_text(curve, exact_time, exact, time):
    """Largest and rms distance from the exact curve, over its range, where both are."""
    both = (time >= exact_time[0]) & (time <= exact_time[-1])
    distance = curve[both] - numpy.interp(time[both], exact_time, exact)
    extent = numpy.ptp(exact) or 1.0
    if not len(distance):
        return ""
    return (f"from the exact curve: at most {100 * numpy.nanmax(abs(distance)) / extent:.3g} %, "
            f"rms {100 * numpy.sqrt(numpy.nanmean(distance**2)) / extent:.3g} % of its range")


def exact_only(run, shown):
    """Panels of columns that have an exact curve and are in no panel yet."""
    known = {curve.column for panel in shown for curve in panel.curves}
    found = []
    for column, values in run.exact_over("time").items():
        if column != "time" and column in run.history and column not in known:
            found.append(Panel(column.replace("_", " "), style.label(column, unit_of(run, column)),
                               [Curve(column.replace("_", " "), column, run.history[column])], run.exact))
    return found


def draw_panel(axes, run, panel):
    time, errors = run.history["time"], []
    mark = {"marker": "o", "markersize": 3} if len(time) < 30 else {}
    for curve in panel.curves:
        axes.plot(time, curve.values, label=curve.label, **mark)
        if curve.column in panel.exact:
            axes.plot(panel.exact["time"], panel.exact[curve.column], **style.EXACT)
            errors.append(error_text(curve.values, panel.exact["time"], panel.exact[curve.column], time))
    axes.locator_params(axis="x", nbins=MOST_TICKS)
    axes.set_xlabel(style.label("time", unit_of(run, "time")))
    axes.set_ylabel(panel.label)
    alone = panel.curves[0].label if len(panel.curves) == 1 else panel.title
    named = panel.title if alone in panel.title else f"{panel.title}: {alone}"
    axes.set_title("\n".join([named, *errors[:1]]), fontsize=8)
    style.legend_beside(axes)


def figure(run, sources, title=""):
    """The panels that these functions give, two in a row; None where there is nothing to draw."""
    shown = [panel for source in sources for panel in source(run) if panel is not None]
    shown = exact_only(run, shown) + shown
    if not shown:
        return None
    drawn, axes = style.panels(len(shown), min(2, len(shown)), 5.6, 2.7)
    drawn.suptitle(title, fontsize=9)
    for panel, panel_axes in zip(shown, axes):
        draw_panel(panel_axes, run, panel)
    return drawn
