# SPDX-License-Identifier: GPL-3.0-or-later
"""A flow's mesh and fields as matplotlib's triangles, and the solids in it."""
import numpy
from matplotlib import tri


# Triangles of an element by its nodes as mesh.nc counts them: corners, then middles of edges, then its own.
QUARTERS = ((0, 4, 8, 7), (4, 1, 5, 8), (8, 5, 2, 6), (7, 8, 6, 3))
SOLID = {"facecolor": "tab:red", "edgecolor": "darkred", "linewidth": 0.8, "zorder": 4}


def triangles(elements):
    """Two of each quadrangle of 4 nodes, eight of each of 9."""
    quads = elements if elements.shape[1] == 4 else numpy.concatenate([elements[:, part] for part in QUARTERS])
    return numpy.concatenate([quads[:, (0, 1, 2)], quads[:, (0, 2, 3)]])


class FlowMesh:
    """What mesh.nc of a flow holds; its nodes stay where they are."""

    def __init__(self, run):
        self.fields = run.fields("mesh")
        self.x, self.y = self.fields["node_x"], self.fields["node_y"]
        self.times = self.fields["time"]
        self.triangles = tri.Triangulation(self.x, self.y, triangles(self.fields["element_nodes"].astype(int)))

    def on_line(self, name, record, across, place):
        """Of the nodes whose coordinate `across` (x or y) is `place`: the other one, ascending, and the field."""
        along = "y" if across == "x" else "x"
        nodes = numpy.flatnonzero(abs(self.fields[f"node_{across}"] - place) < 1e-9)
        nodes = nodes[numpy.argsort(self.fields[f"node_{along}"][nodes])]
        return self.fields[f"node_{along}"][nodes], self.fields[name][record][nodes]

    def draw_streamlines(self, axes, record, count, **look):
        """Lines of the stream function, as many between its least and its largest value."""
        stream = self.fields["stream"][record]
        levels = numpy.linspace(stream.min(), stream.max(), count + 2)[1:-1]
        self.draw_lines(axes, record, levels, **look)

    def draw_lines(self, axes, record, levels, **look):
        look = {"colors": "tab:blue", "linewidths": 0.7, "linestyles": "solid", **look}
        axes.tricontour(self.triangles, self.fields["stream"][record], levels=levels, **look)


class Solids:
    """What solids.nc holds: the bodies in a flow, which move."""

    def __init__(self, run):
        self.fields = run.fields("solids")
        self.elements = self.fields["element_nodes"].astype(int)

    def draw(self, axes, record):
        for element in self.elements[:, :4]:
            axes.fill(self.fields["x"][record][element], self.fields["y"][record][element], **SOLID)
