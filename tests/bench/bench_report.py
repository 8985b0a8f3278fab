# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of bench_points.py as Markdown, and its region in a guide."""
import pathlib

BEGIN, END = "<!-- bench points -->", "<!-- /bench points -->"


class NoRegion(Exception):
    """A guide has not exactly one region for the table."""


def table(head, rows):
    """Names on the left, numbers on the right."""
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def ratio(reference, ours):
    return f"{reference / ours:.2f}"


def of_points(found):
    """found: name -> (plain, tether) [ns]"""
    rows = [[name, f"{plain:.1f}", f"{ours:.1f}", ratio(plain, ours)] for name, (plain, ours) in found.items()]
    return ("A point-step by the plain loop that does the same and by the program, in nanoseconds of a processor, and\n"
            "how many times as fast the program is. Start, outputs and the first step are left out. Of rows in random\n"
            "order, what rows in order take stands in place of the plain loop:\n\n" +
            table(["scene", "plain", "tether", "times"], rows))


def of_sets(found):
    """found: name -> {set of instructions: (plain, tether)}"""
    sets = list(next(iter(found.values())))
    rows = []
    for name, by_set in found.items():
        rows.append([name, *(f"{ours:.1f} ({ratio(plain, ours)})" for plain, ours in by_set.values())])
    return ("By sets of instructions (`TETHER_TARGET`; sse2 where it was built by `TETHER_SSE`), and in brackets the times again:\n\n" +
            table(["scene", *sets], rows))


def of_decks(found, against):
    """found: name -> [ms before the first step, seconds, and of another binary, too]"""
    head = ["deck", "start, ms", "CPU s"] + (["before", "times"] if against else [])
    rows = [[name, f"{start:.0f}", f"{now:.3g}", *(f"{before:.3g}" for before in more),
             *(ratio(before, now) for before in more)] for name, (start, now, *more) in found.items()]
    return "Whole decks, with start and outputs:\n\n" + table(head, rows)


def of_growth(found):
    """found: name -> (points, plain, tether, bytes a point)"""
    rows = [[name, f"{points:.3g}", f"{plain:.1f}", f"{ours:.1f}", ratio(plain, ours), f"{size:.0f}"]
            for name, (points, plain, ours, size) in found.items()]
    return ("From 1e4 to 1e7 points, with the most memory that a run held, all of it, over its points:\n\n" +
            table(["scene", "points", "plain", "tether", "times", "bytes a point"], rows))


def of_machine(machine, bounds):
    """bounds: name -> {limit: ns}"""
    limits = list(next(iter(bounds.values())))
    rows = [[name, *(f"{of[limit]:.1f}" for limit in limits)] for name, of in bounds.items()]
    memory, cache, products = (1e-9 * machine[name] for name in ("memory", "cache", "multiplications"))
    return (f"The machine copies {memory:.1f} GB/s in memory and {cache:.0f} GB/s in its second cache, read and written\n"
            f"together, and multiplies {products:.1f}e9 times a second. A point-step by these passes needs at least, in ns:"
            "\n\n" +
            table(["step", *limits], rows))


def text(sections, processor):
    """All sections, after what they were measured on."""
    return "\n\n".join([f"Measured on one core of: {processor}.", *sections]) + "\n"


def with_region(guide, new):
    """A guide's text with what stands between the two marks replaced."""
    if guide.count(BEGIN) != 1 or guide.count(END) != 1 or guide.index(END) < guide.index(BEGIN):
        raise NoRegion(f"not exactly one {BEGIN} with its {END} after it")
    before, rest = guide.split(BEGIN)
    return f"{before}{BEGIN}\n{new}{END}{rest.split(END)[1]}"


def processor():
    """The name that Linux gives it."""
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "unknown"
