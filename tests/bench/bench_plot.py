# SPDX-License-Identifier: GPL-3.0-or-later
"""The machine's limits for a point-step, and the figure that sets them next to what was measured.

Counted in the text of src/physics/points/lanes for elastic points in a step that writes nothing, without what is done
once for a cell or a node but for the nodes' memory. Each line of a count says which pass it is of.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "post"))

DOUBLE = 8  # bytes

# Numbers of a point that a step reads and writes.
POINT_NUMBERS = {
    "robust": (6 + 3      # stress first: x, y, volume and three stresses, which are written again
               + 3 + 2),  # then: x, y, mass; x, y
    "thesis": (5 + 2       # velocities: x, y, mass and two velocities, which are written again
               + 8 + 5 + 1),  # then: x, y, mass, two velocities, three stresses; x, y, stresses; and the volume
}
# Numbers of a node that a step reads and writes (lanes/nodes.cpp, and the rows of the scatters, read and written).
NODE_NUMBERS = {
    "robust": 5 + 2 + 6 + 14 + 8,  # mapped velocity; forces cleared; pull; solve, with sums cleared; moves
    "thesis": 2 + 9 + 6 + 10 + 14,  # momenta cleared; solve; velocities; divided, with sums cleared; moves and forces
}
# Multiplications of a point in a step.
PRODUCTS = {
    "robust": (2 + 4 + 38      # place in the cell, weights, strain rate
               + 5 + 3 + 30    # law, pull, scatter of forces
               + 2 + 4 + 43    # place, weights, velocity and the field about the point
               + 14 + 32),     # move and masses, scatter of mass and momentum
    "thesis": (2 + 12 + 5 + 14           # place, acceleration, velocity and its square, scatter of momenta
               + 2 + 8 + 12 + 5          # place, strain rate, velocity that it moves with, move
               + 5 + 3 + 14 + 8),        # law, pull, scatter of mass and momentum, of forces
}
POINTS_OF_A_CELL = 4  # in the scenes of the figure; as many as to a node
METHODS = ("robust", "thesis")


def moved_bytes(method):
    return DOUBLE * (POINT_NUMBERS[method] + NODE_NUMBERS[method] / POINTS_OF_A_CELL)


def bounds(machine):
    """method -> {what limits: ns a point-step}"""
    return {method: {"memory": 1e9 * moved_bytes(method) / machine["memory"],
                     "second cache": 1e9 * moved_bytes(method) / machine["cache"],
                     "multiplications": 1e9 * PRODUCTS[method] / machine["multiplications"]} for method in METHODS}


def draw_method(axes, method, measured, limits):
    """measured: (points, plain, tether, ...) of each size"""
    points = [row[0] for row in measured]
    axes.plot(points, [row[1] for row in measured], marker="s", markersize=4, color="0.45", label="plain loop")
    axes.plot(points, [row[2] for row in measured], marker="o", markersize=4, color="tab:blue", label="tether")
    looks = {"memory": ("tab:red", "--"), "second cache": ("tab:orange", "-."), "multiplications": ("black", ":")}
    for name, least in limits.items():
        color, line = looks[name]
        axes.axhline(least, color=color, linestyle=line, linewidth=1, label=f"limit of {name}")
    axes.set_xscale("log"), axes.set_yscale("log")
    axes.set_title(f"{method} step, elastic")
    axes.set_xlabel("points"), axes.set_ylabel("a point-step [ns]")


def draw(growth, machine):
    """A figure of what bench_report.of_growth has, a panel a method."""
    import style  # of post/: without matplotlib the tables are made all the same
    style.use()
    measured = {method: [row for name, row in growth.items() if name.startswith(method)] for method in METHODS}
    methods = [method for method in METHODS if measured[method]]
    figure, panels = style.panels(len(methods), len(methods))
    limits = bounds(machine)
    for axes, method in zip(panels, methods):
        draw_method(axes, method, measured[method], limits[method])
    lowest = min(axes.get_ylim()[0] for axes in panels)
    highest = max(axes.get_ylim()[1] for axes in panels)
    for axes in panels:
        axes.set_ylim(lowest, 3 * highest)  # room for the legend
    style.legend(panels[0], loc="upper left", ncols=2)
    return figure
