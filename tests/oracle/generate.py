# SPDX-License-Identifier: GPL-3.0-or-later
"""Decks from a seed, in two spellings: as tether reads them, and with what gfortran cannot read written otherwise.

generate(seed) covers the grammar of decks: headers and notes, openers and terminators, groups in any order, items with
and without subscripts, sections, nulls, repeat counts, every spelling of a value, every separator, comments. What
gfortran and tether read differently is left out here; README.md lists it and test_quirks.py shows it.
"""
import random

import spell
from table import GROUPS, REQUIRED

NOTES = ("", "'\"ary\"'", "\"sods problem\" '", "! $in nx=3 /", "nx = 5, 'open", "$ 5", "& co", "100 % & more", "$end",
         "0.5 !density", "a = b / c", "x(3)=1", "# note", "  ", "$inlet&regular", "$1in", "in", "\t!", "gr\u00fc\u00df")
# As tether may read it, as gfortran must: it takes no bare '$' or '&'.
TERMINATORS = (("/", "/"), ("$", "/"), ("&", "/"), ("$end", "$end"), ("&end", "&end"), ("$END", "$END"),
               ("&End", "&End"))


class Deck:
    """A deck in its two spellings as it is written."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.ours = []
        self.theirs = []
        self.behind_logical = False

    def write(self, text, theirs=None):
        self.ours.append(text)
        self.theirs.append(text if theirs is None else theirs)

    def chance(self, probability):
        return self.rng.random() < probability

    def notes(self):
        for _ in range(self.rng.choice((0, 0, 1, 2))):
            self.write(self.rng.choice(NOTES) + "\n")

    # --- groups

    def deck(self):
        names = [name for name in GROUPS if name == "in" or self.chance(0.6)]
        if self.chance(0.3):
            self.rng.shuffle(names)
        if self.chance(0.1):
            self.write("\ufeff")  # byte-order mark
        self.notes()
        for number, name in enumerate(names, 1):
            left_open = number < len(names) and self.chance(0.05)
            self.group(name, left_open)
            if not left_open:
                self.notes()

    def group(self, name, left_open):
        self.write(spell.blanks(self.rng) + self.rng.choice("$&") + spell.any_case(self.rng, name))
        self.write(self.rng.choice((spell.gap, spell.line_end, spell.comma))(self.rng))
        self.behind_logical = False
        for variable, full in self.variables(name):
            kind, shape, allowed = GROUPS[name][variable]
            self.item(variable, kind, shape, allowed, full)
            self.behind_logical = kind == "logical"
        if left_open:
            self.write("\n", "\n/\n")  # for tether the next opener closes the group
        else:
            self.terminator()

    def variables(self, group):
        """(name, whether it must get a value) of those that are set, in any order, some twice."""
        chosen = [(name, False) for name in self.rng.choices(list(GROUPS[group]), k=self.rng.randint(0, 12))]
        if group == "in":
            chosen += [(name, True) for name in REQUIRED]
            self.rng.shuffle(chosen)
        # Behind a logical gfortran takes 'tracked_at(' for a value.
        return [item for k, item in enumerate(chosen) if item[0] != "tracked_at" or "tracked" not in dict(chosen[:k])]

    def terminator(self):
        if self.behind_logical:
            self.write("\n")  # gfortran overlooks a '/' behind it in the deck's last line
        ours, theirs = self.rng.choice(TERMINATORS)
        rests = ("", "", " ", "\t! done") if ours in "$&" else ("", "", " x = 3", "! done", " 'open", " /")
        rest = self.rng.choice(rests) + "\n"
        self.write(ours + rest, theirs + rest)

    # --- items

    def item(self, name, kind, shape, allowed, full):
        target, room = self.target(shape)
        self.write(spell.any_case(self.rng, name))
        if target:
            self.write(spell.blanks(self.rng, 0.05) + target, target)
        self.write(spell.blanks(self.rng))
        if self.chance(0.05):
            self.write("\n" if self.behind_logical or self.chance(0.5) else f" {spell.comment(self.rng)}\n")
        self.write("=" + spell.blanks(self.rng))
        self.values(kind, allowed, 1 if full else min(room, self.rng.choice((0, 1, 1, 1, 2, 3, 4, 9))), full)

    def target(self, shape):
        """A subscript or none, and the number of values that fit."""
        if not shape or self.chance(0.3):
            return "", shape[0] if shape else 1
        sections = [self.section(extent) for extent in shape]
        ranged = any(elements for _, elements in sections)
        if ranged:
            count = 1
            for _, elements in sections:
                count *= elements or 1
        else:
            count = self.onward(shape, [int(text) for text, _ in sections])
        return "(" + ",".join(self.between_blanks(text, ranged) for text, _ in sections) + ")", count

    def between_blanks(self, subscript, ranged):
        """gfortran takes no blanks behind a subscript beside a section, and none at all behind a logical."""
        if self.behind_logical:
            return subscript
        return spell.blanks(self.rng, 0.1) + subscript + ("" if ranged else spell.blanks(self.rng, 0.1))

    def onward(self, shape, first):
        """Elements from one on, in column-major order; gfortran goes on from inside a column at the same row."""
        in_column = shape[0] - first[0] + 1
        return in_column if len(shape) == 1 or first[0] > 1 else shape[0] * (shape[1] - first[1] + 1)

    def section(self, extent):
        """Text of a subscript, and how many elements it has, 0 for a plain one."""
        first = self.rng.randint(1, min(extent, 25))
        if self.chance(0.6):
            return spell.integer(self.rng, (first,)), 0
        form = self.rng.randrange(5)
        if form == 0:
            return ":", extent
        if form == 1:
            return f"{first}:", extent - first + 1
        last, step = self.rng.randint(1, extent), self.rng.randint(1, 4)
        if form == 2:
            return f":{last}:{step}", (last - 1) // step + 1
        if form == 3:
            last = max(first, last)
            return f"{first}:{last}", last - first + 1
        step = step if first <= last else -step
        return f"{first}:{last}:{step}", (last - first) // step + 1

    # --- values

    def values(self, kind, allowed, count, full):
        """That many values or nulls, and what separates them from the next item; no nulls if `full`."""
        done = 0
        behind_comma = True  # where nothing more makes a null
        if count and self.chance(0.05):
            self.write("\n")
            behind_comma = False
        while done < count:
            done, behind_comma = self.value(kind, allowed, done, count, behind_comma, full)
        if count == 0:
            self.write(spell.comma(self.rng) if self.chance(0.5) else spell.gap(self.rng, comments=False))
        elif self.ours[-1] == "," and self.chance(0.2):
            self.write(",")  # a null more, which may stand behind the last element

    def value(self, kind, allowed, done, count, behind_comma, full):
        repeats = self.rng.randint(1, count - done) if self.chance(0.15) else 0
        if repeats:
            self.write(f"{spell.zeros(self.rng)}{repeats}*")
        null = (repeats or behind_comma) and not full and self.chance(0.1)
        if not null:
            self.write(spell.value(self.rng, kind, allowed))
        comma = (null and not repeats) or self.chance(0.5)
        comments = kind != "logical" and not null
        self.write(spell.comma(self.rng) if comma else spell.gap(self.rng, comments))
        return done + max(repeats, 1), comma


def generate(seed):
    """(as tether reads it, as gfortran reads it): the same deck, as bytes."""
    deck = Deck(seed)
    deck.deck()
    ours, theirs = "".join(deck.ours), "".join(deck.theirs)
    if deck.chance(0.1):
        ours, theirs = ours.replace("\n", "\r\n"), theirs.replace("\n", "\r\n")
    if deck.chance(0.1):
        ours = ours.removesuffix("\n")
    return ours.encode(), theirs.encode()
