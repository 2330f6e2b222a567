// The page is read and operated by these functions, which run after its script.

const settled = () => new Promise((done) => setTimeout(done, 300));
const pixels = (canvas) => {
  const { width, height } = canvas;
  const copy = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  return copy.getImageData(0, 0, width, height).data;
};
const picture = (canvas) => pixels(canvas).reduce((hash, byte) => (Math.imul(hash, 31) + byte) | 0, 0);
const colours = () => elements("canvas").map((canvas) => new Set(new Uint32Array(pixels(canvas).buffer)).size);
const facts = () => Object.fromEntries(elements("tr").map((row) => [...row.children].map((cell) => cell.textContent)));
const set = async (id, value, event) => {
  element(id).value = value;
  element(id).dispatchEvent(new Event(event, { bubbles: true }));
  await settled();
};

/** Goes to each time by the address. Returns the data that are shown. */
async function shownAt(times) {
  const results = [];
  for (const t of times) {
    location.hash = `t=${t}`;
    await settled();
    const { pose, rotate } = shown;
    const columns = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(rotate);
    results.push({ t: state.t, ...pose, columns, facts: facts(), colours: colours() });
  }
  return results;
}

/** Moves every slider. Returns the data that are shown, the scenario file, and the address. */
async function moveSliders() {
  const results = [];
  play(false);
  for (const control of CONTROLS.filter(({ row }) => !row.hidden)) {
    for (const value of ["0.31", "0.62"]) {
      await set(control.key, value, "input");
      state.t = 7.25;
      show();
      const { pose } = shown;
      results.push({ key: control.key, ...pose, toml: toToml(state.scenario, state.name) });
    }
  }
  await set("speed", "-2", "input");
  element("comparison").click();
  await settled();
  return { results, fragment: location.hash, speed: state.speed, comparison: shown.frame.comparison.axis };
}

/** Data that are shown, and the settings. */
function restored() {
  const { pose } = shown;
  return { ...pose, t: state.t, playing: clock.playing, fragment: addressFragment(), speed: state.speed, comparison: shown.frame.comparison.axis };
}

/** Goes to each address. Returns the messages, and the spins. */
async function visit(fragments) {
  const found = [];
  play(false);
  for (const fragment of fragments) {
    location.hash = fragment;
    await settled();
    found.push([element("message").hidden ? "" : element("message").textContent, scene.constants.spin]);
  }
  return found;
}

/** Summaries of a motion in each regime, and all words of the page. */
function describe(regimes) {
  play(false);
  const found = regimes.map((regime) => summaryOf({ ...scene.constants, regime }));
  const definitions = elements("[data-define]").map((term) => term.dataset.define);
  found.push([document.body.innerText, ...definitions].join(" "));
  return found;
}
