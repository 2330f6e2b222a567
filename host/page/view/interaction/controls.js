// Sliders and fields: each shows a number of the motion and sets it.

const LINEAR = { position: (x, [low, high]) => (x - low) / (high - low), value: (position, [low, high]) => low + position * (high - low) };
const LOGARITHMIC = {
  position: (x, [low, high]) => Math.log(x / low) / Math.log(high / low),
  value: (position, [low, high]) => low * (high / low) ** position,
};
/** Scale that is finer towards the lower end, where e₃ has the greatest effect. */
const CUBIC = { position: (x, [low, high]) => Math.cbrt((x - low) / (high - low)), value: (position, [low, high]) => low + position ** 3 * (high - low) };

const aroundValue = (value) => [value / 8, value * 8];
const upTo = (most) => (value, constants) => [0, Math.max(value, most(value, constants))];
const bothWays = (least) => (value, constants) => {
  const reach = 2 * Math.max(Math.abs(value), least(constants));
  return [-reach, reach];
};

/** Keys that have no effect on a free body. */
const WEIGHT_KEYS = ["mass", "mass_moment", "com_height", "gravity"];

/** Control for a number of the top, by its key in a scenario. */
const topControl = (key, label, unit, define, scale = LOGARITHMIC, range = aroundValue) => ({
  key, label, unit, define, group: "top", scale, range,
  read: ({ top }) => {
    if (top.support === "free" && WEIGHT_KEYS.includes(key)) return undefined;
    // a logarithmic scale has no 0, which stands for a number that is not given
    return (top[key] ?? DEFAULTS[key]) || (scale === LOGARITHMIC ? undefined : 0);
  },
  write: (scenario, x) => ({ ...scenario, top: { ...scenario.top, [key]: x } }),
});

/** Control for a number of the release. */
const releaseControl = (key, label, unit, define, range, read) => ({
  key, label, unit, define, group: "release", scale: LINEAR, range,
  read: ({ motion }, constants) => (motion.kind === "release" ? (motion[key] ?? 0) : read(constants)),
  write: (scenario, x, constants) => {
    const released = asRelease(scenario, constants);
    return { ...released, motion: { ...released.motion, [key]: x } };
  },
});

/** Control for a branch point; it moves the other branch points where they would be in the wrong order. */
const rootControl = (key, label, define, scale, range) => ({
  key, label, unit: "", define, group: "roots", scale, range,
  read: (_, constants) => (isTorqueFree(constants) ? undefined : constants[key]),
  write: (scenario, x, constants) => withRoot(scenario, key, x, constants),
});

function withRoot(scenario, key, x, constants) {
  const { motion } = asBranchPoints(scenario, constants);
  const changed = { ...motion, [key]: x };
  if (key === "e1") changed.e2 = Math.max(motion.e2, x);
  if (key === "e2") changed.e1 = Math.min(motion.e1, x);
  return { ...scenario, motion: changed };
}

const perNutation = ({ period, natural_time }) => 3 / (period > 0 ? period : natural_time);
/** Spin that is fast for this body, rad/s. */
const fastSpin = (constants) => Math.max(perNutation(constants), constants.C > 0 ? constants.critical_spin + constants.K / constants.C : 0);

const CONTROLS = [
  releaseControl("tilt_deg", "Tilt", "°", "Angle of the axis from the upward vertical at t = 0.", () => [0, 180], ({ tilt }) => degrees(tilt)),
  releaseControl("spin", "Spin", "rad/s", "Component of the angular velocity along the axis; it never changes.", bothWays(fastSpin), ({ spin }) => spin),
  releaseControl("precession", "Precession", "rad/s", "Rate at which the axis goes round the vertical at t = 0.", bothWays(perNutation), ({ precession }) => precession),
  releaseControl("nutation", "Nutation", "rad/s", "Rate at which the tilt grows at t = 0.", bothWays(perNutation), ({ nutation }) => nutation),
  topControl("mass", "Mass", "kg", "Mass M."),
  topControl("mass_moment", "Moment p", "kg m", "Mass times distance from the tip to the centre of mass."),
  topControl("transverse_inertia", "Inertia A", "kg m²", "Transverse moment of inertia: about the tip where that is held, about the centre of mass of any other body."),
  topControl("axial_inertia", "Inertia C", "kg m²", "Moment of inertia about the axis of the top; at most 2A, and 0 for a pendulum.", LINEAR, upTo((_, { A }) => 2 * A)),
  topControl("rotor_momentum", "Rotor K", "kg m²/s", "Angular momentum of a rotor that turns inside about the same axis, relative to the body; 0 without one.", LINEAR, bothWays((constants) => constants.A * fastSpin(constants))),
  topControl("com_height", "Height s", "m", "Distance from the tip to the centre of mass."),
  topControl("gravity", "Gravity", "m/s²", "Gravity g: 9.81 on Earth, 1.62 on the Moon; 0 only where the tip is held.", LINEAR, upTo((value) => 3 * (value || DEFAULTS.gravity))),
  rootControl("e1", "e₁", "Least u, the cosine of the tilt.", LINEAR, () => [-1, 1]),
  rootControl("e2", "e₂", "Greatest u.", LINEAR, () => [-1, 1]),
  rootControl("e3", "e₃", "Third root of the cubic, at least 1.", CUBIC, (value) => [1, Math.max(20, 1 + 4 * (value - 1))]),
];

/** Value of a slider, rounded to the digits that its range resolves. */
const rounded = (x, [low, high]) => Number(x.toFixed(Math.max(0, Math.min(20, 3 - Math.floor(Math.log10(high - low))))));

/** Text with six digits in the form in which a user types them: 0.25, 7.5e-5. */
const typed = (x) => (x !== 0 && Math.abs(x) < 1e-3 ? x.toExponential(5).replace(/\.?0+e/, "e") : String(Number(x.toPrecision(6))));

/** Builds the rows of sliders and fields in their groups. */
function buildControls(change) {
  for (const control of CONTROLS) {
    const { key, label, unit, define, group } = control;
    const row = document.createElement("div");
    row.className = "row";
    row.innerHTML = `<label for="${key}" class="term" data-define="${define}">${label}</label>
      <input type="range" id="${key}" min="0" max="1" step="any">
      <input type="text" id="${key}-field" inputmode="text" autocomplete="off" spellcheck="false" aria-label="${label}, ${unit || "number"}" aria-description="${define}">
      <span class="unit">${unit}</span>`;
    element(`${group}-controls`).append(row);
    Object.assign(control, { row, slider: element(key), field: element(`${key}-field`), unitElement: row.lastElementChild });
    control.slider.addEventListener("input", ({ target }) => {
      const x = control.scale.value(Number(target.value), control.limits);
      change(control, control.scale === LOGARITHMIC ? Number(x.toPrecision(4)) : rounded(x, control.limits));
    });
    control.field.addEventListener("change", ({ target }) => {
      const x = numberOf(target.value);
      mark(target, Number.isNaN(x));
      if (Number.isNaN(x)) showMessage("motion", `${label}: “${target.value.slice(0, 40)}” is no number`);
      else change(control, x);
    });
    // a refused number leaves with the cursor, and the number of the motion returns
    control.field.addEventListener("blur", ({ target }) => {
      if (target.getAttribute("aria-invalid")) target.value = typed(control.number);
      mark(target, false);
    });
  }
}

/** Shows the numbers of a motion. `settle` also sets the ranges of the sliders around these numbers. */
function showControls({ scenario, constants, settle = false }) {
  for (const control of CONTROLS) {
    const x = control.read(scenario, constants);
    control.row.hidden = x === undefined;
    if (x === undefined) continue;
    const [low, high] = control.limits ?? [NaN, NaN];
    if (settle || !(x >= low && x <= high)) control.limits = control.range(x, constants);
    control.number = x;
    const text = typed(x);
    const unit = unitName(control.unit, scenario);
    control.slider.value = String(control.scale.position(x, control.limits));
    mark(control.field, false);
    if (document.activeElement !== control.field) control.field.value = text;
    const said = `${text} ${unit}`;
    if (control.said === said) continue;
    control.said = said;
    control.unitElement.textContent = unit;
    control.slider.setAttribute("aria-valuetext", said);
  }
  const { kind } = scenario.motion;
  element("release-controls").classList.toggle("given", kind !== "branch_points");
  element("roots-controls").classList.toggle("given", kind === "branch_points");
  for (const sign of ["sign_l_plus_n", "sign_l_minus_n"]) element(sign).value = String(constants[sign]);
  element("roots").hidden = isTorqueFree(constants);
  element(SUPPORTS[constants.support]).checked = true;
}
