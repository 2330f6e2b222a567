// The page starts here.

async function begin() {
  await loadCore();
  buildControls(change);
  fillPresets();
  setScenario(data.scenario, { settle: true });
  listenToTime();
  listenToMotion();
  listenToPictures();
  document.addEventListener("keydown", onKey);
  window.addEventListener("hashchange", applyAddress);
  listenToSizes(elements("canvas"), redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
  for (const event of ["beforeprint", "afterprint"]) window.addEventListener(event, recolour);
  matchMedia("print").addEventListener("change", recolour);
  const isAtGivenTime = applyAddress();
  play(!isAtGivenTime && !matchMedia("(prefers-reduced-motion: reduce)").matches);
}

/** Promise that the page is complete. */
const ready = begin();
