# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic bodies on meshes: what the steps of a free body keep."""
import numpy

import style

FREE = 5.0  # from then on no load acts on the block
RULES = (("'energy'", "discrete gradient", "tab:blue"), ("'midpoint'", "mid-point", "tab:orange"),
         ("'trapezoid'", "Newmark", "tab:green"))
STEPS = (0.1, 0.2)


def size(vector):
    return numpy.sqrt((vector**2).sum(axis=0))


def changes(run):
    """Of energy and of angular momentum in free flight, over what they are when it begins."""
    time = run.history["time"]
    free = time > FREE + 1e-9
    energy = run.history["energy_total"][free]
    momentum = numpy.array([run.history[f"angular_momentum_{axis}"][free] for axis in "xyz"])
    change = size(momentum - momentum[:, :1]) / size(momentum[:, 0])
    return time[free], abs(energy / energy[0] - 1), change


def flight(runs, rule, step):
    return runs.of("l-block", f"fem.integrator={rule}", f"in.tstep={step}", f"in.tiout(33)={step}",
                   f"in.tmax={FREE + 1000 * step}")


def tumbling(runs):
    """Tumbling L-block, 1,000 free steps: change of energy and of angular momentum by three rules."""
    figure, axes = style.panels(2 * len(STEPS), 2, 5.5, 3.2)
    drawn = [(rule, name, colour, step) for step in STEPS for rule, name, colour in RULES]
    longest = ("'energy'", "discrete gradient, steps of 2.0", "tab:purple", 2.0)
    for rule, name, colour, step in [*drawn, longest]:
        time, *columns = changes(flight(runs, rule, step))
        row = STEPS.index(step) if step in STEPS else len(STEPS) - 1
        for axis, values in zip(axes[2 * row:2 * row + 2], columns):
            axis.semilogy((time - FREE) / step, numpy.maximum(values, 1e-17), color=colour, label=name)
    for row, step in enumerate(STEPS):
        for axis, what in zip(axes[2 * row:2 * row + 2], ("energy", "angular momentum")):
            axis.set_title(f"steps of {step}")
            axis.set_ylabel(f"relative change of {what}")
            axis.set_xlabel("steps since the loads went")
            axis.set_ylim(1e-16, 1e6)
    style.legend(axes[2], loc="center right")
    return figure


FIGURES = {"l-block": tumbling}
