// The page starts here.

import { listenToSizes } from "./pictures/canvas.js";
import { data } from "./motion/data.js";
import { elements } from "./interaction/document.js";
import { buildControls } from "./interaction/controls.js";
import { change, applyAddress, loadCore, play, redraw, setScenario } from "./interaction/state.js";
import { fillPresets, listenToMotion, listenToPictures, listenToTime, onKey, recolour } from "./interaction/listen.js";

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
export const ready = begin();
