// The page has one state, which these functions change and draw.

/** Greatest time that the field accepts, s: 30 thousand years. */
const FURTHEST = 1e12;

/** View from which a page starts. */
const START_VIEW = { azimuth: 0.9, elevation: 0.42 };
const state = { t: 0, intervalNumber: 0, speed: 1, exponent: 0, view: { ...START_VIEW }, colours: palette(), scenario: data.scenario, name: data.name.replaceAll("_", " ") };
/** Core, computed points of the motion, and those of the interval that the slider covers. */
let core, points, interval;
/** Scene of the motion that is shown. */
let scene;
/** State of the motion that is shown; a test compares it with the crate. */
let shown;
let pending = false;

const clock = new Clock((passed) => {
  state.t = limited(state.t + passed * state.speed);
  moveInterval();
  show();
});

/** A time with its unit, if the scenario has units. */
const inSeconds = (text) => (state.scenario.units === "none" ? text : `${text} s`);

const limited = (t) => Math.max(-FURTHEST, Math.min(FURTHEST, t));

/** Shows a scenario; if the core refuses it, shows the reason and keeps the scenario before. */
function setScenario(scenario, { settle = false, name = undefined } = {}) {
  const launched = core.launch(scenario);
  if (launched.refused) {
    showMessage("motion", refusalText(launched.refused));
    core.launch(state.scenario);
    startComparison();
    if (scene) showControls({ scenario: state.scenario, constants: scene.constants });
    return false;
  }
  state.scenario = scenario;
  if (name !== undefined) state.name = name;
  element("presets").value = state.name;
  scene = sceneOf(launched);
  points = new Points(core, scene);
  interval = undefined;
  state.intervalNumber = Math.floor(state.t / scene.span);
  showMessage("motion", "");
  startComparison();
  setSpeed(settle ? 0 : state.exponent, settle);
  showControls({ scenario, constants: launched, settle });
  tellMotion(launched);
  show();
  return true;
}

/** Data of the pictures at a time. */
function frameAt(t) {
  const now = drawnPose(scene, core.at(t));
  const { view, colours, scenario } = state;
  return { scene, scenario, now, past: [...points.before(t), now], t, view, colours, comparison: comparisonNow(t) };
}

function show() {
  pending = false;
  const { t, intervalNumber } = state;
  points.forget(t);
  if (interval?.number !== intervalNumber) interval = intervalOf(points, scene, intervalNumber);
  const frame = { ...frameAt(t), interval };
  const { now, colours } = frame;
  shown = { ...now, t, frame };
  drawScene(element("scene-picture"), frame);
  drawSphere(element("sphere-picture"), frame);
  for (const [id, draw] of Object.entries(FLAT_PICTURES)) draw(sheet(element(`${id}-picture`), colours.card), frame);
  tellPose(now);
}

/** Pictures that can also be saved as SVG. */
const FLAT_PICTURES = {
  plan: drawPlan,
  tilt: (paper, frame) => drawChart(paper, frame, "tilt"),
  precession: (paper, frame) => drawChart(paper, frame, "precession"),
  potential: drawPotential,
};

async function loadCore() {
  core = await Core.load(element("core").textContent.trim(), data.constants);
}

/** Requests one drawing, with the next frame of the browser. */
function redraw() {
  if (!pending) requestAnimationFrame(show);
  pending = true;
}

function tellMotion(launched) {
  document.title = `${state.name}: a top in motion`;
  element("name").textContent = state.name;
  element("summary").textContent = summaryOf(launched);
  element("curve-reason").textContent = curveReason(launched);
  element("plan-title").textContent = scene.slides ? "Tip from above" : "Axis from above";
  element("tip-legend").parentElement.hidden = scene.support === "free";
  element("tip-legend").textContent = scene.slides ? "tip on the plane" : "foot of the axis, −2αβ";
  element("momentum-legend").hidden = !scene.momentum;
  for (const unit of elements(".second")) unit.hidden = state.scenario.units === "none";
  fillTable(element("teachers-facts"), teachersFacts(launched, state.scenario), state.scenario);
  fillTable(element("papers-facts"), paperFacts(launched), state.scenario);
}

function tellPose({ pose }) {
  const { t, intervalNumber } = state;
  fillTable(element("now-facts"), poseFacts(pose, t, scene.constants), state.scenario);
  const time = element("time");
  if (document.activeElement !== time) time.value = String(Number(t.toPrecision(Math.abs(t) > 1e4 ? 12 : 5)));
  const slider = element("position");
  slider.value = String(t / scene.span - intervalNumber);
  slider.setAttribute("aria-valuetext", inSeconds(short(t, 6)));
}

/** Sets the time; if it is outside of the slider's interval, the interval changes. */
function go(t) {
  if (limited(t) !== t) showMessage("t", `t: must be between −10¹² and ${inSeconds("10¹²")}; ${inSeconds(short(t))} is beyond`);
  else showMessage("t", "");
  state.t = limited(t);
  moveInterval();
  redraw();
}

function moveInterval() {
  const fraction = state.t / scene.span - state.intervalNumber;
  if (fraction < 0 || fraction > 1) state.intervalNumber = Math.floor(state.t / scene.span);
}

function play(playing) {
  const button = element("play");
  button.setAttribute("aria-label", playing ? "Pause" : "Play");
  button.title = playing ? "Pause (space)" : "Play (space)";
  button.dataset.playing = playing;
  clock.play(playing);
}

function setSpeed(exponent, settle = true) {
  state.exponent = exponent;
  if (settle) state.base = scene.speed;
  state.speed = state.base * 2 ** exponent;
  element("speed").value = String(exponent);
  const text = `${inSeconds(short(state.speed, 2))} of motion a second`;
  element("speed-now").textContent = text;
  element("speed").setAttribute("aria-valuetext", text);
}

/** Sets a number that a slider, a field or a drag has changed. */
function change(control, x) {
  const good = setScenario(control.write(state.scenario, x, scene.constants), { name: "Your top" });
  mark(control.field, !good);
  if (!good) showMessage("motion", `${element("message").textContent}; the motion keeps ${control.label} = ${typed(control.number)}`);
  updateAddress();
}

/** Step of the comparison top in its field, s; 0 if it is switched off. */
const comparisonStep = () => (element("comparison").checked ? numberOf(element("comparison-step").value) : 0);

function startComparison() {
  const step = comparisonStep();
  showMessage("comparison", Number.isNaN(step) || step < 0 ? "step of the comparison top: must be a positive number of seconds" : "");
  core.startComparison(step > 0 ? step : 0);
}

function comparisonNow(t) {
  const comparison = core.comparisonAt(t);
  const output = element("comparison-error");
  if (!comparison) {
    output.textContent = "";
    return null;
  }
  const { pose, reached, distance } = comparison;
  const arrived = Math.abs(reached - t) <= 1e-9 * Math.abs(t);
  const off = distance < 0.01 ? `${short(distance, 2)} rad` : `${decimals(degrees(distance), 1)}°`;
  output.textContent = arrived ? `The comparison top is ${off} off.` : `The comparison top is still on its way: t = ${inSeconds(short(reached, 4))}, ${off} off.`;
  if (!arrived && !clock.playing) redraw();
  return drawnPose(scene, pose);
}

/** Fragment of the address for the settings: the motion, and time, speed and step of the comparison top if they differ from those of a page that was just opened. */
function addressFragment() {
  const speed = state.exponent === 0 ? undefined : Number(state.speed.toPrecision(4));
  return toFragment(state.scenario, { t: clock.playing ? undefined : state.t, speed, comparison: comparisonStep() || undefined });
}

/** Puts the settings into the address, so that it can be shared and reloaded. */
let addressTimer;
function updateAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, "", addressFragment()), 250);
}

/** Applies the settings of the address; a page with a time in its address does not play. An address with an error changes nothing. */
function applyAddress() {
  const { refused, scenario, t, speed, comparison } = fromFragment(location.hash);
  showMessage("motion", refused ?? "");
  if (refused) return false;
  if (comparison > 0) {
    element("comparison").checked = true;
    element("comparison-step").value = String(comparison);
  }
  if (scenario) setScenario(scenario, { settle: true, name: "A shared top" });
  else startComparison();
  if (speed > 0) setSpeed(Math.max(-6, Math.min(6, Math.log2(speed / scene.speed))));
  if (Number.isNaN(t)) return false;
  play(false);
  go(t);
  return true;
}
