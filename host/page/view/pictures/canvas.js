// Every picture takes its size and colours, and draws its lines and words, by these functions.

/** Colours of the style sheet, for the light or the dark appearance. */
function palette() {
  const style = getComputedStyle(document.documentElement);
  const names = "card ground rim grid bound tip axis ink faint sphere stand shine pin comparison".split(" ");
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

/**
 * Path through points of the canvas.
 * @param {any} pen
 * @param {number[][]} pixels
 */
function trace(pen, pixels, closed = false) {
  pen.beginPath();
  pixels.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  if (closed) pen.closePath();
}

function stroke(pen, style, width, dash = []) {
  Object.assign(pen, { strokeStyle: style, lineWidth: width });
  pen.setLineDash(dash);
  pen.stroke();
  pen.setLineDash([]);
}

/**
 * Draws a disc.
 * @param {any} pen
 * @param {number[]} pixel
 */
function disc(pen, [x, y], radius, style) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = style;
  pen.fill();
}

/** Draws a trail in parts, the older the fainter. `seen` returns the opacity at a point, 0 for a hidden one. */
function fading(pen, pixels, style, width, seen = (_pixel) => 1) {
  const parts = Math.min(40, pixels.length - 1);
  for (let part = 0; part < parts; part++) {
    const [from, to] = [part, part + 1].map((n) => Math.floor((n * (pixels.length - 1)) / parts));
    const visible = seen(pixels[Math.floor((from + to) / 2)]);
    if (visible === 0) continue;
    pen.globalAlpha = visible * (0.12 + 0.88 * ((part + 1) / parts) ** 1.5);
    trace(pen, pixels.slice(from, to + 1));
    pen.lineCap = "butt";
    stroke(pen, style, width);
  }
  pen.lineCap = "round";
  pen.globalAlpha = 1;
}

/** Sets colour, alignment and size of words. */
function write(pen, style, align, size = 12) {
  Object.assign(pen, { font: `${size}px system-ui, sans-serif`, textAlign: align, fillStyle: style });
}
