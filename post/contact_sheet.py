# SPDX-License-Identifier: GPL-3.0-or-later
"""Many pictures on one sheet."""
from matplotlib import image, pyplot

WIDTH = 24.0  # of the sheet, inches
IN_A_ROW = 6.5  # widths over heights of the pictures of a row, together, at least
GAP = 0.1  # between pictures, inches
DPI = 100


def rows_of(pictures):
    """The pictures in order, as many in a row as make it wide enough."""
    row, wide = [], 0
    for picture in pictures:
        row.append(picture)
        wide += picture.shape[1] / picture.shape[0]
        if wide >= IN_A_ROW:
            yield row
            row, wide = [], 0
    if row:
        yield row


def height_of(row):
    """With which the row is as wide as the sheet; the last row may be short of that."""
    wide = sum(picture.shape[1] / picture.shape[0] for picture in row)
    return (WIDTH - GAP * (len(row) + 1)) / max(wide, IN_A_ROW)


def write(paths, sheet):
    """Puts the pictures onto the sheet (both PNG), those of a row equally high, and gives the sheet's path."""
    rows = list(rows_of(image.imread(path) for path in paths))
    height = sum(height_of(row) + GAP for row in rows) + GAP
    figure = pyplot.figure(figsize=(WIDTH, height), layout="none")
    top = height
    for row in rows:
        top -= height_of(row) + GAP
        left = GAP
        for picture in row:
            width = height_of(row) * picture.shape[1] / picture.shape[0]
            axes = figure.add_axes((left / WIDTH, top / height, width / WIDTH, height_of(row) / height))
            axes.imshow(picture, interpolation="antialiased", aspect="auto")
            axes.axis("off")
            left += width + GAP
    figure.savefig(sheet, dpi=DPI)
    pyplot.close(figure)
    return sheet
