# SPDX-License-Identifier: GPL-3.0-or-later
"""The gas of the last snapshot along x, over the exact solution at its time."""

import style

# A gas field of particles.nc: its column of reference.txt, and its name on the axis.
COLUMNS = {"density": ("density", "density"), "vx": ("velocity", "velocity"), "pressure": ("pressure", "pressure"),
           "specific_energy": ("specific_energy", "specific internal energy")}


def figure(run):
    """Density, velocity, pressure and specific energy; None without points of gas or an exact solution over x."""
    exact = run.exact_over("x")
    if not exact or not run.has("particles") or not all(name in run.particles for name in ("x", *COLUMNS)):
        return None
    values, units = run.particles.at(-1), run.particles.units
    drawn, panels = style.panels(len(COLUMNS), 2)
    for axes, (name, (column, title)) in zip(panels, COLUMNS.items()):
        axes.plot(values["x"], values[name], label="points", color=style.OURS[0], **style.POINTS)
        if column in exact:
            axes.plot(exact["x"], exact[column], **style.EXACT)
        if f"error_{column}" in run.summary:
            axes.set_title(f"L1 error {run.summary[f'error_{column}']:.3g}", fontsize=8)
        axes.set_xlabel(style.label("x", units["x"]))
        axes.set_ylabel(style.label(title, units[name]))
    style.legend(panels[0])
    drawn.suptitle(style.at_time(run.particles.times[-1], units["time"]))
    return drawn
