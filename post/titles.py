# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles of figures: the first sentence of the text before a deck's groups."""
import re
import textwrap

LONGEST = 140
SENTENCE_ENDS = r"(?<!Fig)(?<!Figs)[.;] "
SOURCE = r"\s*\((?=[^()]*(?:chapter|appendix|[Ss]ection|thesis|Fig|Box|Table))[^()]*\)"  # where a deck is from


def first_statement(lines):
    """Lines up to one that the next, which begins with a capital, does not carry on."""
    found = lines[:1]
    for line in lines[1:]:
        if line[0].isupper() and not found[-1].endswith(","):
            break
        found.append(line)
    return " ".join(found)


def title(name, head):
    """A name and the first sentence of a deck's head, without its source; lines that a namelist's readers want quoted are no
    words."""
    lines = [line.strip() for line in head.splitlines() if line.strip()]
    words = [line for line in lines if line[0] not in "'\""] or [line.strip("'\" ") for line in lines[-1:]]
    sentence = re.split(SENTENCE_ENDS, re.sub(SOURCE, "", first_statement(words)))[0]
    while sentence.count("(") > sentence.count(")"):
        sentence = sentence[:sentence.rindex("(")].rstrip()
    return f"{name}: {textwrap.shorten(sentence, LONGEST, placeholder=' ...')}" if sentence else name
