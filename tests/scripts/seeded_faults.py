#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forty faults for src/, one or two a room, to see what the tests catch.

  seeded_faults.py --list
  seeded_faults.py --write FOLDER     a copy of src/ that has them all, for CMake with -DTETHER_FAULTS=ON
  seeded_faults.py --run BUILD [--fault NAME...] [--label quick|default] [--jobs N] [--resume TABLE]

In a program that was built so, the environment variable TETHER_FAULT chooses one of them by its name; without it the program
is as it should be. src/ itself has none: a row of the tables in seeded_faults/ has the text that stands once in its file, and
what stands there in the copy, with FAULT for the question whether this fault was chosen. A room is a folder of src/."""
import argparse
import dataclasses
import pathlib
import re
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
SRC = HERE.parents[1] / "src"
TABLES = HERE / "seeded_faults"
HEADER = "seeded_fault.hpp"
CHOICE = """// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace tether {

/// A fault's name by a number, so that loops compare numbers.
struct SeededFault {
  static constexpr std::uint64_t number_of(std::string_view name) {
    std::uint64_t number = 14695981039346656037U;  // FNV-1a
    for (const char c : name) number = (number ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return number;
  }
  consteval SeededFault(const char* name) : number(number_of(name)) {}  // NOLINT: names stand for faults
  std::uint64_t number;
};

inline const std::uint64_t chosen_fault = [] {
  const char* name = std::getenv("TETHER_FAULT");
  return SeededFault::number_of(name == nullptr ? "" : name);
}();

/// Returns whether TETHER_FAULT names this fault.
inline bool seeded_fault(SeededFault fault) { return fault.number == chosen_fault; }

}  // namespace tether
"""


class WrongRow(Exception):
    """A row of the tables that is no fault of src/ as it is."""


@dataclasses.dataclass(frozen=True)
class Fault:
    name: str
    file: str  # below src/
    text: str  # stands there once
    fault: str  # what stands there in the copy
    kind: str
    why: str  # somebody should notice
    likely: str = ""  # a part of the names of tests that may notice, or several with | between them

    @property
    def room(self):
        folder = pathlib.PurePath(self.file).parent.as_posix()
        return "commands" if folder == "." else folder

    def applied(self, source):
        """The source with the fault to be chosen."""
        count = source.count(self.text)
        if count != 1:
            raise WrongRow(f"seeded fault {self.name}: its text stands {count} times in src/{self.file}, not once: "
                           f"{self.text!r}. Bring the row in {TABLES.name}/ to what stands there now; where nothing like "
                           "it is left, seed another fault in its room")
        return source.replace(self.text, re.sub(r"\bFAULT\b", f'tether::seeded_fault("{self.name}")', self.fault))


def checked(fault):
    if not re.fullmatch(r"[a-z0-9-]+", fault.name):
        raise WrongRow(f"seeded fault {fault.name!r}: a name is of lower-case letters, digits and hyphens")
    if len(re.findall(r"\bFAULT\b", fault.fault)) != 1:
        raise WrongRow(f"seeded fault {fault.name}: FAULT must stand once in what it writes: {fault.fault!r}")
    return fault


def faults(tables=TABLES):
    rows = [row for table in sorted(tables.glob("*.toml")) for row in tomllib.loads(table.read_text())["fault"]]
    found = [checked(Fault(**row)) for row in rows]
    names = [fault.name for fault in found]
    for name in names:
        if names.count(name) > 1:
            raise WrongRow(f"seeded fault {name}: two rows have this name")
    return found


def with_faults(src, rows):
    """The texts of the files of src that have faults, by their paths below it."""
    texts = {}
    for fault in rows:
        texts[fault.file] = fault.applied(texts.get(fault.file) or (src / fault.file).read_text())
    include = f'\n#include "{HEADER}"\n'  # after the line with the licence, outside of all guards
    return {file: text.replace("\n", include, 1) for file, text in texts.items()}


def write_copy(src, copy, rows):
    """Makes the copy what it should be; files that are so already are left alone, for the sake of their times."""
    wanted = {path.relative_to(src).as_posix(): path.read_bytes() for path in src.rglob("*") if path.is_file()}
    wanted |= {file: text.encode() for file, text in with_faults(src, rows).items()}
    wanted[HEADER] = CHOICE.encode()
    for path in [path for path in copy.rglob("*") if path.is_file()]:
        if path.relative_to(copy).as_posix() not in wanted:
            path.unlink()
    for file, content in wanted.items():
        path = copy / file
        if path.is_file() and path.read_bytes() == content:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def listing(rows):
    return "".join(f"{fault.name:36} {fault.room:24} {fault.kind:30} {fault.why}\n" for fault in rows)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--list", action="store_true", help="the faults, a line each")
    what.add_argument("--write", type=pathlib.Path, metavar="FOLDER")
    what.add_argument("--run", type=pathlib.Path, metavar="BUILD")
    parser.add_argument("--fault", nargs="+", metavar="NAME", help="these alone")
    parser.add_argument("--label", choices=("quick", "default"), default="default", help="tests labelled quick, or all but full")
    parser.add_argument("--jobs", type=int, default=1, help="tests side by side")
    parser.add_argument("--resume", type=pathlib.Path, metavar="TABLE", help="go on with this table, which may not be there yet")
    return parser.parse_args()


def main():
    given = arguments()
    try:
        rows = faults()
        if given.list:
            print(listing(rows), end="")
        if given.write:
            write_copy(SRC, given.write, rows)
        if given.run:
            from seeded_fault_runs import run_all
            return run_all(rows, given)
    except WrongRow as wrong:
        print(wrong, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
