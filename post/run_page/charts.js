// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of the history: curves over time, a line at one record, and its numbers as history.txt has them.
"use strict";

const OURS = ["#0072B2", "#E69F00", "#009E73", "#56B4E9", "#CC79A7", "#7A5195", "#8C6D31", "#5A5A5A"];
const DASHES = [[], [7, 3], [2, 2], [9, 3, 2, 3], [4, 4], [12, 4], [1, 3], [6, 2, 1, 2]];  // so that ink alone tells them apart
const MARGIN = {left: 78, right: 12, top: 10, bottom: 34};

class History {
  constructor(text, columns) {
    this.columns = columns;
    this.rows = text.trim().split("\n").map(line => line.trim().split(/\s+/));
  }
  cell(record, column) { return this.rows[record][this.columns.indexOf(column)]; }
  curve(column) {
    const k = this.columns.indexOf(column);
    return this.rows.map(row => Number(row[k]));
  }
}

// Round numbers between two others, about as many as asked for.
function ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(part => part * power).find(size => size >= raw * 0.999) || raw;
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

function bounds(curves) {
  let low = Infinity, high = -Infinity;
  curves.forEach(curve => curve.forEach(value => {
    if (!Number.isFinite(value)) return;
    low = Math.min(low, value); high = Math.max(high, value);
  }));
  if (low > high) return [0, 1];
  const margin = 0.05 * (high - low) || 0.05 * Math.abs(high) || 1;
  return [low - margin, high + margin];
}

class Chart {
  constructor(canvas, output, history, panel, picked) {
    Object.assign(this, {canvas, output, history, panel});
    this.time = history.curve("time");
    this.prepare();
    const at = event => {
      const share = (event.offsetX / canvas.clientWidth * canvas.width - MARGIN.left) / (canvas.width - MARGIN.left - MARGIN.right);
      picked(this.nearest(this.left + share * (this.right - this.left)));
    };
    canvas.addEventListener("mousemove", at);
    canvas.addEventListener("click", at);
    canvas.addEventListener("keydown", event => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (step) { picked(Math.min(this.time.length - 1, Math.max(0, (this.record || 0) + step))); event.preventDefault(); }
    });
  }

  prepare() {
    this.curves = this.panel.columns.map(column => {
      const curve = this.history.curve(column);
      return this.panel.change ? curve.map(value => value - curve[0]) : curve;
    });
    [this.left, this.right] = [this.time[0], this.time[this.time.length - 1]];
    if (!(this.right > this.left)) this.right = this.left + 1;
    [this.low, this.high] = bounds([...this.curves, ...this.panel.exact.map(exact => exact.y)]);
  }

  nearest(time) {
    let best = 0;
    this.time.forEach((value, k) => { if (Math.abs(value - time) < Math.abs(this.time[best] - time)) best = k; });
    return best;
  }

  x(time) { return MARGIN.left + (time - this.left) / (this.right - this.left) * (this.canvas.width - MARGIN.left - MARGIN.right); }
  y(value) { return this.canvas.height - MARGIN.bottom - (value - this.low) / (this.high - this.low) * (this.canvas.height - MARGIN.top - MARGIN.bottom); }

  read(record) {
    this.record = record;
    this.draw();
    const names = this.panel.columns.map((column, k) => `${column} = ${this.history.cell(record, column)}`);
    this.output.textContent = [`time = ${this.history.cell(record, "time")}`, ...names].join(", ");
  }

  draw() {
    const context = this.canvas.getContext("2d");
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.drawAxes(context);
    this.curves.forEach((curve, k) => this.drawCurve(context, this.time, curve, OURS[k % OURS.length], DASHES[k % DASHES.length], 1.8));
    this.panel.exact.forEach(exact => this.drawCurve(context, exact.x, exact.y, "#000000", [6, 4], 1.2));
    if (this.record !== undefined) this.drawRecord(context);
  }

  drawAxes(context) {
    context.strokeStyle = "#dddddd"; context.fillStyle = "#333333"; context.lineWidth = 1; context.font = "13px sans-serif";
    context.setLineDash([]);
    const brief = value => String(Number(value.toPrecision(6)));
    context.textAlign = "center"; context.textBaseline = "top";
    ticks(this.left, this.right, 6).forEach(time => {
      this.segment(context, this.x(time), MARGIN.top, this.x(time), this.canvas.height - MARGIN.bottom);
      context.fillText(brief(time), this.x(time), this.canvas.height - MARGIN.bottom + 5);
    });
    context.fillText(this.panel.time, this.canvas.width / 2, this.canvas.height - 14);
    context.textAlign = "right"; context.textBaseline = "middle";
    ticks(this.low, this.high, 5).forEach(value => {
      this.segment(context, MARGIN.left, this.y(value), this.canvas.width - MARGIN.right, this.y(value));
      context.fillText(brief(value), MARGIN.left - 6, this.y(value));
    });
  }

  segment(context, ...ends) {
    context.beginPath(); context.moveTo(ends[0], ends[1]); context.lineTo(ends[2], ends[3]); context.stroke();
  }

  drawCurve(context, times, values, colour, dashes, width) {
    context.strokeStyle = colour; context.lineWidth = width; context.setLineDash(dashes);
    context.beginPath();
    let joined = false;
    times.forEach((time, k) => {
      const fits = Number.isFinite(values[k]) && time >= this.left && time <= this.right;
      if (fits) joined ? context.lineTo(this.x(time), this.y(values[k])) : context.moveTo(this.x(time), this.y(values[k]));
      joined = fits;
    });
    context.stroke();
    context.setLineDash([]);
  }

  drawRecord(context) {
    context.strokeStyle = "#555555"; context.lineWidth = 1;
    const x = this.x(this.time[this.record]);
    this.segment(context, x, MARGIN.top, x, this.canvas.height - MARGIN.bottom);
    this.curves.forEach((curve, k) => {
      context.fillStyle = OURS[k % OURS.length];
      context.beginPath(); context.arc(x, this.y(curve[this.record]), 4, 0, 2 * Math.PI); context.fill();
    });
  }
}
