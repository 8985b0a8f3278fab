#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of a point-step against plain loops, in turns in one run: CPU time of the process, the best of some rounds.

python3 tests/bench/bench_points.py build/release [rounds [words of names of cases]] [options]

Give the machine nothing else to do. The ratio says how many times as fast as the plain loop the program is. The first
step of a run, with what is done once, is left out: a run of one step is taken off. Without options the cases alone are
run; with options what they name, and --all is all of it, as `./quickstart bench` has it.
"""
import argparse
import pathlib
import sys

import bench_cases
import bench_plot
import bench_report
from bench_runs import LONGEST, Bench, Failed, in_turns, scratch

FIGURE = "point-steps.png"


def arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="folder of the build")
    parser.add_argument("rounds", type=int, nargs="?", default=7)
    parser.add_argument("words", nargs="*", help="only what has them in its name")
    parser.add_argument("--cases", action="store_true", help="scenes against plain loops, as without any option")
    parser.add_argument("--sets", action="store_true", help="some of them by all sets of instructions that there are")
    parser.add_argument("--decks", action="store_true", help="seconds of whole decks")
    parser.add_argument("--growth", action="store_true", help="1e4 to 1e7 points, with memory")
    parser.add_argument("--machine", action="store_true", help="its own limits; with --growth the figure, too")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--against", type=pathlib.Path, help="another binary that runs the whole decks in turns")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/bench"), help="for table and figure")
    parser.add_argument("--write", type=pathlib.Path, metavar="GUIDE",
                        help="put the table into this guide's region, and the figure next to it")
    return parser.parse_intermixed_args(words)


def say(name, *numbers):
    print(f"{name:36}" + "".join(f" {number:>9.4g}" for number in numbers), flush=True)


def run_cases(bench, chosen):
    print(f"{'case':36} {'plain':>9} {'tether':>9} {'times':>9}   [ns a point-step]")
    found = {}
    for case in bench_cases.chosen(bench_cases.CASES, chosen.words):
        plain, ours = found[case.name] = bench.compared(case, chosen.rounds)
        say(case.name, plain, ours, plain / ours)
    return found


def run_sets(bench, chosen):
    sets = [target for target in bench_cases.SETS if bench.has_set(target)]
    print(f"{'case by ' + ', '.join(sets):36}")
    found = {}
    for case in bench_cases.chosen(bench_cases.BY_SETS, chosen.words):
        found[case.name] = {target: bench.compared(case, chosen.rounds, target) for target in sets}
        say(case.name, *(ours for _, ours in found[case.name].values()))
    return found


def run_decks(bench, chosen):
    print(f"{'deck':36} {'start ms':>9} {'CPU s':>9}" + (f" {'before':>9}" if chosen.against else ""))
    found = {}
    programs = [bench.tether] + ([chosen.against] if chosen.against else [])
    for deck in bench_cases.chosen(bench_cases.WHOLE, chosen.words):
        runs = [lambda program=program: bench.whole_deck(deck, program) for program in programs]
        name = " ".join([deck.name, *(setting.split("'")[1] for setting in deck.settings)])
        seconds = in_turns(chosen.rounds, *runs, longest=LONGEST)
        found[name] = [bench.start(), *seconds]
        say(name, *found[name])
    return found


def run_growth(bench, chosen):
    print(f"{'growth':36} {'points':>9} {'plain':>9} {'tether':>9} {'bytes':>9}")
    found = {}
    for case in bench_cases.chosen(bench_cases.GROWTH, chosen.words):
        plain, ours = bench.compared(case, chosen.rounds, longest=LONGEST)
        points, memory = bench.points_and_memory(case)
        found[case.name] = (points, plain, ours, memory / points)
        say(case.name, *found[case.name])
    return found


def sections(bench, chosen):
    """Texts of what was asked for, and what the figure needs."""
    some = chosen.sets or chosen.decks or chosen.growth or chosen.machine
    parts, growth, machine = [], {}, {}
    if chosen.all or chosen.cases or not some:
        parts.append((run_cases(bench, chosen), bench_report.of_points))
    if chosen.all or chosen.sets:
        parts.append((run_sets(bench, chosen), bench_report.of_sets))
    if chosen.all or chosen.decks:
        parts.append((run_decks(bench, chosen), lambda found: bench_report.of_decks(found, chosen.against)))
    if chosen.all or chosen.growth:
        growth = run_growth(bench, chosen)
        parts.append((growth, bench_report.of_growth))
    texts = [text_of(found) for found, text_of in parts if found]
    if chosen.all or chosen.machine:
        machine = bench.machine()
        texts.append(bench_report.of_machine(machine, bench_plot.bounds(machine)))
    return texts, growth, machine


def write(chosen, texts, growth, machine):
    folder = chosen.write.parent if chosen.write else chosen.out
    chosen.out.mkdir(parents=True, exist_ok=True)
    if growth and machine:
        bench_plot.draw(growth, machine).savefig(folder / FIGURE)
        texts = [*texts, f"![a point-step over the number of points, with the machine's limits]({FIGURE})"]
    table = bench_report.text(texts, bench_report.processor())
    (chosen.out / "table.md").write_text(table)
    if chosen.write:
        chosen.write.write_text(bench_report.with_region(chosen.write.read_text(), table))


def main(words=None):
    chosen = arguments(words)
    if chosen.write:
        bench_report.with_region(chosen.write.read_text(), "")  # before an hour of runs
    try:
        with scratch() as folder:
            texts, growth, machine = sections(Bench(chosen.build, folder), chosen)
    except Failed as reason:
        print(f"bench_points: {reason}", file=sys.stderr)
        return 3
    write(chosen, texts, growth, machine)
    return 0


if __name__ == "__main__":
    sys.exit(main())
