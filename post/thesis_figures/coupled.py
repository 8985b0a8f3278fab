# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of the coupled path: fluid and bodies at six times, and what the piston and the block are compared with."""
from dataclasses import dataclass

import numpy

import style
from scene.box import BoxLayer
from scene.frame import Scene


@dataclass(frozen=True)
class Shown:
    """How a deck's run is drawn."""

    field: str  # smoke, speed or p
    times: tuple  # [s]


SHOWN = {
    "coupled-piston": Shown("p", (0.25, 0.75)),
    "coupled-archimedes": Shown("p", (1.0,)),
    "coupled-balloon": Shown("speed", (0.0, 0.3, 0.4, 0.6, 1.0, 10.0)),
    "coupled-bar": Shown("smoke", (0.3, 0.6, 1.0, 2.0, 5.0, 10.0)),
    "coupled-bar-3d": Shown("smoke", (0.3, 0.6, 1.0, 2.0, 5.0, 10.0)),
    "coupled-blocks": Shown("speed", (0.0, 0.3, 0.5, 0.7, 1.0, 2.0)),
    "coupled-paddle": Shown("smoke", (0.4, 0.6, 0.8, 1.2, 4.4, 8.0)),
    "coupled-paddle-3d": Shown("smoke", (0.4, 0.6, 0.8, 1.2, 4.4, 8.0)),
    "coupled-sheets": Shown("smoke", (0.4, 0.8, 1.2, 2.0, 5.0, 10.0)),
    "coupled-sheets-3d": Shown("smoke", (0.6, 1.2, 1.8, 2.6, 5.0, 10.0)),
    "coupled-toy": Shown("speed", (0.0, 0.2, 0.3, 0.45, 0.8, 10.0)),
    "coupled-toy-3d": Shown("speed", (0.0, 0.2, 0.3, 0.45, 0.8, 5.0)),
}
CELLS = (16, 32, 64)  # along each side of the box of the block under water
LIFT = 1000 * 9.81 * 0.05999736  # rho g times the area between the deck's vertices [N/m]


def note_of(layer):
    """What a reader must know of a picture in space."""
    if layer.scene.dim == 2:
        return ""
    return "Bodies are drawn clear, so that the speed inside is seen." if layer.name == "speed" else ""


def frames(runs, deck):
    """The scene at each of its times."""
    run, shown = runs.of(deck), SHOWN[deck]
    layer = BoxLayer(run, shown.field)
    return Scene([layer], deck, note_of(layer)).figure([layer.fields.record(time) for time in shown.times])


def snapshot(figure, axes, run, deck, time):
    layer = BoxLayer(run, SHOWN[deck].field)
    layer.fit(range(len(layer.times)))
    record = layer.fields.record(time)
    layer.draw(axes, record)
    axes.set_xlabel(style.label("x", layer.scene.units["x"]))
    axes.set_ylabel(style.label("y", layer.scene.units["y"]))
    axes.set_title(style.at_time(layer.times[record], layer.fields.units["time"]))
    for scale in layer.scales:
        figure.colorbar(scale.mappable(), ax=axes, label=scale.label, extend=scale.extend)


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
    style.note(figure, "Exact is sin(2 pi t) with the speed that the block begins with; the paper's step damps by h omega/4.")
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


def blocks(runs):
    """Three blocks of rubber that sink onto each other in a tank of water."""
    return frames(runs, "coupled-blocks")


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
           for draw in (piston, archimedes, balloon, bar, bar_3d, blocks, paddle, paddle_3d, sheets, sheets_3d, toy,
                        toy_3d)}
