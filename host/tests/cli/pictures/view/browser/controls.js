// The page and its controls are operated.

/** Operates the page and its controls. Each entry of the result is a sentence that must be true. */
async function operate() {
  const facts = {};
  const key = (target, key) => target.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  const main = element("scene-picture");
  const message = () => (element("message").hidden ? "" : element("message").textContent);
  facts["it plays by itself"] = clock.playing && state.t > 0;
  element("play").click();
  await settled();
  const paused = state.t;
  facts["the button pauses and says what it does now"] = !clock.playing && element("play").getAttribute("aria-label") === "Play";
  await settled();
  facts["time stands still after a pause"] = state.t === paused;
  key(document.body, " ");
  await settled();
  facts["space plays"] = clock.playing && state.t > paused;
  await set("position", "0.25", "input");
  facts["the slider sets the time and pauses"] = !clock.playing && Math.abs(state.t - 0.25 * scene.span) < 1e-9;
  facts["the slider says the time, and its unit where there is one"] = element("position").getAttribute("aria-valuetext").endsWith(" s") === elements(".second").some(({ hidden }) => !hidden);
  const before = picture(main);
  key(main, "ArrowLeft");
  await settled();
  facts["an arrow turns the picture"] = picture(main) !== before;
  await set("speed", "3", "input");
  facts["the slider sets the speed"] = Math.abs(state.speed - 8 * scene.speed) < 1e-12;
  await set("time", "1e6", "change");
  facts["the field takes any time"] = state.t === 1e6 && shown.t === 1e6;
  facts["the slider follows"] = Number(element("position").value) <= 1 && state.intervalNumber === Math.floor(1e6 / scene.span);
  await set("time", "abc", "change");
  facts["what is no time changes nothing and is answered"] = state.t === 1e6 && message().includes("no number");
  await set("time", "5e8", "change");
  facts["half a thousand million seconds are no limit"] = state.t === 5e8 && message() === "";
  await set("time", "1e13", "change");
  facts["a limit is said"] = state.t === 1e12 && message().includes("must be between");
  key(document.body, "Home");
  await settled();
  facts["Home goes back"] = state.t === 0;
  element("far").click();
  await settled();
  facts["the button goes to a million seconds"] = state.t === 1e6;
  await set("spin-field", "NaN", "change");
  facts["what is no spin is answered"] = message().includes("Spin") && Number.isFinite(scene.constants.spin);
  const inertia = scene.constants.C;
  await set("axial_inertia-field", "1e3", "change");
  facts["what the core refuses is answered and changes nothing"] = message().startsWith("axial inertia: must be between 0 and twice") && scene.constants.C === inertia;
  const refusal = async (key, text) => {
    const [field, before] = [element(`${key}-field`), scene.constants[key]];
    field.focus();
    await set(field.id, text, "change");
    const told = field.getAttribute("aria-invalid") === "true" && message().includes("; the motion keeps e") && scene.constants[key] === before;
    field.blur();
    await settled();
    return told && field.value === typed(before) && !field.hasAttribute("aria-invalid");
  };
  facts["a refused e3 leaves the field, and the motion keeps its own"] = await refusal("e3", "0.5");
  facts["a refused e1 leaves the field, and the motion keeps its own"] = await refusal("e1", "-1.5");
  facts["a refused e2 leaves the field, and the motion keeps its own"] = await refusal("e2", "1.2");
  await set("spin-field", "123", "change");
  facts["a field sets the spin and clears the message"] = Math.abs(scene.constants.spin - 123) < 1e-12 && message() === "";
  await set("e1", "0.1", "input");
  facts["e1 moves and its group is the one that is given"] = Math.abs(scene.constants.e1 + 0.8) < 1e-9 && element("roots-controls").matches(".given");
  await set("e2", "0.05", "input");
  facts["e1 gives way to e2"] = Math.abs(scene.constants.e2 + 0.9) < 1e-9 && scene.constants.e1 === scene.constants.e2;
  await set("e2", "0.9", "input");
  const well = element("potential-picture");
  well.setPointerCapture = () => {};
  const pointer = (kind, u) => {
    const { left, top } = well.getBoundingClientRect();
    well.dispatchEvent(new PointerEvent(kind, { clientX: left + u * unitOf(), clientY: top + 40, bubbles: true }));
  };
  const place = potentialLayout(sizeOf(well), scene.e);
  pointer("pointerdown", place.x(scene.constants.e1));
  pointer("pointermove", place.x(-0.25));
  pointer("pointerup", place.x(-0.25));
  await settled();
  facts["a root is dragged along the potential"] = Math.abs(scene.constants.e1 + 0.25) < 2e-3 && scene.constants.e2 > 0.7;
  await set("sign_l_minus_n", "-1", "change");
  const minus = scene.constants.l - scene.constants.n;
  await set("sign_l_minus_n", "1", "change");
  facts["the sign of l - n follows its control"] = minus < 0 && scene.constants.l > scene.constants.n;
  element("fixed").click();
  await settled();
  facts["the tip is held"] = scene.support === "fixed" && element("summary").textContent.startsWith("The tip is held.");
  element("sliding").click();
  await settled();
  facts["the tip slides again"] = scene.slides;
  const heavy = { ...state.scenario.top };
  const rows = () => CONTROLS.filter(({ row }) => !row.hidden).map(({ key }) => key).join(" ");
  element("free").click();
  await settled();
  facts["a free body has no weight and no roots"] = scene.support === "free" && scene.e.length === 2 && element("roots").hidden &&
    rows() === "tilt_deg spin precession nutation transverse_inertia axial_inertia rotor_momentum";
  facts["its words are those of a free body"] = element("summary").textContent.startsWith("The body is free. No torque acts: the axis goes round the angular momentum") &&
    !element("momentum-legend").hidden && element("plan-title").textContent === "Axis from above";
  facts["the axis keeps its angle to the angular momentum"] = Math.abs(dot(scene.momentum, shown.axis) - Math.cos((coneAngle(scene.constants) * Math.PI) / 180)) < 1e-9;
  await set("rotor_momentum-field", String(-0.5 * scene.constants.n), "change");
  facts["a rotor is a part of n"] = Math.abs(scene.constants.n / (scene.constants.C * scene.constants.spin + scene.constants.K) - 1) < 1e-9 && scene.constants.K !== 0;
  await set("rotor_momentum-field", "0", "change");
  element("sliding").click();
  await settled();
  const same = (key) => Math.abs((state.scenario.top[key] ?? 9.80665) / (heavy[key] ?? 9.80665) - 1) < 1e-12;
  facts["what was thrown is put down as it was"] = ["mass", "com_height", "transverse_inertia", "axial_inertia", "gravity"].every(same) && element("momentum-legend").hidden;
  element("comparison").click();
  await settled();
  facts["the comparison top is shown where it is asked for"] = shown.frame.comparison !== null && element("comparison-error").textContent.startsWith("The comparison top is");
  await set("comparison-step", "0", "change");
  facts["a step of 0 is no comparison top"] = shown.frame.comparison === null;
  const classes = {};
  for (const option of [...element("presets").options]) {
    await set("presets", option.value, "change");
    classes[option.value] = [scene.constants.regime, scene.constants.tipClass];
  }
  facts["all presets are motions"] = message() === "" && Object.keys(classes).length === 25;
  facts["the nine curves are the paper's"] = JSON.stringify(Object.entries(classes).filter(([name]) => name.startsWith("Figure")).map(([, [, kind]]) => kind)) ===
    JSON.stringify(["smooth", "smooth", "smooth", "smooth", "smooth", "smooth", "cusp", "loops", "loops"]);
  await set("presets", "Pendulum, in a plane", "change");
  facts["a pendulum has no axial inertia and stays in its plane"] = scene.constants.C === 0 && element("summary").textContent.endsWith("It swings in a vertical plane.") &&
    [...element("teachers-facts").rows].every((row) => !row.textContent.includes("NaN"));
  const azimuths = CHARTS.precession.values(shown.frame.interval, scene.constants);
  facts["a pendulum does not precess"] = scene.constants.phi_per_period === 0 && Math.max(...azimuths) - Math.min(...azimuths) < 1e-3;
  await set("presets", [...element("presets").options].map(({ value }) => value).find((value) => value.startsWith("Figure 3")), "change");
  facts["no unit is named where there is none"] = elements(".second").every(({ hidden }) => hidden) && !element("speed-now").textContent.includes(" s of");
  await set("presets", "Sleeping, just above the critical spin", "change");
  const asleep = tiltAt(scene.constants.e1);
  await set("presets", "Waking, just below the critical spin", "change");
  facts["above the critical spin it sleeps, below it wakes"] = asleep < 6 && tiltAt(scene.constants.e1) > 15;
  await set("time", "2", "change");
  const svg = svgOf(element("plan-picture"), (paper) => drawPlan(paper, shown.frame), state.colours);
  const parsed = new DOMParser().parseFromString(svg, "image/svg+xml");
  facts["a picture is SVG"] = !parsed.querySelector("parsererror") && parsed.querySelectorAll("path").length > 20 && parsed.querySelectorAll("text").length > 1;
  facts["a film can be taken"] = canFilm();
  facts["no number is minus zero"] = complexText([-1e-9, -1e-9]) === "0.0000 + 0.0000 i" && decimals(-1e-9, 2) === "0.00";
  const named = (e) => e.getAttribute("aria-label") || e.textContent.trim() || (e.labels && e.labels.length > 0);
  for (const fragment of ["#t=%", "#kind=release&spin=x", "#kind=release&tilt_deg=200&spin=1", "#=&&", "#kind=state&alpha=1"]) {
    location.hash = fragment;
    await settled();
  }
  facts["an address that says nothing changes nothing"] = scene.constants.regime === "nutating" && Number.isFinite(state.t);
  facts["everything has a name"] = elements("canvas, button, input, select").every(named);
  facts["every name of a number is defined"] = elements(".term").every((term) => term.dataset.define.length > 4);
  facts["nothing is wider than the window"] = document.documentElement.scrollWidth <= innerWidth;
  return facts;
}
