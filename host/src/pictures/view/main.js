// Start of the page.

async function begin() {
  core = await Core.load(element("core").textContent.trim(), data.constants);
  buildControls(change);
  fillPresets();
  setScenario(data.scenario, { settle: true });
  listenToTime();
  listenToMotion();
  listenToPictures();
  document.addEventListener("keydown", onKey);
  window.addEventListener("hashchange", fromAddress);
  listenToSizes(document.querySelectorAll("canvas"), redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
  for (const event of ["beforeprint", "afterprint"]) window.addEventListener(event, recolour);
  matchMedia("print").addEventListener("change", recolour);
  const stands = fromAddress();
  play(!stands && !matchMedia("(prefers-reduced-motion: reduce)").matches);
}

const ready = begin();
