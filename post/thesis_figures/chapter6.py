# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 6: fluid and structure."""
import numpy

import style


def piston(runs):
    """Piston and container, displacement of the piston."""
    figure, axes = style.panels(2, 1, 7, 2.6)
    for panel, (deck, mass) in zip(axes, (("piston-m01", "0.1"), ("piston-m1", "1.0"))):
        run = runs.of(deck)
        time, y = run.history["time"], run.history["point_y"][:, 0]
        panel.plot(time, y - y[0], label="MPM")
        period = run.summary["exact_period"]
        for at in numpy.arange(period, time[-1], period):
            panel.axvline(at, **style.EXACT)
        panel.set_title(f"mass {mass}: period {run.summary['period']:.5f}, exact {period:.5f} (broken lines)")
        panel.set_ylabel(style.label("displacement", run.history.units["point_y"]))
        panel.set_xlabel(style.label("time", run.history.units["time"]))
    return figure


FIGURES = {"46": piston}
