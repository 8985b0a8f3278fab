# SPDX-License-Identifier: GPL-3.0-or-later
"""Finite elements where they are, over the outline of where they were: elastic bodies, rigid ones, bodies in a fluid."""
import numpy
from matplotlib import collections, patches, tri

import style
from scene import in_space, quantities, topology

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

    def limits(self, records):
        """Of the picture; in space those of the room that fit() has made."""
        if self.dimension == 3:
            return self.room.limits
        everywhere = [self.fields.start, *(self.fields.places(record) for record in records)]
        return quantities.largest(quantities.limits_of(places) for places in everywhere)

    def fit(self, records):
        if self.dimension == 3:
            places = numpy.concatenate([self.fields.start, *(self.fields.places(record) for record in records)])
            self.room = in_space.Room(*in_space.room_around(places[numpy.isfinite(places).all(axis=1)]))
        for scale in self.scales:
            scale.fit([self.values(record) for record in records])

    def draw(self, axes, record):
        if self.dimension == 3:
            self.room.show(axes, self.image(record))
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

    def image(self, record):
        """The picture of bodies in space."""
        places, values = self.fields.places(record), self.values(record)
        if not numpy.isfinite(places).all():
            return self.room.picture.draw([])
        if values is None:
            colours = numpy.tile(style.RIGID_MAP(0.0), (len(places), 1))
        else:
            colours = self.scales[0].rgba(numpy.nan_to_num(values))
        return self.room.picture.draw([in_space.surface_of(places, self.faces, colours[:, :3])])

    @property
    def handles(self):
        """What the legend explains."""
        if self.dimension == 3:
            return []
        return [patches.Patch(fill=False, edgecolor=style.BEFORE["color"], label="at the start")]

    axes_names = ("x", "y")
