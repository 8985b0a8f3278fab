# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of the coupled path: fluid and bodies at six times, and what the piston and the block are compared with."""
from dataclasses import dataclass

import numpy

import style
from thesis_figures.coupled_scene import CoupledScene


@dataclass(frozen=True)
class Shown:
    """How a deck's run is drawn."""

    field: str  # smoke, speed or p
    colours: str
    times: tuple  # [s]


SMOKE, SPEED, PRESSURE = ("smoke", "gray_r"), ("speed", "Blues"), ("p", "coolwarm")
SHOWN = {
    "coupled-piston": Shown(*PRESSURE, (0.25, 0.75)),
    "coupled-archimedes": Shown(*PRESSURE, (1.0,)),
    "coupled-balloon": Shown(*SPEED, (0.0, 0.3, 0.4, 0.6, 1.0, 10.0)),
    "coupled-bar": Shown(*SMOKE, (0.3, 0.6, 1.0, 2.0, 5.0, 10.0)),
    "coupled-bar-3d": Shown(*SMOKE, (0.3, 0.6, 1.0, 2.0, 5.0, 10.0)),
    "coupled-paddle": Shown(*SMOKE, (0.4, 0.6, 0.8, 1.2, 4.4, 8.0)),
    "coupled-paddle-3d": Shown(*SMOKE, (0.4, 0.6, 0.8, 1.2, 4.4, 8.0)),
    "coupled-sheets": Shown(*SMOKE, (0.4, 0.8, 1.2, 2.0, 5.0, 10.0)),
    "coupled-sheets-3d": Shown(*SMOKE, (0.6, 1.2, 1.8, 2.6, 5.0, 10.0)),
    "coupled-toy": Shown(*SPEED, (0.0, 0.2, 0.3, 0.45, 0.8, 10.0)),
    "coupled-toy-3d": Shown(*SPEED, (0.0, 0.2, 0.3, 0.45, 0.8, 10.0)),
}
AXES_LABELS = {"smoke": "density of smoke", "speed": "speed", "p": "pressure"}
ENERGY = "Bodies are coloured by their energy density, from pale to dark red, which the largest 2 % of all have, too."
CELLS = (16, 32, 64)  # along each side of the box of the block under water
LIFT = 1000 * 9.81 * 0.05999736  # rho g times the area between the deck's vertices [N/m]


def unit_of(scene, field):
    return scene.units.get("vx" if field == "speed" else field, "1")


def frames(runs, deck, columns=3):
    """The scene at each of its times."""
    shown, scene = SHOWN[deck], CoupledScene(runs.of(deck))
    extent = scene.extent()
    height = 3.8 * (extent[3] - extent[2]) / (extent[1] - extent[0]) + 0.4
    figure, panels = style.panels(len(shown.times), columns, 3.8, height)
    most = scene.most(shown.field)
    for panel, time in zip(panels, shown.times):
        record = scene.record_at(time)
        image = scene.draw(panel, record, shown.field, most, shown.colours)
        panel.set_title(style.at_time(scene.times[record], scene.units["time"]))
    if image is not None:
        figure.colorbar(image, ax=panels, label=style.label(AXES_LABELS[shown.field], unit_of(scene, shown.field)))
    style.note(figure, ENERGY + ("" if scene.dim == 2 else " Seen aslant; darker where there is more of the "
                                 f"{'smoke' if shown.field == 'smoke' else 'speed'} in the way."))
    return figure


def snapshot(figure, axes, run, deck, time):
    shown, scene = SHOWN[deck], CoupledScene(run)
    record = scene.record_at(time)
    image = scene.draw(axes, record, shown.field, scene.most(shown.field), shown.colours)
    axes.set_title(style.at_time(scene.times[record], scene.units["time"]))
    figure.colorbar(image, ax=axes, label=style.label("pressure", unit_of(scene, "p")))


def piston(runs):
    """A block on a spring in a channel of water: pressure, and displacement beside that at 1 Hz."""
    figure, (field, motion) = style.panels(2, 2, 6.0, 3.2)
    cases = (("trapezoidal rule", "'trapezoid'"), ("the paper's step", "'paper'"))
    for name, integrator in cases:
        run = runs.of("coupled-piston", f"coupled.integrator={integrator}")
        time, x = run.history["time"], run.history["body_x"][:, 0]
        motion.plot(time, x - x[0], label=name)
    motion.plot(time, 0.05 / (2 * numpy.pi) * numpy.sin(2 * numpy.pi * time), **style.EXACT)
    motion.set_xlabel("time [s]")
    motion.set_ylabel("displacement [m]")
    style.legend_above(motion, 3)
    snapshot(figure, field, runs.of("coupled-piston", f"coupled.integrator={cases[0][1]}"), "coupled-piston", 0.25)
    style.note(figure, "Exact is sin(2 pi t) with the speed that the block begins with; the paper's step damps by h omega/4. "
               + ENERGY)
    return figure


def archimedes(runs):
    """A rotated block held in water at rest: pressure, and the error of the lift over cells."""
    figure, (field, error) = style.panels(2, 2, 5.0, 4.0)
    for mode in ("symmetric", "cut-cell"):
        errors = []
        for cells in CELLS:
            size = [f"in.{name}={cells + 1}" for name in ("nx", "ny")]
            run = runs.of("coupled-archimedes", f"coupled.mode='{mode}'", "in.tmax=1.", *size)
            errors.append(abs(run.history["body_force_y"][-1, 0] / LIFT - 1))
        error.loglog(CELLS, errors, marker="o", label=mode)
    error.set_xlabel("cells along a side")
    error.set_ylabel("relative error of the lift")
    style.legend(error)
    snapshot(figure, field, runs.of("coupled-archimedes", "in.tmax=1."), "coupled-archimedes", 1.0)
    style.note(figure, ENERGY)
    return figure


def balloon(runs):
    """A balloon full of water that is dropped on a floor."""
    return frames(runs, "coupled-balloon")


def bar(runs):
    """A bar in a stream of water with dye."""
    return frames(runs, "coupled-bar")


def bar_3d(runs):
    """A bar in a stream of water with dye, in space."""
    return frames(runs, "coupled-bar-3d")


def paddle(runs):
    """A paddle, hinged above a floor, in a jet of smoke."""
    return frames(runs, "coupled-paddle")


def paddle_3d(runs):
    """A paddle, hinged above a floor, in a jet of smoke, in space."""
    return frames(runs, "coupled-paddle-3d")


def sheets(runs):
    """Three sheets in a jet of smoke."""
    return frames(runs, "coupled-sheets")


def sheets_3d(runs):
    """Three sheets in a jet of smoke, in space."""
    return frames(runs, "coupled-sheets-3d")


def toy(runs):
    """A pentagon of rubber full of water that is dropped on a floor."""
    return frames(runs, "coupled-toy")


def toy_3d(runs):
    """A box of rubber full of water that is dropped on a floor, in space."""
    return frames(runs, "coupled-toy-3d")


FIGURES = {f"coupled-{draw.__name__.replace('_', '-')}": draw
           for draw in (piston, archimedes, balloon, bar, bar_3d, paddle, paddle_3d, sheets, sheets_3d, toy, toy_3d)}
