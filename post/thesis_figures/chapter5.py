# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 5: springs, strings and the pendulum."""
import numpy

import style

# The spring of 5.5: A E/L with L between its end points; its mass and gravity.
SPRING, MASS, GRAVITY = 0.1 * 1e6 / 0.3, 3.33, 250.0
PENDULUMS = {"20": "pendulum-20", "40": "pendulum-40", "80": "pendulum-80", "320": "pendulum-320"}
BARS = "--path=fem"
SNAPSHOTS = ("in.tiout(13)=0.25", "in.iout(32)=0")  # of the pendulum: at these and at the end


def time_axis(axes, run):
    axes.set_xlabel(style.label("time", run.history.units["time"]))


def displacement(axes, run):
    """Of the mass, the point tracked last, over the exact one."""
    here, exact = run.history["point_y"][:, -1], run.exact_over("time")
    column = f"point_y_{run.history['point_y'].shape[1]}"
    axes.plot(run.history["time"], here - here[0], label="MPM")
    axes.plot(exact["time"], exact[column] - here[0], **style.EXACT)
    axes.set_ylabel(style.label("displacement of the mass", run.history.units["point_y"]))
    time_axis(axes, run)
    style.legend_above(axes, 3)


def energy_axis(axes, run):
    axes.set_ylabel(style.label("energy", run.history.units["energy_total"]))
    time_axis(axes, run)
    style.legend_above(axes, 5)


def spring(runs):
    """Spring-mass system, displacement of the mass and energy without gravity's."""
    run = runs.of("spring-mass")
    figure, axes = style.panels(2, 1, 7, 2.8)
    displacement(axes[0], run)
    time = run.history["time"]
    omega = numpy.sqrt(SPRING / MASS)
    drop = MASS * GRAVITY / SPRING * (1 - numpy.cos(omega * time))
    speed = MASS * GRAVITY / SPRING * omega * numpy.sin(omega * time)
    axes[1].plot(time, run.history["energy_kinetic"], label="kinetic")
    axes[1].plot(time, run.history["energy_strain"], label="of the spring")
    for exact in (MASS * speed**2 / 2, SPRING * drop**2 / 2):
        axes[1].plot(time, exact, **style.EXACT)
    energy_axis(axes[1], run)
    return figure


def string_places(runs):
    """String-mass system, the points over time."""
    run = runs.of("string-mass", "in.tiout(13)=0.0025", "in.tmax=0.1")
    figure, (axes,) = style.panels(1, 1, 8, 4.5)
    times = numpy.broadcast_to(run.particles["time"][:, None], run.particles["y"].shape)
    taut = run.particles["strain"] > 0
    look = style.POINTS | {"markersize": 3.5, "markeredgewidth": 0.7}
    axes.plot(times[~taut], run.particles["y"][~taut], color="tab:orange", markerfacecolor="white", label="without tension", **look)
    axes.plot(times[taut], run.particles["y"][taut], color="tab:blue", label="in tension", **look)
    axes.plot(times[:, -1], run.particles["y"][:, -1], color="black", **look | {"markersize": 6}, label="the mass")
    axes.grid(False)
    for side in numpy.arange(1.6, 2.05, 0.1):
        axes.axhline(side, **style.GRID | {"color": "0.7"})
    axes.set_ylim(1.63, 2.02)
    axes.set_ylabel(style.label("y, lines at the cells' sides", run.particles.units["y"]))
    time_axis(axes, run)
    style.legend_above(axes, 3)
    return figure


def shade_tension(axes, run):
    """Where the exact solution has the string in tension."""
    begin, end, period = (run.summary[f"exact_{name}_time"] for name in ("taut", "slack_again", "apex"))
    for n in range(int(run.history["time"][-1] / period) + 1):
        axes.axvspan(n * period + begin, min(n * period + end, run.history["time"][-1]), color="0.92", zorder=0,
                     label="in tension, exact")


def string_motion(runs):
    """String-mass system, displacement of the mass and energy without gravity's."""
    run = runs.of("string-mass")
    figure, axes = style.panels(2, 1, 7, 2.8)
    for panel in axes:
        shade_tension(panel, run)
    displacement(axes[0], run)
    time, kinetic, strain = (run.history[name] for name in ("time", "energy_kinetic", "energy_strain"))
    exact = run.exact_over("time")
    drop = run.history["point_y"][0, 0] - exact["point_y_1"]
    axes[1].plot(time, strain, label="of the string")
    axes[1].plot(time, kinetic, label="kinetic")
    axes[1].plot(time, kinetic + strain, label="total", color="tab:red")
    axes[1].plot(exact["time"], MASS * GRAVITY * drop, **style.EXACT | {"label": "total, exact"})
    energy_axis(axes[1], run)
    return figure


def pivot_and_length(run):
    x, y = run.particles["x"][0], run.particles["y"][0]
    return x[0], y[0], numpy.hypot(x[-1] - x[0], y[-1] - y[0])


def exact_angle(run, times):
    """Of the rigid pendulum, radians to the right of the vertical."""
    pivot_x, _, length = pivot_and_length(run)
    exact = run.exact_over("time")
    return numpy.arcsin((numpy.interp(times, exact["time"], exact["point_x_2"]) - pivot_x) / length)


def draw_rod(axes, run, time, **look):
    x, y, length = pivot_and_length(run)
    angle = exact_angle(run, time)
    axes.plot([x, x + length * numpy.sin(angle)], [y, y - length * numpy.cos(angle)], **look)


def frame_pendulum(axes, run, time):
    """All frames alike: the grid of the finest pendulum, .7 wide and 1 high, and the lines of this one's cells."""
    axes.set_aspect("equal")
    axes.set_xlim(-0.02, 0.72)
    axes.set_ylim(0.15, 1.02)
    axes.grid(False)
    for line in (axes.axvline, axes.axhline):
        for at in numpy.arange(0, 1.01, run.summary["dx"]):
            line(at, **style.GRID)
    axes.set_title(style.at_time(time, run.particles.units["time"]))


def label_outer(figure, run, columns):
    for k, panel in enumerate(figure.axes):
        if k >= len(figure.axes) - columns:
            panel.set_xlabel(style.label("x", run.particles.units["x"]))
        if k % columns == 0:
            panel.set_ylabel(style.label("y", run.particles.units["y"]))


def pendulum_frames(run, method="MPM"):
    """One frame a snapshot: the method's points, and the rigid pendulum at the same time."""
    times = run.particles["time"]
    figure, axes = style.panels(len(times), 4, 2.4, 2.9)
    for record, (panel, time) in enumerate(zip(axes, times)):
        frame_pendulum(panel, run, time)
        panel.plot(run.particles["x"][record], run.particles["y"][record], color="tab:blue", label=method,
                   **style.POINTS)
        draw_rod(panel, run, time, **style.EXACT | {"label": "exact, rigid"})
    label_outer(figure, run, 4)
    style.legend(axes[0], loc="lower right")
    return figure


def pendulum_20(runs):
    """Pendulum at various times, 20 material points."""
    return pendulum_frames(runs.of(PENDULUMS["20"], *SNAPSHOTS))


def pendulum_40(runs):
    """Pendulum at various times, 40 material points."""
    return pendulum_frames(runs.of(PENDULUMS["40"], *SNAPSHOTS))


def pendulum_80(runs):
    """Pendulum at various times, 80 material points."""
    return pendulum_frames(runs.of(PENDULUMS["80"], *SNAPSHOTS))


def pendulum_320(runs):
    """Pendulum at various times, 320 material points."""
    return pendulum_frames(runs.of(PENDULUMS["320"], *SNAPSHOTS))


def pendulum_bars(runs):
    """Pendulum at various times, finite elements: 319 bars that only pull."""
    return pendulum_frames(runs.of(PENDULUMS["320"], *SNAPSHOTS, BARS), "bars")


def pendulum_two_way(runs):
    """Pendulum at various times, 40 material points, without the wrinkle algorithm."""
    return pendulum_frames(runs.of("pendulum-40-two-way", *SNAPSHOTS))


def pendulum_angles(runs):
    """Angle of the pendulum on four grids and by finite elements."""
    figure, (axes,) = style.panels(1, 1, 8, 4.5)
    for count, deck in PENDULUMS.items():
        run = runs.of(deck, *SNAPSHOTS)
        period = run.summary["period"]
        axes.plot(run.history["time"], run.history["tracked_angle"], label=f"{count} points, period {period:.3f}")
    bars = runs.of(PENDULUMS["320"], *SNAPSHOTS, BARS)
    axes.plot(bars.history["time"], bars.history["tracked_angle"], color="tab:purple",
              label=f"319 bars, period {bars.summary['period']:.4f}")
    exact = numpy.degrees(exact_angle(run, run.history["time"]))
    axes.plot(run.history["time"], exact,
              **style.EXACT | {"label": f"exact, rigid, period {run.summary['exact_period']:.4f}"})
    axes.set_ylabel("angle to the right of the vertical [degrees]")
    time_axis(axes, run)
    style.legend_above(axes, 3)
    return figure


FIGURES = {"26": spring, "28": string_places, "29": string_motion, "32": pendulum_20, "33": pendulum_40,
           "34": pendulum_80, "35": pendulum_320, "36": pendulum_bars, "37": pendulum_angles, "38": pendulum_two_way}
