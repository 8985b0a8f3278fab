# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite elements where they are, over the outline of where they were: elastic bodies, rigid ones, bodies in a fluid."""
import numpy
from matplotlib import collections, patches, tri

import style
from scene import quantities, space, topology

CHOICES = ("von Mises stress", "energy density", "stress")


class Elements:
    """A layer of mesh.nc or solids.nc: deformed bodies coloured by a quantity, in the plane or in space."""

    def __init__(self, fields, name=None):
        self.fields, self.times = fields, fields.times
        self.elements, self.dimension = fields.elements, fields.dimension
        self.name = name or next((choice for choice in CHOICES if quantities.has(fields, choice)), None)
        self.scales = [quantities.Scale(self.name, quantities.unit(fields, self.name))] if self.name else []
        self.outline = topology.outer_edges(self.elements) if self.dimension == 2 else None
        self.faces = topology.outer_faces(self.elements) if self.dimension == 3 else None

    def values(self, record):
        """The quantity at the nodes, None for bodies without one, which are rigid."""
        return quantities.value_of(self.fields.at(record), self.name) if self.name else None

    def picture(self, places):
        return places if self.dimension == 2 else space.flat(places)[0]

    def limits(self, records):
        everywhere = [self.fields.start] if self.dimension == 2 else []
        everywhere += [self.fields.places(record) for record in records]
        return quantities.largest(quantities.limits_of(self.picture(places)) for places in everywhere)

    def fit(self, records):
        for scale in self.scales:
            scale.fit([self.values(record) for record in records])

    def draw(self, axes, record):
        if self.dimension == 3:
            self.draw_space(axes, record)
        else:
            self.draw_plane(axes, record)

    def draw_plane(self, axes, record):
        start, places, values = self.fields.start, self.fields.places(record), self.values(record)
        axes.add_collection(collections.LineCollection(start[self.outline], **style.BEFORE))
        if not numpy.isfinite(places).all():
            return
        mesh = tri.Triangulation(*places.T, topology.triangles(self.elements))
        if values is None:
            axes.tripcolor(mesh, numpy.zeros(len(places)), cmap=style.RIGID_MAP, vmin=0, vmax=1, zorder=3)
        else:
            axes.tripcolor(mesh, numpy.nan_to_num(values), cmap=self.scales[0].colours, norm=self.scales[0].norm,
                           shading="gouraud", zorder=3)
        axes.add_collection(collections.LineCollection(places[self.outline], **style.OUTLINE))

    def draw_space(self, axes, record):
        places, values = self.fields.places(record), self.values(record)
        if values is None:
            colours = numpy.tile(style.RIGID_MAP(0.0), (len(self.faces), 1))
        else:
            colours = self.scales[0].rgba(numpy.nan_to_num(values[self.faces].mean(axis=1)))
        space.draw_faces(axes, places, self.faces, colours)
        space.draw_triad(axes)

    @property
    def handles(self):
        """What the legend explains."""
        if self.dimension == 3:
            return []
        return [patches.Patch(fill=False, edgecolor=style.BEFORE["color"], label="at the start")]

    axes_names = ("x", "y")
