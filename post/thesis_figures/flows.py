# SPDX-License-Identifier: GPL-3.0-or-later
"""Flows of published numbers: the lid-driven cavity and the cylinder in a channel, and what their accuracy costs."""
import style
from scene.flow import FlowMesh

PUBLISHED = {"color": "tab:red", "linestyle": ":", "linewidth": 1.0, "label": "extremes, published"}
# Of the cavity at Re = 100: extremes of u over y at x = 1/2 and of v over x at y = 1/2.
LEAST_U, LEAST_V, LARGEST_V = -0.21404, -0.25380, 0.17957
# Of the cylinder: column of the history, name, published value.
QUANTITIES = (("drag_1", "drag", 5.57953523384), ("lift_1", "lift", 0.010618948146),
              ("pressure_difference_1", "difference of pressure", 0.11752016697))
ELEMENTS = (("q1q1", "tab:blue"), ("q2q1", "tab:orange"))
CELLS = (6, 12, 24, 48)  # to a quarter of the cylinder


def cavity(runs):
    """Lid-driven cavity, Re = 100: streamlines, and velocities on the middle lines."""
    mesh = FlowMesh(runs.of("cavity", "flow.element='q2q1'").fields("mesh"))
    figure, (lines, profile) = style.panels(2, 2, 4.6, 4.2)
    mesh.draw_streamlines(lines, -1)
    lines.set_aspect("equal")
    lines.set_xlabel("x")
    lines.set_ylabel("y")
    for name, across, published in (("vx", "x", (LEAST_U,)), ("vy", "y", (LEAST_V, LARGEST_V))):
        along = "y" if across == "x" else "x"
        profile.plot(*mesh.on_line(name, -1, across, 0.5), label=f"{name} over {along} at {across} = 1/2")
        for extreme in published:
            profile.axhline(extreme, **PUBLISHED)
    profile.set_xlabel("place on the line")
    profile.set_ylabel("velocity over the lid's")
    style.legend(profile)
    style.note(figure, "The stream function of the vortices in the corners is of 1e-6 to 1e-5.")
    return figure


def cylinder(runs):
    """Steady flow past a cylinder in a channel, Re = 20: pressure and streamlines."""
    run = refined(runs, "q2q1", 24)
    mesh = FlowMesh(run.fields("mesh"))
    figure, (axes,) = style.panels(1, 1, 9.5, 3.6)
    drawn = axes.tricontourf(mesh.triangles, mesh.fields.at(-1)["p"], levels=30, cmap="viridis")
    figure.colorbar(drawn, ax=axes, label=style.label("pressure", run.history.units["probe_p_1"]))
    mesh.draw_streamlines(axes, -1, colors="white")
    axes.set_xlim(0, 1.1)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.grid(False)
    return figure


def refined(runs, element, cells):
    """Cells to a quarter of the cylinder, all blocks in proportion."""
    return runs.of("cylinder", f"flow.element='{element}'", f"mesh.cells(1:2,1:5)=8*{cells},{2 * cells},{cells}")


def cylinder_cost(runs):
    """Steady flow past a cylinder: errors over processor seconds and over unknowns, by both elements."""
    figure, axes = style.panels(6, 3, 3.8, 3.1)
    for element, colour in ELEMENTS:
        made = [refined(runs, element, cells) for cells in CELLS[:2 * runs.levels]]
        for k, (column, name, published) in enumerate(QUANTITIES):
            errors = [abs(run.history[column].flat[-1] / published - 1) for run in made]
            for row, key in ((0, "cpu_seconds"), (3, "unknowns")):
                costs = [run.summary[key] for run in made]
                axes[row + k].loglog(costs, errors, marker="o", color=colour, label=element)
            axes[k].set_title(name)
    for k, panel in enumerate(axes):
        panel.set_xlabel("processor seconds [s]" if k < 3 else "unknowns")
        panel.set_ylabel("relative error")
    style.legend(axes[0])
    style.note(figure, "6, 12, 24, 48 cells to a quarter of the cylinder. Seconds are those of the machine that drew this.")
    return figure


FIGURES = {"cavity": cavity, "cylinder": cylinder, "cylinder-cost": cylinder_cost}
