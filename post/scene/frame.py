# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene in panels: layers over each other, one set of limits and one scale of colours over all panels of a figure."""
import numpy

import style
from scene import quantities
from scene.sheet import Sheet

THINNEST = 6.0  # length over width of a domain: a thinner one is drawn wider than it is
POWERS = (-3, 4)  # of ten, between which the numbers at a bar have no factor above it
MARGIN = 0.03  # around a domain, of its sizes


class Scene:
    """Layers of a run with the snapshots of the first of them."""

    def __init__(self, layers, title="", note=""):
        self.layers, self.title, self.note = layers, title, note
        self.times, self.unit = layers[0].times, layers[0].fields.units.get("time", "1")

    def records_in(self, layer, records):
        """The numbers of a layer's snapshots at the times of these of the scene."""
        return [layer.fields.record(float(self.times[record])) for record in records]

    def fit(self, records):
        """Fixes limits and scales by these snapshots, for all that is drawn from then on."""
        for layer in self.layers:
            layer.fit(self.records_in(layer, records))
        bounds = quantities.largest(layer.limits(self.records_in(layer, records)) for layer in self.layers)
        spans = [bounds[1] - bounds[0], bounds[3] - bounds[2]]
        margins = [MARGIN * (span if span > 0 else max(spans) or 1.0) for span in spans]
        self.limits = (bounds[0] - margins[0], bounds[1] + margins[0], bounds[2] - margins[1], bounds[3] + margins[1])
        self.true_aspect = (self.limits[1] - self.limits[0]) / (self.limits[3] - self.limits[2])
        self.aspect = float(numpy.clip(self.true_aspect, 1 / THINNEST, THINNEST))

    def draw(self, axes, record):
        """One snapshot."""
        axes.set_xlim(self.limits[:2])
        axes.set_ylim(self.limits[2:])
        axes.grid(False)
        for layer in self.layers:
            layer.draw(axes, self.records_in(layer, [record])[0])
        axes.set_xlim(self.limits[:2])
        axes.set_ylim(self.limits[2:])
        axes.set_aspect(self.true_aspect / self.aspect, adjustable="box")
        self.label_axes(axes)
        axes.set_title(style.at_time(self.times[record], self.unit), fontsize=9)

    def label_axes(self, axes):
        layer = self.layers[0]
        if layer.fields.dimension == 3:
            axes.set_xticks([])  # the axes count the pixels of a picture
            axes.set_yticks([])
            return
        for set_label, name in zip((axes.set_xlabel, axes.set_ylabel), layer.axes_names):
            set_label(style.label(name, layer.fields.units.get(name, layer.fields.units.get(f"node_{name}", "1"))))

    @property
    def scales(self):
        return [scale for layer in self.layers for scale in layer.scales]

    @property
    def handles(self):
        return [handle for layer in self.layers for handle in layer.handles]

    def explain(self, sheet):
        """Colour bars, the legend above the panels, title and note."""
        for scale, axes in zip(self.scales, sheet.bars()):
            bar = sheet.figure.colorbar(scale.mappable(), cax=axes, label=scale.label, extend=scale.extend)
            bar.formatter.set_powerlimits(POWERS)
        sheet.head(self.handles)
        sheet.note(" ".join(note for note in (self.note, self.stretched()) if note))

    def stretched(self):
        """What a reader must know of a domain that is drawn wider than it is."""
        factor = max(self.true_aspect / self.aspect, self.aspect / self.true_aspect)
        if factor < 1 + 1e-6:
            return ""
        return f"{'y' if self.true_aspect > self.aspect else 'x'} is drawn {factor:.3g} times as large as the other direction."

    def sheet(self, count):
        """An empty figure with axes for so many snapshots."""
        return Sheet(count, self.aspect, self.title, len(self.scales), len(self.handles))

    def figure(self, records):
        """The panels of these snapshots."""
        self.fit(records)
        sheet = self.sheet(len(records))
        for panel, record in zip(sheet.panels, records):
            self.draw(panel, record)
        sheet.label_outer()
        self.explain(sheet)
        return sheet.figure
