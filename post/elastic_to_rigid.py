#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How an elastic body becomes a rigid one, from runs made for it: python3 post/elastic_to_rigid.py [--out FOLDER].

Draws elastic-to-rigid.png and prints its numbers: over Young's modulus the distance between the paths of an elastic body's
nodes and a rigid body's under the same loads, by the same steps and by much finer ones, and what the runs cost. Runs stay
in FOLDER/runs. Exit codes: 0 done, 2 no program to run, 3 a run failed, 4 the figure could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import numpy
from matplotlib import pyplot

import tether_results
import style
from thesis_figures.runs import NoProgram, RunFailed, Runs

ROOT = Path(__file__).resolve().parents[1]
MODULI = tuple(10.0**k for k in range(3, 13))
STEPS = (0.08, 0.04, 0.02)
FINE = 0.00125
RECORDS = "in.tiout(33)=0.08"  # of all runs at the same times
COLOURS = ("tab:blue", "tab:orange", "tab:green")


def rigid(runs, step):
    return runs.of("rigid-body", f"in.tstep={step}", RECORDS)


def elastic(runs, step, modulus):
    return runs.of("elastic-body", f"in.tstep={step}", f"reg.matr(1,1:3)=3*{modulus:.1e}", RECORDS)


def distance(run, other):
    """The largest over time of the root mean square over the tracked nodes, how far they are apart."""
    squares = sum((run.history[name] - other.history[name])**2 for name in ("point_x", "point_y", "point_z"))
    return float(numpy.sqrt(squares.mean(axis=1)).max())


class Transition:
    """The runs of one step and what is read from them, a number a modulus."""

    def __init__(self, runs, step, moduli):
        self.step, self.moduli = step, moduli
        self.rigid = rigid(runs, step)
        self.runs = [elastic(runs, step, modulus) for modulus in moduli]
        self.same = [distance(run, self.rigid) for run in self.runs]
        self.fine = [distance(run, rigid(runs, FINE)) for run in self.runs]

    def of_summaries(self, key):
        return [run.summary[key] for run in self.runs]

    def iterations(self, run):
        return run.summary["newton_iterations"] / run.summary["steps"]

    def table(self):
        yield (f"steps of {self.step}: unknowns {self.runs[0].summary['unknowns']:.0f}, rigid "
               f"{self.rigid.summary['unknowns']:.0f}; rigid: {self.rigid.summary['cpu_seconds']:.3g} s, "
               f"{self.iterations(self.rigid):.3g} iterations a step")
        yield "modulus distance slope to_fine_steps cpu_seconds iterations_a_step"
        for k, modulus in enumerate(self.moduli):
            slope = numpy.log10(self.same[k] / self.same[k - 1]) / numpy.log10(modulus / self.moduli[k - 1]) if k else 0
            yield (f"{modulus:.0e} {self.same[k]:.4g} {slope:.3f} {self.fine[k]:.4g} "
                   f"{self.runs[k].summary['cpu_seconds']:.3g} {self.iterations(self.runs[k]):.3g}")


def chart(transitions):
    figure, (distances, seconds, iterations) = style.panels(3, 3, 4.4, 3.8)
    for of, colour in zip(transitions, COLOURS):
        name = f"steps of {of.step}"
        distances.loglog(of.moduli, of.same, color=colour, marker="o", label=name)
        distances.loglog(of.moduli, of.fine, color=colour, linestyle=":", label=f"{name}, from finest")
        seconds.loglog(of.moduli, of.of_summaries("cpu_seconds"), color=colour, marker="o", label=name)
        seconds.axhline(of.rigid.summary["cpu_seconds"], color=colour, linestyle="--")
        iterations.semilogx(of.moduli, [of.iterations(run) for run in of.runs], color=colour, marker="o", label=name)
        iterations.axhline(of.iterations(of.rigid), color=colour, linestyle="--")
    for axes, label in ((distances, "distance from the rigid body's path"), (seconds, "processor seconds [s]"),
                        (iterations, "Newton iterations a step")):
        axes.set_xlabel("Young's modulus")
        axes.set_ylabel(label)
    iterations.set_ylim(bottom=0)
    style.legend(distances)
    style.legend(seconds)
    unknowns = [run.summary["unknowns"] for run in (transitions[0].runs[0], transitions[0].rigid)]
    style.note(figure, f"Dots: an elastic body of {unknowns[0]:.0f} unknowns, compared with a rigid one of {unknowns[1]:.0f} by the "
                       f"same steps; dotted: with the rigid one by steps of {FINE}. Broken: the rigid body's cost.")
    figure.suptitle("An elastic body that grows stiff becomes a rigid one")
    return figure


def arguments(words):
    parser = argparse.ArgumentParser(description="Draws how an elastic body becomes a rigid one, from runs made for it.")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "figures", metavar="FOLDER",
                        help="folder for figure and runs (default: out/figures)")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "release" / "tether", metavar="FILE",
                        help="the program (default: build/release/tether)")
    return parser.parse_args(words)


def main(words=None):
    chosen = arguments(words)
    style.use()
    try:
        runs = Runs(chosen.program, ROOT / "decks", chosen.out / "runs")
        transitions = [Transition(runs, step, MODULI) for step in STEPS]
        for transition in transitions:
            print("\n".join(transition.table()))
        chosen.out.mkdir(parents=True, exist_ok=True)
        figure = chart(transitions)
        figure.savefig(chosen.out / "elastic-to-rigid.png")
        pyplot.close(figure)
        print(chosen.out / "elastic-to-rigid.png")
    except NoProgram as reason:
        print(f"elastic_to_rigid: {reason}", file=sys.stderr)
        return 2
    except (RunFailed, tether_results.NotARun) as reason:
        print(f"elastic_to_rigid: {reason}", file=sys.stderr)
        return 3
    except OSError as reason:
        print(f"elastic_to_rigid: {reason}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
