# SPDX-License-Identifier: GPL-3.0-or-later
"""Where panels, colour bars, title, legend and note of a scene stand in its figure, in inches."""
import textwrap

import numpy
from matplotlib import pyplot
from matplotlib.layout_engine import PlaceHolderLayoutEngine
from matplotlib.ticker import MaxNLocator

WIDTH, TALLEST = 9.0, 6.0  # of all panels together, and of one
NARROWEST, ALONE = 5.5, 6.5  # a figure, and a panel that stands alone
BROAD = 1.5  # width over height that a figure should have
EMPTY = 8.0  # what a place without a panel costs
LEFT, BOTTOM, BETWEEN, ABOVE = 0.75, 0.55, 0.2, 0.3  # around the panels; ABOVE each is its title
BAR, NEXT_BAR = 0.16, 0.95  # width of a colour bar, and how far from each other they stand
LINE = 0.2  # height of a line of text
IN_ROW = 4  # entries of the legend
LETTERS = 12.5  # of a title, an inch
TICK = 0.55  # width of a number at an axis


def columns_of(count, aspect):
    """How many panels stand in a row, for a figure that is broad and has no empty places."""
    def cost(columns):
        rows = -(-count // columns)
        return abs(numpy.log(columns * aspect / rows / BROAD)) + EMPTY * (columns * rows - count) / count
    return min(range(1, count + 1), key=cost)


class Sheet:
    """A figure with axes for so many panels of one aspect (width over height)."""

    def __init__(self, count, aspect, title="", bars=0, entries=0):
        self.columns = columns_of(count, aspect)
        self.rows = -(-count // self.columns)
        width = min(WIDTH / self.columns, TALLEST * aspect, ALONE if count == 1 else WIDTH)
        self.panel = (width, width / aspect)
        self.block = (self.columns * width + (self.columns - 1) * BETWEEN,
                      self.rows * (self.panel[1] + ABOVE) + (self.rows - 1) * 0.08)
        self.bar_count, self.legend_lines = bars, -(-entries // IN_ROW)
        self.width = max(LEFT + self.block[0] + 0.2 + max(bars * NEXT_BAR, 0.1), NARROWEST)
        self.left = LEFT + 0.5 * (self.width - (LEFT + self.block[0] + 0.2 + max(bars * NEXT_BAR, 0.1)))
        self.title = textwrap.wrap(title, int(LETTERS * self.width))[:2]
        self.head_height = LINE * (len(self.title) + self.legend_lines) + 0.15
        self.height = self.bottom + self.block[1] + self.head_height
        self.figure = pyplot.figure(figsize=(self.width, self.height))
        self.figure.set_layout_engine(PlaceHolderLayoutEngine(adjust_compatible=True, colorbar_gridspec=True))  # all is in place
        self.panels = [self._panel(number) for number in range(count)]

    @property
    def bottom(self):
        return BOTTOM + LINE

    def axes(self, left, bottom, width, height):
        """Axes by inches."""
        return self.figure.add_axes((left / self.width, bottom / self.height, width / self.width, height / self.height))

    def _panel(self, number):
        row, column = divmod(number, self.columns)
        top = self.bottom + self.block[1] - row * (self.panel[1] + ABOVE + 0.08) - ABOVE
        axes = self.axes(self.left + column * (self.panel[0] + BETWEEN), top - self.panel[1], *self.panel)
        axes.xaxis.set_major_locator(MaxNLocator(max(int(self.panel[0] / TICK), 1), steps=(1, 2, 5, 10)))
        return axes

    def label_outer(self):
        """Numbers and names of axes stand at the left and at the bottom alone."""
        for number, panel in enumerate(self.panels):
            if number % self.columns:
                panel.set_ylabel("")
                panel.tick_params(labelleft=False)
            if number + self.columns < len(self.panels):
                panel.set_xlabel("")
                panel.tick_params(labelbottom=False)

    def bars(self):
        """Axes of the colour bars, to the right of the panels."""
        height = self.block[1] - ABOVE
        return [self.axes(self.left + self.block[0] + 0.2 + number * NEXT_BAR, self.bottom, BAR, height)
                for number in range(self.bar_count)]

    def head(self, handles):
        """Title and legend above the panels."""
        self.figure.suptitle("\n".join(self.title), y=1 - 0.08 / self.height, va="top", fontsize=9)
        if handles:
            self.figure.legend(handles=handles, loc="upper center", ncol=min(len(handles), IN_ROW), borderaxespad=0,
                               bbox_to_anchor=(0.5, 1 - (0.1 + LINE * len(self.title)) / self.height))

    def note(self, text):
        """What a reader must know, below the panels."""
        self.figure.text(0.08 / self.width, 0.06 / self.height, text, fontsize=8)
