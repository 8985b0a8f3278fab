#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of one run: python3 post/page.py DIR [--out FILE] [--field NAME]; one HTML file that needs no other.

Fields with a slider over time, histories with their numbers, summary, messages, deck and command. Exit codes: 0 done, 2 DIR
is not the folder of a run, 4 the page could not be written.
"""
import argparse
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

import command
import tether_results
from run_page import document


def arguments(words):
    parser = argparse.ArgumentParser(description="Makes the HTML page of a run.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the run")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the page (default: DIR/page.html)")
    parser.add_argument("--field", metavar="NAME", help="what colours the fields, in place of what matters most; of a liquid also one colour")
    return parser.parse_args(words)


def page(chosen):
    """Makes the page of a run and yields its path."""
    text = document.page(tether_results.open(chosen.folder), chosen.field)
    return command.save(chosen.out or chosen.folder / "page.html", lambda path: path.write_text(text, encoding="utf-8"))


def main(words=None):
    chosen = arguments(words)
    return command.run("page", lambda: page(chosen))


if __name__ == "__main__":
    sys.exit(main())
