# SPDX-License-Identifier: GPL-3.0-or-later
"""THE table of what is drawn of which kind of run. A kind is known by a column that its histories alone have."""
from dataclasses import dataclass

import command
import tether_results
import titles
from scene import histories, last_values, moments, quantities
from scene.bars import Bars
from scene.box import BoxLayer, is_painted
from scene.elements import Elements
from scene.flow import Flow
from scene.frame import Scene
from scene.points import Points

MESHES, POINTS = "iout(39)=1 and tiout(39)=TIME write mesh.nc", "iout(13)=1 and tiout(13)=TIME write particles.nc"


@dataclass(frozen=True)
class Kind:
    """How a kind of run is drawn: layers of its scene, histories, and the switch that has it write snapshots."""

    name: str
    column: str
    fields: str
    layers: tuple
    histories: tuple
    switch: str
    note: str = ""


def bodies_in(run, _=None):
    """Bodies in a flow, which are in a file of their own."""
    return Elements(run.fields("solids")) if run.has("solids") else None


def of_mesh(run, name=None):
    return Elements(run.fields("mesh"), name)


KINDS = (
    Kind("box", "fluid_volume", "mesh", (BoxLayer,),
         (histories.places, histories.energies, histories.works, histories.forces, histories.volumes, histories.smoke),
         MESHES),
    Kind("flow", "stream_max", "mesh", (Flow, bodies_in),
         (histories.places, histories.drag, histories.lift, histories.pressure_differences, histories.forces,
          histories.energies, histories.works), MESHES),
    Kind("rigid", "director_1_x", "mesh", (of_mesh,),
         (histories.places, histories.spin, histories.energies, histories.works), MESHES),
    Kind("points", "energy_transfer", "particles", (Points,),
         (histories.places, histories.velocities, histories.energies), POINTS),
    Kind("bars", "energy_step", "particles", (Bars,), (histories.places, histories.energies), POINTS),
    Kind("solids", "energy_supports", "mesh", (of_mesh,),
         (histories.places, histories.energies, histories.works, histories.volumes), MESHES),
)


def kind_of(run):
    """The row of the table for a run."""
    return next((kind for kind in KINDS if kind.column in run.history.columns), KINDS[-1])


def is_steady(run):
    """Whether the first snapshot is nothing but the guess that a steady or static run starts from."""
    return ".true." in (run.deck_values.get("fem.static"), run.deck_values.get("flow.steady"))


def title_of(run):
    """The run's name and what it is about."""
    return titles.title(run.name, run.title)


def known_fields(fields):
    """The names that a file's snapshots may be coloured by."""
    return [name for name in quantities.DERIVED if quantities.has(fields, name)] + \
           [name for name in fields.names if name not in ("x", "y", "z", "id")]


def scene_of(run, name=None):
    """The scene of a run, coloured by what matters or by the field of this name, or a liquid in this colour; None where it wrote no snapshots."""
    kind = kind_of(run)
    if not run.has(kind.fields):
        return None
    known = known_fields(run.fields(kind.fields))
    if name and name not in known and not is_painted(run.fields(kind.fields), name):
        raise command.Refused(f"{run.folder}: no field {name}; there are {', '.join(known)}")
    layers = [layer for make in kind.layers if (layer := make(run, name)) is not None]
    return Scene(layers, title_of(run), kind.note)


def needed_scene(run, name=None):
    """The scene of a run. Raises NotARun, which says what writes snapshots, where there are none."""
    scene = scene_of(run, name)
    if scene is None:
        raise tether_results.NotARun(f"{run.folder}: has no snapshots: {kind_of(run).switch}")
    return scene


def records_of(run, scene, times=()):
    """The snapshots that are drawn: those nearest to these times, or some that show it; of a steady run the last."""
    if times:
        return sorted({scene.layers[0].fields.record(float(time)) for time in times})
    if is_steady(run):
        return [len(scene.times) - 1]
    return moments.telling(run, scene.times)


def histories_of(run):
    """The figure of histories; of a run of few records a table of the last one."""
    if len(run.history) <= last_values.FEW:
        return last_values.figure(run, title_of(run))
    return histories.figure(run, kind_of(run).histories, title_of(run))
