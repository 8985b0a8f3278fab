# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tests catch which seeded fault: a table with a line a fault, written as it is found, so that it can be gone on with.

A fault is caught by a test that fails with it and passes without it. The tests of the fault's own room come first, then those
that its row names as likely, and all others, each time the cheapest first; what they take is what ctest noted when they ran
last. A fault that nothing catches takes a whole run."""
import json
import os
import re
import resource
import subprocess
import sys

COLUMNS = ("fault", "room", "kind", "result", "test", "cpu_seconds")
BATCH = 20  # seconds of tests that one ctest runs
PATIENCE = 120, 30  # seconds, and times what a test took: a fault may keep a program from ending


class Build:
    """The tests of a build folder, and ctest over some of them."""

    def __init__(self, folder, label, jobs):
        self.folder, self.jobs = folder, jobs
        cache = folder / "CMakeCache.txt"
        if not cache.exists() or "TETHER_FAULTS:BOOL=ON" not in cache.read_text():
            sys.exit(f"{folder} is no build with faults: cmake --preset faults makes one")
        shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=folder, capture_output=True, text=True, check=True)
        self.tests = {}  # name to number
        for number, test in enumerate(json.loads(shown.stdout)["tests"], 1):
            labels = next((of["value"] for of in test["properties"] if of["name"] == "LABELS"), [])
            if "quick" in labels if label == "quick" else "full" not in labels:
                self.tests[test["name"]] = number
        if not self.tests:
            sys.exit(f"{folder} has no test of the label {label}")

    def costs(self):
        """Seconds of each test, as ctest noted them."""
        noted = self.folder / "Testing" / "Temporary" / "CTestCostData.txt"
        lines = noted.read_text().split("---")[0].splitlines() if noted.exists() else []
        return {name: float(cost) for name, _, cost in (line.rsplit(maxsplit=2) for line in lines)}

    def failing(self, tests, fault, *options, patience=1500):
        """The tests that fail with this fault, with none without one."""
        environment = {name: value for name, value in os.environ.items() if name != "TETHER_FAULT"}
        if fault:
            environment["TETHER_FAULT"] = fault
        numbers = ",".join(str(self.tests[name]) for name in tests)
        command = ["ctest", "-I", f"0,0,0,{numbers}", "-j", str(self.jobs), "--timeout", str(round(patience)), *options]
        nowhere = subprocess.DEVNULL
        if subprocess.run(command, cwd=self.folder, env=environment, stdout=nowhere, stderr=nowhere).returncode == 0:
            return []
        failed = (self.folder / "Testing" / "Temporary" / "LastTestsFailed.log").read_text().splitlines()
        return [name for name in (line.split(":", 1)[1] for line in failed) if name in tests]


def in_order(tests, costs, fault):
    """Those of the room's program, those that are likely, all others; the cheapest first."""
    program = "program." if fault.room == "commands" else f"unit.{fault.room.split('/')[0]}"
    likely = re.compile(fault.likely or "$^", re.I)
    return sorted(tests, key=lambda name: (not name.startswith(program), not likely.search(name), costs.get(name, 0)))


def batches(tests, costs):
    """Tests that one ctest runs: in the order given, until they take BATCH seconds."""
    batch, seconds = [], 0.0
    for name in tests:
        batch.append(name)
        seconds += costs.get(name, 0)
        if seconds >= BATCH:
            yield batch
            batch, seconds = [], 0.0
    if batch:
        yield batch


def first_to_catch(build, fault):
    """The name of the first test that fails with the fault and passes without it, or None."""
    costs = build.costs()
    for batch in batches(in_order(build.tests, costs, fault), costs):
        patience = PATIENCE[0] + PATIENCE[1] * max(costs.get(name, 0) for name in batch)
        left = batch
        while failed := build.failing(left, fault.name, "--stop-on-failure", patience=patience):
            red = build.failing(failed, None)
            if caught := [name for name in failed if name not in red]:
                return caught[0]
            left = [name for name in left if name not in red]
            if not left:
                break
    return None


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def rows_of(table):
    """The rows that a table has, by the names of the faults."""
    lines = table.read_text().splitlines()[1:] if table.exists() else []
    return {line.split("\t")[0]: line.split("\t") for line in lines}


def add_row(table, *cells):
    with table.open("a") as file:
        print(*cells, sep="\t", file=file, flush=True)
    print(*cells, sep="  ", flush=True)


def look_without_fault(build, table):
    """Returns whether all tests pass where no fault is chosen; that run notes what each takes, too."""
    before = cpu_seconds()
    failed = build.failing(list(build.tests), None)
    if failed:
        print(f"{len(failed)} of {len(build.tests)} tests fail without a fault, too: {', '.join(failed)}", file=sys.stderr)
        return False
    add_row(table, "none", "", "", "green", f"{len(build.tests)} tests", f"{cpu_seconds() - before:.0f}")
    return True


def chosen_faults(faults, names):
    unknown = set(names or ()) - {fault.name for fault in faults}
    if unknown:
        sys.exit(f"no seeded fault is called {', '.join(sorted(unknown))}: --list has their names")
    return [fault for fault in faults if not names or fault.name in names]


def run_all(faults, given):
    """Writes the table of the faults that the command names, all without any. Returns the exit code."""
    wanted = chosen_faults(faults, given.fault)
    build = Build(given.run.resolve(), given.label, given.jobs)
    table = given.resume or build.folder / "seeded_faults.tsv"
    if not given.resume or not table.exists():
        table.write_text("\t".join(COLUMNS) + "\n")
    done = rows_of(table)
    try:
        if "none" not in done and not look_without_fault(build, table):
            return 1
        for fault in wanted:
            if fault.name in done:
                continue
            before = cpu_seconds()
            test = first_to_catch(build, fault)
            result = "caught" if test else "not caught"
            add_row(table, fault.name, fault.room, fault.kind, result, test or "", f"{cpu_seconds() - before:.0f}")
    except KeyboardInterrupt:
        print(f"stopped; --resume {table} goes on", file=sys.stderr)
        return 130
    rows = rows_of(table)
    caught = sum(rows[fault.name][3] == "caught" for fault in wanted)
    print(f"{caught} of {len(wanted)} faults are caught; {table} says by what")
    return 0
