#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when a comment or a message in src/ has a word that plain English has a commoner one for, or a number like .5,
and when the doc comment of a function in a header opens as a fragment instead of a sentence."""
import re
import sys

from sources import end, sources

# What is not to stand there, and what to write instead.
WORDS = (
    (re.compile(r"\bbehind\b", re.I), "'after' for order and time; 'behind' only for a place: behind a wall"),
    (re.compile(r"\b(tells?|told|telling)\b", re.I), "'reports', 'says' or 'shows', or a verb that says what is done"),
    (re.compile(r"\bgo(es)? by\b", re.I), "'uses' or 'follows'"),
    (re.compile(r"(?:^|[\s(,=])\.\d"), "a digit before the point: 0.5"),
)
# What may stand all the same, with the reason.
EXCEPTIONS = (
    (re.compile(r"\bbehind (which|(\w+ |\{\} )?(\w+ |\{\} )?(walls?|edges?|side|mirror|wave)\b)", re.I), "it is a place"),
    (re.compile(r"`[^`]*`"), "a name of the code"),
    (re.compile(r"\btells nothing\b(?=$|\"|: )"), "a verdict in the files of maps that users have"),
    (re.compile(r"^\.0$"), "what a whole number gets at its end to be a real one"),
    (re.compile(r"'in\.tstep=[.\d,]+'"), "a value as a deck may write it"),
)
# Openings of doc comments of functions, and what to write instead.
OPENINGS = {
    "Of": "'Returns ... of', 'Says of ...'", "With": "'Makes it with ...', 'Does ... with'",
    "Whether": "'Returns whether ...'", "What": "'Returns what ...', 'Says what ...'",
    "For": "'Returns for ...', 'Does ... for'", "By": "'Finds ... by'", "Where": "'Returns where ...'",
    "The same": "'Does the same ...', 'Returns the same ...'",
}
OPENING = re.compile(rf"({'|'.join(OPENINGS)})\b")


def texts_of(line):
    """The string literals of a line, without their quotes, and its comment."""
    at = 0
    while at < len(line):
        if line.startswith("//", at):
            yield line[at:].lstrip("/<").strip()
            return
        quote = line[at]
        # A ' within a number or a word opens nothing.
        if quote == '"' or (quote == "'" and not line[at - 1:at].isalnum()):
            end = at + 1
            while end < len(line) and line[end] != quote:
                end += 2 if line[end] == "\\" else 1
            if quote == '"':
                yield line[at + 1:end]
            at = end
        at += 1


def wrong_words(file, lines):
    for number, line in enumerate(lines, 1):
        if line.lstrip().startswith("#include"):
            continue
        for text in texts_of(line):
            for exception, _ in EXCEPTIONS:
                text = exception.sub("", text)
            for word, instead in WORDS:
                if match := word.search(text):
                    yield f"{file}:{number}: '{match[0].strip()}': write {instead}"


def declaration_after(lines, at):
    """What a doc comment is about that ends before line `at`: the text to the first ; or {, without its template."""
    text = ""
    for line in lines[at:at + 8]:
        text += " " + line.strip()
        if re.search(r"[;{]", line):
            break
    text = re.sub(r"^ ?template ?<.*?> (?=\w)", "", text)
    return re.sub(r"\[\[\w+\]\] ?", "", text).strip()


def is_function(declaration):
    if re.match(r"(struct|class|enum|using|namespace|concept|typedef)\b", declaration):
        return False
    head = re.split(r"[{;]|=(?!=)", declaration)[0]
    return "operator" in head or "(" in re.sub(r"std::function<.*?>\s", "", head)


def fragments(file, lines):
    for number, line in enumerate(lines):
        doc = re.match(r"\s*/// (.*)", line)
        if not doc or (number and re.match(r"\s*///(?!<)", lines[number - 1])):
            continue
        opening = OPENING.match(doc[1])
        end = number
        while end < len(lines) and re.match(r"\s*///", lines[end]):
            end += 1
        if opening and is_function(declaration_after(lines, end)):
            yield (f"{file}:{number + 1}: a function's doc comment opens with '{opening[1]}': write a sentence, "
                   f"such as {OPENINGS[opening[1]]}")


def main():
    _, files = sources()
    found = []
    for file in files:
        lines = file.read_text().splitlines()
        found += wrong_words(file, lines)
        if file.suffix == ".hpp":
            found += fragments(file, lines)
    return end(found, files, "in plain words")


if __name__ == "__main__":
    sys.exit(main())
