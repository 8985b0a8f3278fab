# SPDX-License-Identifier: GPL-3.0-or-later
"""The runs that figures are drawn from, made when they are asked for."""
import hashlib
import sys

import tether_results
from tether_results.program import NoProgram, RunFailed, call


class Runs:
    def __init__(self, program, decks, folder, levels=2):
        """`program` runs the decks of one folder (their particle files are in ../particles) into another. Figures of
        several meshes, some of which take long, are drawn with that many of `levels`, from the coarsest."""
        self.program, self.decks, self.folder, self.levels = program, decks, folder, levels

    def of(self, deck, *settings):
        """The finished run of decks/<deck>.in with these `group.name=value`, and options such as `--path=fem`."""
        folder = self.folder / self._name(deck, settings)
        if not self._is_fresh(folder / "summary.txt", self.decks / f"{deck}.in"):
            self._make(self.decks / f"{deck}.in", settings, folder)
        return tether_results.open(folder)

    @staticmethod
    def _name(deck, settings):
        """As long as deck and settings are the same, so is the folder."""
        if not settings:
            return deck
        return f"{deck}-{hashlib.sha256(' '.join(settings).encode()).hexdigest()[:8]}"

    def _is_fresh(self, result, deck):
        """Whether a run ended after the last change of all that it is made from."""
        if not self.program.is_file():
            raise NoProgram(f"{self.program}: is not there; ./quickstart build makes it")
        sources = [self.program, deck, *(self.decks.parent / "particles").glob("*.par")]
        made = result.stat().st_mtime if result.is_file() else 0
        return made > max(path.stat().st_mtime for path in sources)

    def _make(self, deck, settings, folder):
        words = [word for setting in settings for word in ([setting] if setting.startswith("--") else ["--set", setting])]
        print(f"running {' '.join([deck.stem, *settings])}", file=sys.stderr, flush=True)
        call(self.program, deck, words, folder)
