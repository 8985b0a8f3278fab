# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a box in space: obstacles, bodies, and a field as smoke."""
import numpy
from matplotlib import colormaps

from render import blocks
from scene.in_space import Room

FLUID, OBSTACLE = 0, 2  # kinds of cells
DENSE = 5.0  # of the field's largest value: the box's depth takes exp(-DENSE) of what is beyond it
CLEAR = 0.45  # share of the light that a body keeps back where the fluid inside is what matters
STONE = (0.62, 0.65, 0.70)
GREY = (0.95, 0.94, 0.92)  # of smoke in full light


class BoxInSpace(Room):
    """Draws the snapshots of a run in a box."""

    def __init__(self, box):
        edges = [box.edges[name] for name in "xyz"]
        super().__init__([edge[0] for edge in edges], [edge[-1] for edge in edges])
        self.sizes = numpy.array([edge[1] - edge[0] for edge in edges])

    def draw(self, kind, share, bodies, colours, inside):
        """Colours of the pixels. `share` is the field over its largest value, `bodies` are surfaces; with `inside` they are
        clear, so that the fluid in them is seen."""
        stones = blocks.surfaces(kind == OBSTACLE, self.low, self.sizes, STONE)
        depth = self.high[2] - self.low[2]
        fog = (DENSE / depth * numpy.where(kind == FLUID, numpy.clip(share, 0, 1), 0), self.sizes)
        tint = GREY if colours.startswith("gray") else colormaps[colours](0.85)[:3]
        whole = self.picture.draw(stones + bodies, fog, tint)
        if not inside or not bodies:
            return whole
        return CLEAR * whole + (1 - CLEAR) * self.picture.draw(stones, fog, tint)
