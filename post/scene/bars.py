# SPDX-License-Identifier: GPL-3.0-or-later
"""Bars of a string: lines from mass to mass, coloured by their stress."""
import numpy
from matplotlib import collections

import style
from scene import quantities


class Bars:
    """A layer of particles.nc of a run of bars."""

    handles = ()
    axes_names = ("x", "y")

    def __init__(self, run, name=None):
        self.fields = run.fields("particles")
        self.times = self.fields.times
        self.name = name or "stress"
        self.scales = [quantities.Scale(self.name, quantities.unit(self.fields, self.name))]

    def limits(self, records):
        return quantities.largest(quantities.limits_of(self.fields.places(record)) for record in records)

    def fit(self, records):
        self.scales[0].fit([quantities.value_of(self.fields.at(record), self.name) for record in records])

    def draw(self, axes, record):
        values, scale = self.fields.at(record), self.scales[0]
        ends = numpy.column_stack([values["x"], values["y"]])
        bars = numpy.stack([ends[:-1], ends[1:]], axis=1)[values["body"][:-1] == values["body"][1:]]
        shown = quantities.value_of(values, self.name)[:-1][values["body"][:-1] == values["body"][1:]]
        lines = collections.LineCollection(bars, cmap=scale.colours, norm=scale.norm, linewidths=3, zorder=3)
        lines.set_array(shown)
        axes.add_collection(lines)
        heavy = values["mass"] > 20 * numpy.median(values["mass"])
        axes.plot(*ends[heavy].T, linestyle="none", marker="o", markersize=6, **style.HEAVY)
