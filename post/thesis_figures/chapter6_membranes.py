# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 6.2: a dog-bone of gas in a membrane becomes a cylinder, on four grids."""
from dataclasses import dataclass

import numpy

import style

TIMES = (0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3)  # of the frames; another one shows the end
RECORDS = ("in.tiout(13)=0.05", "in.tiout(33)=0.005", "in.tiout(34)=0.005",
           "points.tracked_at(1,1)=0.5,0.0,0.0,1.0")  # the membrane's ends, on the axes
ROBUST = ("mpm.method='robust'",)
FIRST_GAS_ENERGY = 250.0  # specific, of all decks


@dataclass(frozen=True)
class Simulation:
    """What the thesis says of it, and how long the runs are here."""

    number: int
    cell: str
    end: float
    radii: tuple  # at 0 and 90 degrees at the end, Table 5
    loss: float  # of energy in percent, from the text
    remark: str = ""
    settings: tuple = ()  # what the run of the thesis' method needs besides

    def run(self, runs, *settings):
        return runs.of(f"membrane-expansion-{self.number}", f"in.tmax={self.end}", *RECORDS, *settings)

    def thesis(self, runs):
        return self.run(runs, *self.settings)

    def robust(self, runs):
        return self.run(runs, *ROBUST)


SIMULATIONS = (
    Simulation(1, "0.4", 6.0, (1.08, 1.13), 3.6,
               "The run ends at t = 6: later a point of the membrane leaves the grid through its open edge."),
    Simulation(2, "0.2", 8.5, (1.335, 1.334), 3.4),
    Simulation(3, "0.1", 3.0, (1.388, 1.387), 1.2, "The run ends at t = 3, before all oscillations have died away."),
    Simulation(4, "0.05", 1.0, (1.394, 1.396), 1.0,
               "The runs end at t = 1. The thesis' method has the gas density from the grid here (mpm.density='grid'):\n"
               "with the deck's, by the continuity equation, the run diverges at t = 0.145, when gas points fly off.",
               ("mpm.density='grid'",)),
)


def of_membrane(run):
    """Which points are the membrane's, the body that stands last."""
    body = run.particles["body"][0]
    return body == body.max()


def nearest(run, time):
    return int(numpy.argmin(abs(run.particles["time"] - time)))


def frame(axes, run, record):
    membrane = of_membrane(run)
    x, y = run.particles["x"][record], run.particles["y"][record]
    size = {"markersize": 2.0 if len(x) < 2000 else 1.0}
    axes.plot(x[~membrane], y[~membrane], color="tab:cyan", label="gas", **style.POINTS | size)
    axes.plot(x[membrane], y[membrane], color="tab:red", label="membrane", **style.POINTS | size)
    axes.set_title(style.at_time(run.particles["time"][record], run.particles.units["time"]))
    frame_grid(axes, run.summary["dx"])


def frame_grid(axes, width):
    axes.set_aspect("equal")
    axes.set_xlim(0, 1.6)
    axes.set_ylim(0, 1.6)
    axes.grid(False)
    for at in numpy.arange(0, 1.6, width):
        axes.axvline(at, **style.GRID)
        axes.axhline(at, **style.GRID)


def quarter(axes, radius, **look):
    angle = numpy.linspace(0, numpy.pi / 2, 91)
    axes.plot(radius * numpy.cos(angle), radius * numpy.sin(angle), **look)


def label_outer(axes, run, columns):
    for k, panel in enumerate(axes):
        panel.set_xticks((0, 0.5, 1, 1.5))
        panel.set_yticks((0, 0.5, 1, 1.5))
        if k + columns >= len(axes):
            panel.set_xlabel(style.label("x", run.particles.units["x"]))
        if k % columns == 0:
            panel.set_ylabel(style.label("y", run.particles.units["y"]))


def frames(runs, simulation):
    run = simulation.thesis(runs)
    records = [nearest(run, time) for time in TIMES] + [-1]
    figure, axes = style.panels(len(records), 4, 2.4, 2.5)
    for panel, record in zip(axes, records):
        frame(panel, run, record)
    radius = run.summary["exact_radius_x"]
    quarter(axes[-1], radius, **style.EXACT | {"label": f"at rest, exact: {radius:.3f}"})
    label_outer(axes, run, 4)
    axes[0].legend(*axes[-1].get_legend_handles_labels(), loc="upper right", markerscale=3, fontsize=7)
    style.note(figure, simulation.remark)
    return figure


def draw_radii(axes, run, name, colours, **look):
    history = run.history
    for values, angle, colour in ((history["point_x"][:, 0], 0, colours[0]), (history["point_y"][:, 1], 90, colours[1])):
        axes.plot(history["time"], values, color=colour, label=f"{name}, {angle}°", **look)


def draw_loss(axes, run, name, **look):
    energy = run.history["energy_total"]
    axes.plot(run.history["time"], 100 * (energy / energy[0] - 1), label=name, **look)


def published(axes, end, values):
    """As short lines at the right edge."""
    for value in values:
        axes.plot([0.97 * end, end], [value, value], color="tab:red", linewidth=2.2, label="thesis, at the end", zorder=4)


def radii_and_energy(runs, simulation):
    thesis, robust = simulation.thesis(runs), simulation.robust(runs)
    figure, axes = style.panels(2, 1, 8, 3.0)
    draw_radii(axes[0], robust, "robust", ("0.75", "0.55"), linewidth=0.9)
    draw_radii(axes[0], thesis, "thesis' method", ("tab:blue", "tab:orange"), linewidth=0.9)
    radius = thesis.summary["exact_radius_x"]
    axes[0].axhline(radius, **style.EXACT | {"label": f"at rest, exact: {radius:.3f}"})
    end = thesis.history["time"][-1]
    published(axes[0], end, simulation.radii)
    draw_loss(axes[1], robust, "robust", color="0.55", linewidth=0.9)
    draw_loss(axes[1], thesis, "thesis' method", color="tab:blue", linewidth=0.9)
    published(axes[1], end, (-simulation.loss,))
    axes[0].set_ylabel(style.label("radius", thesis.history.units["point_x"]))
    axes[1].set_ylabel("change of total energy [%]")
    for panel in axes:
        panel.set_xlim(0, end)
        panel.set_xlabel(style.label("time", thesis.history.units["time"]))
        style.legend_above(panel, 3)
    style.note(figure, simulation.remark)
    return figure


def of_grid(run, record, chosen, values):
    """Mean of the chosen points' values at the nodes, by mass and linear shape functions, NaN where none is near."""
    width, count = run.summary["dx"], int(round(1.6 / run.summary["dx"])) + 1
    x, y = run.particles["x"][record][chosen] / width, run.particles["y"][record][chosen] / width
    mass = run.particles["mass"][record][chosen]
    sums, masses = numpy.zeros((count, count)), numpy.zeros((count, count))
    i, j = x.astype(int), y.astype(int)
    for a in (0, 1):
        for b in (0, 1):
            share = mass * abs(1 - a - (x - i)) * abs(1 - b - (y - j))
            numpy.add.at(sums, (j + b, i + a), share * values[chosen])
            numpy.add.at(masses, (j + b, i + a), share)
    with numpy.errstate(invalid="ignore"):
        return numpy.where(masses > 1e-3 * masses.max(), sums / masses, numpy.nan)


def contours(runs):
    """Contours of pressure and membrane stress in simulation 4."""
    simulation = SIMULATIONS[3]
    run = simulation.robust(runs)
    particles, membrane = run.particles, of_membrane(run)
    tangent = particles["sxx"][-1] + particles["syy"][-1]  # the only stress in the plane: its trace
    figure, axes = style.panels(2, 2, 4.8, 4.2)
    nodes = numpy.linspace(0, 1.6, int(round(1.6 / run.summary["dx"])) + 1)
    for panel, chosen, values, name, exact in (
            (axes[0], ~membrane, particles["pressure"][-1], "pressure of the gas", run.summary["exact_pressure"]),
            (axes[1], membrane, tangent, "tangent stress of the membrane", run.summary["exact_stress"])):
        frame_grid(panel, run.summary["dx"])
        drawn = panel.contourf(nodes, nodes, of_grid(run, -1, chosen, values), 12, cmap="viridis", zorder=1)
        figure.colorbar(drawn, ax=panel, shrink=0.85)
        mean = numpy.average(values[chosen], weights=particles["volume"][-1][chosen])
        panel.set_title(f"{name}\nmean {mean:.1f}; at rest, exact: {exact:.1f}")
        quarter(panel, run.summary["exact_radius_x"], **style.EXACT | {"linewidth": 0.7})
    label_outer(axes, run, 2)
    style.note(figure, f"At t = {particles['time'][-1]:.3g}, before the gas has come to rest (the thesis shows the end, pressure "
                       "29.0 and stress 447);\nrobust method. Points' values at the nodes by mass and linear shape functions, "
                       "unsmoothed.")
    return figure


def expansion_frames(number):
    def draw(runs):
        return frames(runs, SIMULATIONS[number - 1])
    draw.__doc__ = f"Membrane expansion {number}, cells of {SIMULATIONS[number - 1].cell}: material points."
    return draw


def expansion_history(number):
    def draw(runs):
        return radii_and_energy(runs, SIMULATIONS[number - 1])
    draw.__doc__ = f"Membrane expansion {number}, cells of {SIMULATIONS[number - 1].cell}: radii and energy."
    return draw


FIGURES = {"48": expansion_frames(1), "49": expansion_history(1), "50": expansion_frames(2), "51": expansion_history(2),
           "52": expansion_frames(3), "53": expansion_history(3), "54": expansion_frames(4), "55": expansion_history(4),
           "56": contours}
