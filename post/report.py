#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts and maps as one HTML page that needs no other file: python3 post/report.py DIR [DIR...], folders of tether chart
and tether map. Figures as SVG, what was found, the numbers, the study decks, commands, version and machine.

Exit codes: 0 done, 2 a folder has neither, 4 the page could not be written.
"""
import argparse
import base64
import csv
import html
import io
import os
import platform
import sys
from pathlib import Path

import needed  # noqa: F401: ends a command whose packages are missing
import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot

import chart
import command
import map as stability_map
import tether_results
import style

STYLE = """body{font:15px/1.45 sans-serif;max-width:76em;margin:2em auto;padding:0 1em;color:#111;background:#fff}
img{max-width:100%}pre{background:#f5f5f5;padding:.8em;overflow-x:auto;font-size:12.5px}
table{border-collapse:collapse;font-size:12.5px}td,th{border:1px solid #ccc;padding:.15em .5em;text-align:right}
.numbers{overflow-x:auto;max-height:30em}h2{margin-top:2.2em;border-top:1px solid #999;padding-top:.7em}
@media print{.numbers{max-height:none}h2{break-before:page}}"""


def drawn(path, draw):
    """The figure as an image that stands in the page itself."""
    text = io.BytesIO()
    try:
        figure = draw()
    except command.Refused as reason:
        return f"<p>{html.escape(str(reason))}</p>"  # the report and the numbers are there all the same
    figure.savefig(text, format="svg")
    pyplot.close(figure)
    return f'<img alt="{html.escape(str(path.parent.name))}" src="data:image/svg+xml;base64,{base64.b64encode(text.getvalue()).decode()}">'


def rows_of(path):
    """A table of the folder, its first line as heads."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    cells = lambda row, tag: "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row)
    lines = [f"<tr>{cells(rows[0], 'th')}</tr>"] + [f"<tr>{cells(row, 'td')}</tr>" for row in rows[1:]]
    return f'<div class="numbers"><table>{"".join(lines)}</table></div>'


def folded(name, inside):
    return f"<details><summary>{html.escape(name)}</summary>{inside}</details>"


def section(folder, link):
    """What a folder of a chart or a map has to show."""
    kind = next((kind for kind in ("chart", "map") if (folder / f"{kind}.nc").is_file()), None)
    if kind is None:
        raise command.Refused(f"{folder} has no chart.nc and no map.nc: give a folder of tether chart or tether map")
    path = folder / f"{kind}.nc"
    figure = (lambda: chart.draw(chart.read(path))) if kind == "chart" else (lambda: stability_map.draw(*stability_map.read(path)))
    with tether_results.open_dataset(path) as data:
        title, typed, deck = data.title, data.history, data.deck
        version = f"{data.program}, {data.git_hash}"
    parts = [f"<h2 id=\"{link}\">{html.escape(folder.resolve().name)} ({kind})</h2>", f"<p>{html.escape(title)}</p>", drawn(path, figure)]
    report = folder / f"{kind}.txt"
    if report.is_file():
        parts.append(f"<pre>{html.escape(report.read_text(encoding='utf-8'))}</pre>")
    parts += [folded("Numbers", rows_of(folder / f"{kind}.csv")), folded("Study deck", f"<pre>{html.escape(deck)}</pre>"),
              f"<p>Command: <code>{html.escape(typed)}</code><br>Program: {html.escape(version)}</p>"]
    return "\n".join(parts)


def machine():
    """Processor, cores and system, as far as they can be known."""
    names = [line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")] if os.path.exists("/proc/cpuinfo") else []
    return f"{names[0] if names else platform.processor()}, {os.cpu_count()} cores, {platform.system()} {platform.release()}"


def page(folders):
    style.use()
    sections = [section(folder, f"study-{number}") for number, folder in enumerate(folders)]
    links = " · ".join(f'<a href="#study-{number}">{html.escape(folder.resolve().name)}</a>' for number, folder in enumerate(folders))
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>tether: charts and maps</title><style>{STYLE}</style></head><body>
<h1>Charts and maps</h1><p>{links}</p>
<p>The page was made on: {html.escape(machine())}</p>
{"".join(sections)}
</body></html>
"""


def page_of(folders):
    """The page. Raises Refused where a folder cannot be read."""
    try:
        return page(folders)
    except OSError as reason:
        raise command.Refused(reason) from reason


def save(chosen):
    text = page_of(chosen.folders)
    return command.save(chosen.out, lambda path: path.write_text(text, encoding="utf-8"))


def main(words=None):
    parser = argparse.ArgumentParser(description="Makes one HTML page of charts and maps.")
    parser.add_argument("folders", type=Path, nargs="+", metavar="DIR", help="folder of a chart or of a map")
    parser.add_argument("--out", type=Path, default=Path("out/report.html"), metavar="FILE.html", help="the page (default: out/report.html)")
    chosen = parser.parse_args(words)
    return command.run("report", lambda: save(chosen))


if __name__ == "__main__":
    sys.exit(main())
