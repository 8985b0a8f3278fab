# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 7.5: normals of a membrane that is a quarter of a circle, and 7.7: of the dog-bone, without connectivity."""
import numpy

import style

VACUUM, FOUR, SIXTEEN = "reg.nreg=0", "reg.nprg=4", "reg.nprg=16"
GAS = {VACUUM: "vacuum", FOUR: "4 gas points a cell", SIXTEEN: "16 gas points a cell"}
TRACKED = "points.tracked_at(1,1)=1.0,0.0,0.70711,0.70711,0.0,1.0"  # at 0, 45 and 90 degrees, as in the thesis
METHODS = {"connectivity": ("connectivity", "black"), "mass-linear": ("mass matrix, linear", "tab:blue"),
           "cubic": ("cubic", "tab:orange"), "quadratic": ("quadratic", "tab:red")}
PRESSURE, STIFFNESS = 100.0, 1e6 / (1 - 0.3**2) * 0.1  # of the gas; E' h of the membrane
ARROW = 0.13  # length of a normal
DOG_BONE = ("in.tmax=2.0", "in.tiout(13)=0.05")
DOG_BONE_TIMES = (0.0, 0.05, 0.1, 0.2, 0.5, 2.0)


def rule(name):
    return f"membrane.normals='{name}'"


def of_membrane(run):
    body = run.particles["body"][0]
    return body == body.max()


def frame(axes, width, side):
    axes.set_aspect("equal")
    axes.set_xlim(0, side)
    axes.set_ylim(0, side)
    axes.grid(False)
    for at in numpy.arange(0, side, width):
        axes.axvline(at, **style.GRID)
        axes.axhline(at, **style.GRID)
    axes.set_xlabel("x")
    axes.set_ylabel("y")


def arrows(axes, x, y, normal, length=ARROW, **look):
    axes.quiver(x, y, *normal, angles="xy", scale_units="xy", scale=1 / length, **{"width": 0.003, "zorder": 3} | look)


def normals_at(run, record):
    """Places and unit normals of the membrane's points."""
    chosen = of_membrane(run)
    return [run.particles[name][record][chosen] for name in ("x", "y", "normal_x", "normal_y")]


def angles_to(normal, exact):
    """Degrees between the lines that they lie in: a normal and its opposite are one."""
    cross, dot = normal[0] * exact[1] - normal[1] * exact[0], normal[0] * exact[0] + normal[1] * exact[1]
    return numpy.degrees(numpy.arctan2(abs(cross), abs(dot)))


def draw_circle_normals(axes, run):
    """Exact ones broken, and the gas."""
    x, y, *normal = normals_at(run, 0)
    exact = numpy.array([x, y]) / numpy.hypot(x, y)
    gas = ~of_membrane(run)
    axes.plot(run.particles["x"][0][gas], run.particles["y"][0][gas], color="0.75", **style.POINTS | {"markersize": 1.2})
    axes.plot(x, y, color="tab:red", **style.POINTS)
    arrows(axes, x, y, exact, color="0.6", width=0.006)
    axes.plot([], [], color="0.6", linewidth=3, label="exact")
    side = numpy.where((normal * exact).sum(axis=0) < 0, -1, 1)  # a normal and its opposite are one
    arrows(axes, x, y, side * normal, color="tab:blue", width=0.0025)
    axes.plot([], [], color="tab:blue", label="calculated")
    return angles_to(normal, exact)


def circle_normals(runs, cases):
    figure, axes = style.panels(len(cases), len(cases), 4.6, 4.8)
    for panel, (method, gas) in zip(axes, cases):
        run = runs.of("normals-cylinder", rule(method), gas)
        error = draw_circle_normals(panel, run)
        frame(panel, run.summary["dx"], 1.3)
        panel.set_title(f"{method}, {GAS[gas]}\n"
                        f"angle to the exact normal: mean {error.mean():.1f}°, largest {error.max():.1f}°")
    axes[0].legend(loc="lower left")
    return figure


def simple(runs):
    """Normals by the simple color function."""
    return circle_normals(runs, (("color", VACUUM), ("color", FOUR)))


def quadratic(runs):
    """Normals by the quadratic method, vacuum and 4 gas points a cell."""
    return circle_normals(runs, (("quadratic", VACUUM), ("quadratic", FOUR)))


def quadratic_16(runs):
    """Normals by the quadratic method, 16 gas points."""
    return circle_normals(runs, (("quadratic", SIXTEEN),))


def cubic(runs):
    """Normals by the cubic method, vacuum and 4 gas points a cell."""
    return circle_normals(runs, (("cubic", VACUUM), ("cubic", FOUR)))


def cubic_16(runs):
    """Normals by the cubic method, 16 gas points."""
    return circle_normals(runs, (("cubic", SIXTEEN),))


def matrix_and_connectivity(runs):
    """Normals by the mass matrix method and from connectivity."""
    return circle_normals(runs, (("mass-linear", VACUUM), ("connectivity", VACUUM)))


def expansion(runs, method):
    return runs.of("cylinder-expansion", TRACKED, rule(method))


def mean_change(run):
    radii = numpy.hypot(run.history["point_x"], run.history["point_y"])
    return (radii - radii[0]).mean(axis=1)


def radius_change(runs):
    """Mean change of the cylinder's radius by the methods for the normals."""
    figure, all_axes = style.panels(2, 2, 5.2, 3.8)
    for axes, top in zip(all_axes, (0.2, 0.013)):
        for method, (name, colour) in METHODS.items():
            run = expansion(runs, method)
            axes.plot(run.history["time"], mean_change(run), color=colour, label=name)
        robust = runs.of("cylinder-expansion", TRACKED, "mpm.method='robust'")
        axes.plot(robust.history["time"], mean_change(robust), color="tab:green", label="robust method")
        axes.axhline(PRESSURE / STIFFNESS, **style.EXACT | {"label": "at rest, p r²/(E' h)"})
        axes.set_ylim(-0.02 * top, top)
        axes.set_xlabel(style.label("time", run.history.units["time"]))
        axes.set_ylabel("mean change of radius at 0, 45, 90°")
    style.legend(all_axes[0], loc="upper left")
    all_axes[1].set_title("the same, enlarged")
    return figure


def draw_cylinder(axes, run, time, normals):
    record = int(numpy.argmin(abs(run.particles["time"] - time)))
    gas = ~of_membrane(run)
    axes.plot(run.particles["x"][record][gas], run.particles["y"][record][gas], color="tab:cyan",
              **style.POINTS | {"markersize": 1.2})
    x, y, *normal = normals_at(run, record)
    axes.plot(x, y, color="tab:red", **style.POINTS)
    if normals:
        arrows(axes, x, y, normal, color="tab:blue", width=0.002)
    frame(axes, run.summary["dx"], 1.5)
    return run.particles["time"][record]


def cylinders(runs, methods, time, normals):
    figure, axes = style.panels(len(methods), 2, 4.3, 4.4)
    for panel, method in zip(axes, methods):
        at = draw_cylinder(panel, expansion(runs, method), time, normals)
        panel.set_title(f"{METHODS[method][0]}, time {at:.3g}")
    return figure


def unsuccessful(runs):
    """Points and normals by the cubic and the quadratic method at t = 0.01."""
    return cylinders(runs, ("cubic", "quadratic"), 0.01, True)


def at_the_end(runs):
    """Points by the four methods at t = 0.05."""
    return cylinders(runs, tuple(METHODS), 0.05, False)


def dog_bone(runs, method):
    return runs.of("membrane-expansion-2", *DOG_BONE, rule(method))


def dog_bone_normals(runs):
    """Normals to the dog-bone by the mass matrix method, quadratic, and from connectivity."""
    figure, axes = style.panels(2, 2, 5.0, 5.0)
    by_points = normals_at(dog_bone(runs, "connectivity"), 0)
    for panel, method, name in zip(axes, ("mass-quadratic", "connectivity"), ("mass matrix, quadratic", "connectivity")):
        run = dog_bone(runs, method)
        x, y, *normal = normals_at(run, 0)
        panel.plot(x, y, color="tab:red", **style.POINTS)
        arrows(panel, x, y, normal, 0.1, color="tab:blue")
        frame(panel, run.summary["dx"], 1.3)
        difference = angles_to(normal, by_points[2:])
        panel.set_title(name if method == "connectivity" else
                        f"{name}\nangle to that from connectivity: mean {difference.mean():.1f}°, "
                        f"largest {difference.max():.1f}°")
    return figure


def dog_bone_positions(runs):
    """Dog-bone by connectivity (left half) and by the mass matrix method, quadratic (right half)."""
    left, right = dog_bone(runs, "connectivity"), dog_bone(runs, "mass-quadratic")
    figure, axes = style.panels(len(DOG_BONE_TIMES), 3, 4.0, 2.9)
    for panel, time in zip(axes, DOG_BONE_TIMES):
        for run, side, gas_colour, colour, name in ((left, -1, "tab:blue", "tab:red", "connectivity"),
                                                    (right, 1, "tab:cyan", "darkred", "mass matrix")):
            record, chosen = int(numpy.argmin(abs(run.particles["time"] - time))), of_membrane(run)
            x, y = side * run.particles["x"][record], run.particles["y"][record]
            panel.plot(x[~chosen], y[~chosen], color=gas_colour, **style.POINTS | {"markersize": 1.2})
            panel.plot(x[chosen], y[chosen], color=colour, **style.POINTS, label=name)
        panel.set_aspect("equal")
        panel.set_xlim(-1.6, 1.6)
        panel.set_ylim(0, 1.6)
        panel.set_xlabel("x")
        panel.set_ylabel("y")
        panel.set_title(style.at_time(run.particles["time"][record], run.particles.units["time"]))
    angle = numpy.linspace(0, numpy.pi, 181)
    radius = left.summary["exact_radius_x"]
    axes[-1].plot(radius * numpy.cos(angle), radius * numpy.sin(angle), **style.EXACT | {"label": "at rest, exact"})
    style.legend(axes[-1], loc="lower center", markerscale=2)
    style.note(figure, "The runs end at t = 2, when the oscillations have nearly died away.")
    return figure


FIGURES = {"67": simple, "68": quadratic, "69": quadratic_16, "70": cubic, "71": cubic_16, "72": matrix_and_connectivity,
           "73": radius_change, "74": unsuccessful, "75": at_the_end, "86": dog_bone_normals, "87": dog_bone_positions}
