#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when a folder of src/ includes one that stands behind it, when headers include each other in a circle, or when
a mutable global stands in a file. The order of the folders is the architecture: data flows one way."""
import pathlib
import re
import sys

ORDER = "base algebra grid laws deck scene reference plan results solvers studies".split()
PATHS = "mpm fem coupled".split()  # inside solvers/

INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')
# A definition at the left margin that is neither constant nor a function, type or alias.
GLOBAL = re.compile(
    r"(?=[A-Za-z])(?:static |inline |extern |thread_local )*"
    r"(?!const\b|constexpr\b|constinit const\b|using\b|namespace\b|template\b|struct\b|class\b|enum\b|return\b|typedef\b|friend\b|BENCHMARK|TEST)"
    r"[\w:<>,*& ]+ \w+(\[\w*\])*\s*(=|;|\{)"
)


def rank(parts):
    """Place of a file, from its path below src/. A header straight in solvers/ is the interface that stands before the
    paths; a source there is the maker that stands behind them."""
    top = parts[0] if len(parts) > 1 else "main"
    outer = ORDER.index(top) if top in ORDER else len(ORDER)
    if len(parts) > 2 and top == "solvers" and parts[1] in PATHS:
        return outer, PATHS.index(parts[1])
    return outer, -1 if parts[-1].endswith(".hpp") else len(PATHS)


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
                yield f"{file}:{number}: must not include {name}, which stands behind it"


def circles(src, files):
    graph = {str(f.relative_to(src)): [n for _, n in includes(f) if (src / n).exists()] for f in files}
    done, path = set(), []

    def visit(name):
        if name in path:
            yield "circle: " + " -> ".join(path[path.index(name):] + [name])
        elif name not in done:
            path.append(name)
            for other in graph.get(name, []):
                yield from visit(other)
            path.pop()
            done.add(name)

    for name in graph:
        yield from visit(name)


def mutable_globals(files):
    for file in files:
        for number, line in enumerate(file.read_text().splitlines(), 1):
            if GLOBAL.match(line) and "(" not in line.split("=")[0]:
                yield f"{file}:{number}: mutable global? {line.strip()}"


def main():
    src = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "src")
    files = sorted(p for pattern in ("*.hpp", "*.cpp") for p in src.rglob(pattern))
    if not files:
        print(f"no sources in {src}")
        return 1
    found = [*downward_includes(src, files), *circles(src, files), *mutable_globals(files)]
    print("\n".join(found) if found else f"{len(files)} files in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
