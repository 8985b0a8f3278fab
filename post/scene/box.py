# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid in a box of cells and the bodies in it, at one time; in space from the front, aslant, from back to front."""
import numpy
from matplotlib import collections, colormaps, colors, patches

import style
from scene import elements, quantities, space

FLUID, SOLID, OBSTACLE, VOID = 0, 1, 2, 3  # kinds of cells
ASLANT = numpy.array((0.35, -0.25))  # what a place moves in the picture for each length that it is nearer
LIGHT = numpy.array((-0.6, 0.6, 0.55))  # its direction
DENSE = 3.0  # of smoke of density 1, a layer as deep as the box takes exp(-DENSE) of what is behind it
CLEAR = 0.4  # share of the light that a body's face keeps back where the fluid is inside
MOST = 98.0  # per cent of the bodies' energy densities of the run: those beyond are drawn as that one
STONE = (0.6, 0.65, 0.7)


class BoxScene:
    """What mesh.nc and solids.nc of a run hold, record by record."""

    def __init__(self, run):
        self.fluid = run.fields("mesh")
        self.box, self.times = self.fluid.box, self.fluid.times
        self.units = self.fluid.units | self.box.units
        self.middles = list(self.box.axes.values())
        self.shape, self.dim = self.box.shape, self.box.dimension
        self.bodies = run.fields("solids") if run.has("solids") else None
        self.faces = elements.topology.outer_faces(self.bodies.elements) if self.dim == 3 and self.bodies else None
        self.energy = quantities.Scale("energy density", self.bodies.units["energy_density"] if self.bodies else "1")

    def fit_bodies(self, records):
        """The scale of the bodies' energy densities from some records."""
        if not self.bodies:
            return
        samples = numpy.concatenate([self.bodies.at(record)["energy_density"] for record in records])
        self.energy.high = max(float(numpy.nanpercentile(samples, MOST)), 1e-300) if numpy.isfinite(samples).any() else 1.0
        self.energy.extend = "max"

    def record_at(self, time):
        return self.fluid.record(float(time))

    def cells(self, name, record):
        """A field as an array over z (in space), y and x; `speed` is that of the velocities."""
        return quantities.value_of(self.fluid.at(record), name)

    def most(self, name):
        """The largest size of a field over all times, in the fluid's cells."""
        return max(numpy.nanmax(abs(self.in_fluid(name, record)), initial=0) for record in range(len(self.times))) or 1.0

    def in_fluid(self, name, record):
        """A field in the fluid's cells."""
        values = self.fluid.at(record)
        found = quantities.value_of(values, name)[values["kind"] == FLUID]
        return found[numpy.isfinite(found)]

    def extent(self, shift=(0.0, 0.0)):
        (left, right), (low, high) = (self.box.edges[axis][[0, -1]] for axis in "xy")
        return left + shift[0], right + shift[0], low + shift[1], high + shift[1]

    def limits(self):
        """Of the picture; in space the box's front is shifted against its back."""
        if self.dim == 2:
            return self.extent()
        return quantities.largest(self.extent(self.shift(self.middles[2][end])) for end in (0, -1))

    def draw(self, axes, record, name, scale):
        """The field, obstacles and bodies."""
        axes.set_aspect("equal")
        axes.grid(False)
        drawn = self.draw_plane if self.dim == 2 else self.draw_space
        drawn(axes, record, name, scale)

    def draw_plane(self, axes, record, name, scale):
        cells = self.fluid.at(record)
        kind, values = cells["kind"], quantities.value_of(cells, name)
        x, y = self.box.edges["x"], self.box.edges["y"]
        axes.pcolormesh(x, y, numpy.ma.masked_where((kind != FLUID) | ~numpy.isfinite(values), values), cmap=scale.colours,
                        norm=scale.norm, zorder=1)
        axes.pcolormesh(x, y, numpy.ma.masked_where(kind != OBSTACLE, kind), cmap=colors.ListedColormap([STONE]), zorder=1.5)
        if self.bodies:
            bodies = elements.Elements(self.bodies, "energy density")
            bodies.scales = [self.energy]
            bodies.draw(axes, self.bodies.record(float(self.times[record])))

    def draw_space(self, axes, record, name, scale):
        """Layers of cells across z from the back to the front, each with the bodies' faces in it."""
        cells = self.fluid.at(record)
        kind, values = cells["kind"], numpy.nan_to_num(quantities.value_of(cells, name))
        layers = numpy.diff(self.box.edges["z"])
        for layer, z in enumerate(self.middles[2]):
            shift = self.shift(z)
            part = numpy.clip(values[layer] / scale.high, 0, 1) * (kind[layer] == FLUID)
            self.draw_layer(axes, part * layers[layer] / layers.sum(), kind[layer], shift, layer, scale)
            self.draw_faces(axes, record, layer, CLEAR if name == "speed" else 1.0)
        self.draw_box(axes, *(self.extent(self.shift(self.middles[2][end])) for end in (0, -1)))

    def draw_layer(self, axes, depth, kind, shift, layer, scale):
        """A layer of cells; `depth` is the field's share of its largest, times the layer's share of the box."""
        ink = numpy.zeros((*depth.shape, 4))
        ink[..., :3] = colormaps[scale.colours](1.0)[:3]
        ink[..., 3] = 1 - numpy.exp(-DENSE * depth)
        obstacles = numpy.zeros_like(ink)  # apart: between the cells' middles colours are mixed
        obstacles[kind == OBSTACLE] = (*STONE, 1.0)
        axes.imshow(ink, origin="lower", extent=self.extent(shift), zorder=3 + layer, interpolation="bilinear")
        axes.imshow(obstacles, origin="lower", extent=self.extent(shift), zorder=3.2 + layer, interpolation="nearest")

    def draw_box(self, axes, back, front):
        """Edges of the box of fluid, those at its back below all else."""
        corners = [[(side[x], side[y]) for x, y in ((0, 2), (1, 2), (1, 3), (0, 3))] for side in (back, front)]
        for corner, order in ((corners[0], 2.5), (corners[1], 3.9 + len(self.middles[2]))):
            axes.plot(*zip(*corner, corner[0]), color="0.6", linewidth=0.6, zorder=order)
        for ends in zip(*corners):
            axes.plot(*zip(*ends), color="0.6", linewidth=0.6, zorder=2.5)

    def shift(self, z):
        return ASLANT * (z - self.middles[2][0])

    def draw_faces(self, axes, record, layer, alpha):
        """The faces of bodies in a layer that show their outer side, the nearer ones last."""
        if not self.bodies:
            return
        values = self.bodies.at(self.bodies.record(float(self.times[record])))
        places = numpy.stack([values[part] for part in "xyz"], axis=1)
        middle = places[self.faces][..., 2].mean(axis=1)
        layers = numpy.clip(numpy.searchsorted(self.middles[2], middle), 0, len(self.middles[2]) - 1)
        chosen = self.faces[layers == layer]
        corners = places[chosen]
        directions = space.normals(corners)
        seen = directions @ numpy.array((-ASLANT[0], -ASLANT[1], 1.0)) > 0
        seen = numpy.flatnonzero(seen)[numpy.argsort(corners[seen][:, :, 2].mean(axis=1))]
        energy = values["energy_density"][chosen[seen]].mean(axis=1)
        colours = space.shaded(self.energy.rgba(energy), directions[seen], LIGHT / numpy.linalg.norm(LIGHT), 0.7)
        pictures = corners[seen][:, :, :2] + (corners[seen][:, :, 2:] - self.middles[2][0]) * ASLANT
        axes.add_collection(collections.PolyCollection(pictures, facecolors=colours, edgecolors=colours, alpha=alpha,
                                                       linewidths=0.3 if alpha == 1 else 0, zorder=3.5 + layer))


def has_smoke(fluid):
    """Whether there is smoke in some snapshots."""
    return "smoke" in fluid.names and any(fluid.at(record)["smoke"].max() > 0 for record in (0, len(fluid) // 2, -1))


def field_that_matters(run):
    """Smoke where there is any; pressure where weight or open sides give it a level; else the speed."""
    fluid, values = run.fields("mesh"), run.deck_values
    if has_smoke(fluid):
        return "smoke"
    if values.get("coupled.fluid_in") == "cavities":
        return "speed"
    opened = any(values.get(f"coupled.side({side})") == "open" for side in range(1, 7))
    return "p" if opened or values.get("in.gravc") else "speed"


class BoxLayer:
    """A layer of a box: a field of the fluid, obstacles, and bodies coloured by their energy density."""

    def __init__(self, run, name=None):
        self.scene = BoxScene(run)
        self.fields, self.times = self.scene.fluid, self.scene.times
        self.name = name or field_that_matters(run)
        self.scale = quantities.Scale(self.name, quantities.unit(self.fields, self.name))
        self.scales = [self.scale] + ([self.scene.energy] if self.scene.bodies else [])
        self.axes_names = ("x", "y") if self.scene.dim == 2 else None

    def limits(self, records):
        return self.scene.limits()

    def fit(self, records):
        samples = [self.scene.in_fluid(self.name, record) for record in records]
        self.scale.fit([*samples, numpy.zeros(1)], 0.0 if self.name == "smoke" else 0.1)
        self.scene.fit_bodies([record for record in records if self.scene.bodies])

    def draw(self, axes, record):
        self.scene.draw(axes, record, self.name, self.scale)

    @property
    def handles(self):
        """What the legend explains."""
        kinds = self.fields.at(0)["kind"]
        found = [patches.Patch(facecolor=STONE, label="obstacle")] if (kinds == OBSTACLE).any() else []
        if self.scene.dim == 2 and self.scene.bodies:
            found.append(patches.Patch(fill=False, edgecolor=style.BEFORE["color"], label="body at the start"))
        return found
