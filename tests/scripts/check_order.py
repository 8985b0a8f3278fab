#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when a folder of src/ includes one that stands after it, when files include each other in a circle, when what
runs a scene reaches the deck, when a mutable global stands in a file, or when two types share a name. The order of the folders is the architecture:
data flows one way."""
import pathlib
import re
import sys

from sources import end, sources

ORDER = "base fields algebra grid laws model deck read reference plan results loops physics run studies".split()
PATHS = "points bars contact solids rigid flow box".split()  # inside physics/
WITHOUT_DECK = "model reference results loops physics".split()
DECK = ("deck/", "read/")

INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')
# A definition at the left margin that is neither constant nor a function, type or alias.
GLOBAL = re.compile(
    r"(?=[A-Za-z])(?:static |inline |extern |thread_local )*"
    r"(?!(?:static |inline )*constexpr\b|const\b|constexpr\b|constinit const\b|using\b|namespace\b|template\b|struct\b|class\b|concept\b|enum\b|return\b|typedef\b|friend\b|BENCHMARK|TEST)"
    r"[\w:<>,*& ]+ \w+(\[\w*\])*\s*(=|;|\{)"
)
# A type that is defined at the left margin, where namespaces do not indent.
TYPE = re.compile(r"(?:struct|class|enum class|enum) (\w+)(?: final)?(?: :[^;]*)? \{")


def rank(parts):
    """Place of a file, from its path below src/. What stands straight in physics/ stands before its paths."""
    top = parts[0] if len(parts) > 1 else "main"
    outer = ORDER.index(top) if top in ORDER else len(ORDER)
    inner = PATHS.index(parts[1]) if len(parts) > 2 and top == "physics" and parts[1] in PATHS else -1
    return outer, inner


def includes(file):
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1]


def downward_includes(src, files):
    for file in files:
        mine = rank(file.relative_to(src).parts)
        for number, name in includes(file):
            if (src / name).exists() and rank(pathlib.PurePath(name).parts) > mine:
                yield f"{file}:{number}: must not include {name}, which stands after it"


def graph_of(src, files, name):
    """Which files each one includes, by what `name` calls them: a header and its source may be one."""
    graph = {}
    for file in files:
        mine = name(file.relative_to(src))
        others = {name(pathlib.PurePath(other)) for _, other in includes(file) if (src / other).exists()}
        graph.setdefault(mine, set()).update(others - {mine})
    return graph


def circles(src, files):
    graph = graph_of(src, files, lambda path: path.with_suffix("").as_posix())
    done, path = set(), []

    def visit(name):
        if name in path:
            yield "circle: " + " -> ".join(path[path.index(name):] + [name])
        elif name not in done:
            path.append(name)
            for other in sorted(graph.get(name, [])):
                yield from visit(other)
            path.pop()
            done.add(name)

    for name in graph:
        yield from visit(name)


def reaches_deck(src, files):
    """What a scene is made of and what runs it, that sees the deck it was read from, through whatever headers."""
    graph = graph_of(src, files, lambda path: path.as_posix())
    for name in graph:
        if not name.startswith(tuple(folder + "/" for folder in WITHOUT_DECK)):
            continue
        seen, ahead = set(), [name]
        while ahead:
            for other in graph.get(ahead.pop(), ()):
                if other not in seen:
                    seen.add(other)
                    ahead.append(other)
        reached = sorted(other for other in seen if other.startswith(DECK))
        if reached:
            yield f"{src / name}: must not see the deck, and does: {reached[0]}"


def mutable_globals(files):
    for file in files:
        for number, line in enumerate(file.read_text().splitlines(), 1):
            if GLOBAL.match(line) and "(" not in line.split("=")[0]:
                yield f"{file}:{number}: mutable global? {line.strip()}"


def types_of_one_name(files):
    """Two types of one name in one namespace: the linker takes the functions of one of them for both."""
    first = {}
    for file in files:
        namespaces = []
        for number, line in enumerate(file.read_text().splitlines(), 1):
            if match := re.match(r"namespace ?([\w:]*) ?\{", line):
                namespaces.append(match[1])
            elif line.startswith("}  // namespace") and namespaces:
                namespaces.pop()
            elif (match := TYPE.match(line)) and "" not in namespaces:
                name = "::".join([*namespaces, match[1]])
                if name in first:
                    yield f"{file}:{number}: {name} is a type of {first[name]}, too"
                first.setdefault(name, file)


def main():
    src, files = sources()
    found = [*downward_includes(src, files), *circles(src, files), *reaches_deck(src, files),
             *mutable_globals(files), *types_of_one_name(files)]
    return end(found, files, "in order")


if __name__ == "__main__":
    sys.exit(main())
