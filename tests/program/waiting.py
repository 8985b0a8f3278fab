# SPDX-License-Identifier: GPL-3.0-or-later
"""Waits for what is to be seen of programs that run: tests neither sleep nor look at a clock anywhere else."""
import os
import pathlib
import time

SLOWER = float(os.environ.get("TETHER_SLOWER", "1"))  # than a release build, as sanitizers make it
PATIENCE = 600 * SLOWER  # seconds after which a program counts as hanging: many times what it takes on a busy machine
SHORTEST, LONGEST = 0.002, 0.1  # seconds between two looks
LATE = 0.05  # part of the wait by which what is awaited may be seen too late


def wait_until(condition, what, *processes, patience=PATIENCE):
    """The first value of condition() that is true. `what` names it in the sentence that is said where it does not come
    to be seen, or where one of the `processes` ends before: with its exit code and what it wrote to its standard error."""
    begin = time.monotonic()
    while True:
        ended = next((process for process in processes if process.poll() is not None), None)
        value = condition()  # after the look at the processes: the last thing that one does may be what is awaited
        if value:
            return value
        if ended:
            raise AssertionError(f"{what} was not seen before process {ended.pid} ended with exit code {ended.returncode}: "
                                 f"{' '.join(map(str, ended.args))}\n{said(ended)}")
        waited = time.monotonic() - begin
        if waited > patience:
            raise AssertionError(f"{what} was not seen within {patience:g} seconds")
        time.sleep(min(max(SHORTEST, LATE * waited), LONGEST))


def entry(pid, name):
    """What /proc has of a process; nothing once it is gone."""
    try:
        return pathlib.Path(f"/proc/{pid}/{name}").read_bytes()
    except OSError:
        return b""


def said(process):
    """What waits in the pipe of a process' standard error, which children that outlive it may hold open."""
    if process.stderr is None:
        return ""
    os.set_blocking(process.stderr.fileno(), False)
    try:
        return os.read(process.stderr.fileno(), 1 << 20).decode("utf-8", "replace")
    except BlockingIOError:
        return ""
