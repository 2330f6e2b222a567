// Functions that every picture of the page uses: rotations, the camera, sizes, colours and lines.

/** Rotation x = Φ X Φ⁻¹ as a function from body to fixed coordinates; the third body axis is the top's axis. */
function rotation({ alpha: [a, b], beta: [c, d], u }) {
  // α², β², αβ and α times β conjugate
  const [aa, bb] = [[a * a - b * b, 2 * a * b], [c * c - d * d, 2 * c * d]];
  const [product, mixed] = [[a * c - b * d, a * d + b * c], [a * c + b * d, b * c - a * d]];
  const first = [aa[0] - bb[0], aa[1] - bb[1], 2 * mixed[0]];
  const second = [-aa[1] - bb[1], aa[0] + bb[0], -2 * mixed[1]];
  const axis = [-2 * product[0], -2 * product[1], u];
  const turned = (x, y, z, i) => x * first[i] + y * second[i] + z * axis[i];
  const rotate = ([x, y, z]) => [turned(x, y, z, 0), turned(x, y, z, 1), turned(x, y, z, 2)];
  return Object.assign(rotate, { axis });
}

const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
const sum = (x, y, k = 1) => [x[0] + k * y[0], x[1] + k * y[1], x[2] + k * y[2]];
const unit = (x) => x.map((coordinate) => coordinate / Math.hypot(...x));

/** Perspective view of `target` from an azimuth and an elevation, in which a sphere of radius `reach` about `target` fits the picture. */
class Camera {
  constructor({ azimuth, elevation }, target, reach, [width, height]) {
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    this.back = [ce * ca, ce * sa, se];
    this.right = [-sa, ca, 0];
    this.up = [-se * ca, -se * sa, ce];
    this.distance = 4.2 * reach;
    this.position = sum(target, this.back, this.distance);
    this.middle = [width / 2, height / 2];
    this.focus = (Math.min(width, height) / 2) * Math.sqrt(4.2 ** 2 - 1);
  }

  /** Position on the picture in pixels, and distance from the camera along the line of sight. */
  project(point) {
    const p = sum(point, this.position, -1);
    const depth = -dot(p, this.back);
    const scale = this.focus / depth;
    return [this.middle[0] + scale * dot(p, this.right), this.middle[1] - scale * dot(p, this.up), depth];
  }

  /** Number of pixels of a unit of length at a point. */
  scaleAt(point) {
    return this.focus / -dot(sum(point, this.position, -1), this.back);
  }
}

/** Colours of the style sheet, for the light or the dark appearance. */
function palette() {
  const style = getComputedStyle(document.documentElement);
  const names = "card ground rim grid bound tip axis ink faint sphere stand shine pin ghost".split(" ");
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** Number of CSS pixels of a unit of the pictures, which scale with the font size of the page. */
const unitOf = () => parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;

/** Width and height of a canvas in units of the pictures, and that unit. */
function measured(canvas) {
  const unit = unitOf();
  return { size: [canvas.clientWidth, canvas.clientHeight].map((length) => length / unit), unit };
}

/** Sizes of the canvases at their last layout; a query for each picture would cause a layout of the page for each picture. */
const sizes = new WeakMap();

const sizeOf = (canvas) => (sizes.get(canvas) ?? measured(canvas)).size;

/** Measures the canvases after each layout, and has them drawn. */
function listenToSizes(canvases, redraw) {
  const observer = new ResizeObserver((entries) => {
    for (const { target } of entries) sizes.set(target, measured(target));
    redraw();
  });
  for (const canvas of canvases) observer.observe(canvas);
}

/** Clears a canvas at the resolution of the screen, and returns its drawing context and its size. */
function sheet(canvas, ground) {
  const { size, unit } = sizes.get(canvas) ?? measured(canvas);
  const ratio = (window.devicePixelRatio || 1) * unit;
  const [width, height] = size.map((length) => Math.max(1, Math.round(length * ratio)));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.fillStyle = ground;
  pen.fillRect(0, 0, ...size);
  pen.lineJoin = pen.lineCap = "round";
  return { pen, size };
}

/** Path through points of the canvas. */
function trace(pen, places, closed = false) {
  pen.beginPath();
  places.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  if (closed) pen.closePath();
}

function stroke(pen, style, width, dash = []) {
  Object.assign(pen, { strokeStyle: style, lineWidth: width });
  pen.setLineDash(dash);
  pen.stroke();
  pen.setLineDash([]);
}

function disc(pen, [x, y], radius, style) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = style;
  pen.fill();
}

/** Points of a horizontal circle in space, at equal angles. */
function circle(radius, height, corners = 120) {
  const corner = (_, i) => (2 * Math.PI * i) / corners;
  return Array.from({ length: corners + 1 }, corner).map((t) => [radius * Math.cos(t), radius * Math.sin(t), height]);
}

/** Draws a trail in parts, the older the fainter. `seen` returns the opacity at a point, 0 for a hidden one. */
function fading(pen, places, style, width, seen = () => 1) {
  const parts = Math.min(40, places.length - 1);
  for (let part = 0; part < parts; part++) {
    const [from, to] = [part, part + 1].map((n) => Math.floor((n * (places.length - 1)) / parts));
    const visible = seen(places[Math.floor((from + to) / 2)]);
    if (visible === 0) continue;
    pen.globalAlpha = visible * (0.12 + 0.88 * ((part + 1) / parts) ** 1.5);
    trace(pen, places.slice(from, to + 1));
    pen.lineCap = "butt";
    stroke(pen, style, width);
  }
  pen.lineCap = "round";
  pen.globalAlpha = 1;
}
