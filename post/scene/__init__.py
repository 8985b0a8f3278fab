# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of a run: its scene by layers (points, elements, flow, box), its histories and its profiles.

choose.py says which of them a run has. A layer has `times`, `limits`, `fit` and `draw`, `scales` and `handles`."""
