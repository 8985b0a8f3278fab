// SPDX-License-Identifier: GPL-3.0-or-later
// Joins slider, canvas and charts. #record=3&column=point_y_1&at=10 sets them: snapshot, column of the chosen chart, record.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const element = name => document.getElementById(name);

function showFields() {
  const view = new FieldView(element("fields"), data.scene), slider = element("slider");
  data.scene.scales.forEach((scale, k) => drawBar(element(`scale-${k}`), scale.colours));
  const show = number => {
    slider.value = number;
    view.show(number);
    element("snapshot").textContent = String(Number(data.scene.times[number].toPrecision(6)));
    element("snapshot").dataset.time = data.scene.times[number];
  };
  slider.addEventListener("input", () => show(Number(slider.value)));
  let timer = null;
  element("play").addEventListener("click", () => {
    if (timer) { clearInterval(timer); timer = null; element("play").textContent = "play"; return; }
    element("play").textContent = "stop";
    timer = setInterval(() => show((Number(slider.value) + 1) % data.scene.times.length), Math.max(66, 6000 / data.scene.times.length));
  });
  return show;
}

function showCharts() {
  const history = new History(data.history.text, data.history.columns), charts = [];
  const pick = record => charts.forEach(chart => chart.read(record));
  data.panels.forEach((panel, k) => charts.push(new Chart(element(`chart-${k}`), element(`reading-${k}`), history, panel, pick)));
  const chosen = new Chart(element("chosen-chart"), element("reading"), history, {...data.chosen, columns: [element("column").value]}, pick);
  charts.push(chosen);
  const choose = column => {
    if (!data.history.columns.includes(column)) return;
    element("column").value = column;
    chosen.panel = {...data.chosen, columns: [column], exact: data.exact.filter(exact => exact.column === column)};
    chosen.prepare();
    chosen.read(chosen.record);
  };
  element("column").addEventListener("change", () => choose(element("column").value));
  pick(history.rows.length - 1);
  return {pick: record => pick(Math.min(history.rows.length - 1, Math.max(0, record))), choose};
}

function setFromAddress(show, charts) {
  const words = new URLSearchParams(location.hash.slice(1));
  const number = name => words.has(name) && /^\d+$/.test(words.get(name)) ? Number(words.get(name)) : null;
  if (show) show(Math.min(data.scene.times.length - 1, number("record") ?? data.scene.first));
  if (words.has("column")) charts.choose(words.get("column"));
  if (number("at") !== null) charts.pick(number("at"));
}

const show = data.scene ? showFields() : null, charts = showCharts();
setFromAddress(show, charts);
window.addEventListener("hashchange", () => setFromAddress(show, charts));
