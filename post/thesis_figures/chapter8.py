# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 8: how long a step may be."""
import amplification
import style

LIMIT = 1e-3  # dx/c of the decks: cells of 1, sqrt(E/rho) = 1000
CASES = (("stability-centre", "(a) points initially in the centres of the cells", amplification.CENTRE,
          (1.0, 1.5, 1.9, 2.0, 2.1, 2.2)),
         ("stability-side", "(b) points initially at the sides of the cells", amplification.SIDE,
          (0.5, 0.9, 1.0, 1.04, 1.1)))


def stability(runs):
    """Energy of the stability tests by steps in units of dx/c."""
    figure, axes = style.panels(2, 1, 7, 3.4)
    for panel, (deck, name, place, ratios) in zip(axes, CASES):
        for ratio in ratios:
            step = f"{ratio * LIMIT:.6g}"
            run = runs.of(deck, f"in.tstep={step}", f"in.dtmax={step}", "limits.energy_growth=0,0")
            energy = run.history["energy_total"]
            panel.semilogy(run.history["time"], energy / energy[0], marker=".", label=f"{ratio:g}")
        exact, bar = amplification.limit(place), float(amplification.bar_limit(place, 5))
        panel.set_title(f"{name}; limit {exact} (8.4), {bar:.3f} for these five cells")
        panel.set_ylabel("energy over its start")
        panel.set_xlabel(style.label("time", run.history.units["time"]))
        panel.set_ylim(0.1, 1e8)
        panel.legend(title="step over dx/c", ncols=2, loc="upper left")
    return figure


FIGURES = {"91": stability}
