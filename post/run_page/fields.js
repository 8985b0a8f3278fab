// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a snapshot of the scene on its canvas, from places and shades that are whole numbers in base64.
"use strict";

const STEPS = 65534, NOWHERE = 65535, NOTHING = 255;
const FINEST = 3, SMALL_AREA = 12, ONE_SHADE = 6;  // halvings of a triangle, pixels of one that is not halved, shades that look alike

function bytesOf(text) {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; k++) bytes[k] = raw.charCodeAt(k);
  return bytes.buffer;
}

const unpacked = new Map();  // what was decoded once is kept
function unpack(text, Type) {
  if (!unpacked.has(text)) unpacked.set(text, new Type(bytesOf(text)));
  return unpacked.get(text);
}

class FieldView {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.scene = scene;
    this.context = canvas.getContext("2d");
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const width = Math.min(1000, Math.max(320, 620 * scene.aspect));
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(width / scene.aspect * ratio);
    canvas.style.maxWidth = width + "px";
    this.luts = scene.scales.map(scale => unpack(scale.colours, Uint8Array));
  }

  colour(scale, shade) {
    const lut = this.luts[scale];
    return `rgb(${lut[3 * shade]},${lut[3 * shade + 1]},${lut[3 * shade + 2]})`;
  }

  // Places as pixels; null for what is nowhere.
  pixels(text) {
    const whole = unpack(text, Uint16Array), found = new Float32Array(whole.length);
    for (let k = 0; k < whole.length; k += 2) {
      const lost = whole[k] === NOWHERE || whole[k + 1] === NOWHERE;
      found[k] = lost ? NaN : whole[k] / STEPS * this.canvas.width;
      found[k + 1] = lost ? NaN : (1 - whole[k + 1] / STEPS) * this.canvas.height;
    }
    return found;
  }

  show(number) {
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.context.fillStyle = "#ffffff";
    this.context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.number = number;
    let shapes = 0;
    this.scene.parts.forEach(part => { shapes += this[part.draw]({...part.fixed, ...part.frames[number]}); });
    this.canvas.dataset.shapes = shapes;
    this.canvas.dataset.record = this.scene.records[number];
  }

  cells(part) {
    const image = new ImageData(part.nx, part.ny), shades = unpack(part.v, Uint8Array), stones = unpack(part.o, Uint8Array);
    const lut = this.luts[part.scale];
    for (let row = 0; row < part.ny; row++) for (let column = 0; column < part.nx; column++) {
      const from = row * part.nx + column, to = 4 * ((part.ny - 1 - row) * part.nx + column);
      const shade = shades[from];
      const rgb = stones[from] ? [153, 166, 178] : shade === NOTHING ? null : lut.subarray(3 * shade, 3 * shade + 3);
      if (rgb) image.data.set([rgb[0], rgb[1], rgb[2], 255], to);
    }
    const small = document.createElement("canvas");
    small.width = part.nx; small.height = part.ny;
    small.getContext("2d").putImageData(image, 0, 0);
    const [left, bottom, right, top] = this.pixels(part.xy);
    this.context.imageSmoothingEnabled = false;
    this.context.drawImage(small, left, top, right - left, bottom - top);
    return part.nx * part.ny;
  }

  triangles(part) {
    const places = this.pixels(part.xy), nodes = unpack(part.t, Uint32Array), context = this.context;
    const shades = part.v ? unpack(part.v, Uint8Array) : null;
    context.lineWidth = 0.7;
    for (let k = 0; k < nodes.length; k += 3) {
      const [a, b, c] = [nodes[k], nodes[k + 1], nodes[k + 2]];
      if (shades && (shades[a] === NOTHING || shades[b] === NOTHING || shades[c] === NOTHING)) continue;
      const corners = [a, b, c].map(node => [places[2 * node], places[2 * node + 1], shades ? shades[node] : 0]);
      this.triangle(corners, shade => shades ? this.colour(part.scale, shade) : part.colour, shades ? FINEST : 0);
    }
    return nodes.length / 3;
  }

  // In one colour, or in four parts where its corners differ and it is large enough to show it.
  triangle(corners, colour, halvings) {
    const shades = corners.map(corner => corner[2]), [[ax, ay], [bx, by], [cx, cy]] = corners;
    const area = Math.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
    if (halvings > 0 && area > SMALL_AREA && Math.max(...shades) - Math.min(...shades) > ONE_SHADE) {
      const middle = (one, other) => one.map((value, k) => (value + other[k]) / 2);
      const [a, b, c] = corners, ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const part of [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]) this.triangle(part, colour, halvings - 1);
      return;
    }
    const context = this.context;
    context.fillStyle = context.strokeStyle = colour(Math.round((shades[0] + shades[1] + shades[2]) / 3));
    context.beginPath();
    context.moveTo(ax, ay);
    context.lineTo(bx, by);
    context.lineTo(cx, cy);
    context.closePath();
    context.fill();
    context.stroke();  // else light comes through between neighbours
  }

  // A whole picture, which is there a moment later; a newer snapshot may have come by then.
  image(part) {
    const picture = new Image(), record = this.number, [left, bottom, right, top] = this.pixels(part.xy);
    picture.onload = () => {
      if (this.number === record) this.context.drawImage(picture, left, top, right - left, bottom - top);
    };
    picture.src = "data:image/jpeg;base64," + part.jpeg;
    return 1;
  }

  points(part) {
    const places = this.pixels(part.xy), shades = unpack(part.v, Uint8Array), context = this.context;
    const [left, right] = this.scene.limits;
    const side = Math.min(12, Math.max(1.5, part.side / (right - left) * this.canvas.width));
    for (let k = 0; k < shades.length; k++) {
      if (isNaN(places[2 * k]) || part.scale >= 0 && shades[k] === NOTHING) continue;
      context.fillStyle = part.scale < 0 ? "#0072B2" : this.colour(part.scale, shades[k]);
      context.fillRect(places[2 * k] - side / 2, places[2 * k + 1] - side / 2, side, side);
    }
    return shades.length;
  }

  lines(part) {
    const places = this.pixels(part.xy), counts = unpack(part.n, Uint32Array), context = this.context;
    context.strokeStyle = part.colour;
    context.lineWidth = part.width;
    let at = 0;
    counts.forEach(count => {
      context.beginPath();
      for (let k = at; k < at + count; k++) context.lineTo(places[2 * k], places[2 * k + 1]);
      context.stroke();
      at += count;
    });
    return counts.length;
  }

  edges(part) {
    const places = this.pixels(part.xy), nodes = unpack(part.e, Uint32Array), context = this.context;
    context.strokeStyle = part.colour;
    context.lineWidth = 1;
    context.beginPath();
    for (let k = 0; k < nodes.length; k += 2) {
      context.moveTo(places[2 * nodes[k]], places[2 * nodes[k] + 1]);
      context.lineTo(places[2 * nodes[k + 1]], places[2 * nodes[k + 1] + 1]);
    }
    context.stroke();
    return nodes.length / 2;
  }
}

// A bar of a scale's colours, with its least, middle and largest number.
function drawBar(canvas, colours) {
  const lut = unpack(colours, Uint8Array), context = canvas.getContext("2d"), count = lut.length / 3;
  for (let k = 0; k < count; k++) {
    context.fillStyle = `rgb(${lut[3 * k]},${lut[3 * k + 1]},${lut[3 * k + 2]})`;
    context.fillRect(k / count * canvas.width, 0, canvas.width / count + 1, canvas.height);
  }
}
