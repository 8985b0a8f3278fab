# SPDX-License-Identifier: GPL-3.0-or-later
"""A fluid on triangles of its own, at one time."""
import numpy

from scene import quantities


def draw(axes, corners, name, scale):
    """Each triangle in the colour of its field's mean; of `corners` three in turn belong to one."""
    here = numpy.isfinite(corners["x"])
    values = numpy.nan_to_num(quantities.value_of(corners, name)[here]).reshape(-1, 3).mean(axis=1)
    x, y = corners["x"][here], corners["y"][here]
    axes.tripcolor(x, y, numpy.arange(x.size).reshape(-1, 3), facecolors=values, cmap=scale.colours, norm=scale.norm,
                   edgecolors="none", antialiased=False, zorder=1)
