# SPDX-License-Identifier: GPL-3.0-or-later
"""What a terminal sees while the program runs, and what a log keeps of it."""
import fcntl
import os
import pty
import re
import struct
import subprocess
import termios
import unittest

from program import DECKS, TETHER, ProgramTest
from waiting import PATIENCE

SOD = DECKS / "sod.in"


class Terminal(ProgramTest):
    def seen(self, columns, *words, enough=None, code=0):
        """What a terminal of so many columns is sent while the program runs, which a signal stops after `enough`."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        process = subprocess.Popen([TETHER, *map(str, words)], stdout=slave, stderr=slave, cwd=self.folder)
        os.close(slave)
        text = b""
        while True:
            try:
                text += os.read(master, 4096)
            except OSError:  # the other end is closed
                break
            if enough and enough in text:
                process.terminate()
                enough = None
        os.close(master)
        self.assertEqual(process.wait(timeout=PATIENCE), code, text)
        return text.decode()

    def test_the_progress_line_fits_into_the_terminal(self):
        for columns in (30, 60, 120):
            text = self.seen(columns, DECKS / "pendulum-40.in", "--set", "in.tmax=1000", "--out", self.folder / str(columns),
                             enough=b"\033[K", code=143)
            lines = [line for line in re.split(r"\r|\n", text) if line.startswith("\033[K") and ": t " in line]
            self.assertGreater(len(lines), 0)
            self.assertLess(max(len(line.removeprefix("\033[K")) for line in lines), columns)

    def test_a_listing_has_colours_on_a_terminal(self):
        self.assertIn("\033[1m  tmax", self.seen(80, "check", SOD))

    def test_a_log_has_all_that_is_said(self):
        log = self.folder / "log.txt"
        quiet = self.expect(0, SOD, "--set", "in.tstep=1.", "--quiet", "--log", log, "--out", self.folder / "out")
        self.assertEqual(quiet.stdout + quiet.stderr, "")
        self.assertIn("warning: tstep = 1 is above dtmax", log.read_text())
        self.assertIn("1430 steps", log.read_text())
        failed = self.expect(2, SOD, "--set", "in.nx=0", "--log", log)
        self.assertEqual(log.read_text(), failed.stderr)
        self.expect(4, SOD, "--log", self.folder / "none" / "log.txt", "--out", self.folder / "never")
        self.assertFalse((self.folder / "never").exists())


if __name__ == "__main__":
    unittest.main()
