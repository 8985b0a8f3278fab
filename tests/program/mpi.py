# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands under mpirun: one program that deals out runs, two that do them; and their processes."""
import os
import pathlib
import subprocess

from program import TETHER
from waiting import PATIENCE, entry

MPIRUN = ["mpirun", "--oversubscribe", "--bind-to", "none"]
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                            "TETHER_TESTED_BY": str(os.getpid())}
OURS = f"TETHER_TESTED_BY={os.getpid()}".encode()  # the setting by which ranks of these commands are known
PROGRAMS = 3


def run(*words, options=(), program=TETHER, folder=None):
    """A command of three programs, to its end."""
    command = [*MPIRUN, *options, "-n", str(PROGRAMS), program, *map(str, words)]
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          timeout=PATIENCE)


def start(*words, options=()):
    command = [*MPIRUN, *options, "-n", str(PROGRAMS), TETHER, *map(str, words)]
    return subprocess.Popen(command, env=ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, text=True)


def parent(pid):
    """None once the process is gone."""
    stat = entry(pid, "stat")
    return int(stat.rsplit(b")", 1)[1].split()[1]) if stat else None


def carriers():
    """The process of each rank of these commands, which carries letters, by rank."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        settings = entry(folder.name, "environ").split(b"\0")
        if entry(folder.name, "comm").strip() != b"tether-mpi" or OURS not in settings:
            continue
        for setting in settings:
            if setting.startswith(b"OMPI_COMM_WORLD_RANK="):
                found[int(setting.split(b"=")[1])] = int(folder.name)
    return found


def served_by(carrier):
    """The program of tether that a rank's process serves; or a child of any other process."""
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        if parent(folder.name) == carrier:
            return int(folder.name)
    return None
