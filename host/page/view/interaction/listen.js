// Buttons, sliders, keys and the address call the functions of the page.

function turn(azimuth, elevation) {
  const { view } = state;
  view.azimuth += azimuth;
  view.elevation = Math.max(0.06, Math.min(1.55, view.elevation + elevation));
  redraw();
}

const TURNS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.06], ArrowDown: [0, -0.06] };

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key, target } = event;
  const { tagName, type } = target;
  const isTyping = tagName === "INPUT" && type === "text";
  const takesSpace = isTyping || ["BUTTON", "SUMMARY", "SELECT"].includes(tagName) || type === "checkbox" || type === "radio";
  if (key === " " && !takesSpace) play(!clock.playing);
  else if (key === "Home" && tagName !== "INPUT") go(0);
  else if (TURNS[key] && target.dataset?.turns) turn(...TURNS[key]);
  else return;
  event.preventDefault();
}

function fillPresets() {
  const select = element("presets");
  const presets = presetsOf(data);
  for (const [group, motions] of Object.entries(presets)) {
    const list = Object.assign(document.createElement("optgroup"), { label: group });
    list.append(...Object.keys(motions).map((name) => new Option(name)));
    select.append(list);
  }
  select.addEventListener("change", () => {
    const motions = Object.assign({}, ...Object.values(presets));
    state.t = 0;
    setScenario(motions[select.value], { settle: true, name: select.value });
    updateAddress();
  });
}

function listenToTime() {
  element("play").addEventListener("click", () => play(!clock.playing));
  element("begin").addEventListener("click", () => go(0));
  element("far").addEventListener("click", () => go(1e6));
  element("position").addEventListener("input", ({ target }) => {
    play(false);
    go((state.intervalNumber + Number(target.value)) * scene.span);
  });
  element("speed").addEventListener("input", ({ target }) => {
    setSpeed(Number(target.value), false);
    updateAddress();
  });
  element("time").addEventListener("change", ({ target }) => {
    const t = numberOf(target.value);
    mark(target, Number.isNaN(t));
    if (Number.isNaN(t)) showMessage("t", `t: “${target.value.slice(0, 40)}” is no number of seconds`);
    else go(t);
    target.blur();
  });
}

function listenToMotion() {
  for (const support of SUPPORTS) {
    element(support).addEventListener("change", () => {
      setScenario(withSupport(state.scenario, support, scene.constants), { settle: true, name: "Your top" });
      updateAddress();
    });
  }
  for (const sign of ["sign_l_plus_n", "sign_l_minus_n"]) {
    element(sign).addEventListener("change", ({ target }) => {
      const scenario = asBranchPoints(state.scenario, scene.constants);
      const motion = { ...scenario.motion, [sign]: Number(target.value) };
      setScenario({ ...scenario, motion }, { name: "Your top" });
      updateAddress();
    });
  }
  for (const id of ["comparison", "comparison-step"]) {
    element(id).addEventListener("change", () => {
      startComparison();
      redraw();
      updateAddress();
    });
  }
  listenToRoots(element("potential-picture"), () => scene.e, (key, x) => {
    const control = CONTROLS.find((other) => other.key === key);
    change(control, Math.max(control.limits[0], Math.min(control.limits[1], x)));
  }, redraw);
}

function listenToPictures() {
  for (const canvas of elements("canvas[data-turns]")) {
    listenToTurns(canvas, turn, () => {
      state.view = { ...START_VIEW };
      redraw();
    });
  }
  for (const button of elements("button[data-png]")) {
    const what = button.dataset.png;
    button.addEventListener("click", () => savePng(element(`${what}-picture`), what));
  }
  for (const button of elements("button[data-svg]")) {
    const what = button.dataset.svg;
    const draw = (paper) => FLAT_PICTURES[what](paper, shown.frame);
    button.addEventListener("click", () => {
      const text = svgOf(element(`${what}-picture`), draw, state.colours);
      download(fileName(what, "svg"), new Blob([text], { type: "image/svg+xml" }));
    });
  }
  const film = element("film");
  film.hidden = !canFilm();
  film.addEventListener("click", filmer(element("scene-picture"), (isFilming) => {
    film.textContent = isFilming ? "Stop film" : "Film";
    film.setAttribute("aria-pressed", String(isFilming));
    if (isFilming) play(true);
  }));
  element("save-toml").addEventListener("click", () => {
    download(fileName("scenario", "toml"), new Blob([toToml(state.scenario, state.name)], { type: "text/plain" }));
  });
  element("share").addEventListener("click", async () => {
    history.replaceState(null, "", addressFragment());
    if (await copy(location.href)) showMessage("link", "The address of this motion is copied.", false);
  });
  element("print").addEventListener("click", () => print());
}

function recolour() {
  for (const canvas of elements("canvas")) sizes.delete(canvas);
  state.colours = palette();
  show();
}
