# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a run as one HTML file: fields, histories, summary, messages and deck, with nothing from anywhere else."""
import html
from pathlib import Path

import numpy

import style
from run_page import encode
from run_page.parts import Maker
from scene import choose

HERE = Path(__file__).parent
MOST_BYTES = 3_000_000  # of all snapshots, and of the history
MOST_SNAPSHOTS, MOST_PICTURES = 200, 50  # in the plane; in space, where each takes a second or two
POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"  # nothing from elsewhere
CHART = 'width="760" height="300" tabindex="0" role="img"'


def escaped(text):
    return html.escape(str(text), quote=True)


def thinned(count, most):
    """Numbers from 0, evenly spaced, of no more than `most`, with the last where the spacing meets it."""
    return list(range(0, count, -(-count // max(most, 1))))


def size_of(frame):
    return sum(len(text) for text in frame.values())


def scene_data(run, name=None):
    """Parts, times and scales of the scene's snapshots, and how many are left out; None without any."""
    scene = choose.scene_of(run, name)
    if scene is None:
        return None
    everything = range(len(scene.times))
    scene.fit([everything[k] for k in thinned(len(everything), 40)])
    maker = Maker(scene)
    parts = maker.parts()
    a_snapshot = max(1, sum(size_of(part.at(everything[-1])) for part in parts))
    records = thinned(len(everything), min(MOST_PICTURES if maker.in_space else MOST_SNAPSHOTS, max(2, MOST_BYTES // a_snapshot)))
    drawn = [{"draw": part.draw, "fixed": part.fixed, "frames": [part.at(record) for record in records]} for part in parts]
    return {"parts": drawn, "times": [float(scene.times[record]) for record in records], "records": records,
            "aspect": scene.aspect, "limits": [float(bound) for bound in scene.limits], "unit": scene.unit,
            "left_out": len(everything) - len(records), "first": len(records) - 1 if choose.is_steady(run) else 0,
            "note": scene.stretched(), "scales": scales_of(scene)}


def scales_of(scene):
    """Labels, ends and colours of the scales."""
    return [{"label": scale.label, "low": float(scale.low), "high": float(scale.high), "colours": encode.colours_of(scale)}
            for scale in scene.scales]


def history_text(run):
    """The rows of history.txt as they stand, thinned where they are many; and the number of rows left out."""
    path = run.folder / "history.txt"
    if path.is_file():
        rows = [line for line in path.read_text().splitlines() if not line.startswith("#")]
        rows = [line for line in rows if len(line.split()) == len(run.history.columns)]  # the last may be half written
    else:
        rows = [" ".join(repr(float(run.history[name][k])) for name in run.history.columns) for k in range(len(run.history))]
    size = sum(len(row) + 1 for row in rows)
    kept = thinned(len(rows), max(2, len(rows) * MOST_BYTES // max(size, MOST_BYTES)))
    return "\n".join(rows[k] for k in kept), len(rows) - len(kept)


def exact_curves(run):
    """Exact columns over time that the history has, too."""
    exact = run.exact_over("time")
    return [{"column": name, "x": exact["time"].tolist(), "y": values.tolist()} for name, values in exact.items()
            if name != "time" and name in run.history and numpy.isfinite(values).all()]


def panel_data(run, panel):
    """A chart's columns, names and exact curves, and whether it shows changes from the start."""
    first, columns = panel.curves[0], [curve.column for curve in panel.curves]
    change = bool(first.values[0] == 0 and run.history[first.column][0] != 0 or panel.label.startswith("change of"))
    exact = [] if change else [curve for curve in exact_curves(run) if curve["column"] in columns]
    return {"title": panel.label if panel.label.startswith(panel.title) else f"{panel.title}: {panel.label}", "columns": columns,
            "names": [curve.label for curve in panel.curves], "change": change, "exact": exact,
            "time": style.label("time", run.history.units["time"])}


def panels_of(run):
    """The charts of the run's kind; those of relative changes have numbers that history.txt has not, and are left out."""
    panels = [panel for source in choose.kind_of(run).histories for panel in source(run) if panel is not None]
    return [panel_data(run, panel) for panel in panels if not panel.label.endswith("[%]")]


def scale_html(number, scale):
    """A bar of colours with its ends."""
    return (f'<div class="scale"><canvas id="scale-{number}" width="256" height="14"></canvas><div class="ends">'
            f'<span>{scale["low"]:.4g}</span><span>{escaped(scale["label"])}</span><span>{scale["high"]:.4g}</span></div></div>')


def fields_html(scene):
    """Canvas, slider and scales, and what a reader must know of them."""
    unit = "" if scene["unit"] == "1" else f" {escaped(scene['unit'])}"
    count, notes = len(scene["times"]), [escaped(scene["note"])]
    if scene["left_out"]:
        notes.append(f"Of {count + scene['left_out']} snapshots {count} are on this page, so that it stays small.")
    scales = "".join(scale_html(number, scale) for number, scale in enumerate(scene["scales"]))
    return (f'<div class="controls"><button id="play" type="button">play</button>'
            f'<label for="slider">time <span id="snapshot"></span>{unit}</label>'
            f'<input id="slider" type="range" min="0" max="{count - 1}" value="0"></div>'
            f'<canvas id="fields" role="img" aria-label="the scene at this time"></canvas><div class="scales">{scales}</div>'
            f'<p class="note">{" ".join(note for note in notes if note)}</p>')


def key_html(panel):
    """Which colour is whose."""
    entries = [f'<span style="background:{style.OURS[k % len(style.OURS)]}"></span>{escaped(name)}'
               for k, name in enumerate(panel["names"])]
    if panel["exact"]:
        entries.append('<span style="border-top:2px dashed #000;height:0"></span>exact')
    return f'<div class="key">{"".join(entries)}</div>'


def chart_html(number, panel):
    """A chart of a panel's curves."""
    title = escaped(panel["title"])
    return (f'<figure><figcaption>{title}</figcaption><canvas id="chart-{number}" {CHART} aria-label="{title}"></canvas>'
            f'{key_html(panel)}<output id="reading-{number}"></output></figure>')


def choice_html(run, first):
    """A chart of a column that the reader chooses."""
    options = "".join(f'<option value="{escaped(name)}"{" selected" if name == first else ""}>'
                      f'{escaped(style.label(name, run.history.units[name]))}: {escaped(run.history.meanings[name])}</option>'
                      for name in run.history.columns)
    return (f'<figure><figcaption><label>any column <select id="column">{options}</select></label></figcaption>'
            f'<canvas id="chosen-chart" {CHART} aria-label="the chosen column"></canvas><output id="reading"></output></figure>')


def charts_html(run, panels, left_out):
    """A chart for each panel, and one for a column that the reader chooses."""
    first = panels[0]["columns"][0] if panels else run.history.columns[-1]
    thin = f'<p class="note">{left_out} records are left out, so that the page stays small.</p>' if left_out else ""
    charts = "".join(chart_html(number, panel) for number, panel in enumerate(panels))
    return (f'{thin}<div class="charts">{charts}</div>{choice_html(run, first)}<p class="note">Numbers under a chart are those of '
            'history.txt at the line; move over a chart, or use the arrow keys on it.</p>')


def texts_html(run):
    """Summary, messages, deck, command and version."""
    rows = "".join(f"<tr><th>{escaped(key)}</th><td>{escaped(value if isinstance(value, str) else f'{value:.10g}')}</td></tr>"
                   for key, value in run.summary.items())
    summary = f"<table>{rows}</table>" if rows else "<p>The run has no summary: it goes on, or was stopped.</p>"
    return (f"<h2>Summary</h2>{summary}<h2>Messages</h2><pre>{escaped(run.messages) or 'none'}</pre>"
            f"<h2>Deck</h2><pre>{escaped(run.title)}</pre><details><summary>All values that the run used</summary>"
            f"<pre>{escaped(run.deck)}</pre></details><h2>Command</h2>"
            f"<pre>{escaped(run.command)}</pre><p>{escaped(run.version)}</p>")


def page_data(run, scene, panels, text):
    """What the scripts draw from, as JSON."""
    chosen = {"change": False, "time": style.label("time", run.history.units["time"]), "exact": []}
    return encode.json_in_html({"scene": scene, "panels": panels, "exact": exact_curves(run), "chosen": chosen,
                                "history": {"columns": run.history.columns, "text": text}})


def page(run, name=None):
    """The whole page as text."""
    scene, panels = scene_data(run, name), panels_of(run)
    text, left_out = history_text(run)
    fields = fields_html(scene) if scene else f"<p>The run wrote no snapshots: {escaped(choose.kind_of(run).switch)}.</p>"
    scripts = "\n".join((HERE / name).read_text(encoding="utf-8") for name in ("fields.js", "charts.js", "page.js"))
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{escaped(run.name)}</title>
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<style>{(HERE / "page.css").read_text(encoding="utf-8")}</style></head><body>
<h1>{escaped(choose.title_of(run))}</h1>
<h2>Fields</h2>{fields}
<h2>Histories</h2>{charts_html(run, panels, left_out)}
{texts_html(run)}
<script type="application/json" id="data">{page_data(run, scene, panels, text)}</script>
<script>{scripts}</script>
</body></html>
"""
