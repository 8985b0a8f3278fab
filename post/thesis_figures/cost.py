# SPDX-License-Identifier: GPL-3.0-or-later
"""What a better answer costs: the error against the exact solution over processor seconds, by both methods."""
import style

ROBUST = ("mpm.method='robust'",)
GAP = (*ROBUST, "mpm.contact='gap'")
PINNED = (*ROBUST, "points.pinned(1)=.true.")
LIGHT = ("in.iout(13)=0",)  # snapshots would cost as much as the steps of the small runs
# Of Sod's tube: cells, step and height of the tube go together.
SOD = tuple((f"in.nx={nodes}", f"in.tstep={step}", f"in.dtmax={step}", f"in.ytop={high}", f"reg.yvi(3:4,1:2)=4*{high}")
            for nodes, step, high in ((51, 2e-4, 0.02), (101, 1e-4, 0.01), (201, 0.5e-4, 0.005)))
BARS = tuple((f"in.nx={nodes}", f"in.ny={nodes}", f"in.tstep={step}", f"in.dtmax={step}")
             for nodes, step in ((11, 8e-4), (21, 4e-4), (41, 2e-4)))
MEMBRANES = ("membrane-expansion-1", "membrane-expansion-2", "membrane-expansion-3")
MEMBRANE_END = ("in.tmax=3.0",)


def of_key(key):
    return lambda run: abs(run.summary[f"error_{key}"])


def of_radius(run):
    """Of both ends of the membrane, their mean."""
    return abs(run.summary["error_radius_x"] + run.summary["error_radius_y"]) / 2


def of_energy(run):
    energy = run.history["energy_total"]
    return abs(energy[-1] / energy[0] - 1)


def curves(runs, cases, robust, error):
    """Seconds and errors by the thesis' method, then by the robust one; `cases` are decks with settings."""
    for method in ((), robust):
        made = [runs.of(deck, *settings, *method) for deck, settings in cases]
        yield [run.summary["cpu_seconds"] for run in made], [error(run) for run in made]


def draw(axes, runs, name, cases, robust, error):
    for (seconds, errors), kind, colour in zip(curves(runs, cases, robust, error), ("thesis' method", "robust"),
                                               ("tab:blue", "tab:orange")):
        axes.loglog(seconds, errors, marker="o", color=colour, label=kind)
    axes.set_title(name)
    axes.set_xlabel("processor seconds [s]")
    axes.set_ylabel("relative error")


def cost(runs):
    """Error over processor seconds, by both methods."""
    figure, axes = style.panels(4, 2, 4.8, 3.5)
    draw(axes[0], runs, "membrane expansion, mean radius at t = 3\n(cells of 0.4, 0.2, 0.1)",
         [(deck, (*MEMBRANE_END, *LIGHT)) for deck in MEMBRANES], ROBUST, of_radius)
    draw(axes[1], runs, "pendulum, period\n(20, 40, 80 points)",
         [(f"pendulum-{points}", ()) for points in (20, 40, 80)], PINNED, of_key("period"))
    draw(axes[2], runs, "Sod's shock tube, velocity (L1)\n(50, 100, 200 cells)",
         [("sod", settings) for settings in SOD], ROBUST, of_key("velocity"))
    draw(axes[3], runs, "two bars, change of total energy\n(cells of 0.5, 0.25, 0.125)",
         [("two-bar", settings) for settings in BARS], GAP, of_energy)
    style.legend(axes[0])
    style.note(figure, "Seconds are those of the machine that drew this. Of the two bars nothing exact is known but that the "
                       "energy stays.")
    return figure


FIGURES = {"cost": cost}
