# SPDX-License-Identifier: GPL-3.0-or-later
"""Chapter 6.3: a probe falls on an airbag, about an axis. Decks and results are in SI units."""
import numpy

import style

THESIS, ROBUST = (), ("mpm.method='robust'",)
# Ends in seconds, where a run cannot go on to its deck's: a gas point gets out of the bag and off the grid.
ENDS = {("cyl-200", THESIS): 0.07, ("cyl-200", ROBUST): 0.07, ("cyl-200-tether-kept", THESIS): 0.06,
        ("cyl-200-tether-kept", ROBUST): 0.06, ("cyl-200-ambient", THESIS): 0.02, ("cyl-200-ambient", ROBUST): 0.07,
        ("cyl-200-tether", THESIS): 0.07}
PROBE, BAG, TETHER = 3, 4, 5  # bodies of all decks with a probe
TIMES_200 = (0.0, 0.02, 0.03, 0.04, 0.05, 0.06)
TIMES_500 = (0.0, 0.01, 0.02, 0.03, 0.04)
NO_CURVES = "PISCES' and the experiment's curves are not printed as numbers in the thesis, so they are missing here."
# Box 10's first gas region, which lies within the shape that the run with a tether ends in.
BOX_10 = ((0.0, 0.14, 0.22, 0.26, 0.28, 0.26, 0.22, 0.18, 0.14, 0.0),
          (0.002, 0.01, 0.037, 0.077, 0.139, 0.219, 0.261, 0.289, 0.299, 0.299))
WIDEST, HIGHEST = 580.0, 315.0  # of the bag, mm


def run_of(runs, deck, method):
    end = ENDS.get((deck, method))
    return runs.of(deck, *([f"in.tmax={end:g}"] if end else []), *method)


def nearest(run, time):
    return int(numpy.argmin(abs(run.particles["time"] - time)))


def both_sides(run, record, body):
    """Of the axis, in mm: along it, and to its sides."""
    chosen = run.particles["body"][record] == body
    along, out = 1e3 * run.particles["y"][record][chosen], 1e3 * run.particles["x"][record][chosen]
    return numpy.concatenate((along, along)), numpy.concatenate((out, -out))


def frame_bag(axes):
    """The axis of the bag to the right, as in the thesis."""
    axes.set_aspect("equal")
    axes.set_xlim(-15, 440)
    axes.set_ylim(-345, 345)


def shape(axes, run, time, gas=False):
    record = nearest(run, time)
    if gas:
        for body in (1, 2):
            axes.plot(*both_sides(run, record, body), color="0.8", **style.POINTS | {"markersize": 1.0})
    for body, colour, name, size in ((PROBE, "tab:orange", "probe", 2.5), (BAG, "tab:blue", "airbag", 1.6),
                                     (TETHER, "tab:green", "tether", 1.2)):
        along, out = both_sides(run, record, body)
        if len(along):
            axes.plot(along, out, color=colour, label=name, **style.POINTS | {"markersize": size})
    axes.set_title(f"{1e3 * run.particles['time'][record]:.0f} ms")
    frame_bag(axes)


def shapes(runs, deck, times):
    """Two rows, the thesis' method and the robust one."""
    figure, axes = style.panels(2 * len(times), len(times), 1.9, 3.0)
    for row, (name, method) in enumerate((("thesis' method", THESIS), ("robust", ROBUST))):
        run = run_of(runs, deck, method)
        for panel, time in zip(axes[row * len(times):], times):
            shape(panel, run, time)
            if row:
                panel.set_xlabel("along the axis [mm]")
        axes[row * len(times)].set_ylabel(f"{name}\nfrom the axis [mm]")
    style.legend(axes[0], loc="upper right", markerscale=3)
    return figure


def shapes_200(runs):
    """Airbag and probe of 200 mm at various times."""
    return shapes(runs, "cyl-200", TIMES_200)


def shapes_500(runs):
    """Airbag and probe of 500 mm at various times."""
    return shapes(runs, "cyl-500", TIMES_500)


def draw_displacement(axes, run, name, **look):
    """Of the probe into the bag, and its largest where the curve has turned."""
    time, y = run.history["time"], run.history["body_y"][:, PROBE - 1]
    depth = 1e3 * (y[0] - y)
    peak = int(numpy.argmax(depth))
    turned = peak < len(depth) - 2
    label = f"{name}: {depth[peak]:.0f} mm at {1e3 * time[peak]:.0f} ms" if turned else name
    axes.plot(1e3 * time, depth, label=label, **look)


def displacements(runs, decks, speed):
    figure, (axes,) = style.panels(1, 1, 7.5, 4.6)
    longest = 0.0
    for (deck, name), colour in zip(decks, ("tab:blue", "tab:green", "tab:purple")):
        for method, kind, line in ((THESIS, "thesis' method", "-"), (ROBUST, "robust", ":")):
            run = run_of(runs, deck, method)
            draw_displacement(axes, run, f"{name}, {kind}", color=colour, linestyle=line)
            longest = max(longest, run.history["time"][-1])
    bottom, top = axes.get_ylim()
    axes.plot([0, 1e3 * longest], [0, 1e3 * speed * longest], color="0.6", linewidth=0.8, label="without a bag")
    axes.set_xlim(0, 1e3 * longest)
    axes.set_ylim(bottom, 1.1 * top)
    axes.set_xlabel("time [ms]")
    axes.set_ylabel("displacement of the probe into the airbag [mm]")
    style.legend_above(axes, 2)
    return figure


def displacement_200(runs):
    """Displacement of the probe of 200 mm, with and without tether and ambient pressure."""
    figure = displacements(runs, (("cyl-200", "vacuum outside"), ("cyl-200-tether-kept", "tether kept"),
                                  ("cyl-200-ambient", "air of 101,325 Pa outside")), 3.90)
    style.note(figure, NO_CURVES + "\nA curve ends with its run or before a gas point gets out of the bag and leaves the grid: "
                       "by the thesis' method\nat 72 ms, at 65 ms with the tether and at 21 ms in air.")
    return figure


def displacement_500(runs):
    """Displacement of the probe of 500 mm, without and with ambient pressure."""
    figure = displacements(runs, (("cyl-500", "vacuum outside"), ("cyl-500-ambient", "air of 101,325 Pa outside")), 4.70)
    style.note(figure, NO_CURVES)
    return figure


def at_40_ms(runs, deck):
    figure, axes = style.panels(2, 2, 3.6, 4.6)
    for panel, (name, method) in zip(axes, (("thesis' method", THESIS), ("robust", ROBUST))):
        shape(panel, run_of(runs, deck, method), 0.040, gas=True)
        panel.set_title(name)
        panel.set_xlabel("along the axis [mm]")
        panel.set_ylabel("from the axis [mm]")
    style.legend(axes[0], loc="upper right", markerscale=3)
    style.note(figure, "Gas grey. The thesis shows PISCES' shape at this time as a picture only; it is missing here.")
    return figure


def shape_200_at_40(runs):
    """Deformed airbag and probe of 200 mm at 40 ms."""
    return at_40_ms(runs, "cyl-200")


def shape_500_at_40(runs):
    """Deformed airbag and probe of 500 mm at 40 ms."""
    return at_40_ms(runs, "cyl-500")


def with_tether(runs):
    """Initial shape of the airbag from a run with a tether."""
    thesis, robust = run_of(runs, "cyl-200-tether", THESIS), run_of(runs, "cyl-200-tether", ROBUST)
    figure, axes = style.panels(3, 3, 3.4, 4.8)
    for panel, run, record, name in ((axes[0], robust, 0, "start"), (axes[1], thesis, -1, "thesis' method"),
                                     (axes[2], robust, -1, "robust, at rest")):
        for body, colour, label in ((1, "0.8", "gas"), (2, "tab:blue", "airbag"), (3, "tab:green", "tether")):
            panel.plot(*both_sides(run, record, body), color=colour, label=label,
                       **style.POINTS | {"markersize": 1.0 if body == 1 else 1.8})
        along, out = both_sides(run, record, 2)
        time = 1e3 * run.particles["time"][record]
        frame_bag(panel)
        panel.set_xlim(-25, 400)
        panel.set_title(f"{name}, {time:.0f} ms\n{2 * out.max():.0f} x {numpy.ptp(along):.0f} mm")
        panel.set_xlabel("along the axis [mm]")
    axes[0].set_ylabel("from the axis [mm]")
    x, y = 1e3 * numpy.array(BOX_10)
    axes[2].plot(numpy.concatenate((y, y[::-1])), numpy.concatenate((x, -x[::-1])), color="tab:red", linewidth=0.9,
                 label="gas region\nof Box 10")
    axes[2].legend(loc="center", markerscale=3, fontsize=7)
    style.note(figure, f"The thesis: {WIDEST:.0f} x {HIGHEST:.0f} mm. By the thesis' method the tether comes loose from the bag "
                       "here, from 20 ms on,\nand gas gets out; so the shape at rest is the robust method's.")
    return figure


FIGURES = {"58": with_tether, "59": shapes_200, "60": displacement_200, "61": shape_200_at_40, "62": shapes_500,
           "63": displacement_500, "64": shape_500_at_40}
