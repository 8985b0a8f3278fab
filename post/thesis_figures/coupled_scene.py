# SPDX-License-Identifier: GPL-3.0-or-later
"""Fluid and bodies of the coupled path's runs, drawn at one time: in space from the front, aslant, from back to front."""
import numpy
from matplotlib import collections, colormaps, tri

import style

FLUID, OBSTACLE = 0, 2  # kinds of cells
ASLANT = numpy.array((0.35, -0.25))  # what a place moves in the picture for each length that it is nearer
BODIES = colormaps["YlOrRd"]
LIGHT = numpy.array((-0.6, 0.6, 0.55))  # its direction
DENSE = 3.0  # of smoke of density 1, a layer as deep as the box takes exp(-DENSE) of what is behind it
CLEAR = 0.4  # share of the light that a body's face keeps back where the fluid is inside
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))  # of a tetrahedron, counter-clockwise from outside
MOST = 98.0  # per cent of the bodies' energy densities of the run: those beyond are drawn as that one


def axis_of(places):
    """Ascending middles of the cells along one axis, and their size."""
    middles = numpy.unique(places.round(9))
    return middles, middles[1] - middles[0]


def faces_of(elements):
    """Boundary faces of tetrahedra: those that one of them has."""
    faces = numpy.concatenate([elements[:, face] for face in FACES])
    _, first, count = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


class CoupledScene:
    """What mesh.nc and solids.nc of a run hold, record by record."""

    def __init__(self, run):
        self.fluid = run.fields("mesh")
        self.bodies = run.fields("solids")
        self.times = self.fluid["time"]
        self.units = self.fluid.units
        names = [name for name in ("node_x", "node_y", "node_z") if name in self.fluid]
        axes = [axis_of(self.fluid[name]) for name in names]
        self.middles, self.sizes = [middles for middles, _ in axes], [size for _, size in axes]
        self.shape = tuple(len(middles) for middles in reversed(self.middles))
        self.dim = len(axes)
        self.elements = self.bodies["element_nodes"].astype(int)
        self.faces = faces_of(self.elements) if self.dim == 3 else None
        self.most_energy = max(numpy.percentile(self.bodies["energy_density"], MOST), 1e-300)

    def record_at(self, time):
        return int(abs(self.times - time).argmin())

    def cells(self, name, record):
        """A field as an array over z (in space), y and x; `speed` is that of the velocities."""
        if name == "speed":
            return numpy.sqrt(sum(self.cells(part, record)**2 for part in ("vx", "vy", "vz")[:self.dim]))
        return self.fluid[name][record].reshape(self.shape)

    def most(self, name):
        """The largest size of a field over all times, in the fluid's cells."""
        return max(abs(numpy.where(self.cells("kind", k) == FLUID, self.cells(name, k), 0)).max()
                   for k in range(len(self.times))) or 1.0

    def extent(self, shift=(0.0, 0.0)):
        low, high = ([middles[end] + sign * size / 2 for middles, size in zip(self.middles[:2], self.sizes)]
                     for end, sign in ((0, -1), (-1, 1)))
        return low[0] + shift[0], high[0] + shift[0], low[1] + shift[1], high[1] + shift[1]

    def draw(self, axes, record, name, most, colours="gray_r"):
        """The field from 0 (or, where it has both signs, -most) to `most`, obstacles and bodies; the image, for a scale."""
        axes.set_aspect("equal")
        axes.grid(False)
        drawn = self.draw_plane if self.dim == 2 else self.draw_space
        return drawn(axes, record, name, most, colours)

    def draw_plane(self, axes, record, name, most, colours):
        kind, values = self.cells("kind", record), self.cells(name, record)
        shown = numpy.ma.masked_where((kind != FLUID), values)
        least = -most if name == "p" else 0
        image = axes.imshow(shown, origin="lower", extent=self.extent(), cmap=colours, vmin=least, vmax=most)
        axes.imshow(numpy.ma.masked_where(kind != OBSTACLE, kind), origin="lower", extent=self.extent(), cmap="bone",
                    vmin=0, vmax=4)
        x, y = (self.bodies[part][record] for part in "xy")
        axes.tripcolor(tri.Triangulation(x, y, self.elements), self.bodies["energy_density"][record], cmap=BODIES, vmin=0,
                       vmax=self.most_energy, shading="gouraud", zorder=3)
        axes.set_xlabel(style.label("x", self.units.get("node_x", "1")))
        axes.set_ylabel(style.label("y", self.units.get("node_y", "1")))
        return image

    def draw_space(self, axes, record, name, most, colours):
        """Layers of cells across z from the back to the front, each with the bodies' faces in it."""
        kind, values = self.cells("kind", record), self.cells(name, record)
        depth = self.sizes[2] * len(self.middles[2])
        face_z = self.bodies["z"][record][self.faces].mean(axis=1)
        layer_of = numpy.clip(numpy.searchsorted(self.middles[2], face_z), 0, len(self.middles[2]) - 1)
        for layer, z in enumerate(self.middles[2]):
            shift = self.shift(z)
            part = numpy.clip(values[layer] / most, 0, 1) * (kind[layer] == FLUID)
            ink = numpy.zeros((*part.shape, 4))
            ink[..., :3] = colormaps[colours](1.0)[:3]
            ink[..., 3] = 1 - numpy.exp(-DENSE * part * self.sizes[2] / depth)
            obstacles = numpy.zeros_like(ink)  # apart: between the cells' middles colours are mixed
            obstacles[kind[layer] == OBSTACLE] = (0.6, 0.65, 0.7, 1.0)
            axes.imshow(ink, origin="lower", extent=self.extent(shift), zorder=3 + layer, interpolation="bilinear")
            axes.imshow(obstacles, origin="lower", extent=self.extent(shift), zorder=3.2 + layer, interpolation="nearest")
            self.draw_faces(axes, record, numpy.flatnonzero(layer_of == layer), 3.5 + layer,
                            CLEAR if name == "speed" else 1.0)
        low, high = (self.extent(self.shift(self.middles[2][end])) for end in (0, -1))
        self.draw_box(axes, low, high)
        axes.set_xlim(min(low[0], high[0]), max(low[1], high[1]))
        axes.set_ylim(min(low[2], high[2]), max(low[3], high[3]))
        axes.set_xticks([])  # places are shifted by their depth
        axes.set_yticks([])
        return None

    def draw_box(self, axes, back, front):
        """Edges of the box of fluid, those behind it below all else."""
        corners = [[(side[x], side[y]) for x, y in ((0, 2), (1, 2), (1, 3), (0, 3))] for side in (back, front)]
        for corner, order in ((corners[0], 2.5), (corners[1], 3.9 + len(self.middles[2]))):
            axes.plot(*zip(*corner, corner[0]), color="0.6", linewidth=0.6, zorder=order)
        for ends in zip(*corners):
            axes.plot(*zip(*ends), color="0.6", linewidth=0.6, zorder=2.5)

    def shift(self, z):
        return ASLANT * (z - self.middles[2][0])

    def draw_faces(self, axes, record, chosen, order, alpha):
        """The faces that show their outer side, the nearer ones last."""
        places = numpy.stack([self.bodies[part][record] for part in "xyz"], axis=1)
        corners = places[self.faces[chosen]]
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        seen = normals @ numpy.array((-ASLANT[0], -ASLANT[1], 1.0)) > 0
        seen = numpy.flatnonzero(seen)[numpy.argsort(corners[seen][:, :, 2].mean(axis=1))]
        energy = self.bodies["energy_density"][record][self.faces[chosen[seen]]].mean(axis=1)
        colours = BODIES(0.3 + 0.7 * numpy.clip(energy / self.most_energy, 0, 1))
        light = 0.7 + 0.3 * numpy.clip(normals[seen] @ (LIGHT / numpy.linalg.norm(LIGHT)), 0, 1)
        colours[:, :3] *= light[:, None]
        flat = corners[seen][:, :, :2] + (corners[seen][:, :, 2:] - self.middles[2][0]) * ASLANT
        axes.add_collection(collections.PolyCollection(flat, facecolors=colours, edgecolors=colours, alpha=alpha,
                                                       linewidths=0.3 if alpha == 1 else 0, zorder=order))
