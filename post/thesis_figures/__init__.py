# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis' figures of results by their numbers.

Each chapter's modules have FIGURES, number -> function. A function takes Runs, asks it for the runs it needs, and gives a
matplotlib figure; the first line of its docstring is the title.
"""
from . import (appendix_a, appendix_a_ball, appendix_a_bars, chapter4, chapter5, chapter6, chapter6_airbags,
               chapter6_membranes, chapter7_cells, chapter7_cylinder, chapter8, cost, coupled, finite_elements, flaps, flows,
               splitting)

MODULES = (chapter4, chapter5, chapter6, chapter6_membranes, chapter6_airbags, chapter7_cylinder, chapter7_cells, chapter8,
           appendix_a, appendix_a_bars, appendix_a_ball, cost, coupled, finite_elements, flaps, flows, splitting)


def by_number(name):
    """In the order of the thesis, then what has no number."""
    return (0, int(name), "") if name.isdigit() else (1, 0, name)


FIGURES = {name: draw for module in MODULES for name, draw in module.FIGURES.items()}
FIGURES = {name: FIGURES[name] for name in sorted(FIGURES, key=by_number)}
