# SPDX-License-Identifier: GPL-3.0-or-later
"""What `./quickstart test --full` does beyond the default run."""
import os

# Whether tests take their full length. Without it a list of decks or a ladder is shorter, where the rest goes the same way.
FULL = os.environ.get("TETHER_FULL") == "1"
