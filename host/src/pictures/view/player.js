// Time: what plays it, what sets it, and what is said of the moment it has come to.

const element = (id) => document.getElementById(id);
const read = (id) => JSON.parse(element(id).textContent);

const scene = read("scene");
const table = readTable(read("table"));
const motion = motionOf(scene, table);
const body = turnOnLathe(scene.breadth);
const rate = table.ticks_per_time[0] + table.ticks_per_time[1];
/** Ticks between points of a line. */
const stride = Math.max(1, Math.round((scene.span * rate) / scene.points));
/** Ticks are counted in whole Numbers. */
const furthest = Math.min(2 ** 52 / rate, 1e15);

const start = { azimuth: 0.9, elevation: 0.42 };
const state = { t: 0, page: 0, speed: scene.speed, playing: false, view: { ...start }, colours: palette(), last: 0 };

/** Points that were computed, by their number; those no longer drawn are forgotten. */
const points = new Map();

function pointsBefore(tick) {
  const span = Math.round(scene.span * rate);
  const first = Math.ceil((tick >= 0 ? Math.max(0, tick - span) : tick - span) / stride);
  const last = Math.floor(tick / stride);
  for (const number of points.keys()) if (number < first || number > last) points.delete(number);
  const list = [];
  for (let number = first; number <= last; number++) {
    if (!points.has(number)) points.set(number, motion.at(number * stride));
    list.push(points.get(number));
  }
  return list;
}

/** The moment that is shown; a test compares it with the crate. */
let shown;

function show() {
  const tick = Math.round(state.t * rate);
  const now = motion.at(tick);
  shown = { tick, ...now };
  const frame = { scene, motion, body, now, past: [...pointsBefore(tick), now], view: state.view, colours: state.colours };
  drawScene(element("scene-picture"), frame);
  drawPlan(element("plan-picture"), frame);
  drawSphere(element("sphere-picture"), frame);
  tell(now);
}

const digits = (x, n = 4) => x.toFixed(n).replace("-", "−");
const short = (x) => String(Number(x.toPrecision(6))).replace("-", "−").replace("e", " · 10^");

function tell({ moment, axis }) {
  const { t, page } = state;
  const values = {
    tilt: `${digits((Math.atan2(Math.hypot(axis[0], axis[1]), axis[2]) * 180) / Math.PI, 2)}°`,
    u: digits(moment.u, 6),
    alpha: `${digits(moment.alpha[0])} ${moment.alpha[1] < 0 ? "−" : "+"} ${digits(Math.abs(moment.alpha[1]))} i`,
    beta: `${digits(moment.beta[0])} ${moment.beta[1] < 0 ? "−" : "+"} ${digits(Math.abs(moment.beta[1]))} i`,
    "axis-now": axis.map((x) => digits(x, 3)).join(", "),
    periods: scene.period ? digits(t / scene.period, 2) : "",
  };
  for (const [id, text] of Object.entries(values)) if (element(id)) element(id).textContent = text;
  const time = element("time");
  if (document.activeElement !== time) time.value = String(Number(t.toPrecision(Math.abs(t) > 1e4 ? 10 : 5)));
  const slider = element("position");
  slider.value = String(t / scene.span - page);
  slider.setAttribute("aria-valuetext", `${short(t)} s`);
}

/** Goes to a time; the slider's range follows where it is left. */
function go(t) {
  state.t = Math.max(-furthest, Math.min(furthest, t));
  const place = state.t / scene.span - state.page;
  if (place < 0 || place > 1) state.page = Math.floor(state.t / scene.span);
  requestAnimationFrame(show);
}

function play(playing) {
  state.playing = playing;
  const button = element("play");
  button.setAttribute("aria-label", playing ? "Pause" : "Play");
  button.title = playing ? "Pause (space)" : "Play (space)";
  button.dataset.playing = playing;
  state.last = performance.now();
  if (playing) requestAnimationFrame(step);
}

function step(time) {
  if (!state.playing) return;
  // a page that was in the background does not jump
  const passed = Math.max(0, Math.min(0.1, (time - state.last) / 1000));
  state.last = time;
  state.t = Math.min(furthest, state.t + passed * state.speed);
  if (state.t / scene.span - state.page > 1) state.page = Math.floor(state.t / scene.span);
  show();
  requestAnimationFrame(step);
}

function setSpeed(exponent) {
  state.speed = scene.speed * 2 ** exponent;
  const text = `${Number(state.speed.toPrecision(2))} s of motion a second`;
  element("speed-now").textContent = text;
  element("speed").setAttribute("aria-valuetext", text);
}

/** `#t=12.5` shows that time and stands still. */
function fromAddress() {
  const asked = /^#t=([-+.\de]+)$/i.exec(location.hash);
  const t = asked ? Number(asked[1]) : NaN;
  if (!Number.isFinite(t)) return false;
  play(false);
  go(t);
  return true;
}

function turn(azimuth, elevation) {
  const { view } = state;
  view.azimuth += azimuth;
  view.elevation = Math.max(0.06, Math.min(1.55, view.elevation + elevation));
  requestAnimationFrame(show);
}

const TURNS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.06], ArrowDown: [0, -0.06] };

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key, target } = event;
  const typing = target.tagName === "INPUT" && target.type !== "range";
  if (key === " " && !typing && target.tagName !== "BUTTON" && target.tagName !== "SUMMARY") play(!state.playing);
  else if (key === "Home" && target.tagName !== "INPUT") go(0);
  else if (TURNS[key] && target.tagName === "CANVAS") turn(...TURNS[key]);
  else return;
  event.preventDefault();
}

function listen() {
  element("play").addEventListener("click", () => play(!state.playing));
  element("begin").addEventListener("click", () => go(0));
  element("position").addEventListener("input", ({ target }) => {
    play(false);
    go((state.page + Number(target.value)) * scene.span);
  });
  element("speed").addEventListener("input", ({ target }) => setSpeed(Number(target.value)));
  element("time").addEventListener("change", ({ target }) => {
    const t = Number(target.value.replace(",", "."));
    if (target.value.trim() !== "" && Number.isFinite(t)) go(t);
    target.blur();
  });
  for (const id of ["scene-picture", "sphere-picture"]) {
    const canvas = element(id);
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (canvas.hasPointerCapture(event.pointerId)) turn(-0.008 * event.movementX, 0.008 * event.movementY);
    });
    canvas.addEventListener("dblclick", () => {
      state.view = { ...start };
      requestAnimationFrame(show);
    });
  }
  document.addEventListener("keydown", onKey);
  window.addEventListener("hashchange", fromAddress);
  window.addEventListener("resize", () => requestAnimationFrame(show));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    state.colours = palette();
    requestAnimationFrame(show);
  });
}

listen();
setSpeed(0);
if (!fromAddress()) play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
// at once: the first frame may be late
show();
