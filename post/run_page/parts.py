# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene's layers as parts that a page draws: cells, triangles, polygons, points and lines.

A part is what never changes, and a function that has what changes of a snapshot."""
from dataclasses import dataclass
from typing import Callable

import numpy
from matplotlib import colors

import style
from run_page import encode
from scene import bars, box, elements, flow, points, quantities, topology


@dataclass
class Part:
    draw: str  # the function of fields.js
    fixed: dict
    at: Callable


class Maker:
    """Makes the parts of a scene that has its limits and scales."""

    def __init__(self, scene):
        self.scene, self.scales = scene, scene.scales
        self.kinds = {points.Points: self.of_points, bars.Bars: self.of_bars, elements.Elements: self.of_elements,
                      flow.Flow: self.of_flow, box.BoxLayer: self.of_box}

    def parts(self):
        """The parts of all layers, those below first; of a scene in space pictures."""
        if self.in_space:
            return [self.pictures(self.scene.layers[0])]
        return [part for layer in self.scene.layers for part in self.kinds[type(layer)](layer)]

    @property
    def in_space(self):
        return self.scene.layers[0].fields.dimension == 3

    def pictures(self, layer):
        """What plot.py draws of each snapshot."""
        right, top = layer.limits([])[1::2]
        return Part("image", {"xy": self.places([(0, 0), (right, top)])}, lambda record: {"jpeg": encode.jpeg_of(layer.image(record))})

    def places(self, found):
        return encode.places(found, self.scene.limits)

    def number_of(self, scale):
        return next(k for k, other in enumerate(self.scales) if other is scale)

    def of_points(self, layer):
        """Squares of gas, fluids and solids, lines of membranes."""
        unknown = 0.01 * (self.scene.limits[1] - self.scene.limits[0])
        side = float(numpy.median(numpy.nan_to_num(layer.sides(layer.fields.at(0)), nan=unknown)))
        found = []
        for kind in layer.kinds.values():
            if kind.name == "membrane":
                found += [self.membrane(layer, kind, k, body) for k, (body, _) in enumerate(kind.bodies)]
            else:
                found.append(self.squares(layer, kind, side))
        return found

    def squares(self, layer, kind, side):
        def at(record):
            values = layer.values(kind, record)
            shown = values["value"] if kind.scale else numpy.zeros(len(values["places"]))
            return {"xy": self.places(values["places"]), "v": encode.shades(shown, kind.scale or quantities.Scale("speed", "1"))}
        return Part("points", {"side": side, "scale": self.number_of(kind.scale) if kind.scale else -1}, at)

    def membrane(self, layer, kind, number, body):
        def at(record):
            values = layer.values(kind, record)
            return self.lines(points.pieces(values["places"][values["body"] == body]))
        return Part("lines", {"colour": style.MEMBRANES[number % len(style.MEMBRANES)], "width": 2}, at)

    def lines(self, pieces):
        """Lines of places after each other, and how many each has."""
        pieces = [piece for piece in pieces if len(piece)]
        return {"xy": self.places(numpy.concatenate(pieces) if pieces else numpy.zeros((0, 2))),
                "n": encode.text_of(numpy.array([len(piece) for piece in pieces], dtype=numpy.uint32))}

    def of_bars(self, layer):
        """Lines from mass to mass."""
        return [Part("lines", {"colour": style.OURS[0], "width": 3}, lambda record: self.lines([layer.fields.places(record)]))]

    def of_elements(self, layer):
        start = Part("edges", {"colour": "#a6a6a6", "xy": self.places(layer.fields.start), "e": self.numbers(layer.outline)},
                     lambda record: {})
        outline = Part("edges", {"colour": "#262626", "e": self.numbers(layer.outline)},
                       lambda record: {"xy": self.places(layer.fields.places(record))})
        return [start, self.triangles(layer), outline]

    @staticmethod
    def numbers(nodes):
        return encode.text_of(numpy.asarray(nodes, dtype=numpy.uint32))

    def triangles(self, layer):
        scale = layer.scales[0] if layer.scales else None

        def at(record):
            found = {"xy": self.places(layer.fields.places(record))}
            return found | ({"v": encode.shades(layer.values(record), scale)} if scale else {})
        fixed = {"t": self.numbers(topology.triangles(layer.elements)), "scale": self.number_of(scale) if scale else -1}
        return Part("triangles", fixed | {"colour": colors.to_hex(style.RIGID_MAP(0.0))}, at)

    def of_flow(self, layer):
        """Triangles of the mesh, streamlines and walls."""
        mesh = layer.mesh
        field = Part("triangles", {"t": self.numbers(mesh.triangles.triangles), "scale": self.number_of(layer.scales[0]),
                                   "xy": self.places(layer.fields.start)},
                     lambda record: {"v": encode.shades(layer.values(record), layer.scales[0])})
        walls = Part("edges", {"colour": "#000000", "xy": self.places(layer.fields.start),
                               "e": self.numbers(topology.outer_edges(mesh.elements))}, lambda record: {})
        if "stream" not in layer.fields.names:
            return [field, walls]
        lines = Part("lines", {"colour": "#303030", "width": 0.7}, lambda record: self.lines(streamlines(layer, record)))
        return [field, lines, walls]

    def of_box(self, layer):
        """Cells, obstacles among them, and bodies."""
        found, bodies = [self.cells(layer)], layer.scene.bodies
        if bodies:
            shown = elements.Elements(bodies, "energy density")
            shown.scales = [layer.scene.energy]
            found += [at_times(part, bodies, layer.times) for part in self.of_elements(shown)]
        return found

    def cells(self, layer):
        edges = layer.scene.box.edges

        def at(record):
            cells = layer.fields.at(record)
            kind, values = cells["kind"], quantities.value_of(cells, layer.name)
            return {"v": encode.shades(numpy.where(kind == box.FLUID, values, numpy.nan), layer.scale),
                    "o": encode.text_of((kind == box.OBSTACLE).astype(numpy.uint8))}
        corners = self.places([(edges["x"][0], edges["y"][0]), (edges["x"][-1], edges["y"][-1])])
        fixed = {"nx": len(edges["x"]) - 1, "ny": len(edges["y"]) - 1, "xy": corners, "scale": self.number_of(layer.scale)}
        return Part("cells", fixed, at)


def at_times(part, fields, times):
    """A part of another file by the numbers of the scene's snapshots."""
    return Part(part.draw, part.fixed, lambda record: part.at(fields.record(float(times[record]))))


def streamlines(layer, record):
    """Lines of the stream function, those of eddies where they are closed."""
    stream = layer.fields.at(record, ["stream"])["stream"]
    if not numpy.isfinite(stream).all():
        return []
    main, weak = layer.mesh.levels(stream, reach=layer.reach)
    return layer.mesh.lines(stream, main) + layer.mesh.closed(stream, weak)
