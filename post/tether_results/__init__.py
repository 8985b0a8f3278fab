# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of tether in Python: the files that a run left in its folder, as numpy arrays, and runs made from scripts.

    import tether_results
    run = tether_results.open("out/sod")
    run.summary["error_density"], run.history["time"], run.fields("particles").at(0.1)["pressure"]
    finer = tether_results.run("decks/sod.in", {"in.nx": 201, "mpm.method": "robust"}, out="out/finer")
"""
from .datasets import NotARun, is_numeric, open_dataset
from .fields import Fields
from .box import Box
from .history import History
from .folder import Run, open
from .program import NoProgram, RunFailed, run

__all__ = ["Box", "Fields", "History", "NoProgram", "NotARun", "Run", "RunFailed", "is_numeric", "open", "open_dataset", "run"]
