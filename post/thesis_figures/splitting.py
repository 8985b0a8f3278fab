# SPDX-License-Identifier: GPL-3.0-or-later
"""Where fluid and solids may be solved one after the other: a bar in a stream over its density and the step."""
import re
import subprocess

import numpy

import style
from .runs import RunFailed

# Of triangles of order 1, as the numbers of the guide's page are.
BARE = ("in.iout(39)=0", "coupled.jet_smoke(2)=0.", "mesh.element='p1'", "mesh.cells(1,1)=3,12")
STEPS = 160  # of each run
RATIOS = (1, 5, 25, 75, 150, 300)  # the bar's density over the fluid's
LENGTHS = (1 / 15, 1 / 30, 1 / 60, 1 / 120, 1 / 240)
MATERIALS = ((1e6, 0.0), (1e7, 0.002), (1e7, 0.02))  # Young's modulus and beta of damping
LOOKS = {("splitting", True): {"marker": "o", "markersize": 9, "color": "tab:green"},
         ("splitting", False): {"marker": "o", "markersize": 9, "color": "tab:red"},
         ("symmetric", True): {"marker": "+", "color": "black"},
         ("symmetric", False): {"marker": "x", "color": "black"}}
THEORY = re.compile(r"by theory: .* added mass is ([\d.e+-]+) times")
ESTIMATE = re.compile(r"added mass ([\d.e+-]+) is \w+ m \+ c h/2 = ([\d.e+-]+)")


def settings(material, ratio, length, mode):
    modulus, beta = material
    return (f"coupled.mode='{mode}'", f"reg.densir(1)={1000 * ratio}", f"reg.matr(1,1)={modulus}", f"fem.beta={beta}",
            f"in.tstep={length:.12g}", f"in.dtmax={length:.12g}", f"in.tmax={STEPS * length:.12g}",
            f"in.tiout(33)={length:.12g}", *BARE)


def holds(runs, *point):
    """Whether it comes to its end with a flow's energy."""
    try:
        return runs.of("coupled-bar", *settings(*point)).summary["energy_growth"] < 10
    except RunFailed:
        return False


def plan_of(runs, settings):
    words = [word for setting in settings for word in ("--set", setting)]
    return subprocess.run([runs.program, "plan", runs.decks / "coupled-bar.in", *words], capture_output=True, text=True,
                          check=True).stdout


def told(runs, *point):
    """Added mass over what resists it, of `tether plan`: in the worst of all motions by theory, and by the estimate that it
    has where there are no factors."""
    chosen = settings(*point, "splitting")
    theory = THEORY.search(plan_of(runs, chosen)).group(1)
    added, resists = ESTIMATE.search(plan_of(runs, [*chosen, "coupled.solver='krylov'"])).groups()
    return {"theory": float(theory), "estimate": float(added) / float(resists)}


def limit(ratios, values):
    """The density ratio at which a value that falls with it is 1, by a power of it between neighbours; nan beyond."""
    at = numpy.log(values)
    if at[0] < 0 or at[-1] > 0:
        return numpy.nan
    return float(numpy.exp(numpy.interp(0, -at, numpy.log(ratios))))


def limits(runs, material):
    """Of theory and estimate, a density ratio for each step."""
    all_told = [[told(runs, material, ratio, length) for ratio in RATIOS] for length in LENGTHS]
    return {way: [limit(RATIOS, [one[way] for one in of_step]) for of_step in all_told] for way in ("theory", "estimate")}


def marks(axes, runs, material, mode):
    held = {(length, ratio): holds(runs, material, ratio, length, mode) for length in LENGTHS for ratio in RATIOS}
    for outcome, verb in ((True, "holds"), (False, "fails")):
        points = [point for point in held if held[point] == outcome]
        axes.plot(*(zip(*points) if points else ([], [])), linestyle="none", label=f"{mode} {verb}", **LOOKS[mode, outcome])


def draw(axes, runs, material):
    marks(axes, runs, material, "splitting")
    lines = limits(runs, material)
    axes.plot(LENGTHS, lines["theory"], color="black", label="limit by theory")
    axes.plot(LENGTHS, lines["estimate"], color="black", linestyle="--", label="estimate of the plan")
    marks(axes, runs, material, "symmetric")
    axes.set(xscale="log", yscale="log", xlabel="step [s]", ylabel="density of the bar over that of the fluid")
    axes.set_xticks(LENGTHS, [f"1/{1 / length:.0f}" for length in LENGTHS])
    axes.minorticks_off()
    axes.set_title(f"E = {material[0]:.0e}, beta = {material[1]:g} s")


def splitting_map(runs):
    """Where splitting holds and fails, beside the simultaneous solution."""
    figure, axes = style.panels(len(MATERIALS), len(MATERIALS), 4.2, 4.2)
    for panel, material in zip(axes, MATERIALS):
        draw(panel, runs, material)
    style.note(figure, f"A bar in a stream (coupled-bar), {STEPS} steps of each kind. Dots: fluid and solids one after the other; crosses: "
                       "together. What fails ends, or has ten times the energy at the start.")
    axes[-1].legend(loc="upper left", bbox_to_anchor=(1.02, 1), borderaxespad=0)
    return figure


FIGURES = {"splitting-map": splitting_map}
