# SPDX-License-Identifier: GPL-3.0-or-later
"""A flow on a mesh: speed or pressure, and lines of the stream function on levels that are symmetric about its walls."""
import numpy
from matplotlib import collections, tri
from matplotlib._tri import TriContourGenerator

import style
from scene import quantities, topology

LINES = 12  # of the stream function, on either side of its middle
IN_EDDIES = (0.25, 0.6, 0.9)  # of an eddy's own extreme, where its lines are
TWO_WALLS = 5.0  # per cent of the outer nodes whose values count for nothing: at the corners of a lid they jump
ONE_WALL = 0.02  # of the stream function's range: walls that differ by less are one
AT_REST = 1e-6  # of its pressures: the kinetic energy of a fluid whose motion means nothing
SMALLEST = 1e-7  # of the stream function's range: what is weaker is no eddy


def both_sides(middle, sizes):
    """Numbers as far below a middle as above it, ascending."""
    return numpy.concatenate([middle - sizes[::-1], middle + sizes])


def is_at_rest(run, fields):
    """Whether the fluid's pressures do no more than hold it where it is: its motion is then rounding, or what the method makes
    of steps of pressure between nodes."""
    last = fields.at(-1, ["x", "y", "p"])
    room = numpy.ptp(last["x"]) * numpy.ptp(last["y"])
    return run.history["energy_kinetic"][-1] < AT_REST * numpy.ptp(last["p"]) * room


class FlowMesh:
    """What mesh.nc of a flow holds; its nodes stay where they are."""

    def __init__(self, fields):
        self.fields, self.times = fields, fields.times
        self.x, self.y = fields["node_x"], fields["node_y"]
        self.elements = fields.elements
        self.triangles = tri.Triangulation(self.x, self.y, topology.triangles(self.elements))

    def on_line(self, name, record, across, place):
        """Of the nodes whose coordinate `across` (x or y) is `place`: the other one, ascending, and the field."""
        along = "y" if across == "x" else "x"
        nodes = numpy.flatnonzero(abs(self.fields[f"node_{across}"] - place) < 1e-9)
        nodes = nodes[numpy.argsort(self.fields[f"node_{along}"][nodes])]
        return self.fields[f"node_{along}"][nodes], self.fields.at(record)[name][nodes]

    def boundary(self):
        """The nodes of each closed line around the mesh, the longest first."""
        found = topology.loops(topology.outer_edges(self.elements))
        return sorted(found, key=lambda loop: -numpy.ptp(self.x[loop]) - numpy.ptp(self.y[loop]))

    def middle(self, stream):
        """The value that lines are symmetric about: that of walls inside the flow, else half-way between the outer ones."""
        outer, *holes = self.boundary()
        if holes:
            return float(numpy.mean([numpy.median(stream[loop]) for loop in holes]))
        low, high = numpy.percentile(stream[outer], (TWO_WALLS, 100 - TWO_WALLS))
        if high - low < ONE_WALL * numpy.ptp(stream):
            return float(numpy.median(stream[outer]))
        return 0.5 * float(low + high)

    def extremes(self, stream):
        """Least and largest values inside the flow: those of its eddies."""
        ends = self.triangles.edges
        above, below = numpy.full_like(stream, -numpy.inf), numpy.full_like(stream, numpy.inf)
        for one, other in (ends.T, ends.T[::-1]):
            numpy.maximum.at(above, one, stream[other])
            numpy.minimum.at(below, one, stream[other])
        inside = (stream > above) | (stream < below)
        inside[numpy.concatenate(self.boundary())] = False
        return stream[inside]

    def reach(self, stream):
        """How far the stream function goes from its middle."""
        return float(abs(stream - self.middle(stream)).max())

    def levels(self, stream, lines=LINES, reach=None):
        """Levels on both sides of the middle, as many on either: evenly spaced up to a reach, and weaker ones of eddies."""
        middle, reach = self.middle(stream), reach or self.reach(stream)
        if not reach > 0:
            return numpy.zeros(0), numpy.zeros(0)
        main, weak = reach * (numpy.arange(lines) + 0.5) / lines, []
        eddies = numpy.unique(abs(self.extremes(stream) - middle))
        for extreme in eddies[(eddies > SMALLEST * reach) & (eddies < reach)]:
            if not any(0.3 < size / extreme < 1 for size in (*main, *weak)):
                weak += [share * extreme for share in IN_EDDIES]
        return both_sides(middle, main), both_sides(middle, numpy.sort(weak))

    def draw_streamlines(self, axes, record, lines=LINES, reach=None, **look):
        """Lines of the stream function on symmetric levels; of the weak ones those alone that are closed, in eddies."""
        stream = self.fields.at(record, ["stream"])["stream"]
        if not numpy.isfinite(stream).all():
            return
        main, weak = self.levels(stream, lines, reach)
        self.draw_lines(axes, record, main, **look)
        if len(weak):
            look = style.STREAMLINES | look
            axes.add_collection(collections.LineCollection(self.closed(stream, weak), colors=look["colors"], zorder=look["zorder"],
                                                           linewidths=look["linewidths"], alpha=look.get("alpha")))

    def lines(self, stream, levels):
        """The lines of these levels as places after each other."""
        tracer = TriContourGenerator(self.triangles.get_cpp_triangulation(), stream)
        return [line for level in levels for line in tracer.create_contour(level)[0]]

    def closed(self, stream, levels):
        """The lines of these levels that come back to where they began."""
        return [line for line in self.lines(stream, levels) if numpy.array_equal(line[0], line[-1])]

    def draw_lines(self, axes, record, levels, **look):
        """Lines of the stream function on these levels."""
        stream = self.fields.at(record, ["stream"])["stream"]
        levels = levels[(levels > stream.min()) & (levels < stream.max())]
        if len(levels):
            axes.tricontour(self.triangles, stream, levels=levels, **style.STREAMLINES | look)


class Flow:
    """A layer of a flow: speed (or a field of that name) under streamlines."""

    handles = ()
    axes_names = ("x", "y")

    def __init__(self, run, name=None):
        fields = run.fields("mesh")
        self.mesh, self.fields, self.times = FlowMesh(fields), fields, fields.times
        self.at_rest = is_at_rest(run, fields)
        self.name = name or ("p" if self.at_rest else "speed")
        self.scales = [quantities.Scale(self.name, quantities.unit(fields, self.name))]

    def values(self, record):
        return quantities.value_of(self.fields.at(record), self.name)

    def limits(self, records):
        return quantities.limits_of(self.fields.start)

    def fit(self, records):
        self.scales[0].fit([self.values(record) for record in records])
        if "stream" in self.fields.names:
            streams = [self.fields.at(record, ["stream"])["stream"] for record in records]
            self.reach = max((self.mesh.reach(stream) for stream in streams if numpy.isfinite(stream).all()), default=0.0)

    def draw(self, axes, record):
        scale = self.scales[0]
        axes.tripcolor(self.mesh.triangles, numpy.nan_to_num(self.values(record)), cmap=scale.colours, norm=scale.norm,
                       shading="gouraud", zorder=1)
        if "stream" in self.fields.names and not self.at_rest:
            self.mesh.draw_streamlines(axes, record, reach=self.reach, colors="black", linewidths=0.45, alpha=0.65)
        edges = self.fields.start[topology.outer_edges(self.mesh.elements)]
        style.draw_edges(axes, edges)
