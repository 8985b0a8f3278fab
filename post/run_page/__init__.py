# SPDX-License-Identifier: GPL-3.0-or-later
"""The HTML page of a run: parts.py makes small arrays of its scene, document.py the page, fields.js and charts.js draw."""
