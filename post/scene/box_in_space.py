# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a box in space: obstacles, bodies, and a field as smoke."""
import numpy
from matplotlib import colormaps, colors

from render import blocks
from render.picture import GREY, WALL
from scene.in_space import Room

FLUID, OBSTACLE, VOID = 0, 2, 3  # kinds of cells
DENSE = 10.0  # of the field's largest value: the box's depth takes exp(-DENSE) of what is beyond it
THINNER = 1.7  # the power of the field that smoke grows with: what has spread thinly does not hide a jet
CLEAR = 0.45  # share of the light that a body keeps back where the fluid inside is what matters
STONE = (0.62, 0.65, 0.70)
OF_BAR = 0.25  # of the box's depth: the bar shows what so much smoke leaves of the wall


def tints_of(scale):
    """The colours of a field's smoke in full light, of numbers below 0 and above."""
    if str(scale.colours).startswith("gray"):
        return GREY, GREY
    if scale.low < 0:
        return tuple(colormaps.get_cmap(scale.colours)(place)[:3] for place in (0.2, 0.8))
    return 2 * (colormaps.get_cmap(scale.colours)(0.5)[:3],)


def bar_of(scale):
    """The colours of a wall seen through more and more smoke of a field."""
    share = numpy.linspace(scale.low / max(scale.high, -scale.low), 1, 256)
    cover = 1 - numpy.exp(-OF_BAR * DENSE * abs(share) ** THINNER)
    below, above = tints_of(scale)
    return colors.ListedColormap(WALL + cover[:, None] * (numpy.where((share < 0)[:, None], below, above) - WALL))


class BoxInSpace(Room):
    """Draws the snapshots of a run in a box."""

    def __init__(self, box):
        edges = [box.edges[name] for name in "xyz"]
        super().__init__([edge[0] for edge in edges], [edge[-1] for edge in edges])
        self.sizes = numpy.array([edge[1] - edge[0] for edge in edges])

    def draw(self, kind, share, bodies, scale, inside):
        """Colours of the pixels. `share` is the field over its largest size, `bodies` are surfaces; with `inside` they are
        clear, so that the fluid in them is seen."""
        stones = blocks.surfaces(kind == OBSTACLE, self.low, self.sizes, STONE)
        depth = self.high[2] - self.low[2]
        fog = (DENSE / depth * numpy.where(kind == FLUID, numpy.clip(abs(share), 0, 1) ** THINNER, 0), self.sizes)
        smoke = fog, tints_of(scale), numpy.where(share > 0, 1.0, 0.0)
        whole = self.picture.draw(stones + bodies, *smoke)
        if not inside or not bodies:
            return whole
        return CLEAR * whole + (1 - CLEAR) * self.picture.draw(stones, *smoke)
