# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis' figures of results by their numbers.

Each chapter's module has FIGURES, number -> function. A function takes Runs, asks it for the runs it needs, and gives a
matplotlib figure; the first line of its docstring is the title.
"""
from . import appendix_a, chapter4, chapter5, chapter6, chapter8

FIGURES = chapter4.FIGURES | chapter5.FIGURES | chapter6.FIGURES | chapter8.FIGURES | appendix_a.FIGURES
