// Film of the 3-D picture as GIF. Each frame is computed for its time, so that a slow computer does not change the film.

/** Width of a film, pixels; time between its frames, hundredths of a second; and number of its frames. */
const FILM = { width: 480, hundredths: 6, frames: 100 };

/** Pause in which the browser handles waiting events, such as a click, and draws the page. */
const pause = () => new Promise((done) => setTimeout(done, 0));

/** Pixels of the 3-D picture of a frame, in RGBA. */
function pixelsOf(canvas, frame) {
  drawScene(canvas, frame);
  return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
}

/** Hidden canvas for pictures with the aspect ratio and the relative line widths of a shown one. */
function filmCanvas(shown, width) {
  const canvas = document.createElement("canvas");
  const size = sizeOf(shown);
  sizes.set(canvas, { size, unit: width / size[0] / (window.devicePixelRatio || 1) });
  canvas.getContext("2d", { willReadFrequently: true });
  return canvas;
}

/**
 * Bytes of a film, whose frames `frameAt` returns by their numbers. `goesOn` is called before each frame with the finished share of
 * the film; if it returns false, the result is null.
 */
async function filmAsGif(shown, frameAt, { width, hundredths, frames }, goesOn) {
  const canvas = filmCanvas(shown, width);
  const samples = [0, 0.37, 0.71].map((share) => pixelsOf(canvas, frameAt(Math.floor(share * frames))).slice());
  const palette = new Palette(samples, UNCHANGED);
  const gif = new Gif([canvas.width, canvas.height], palette, hundredths);
  for (let i = 0; i < frames; i++) {
    if (!goesOn(i / frames)) return null;
    gif.add(palette.placesOf(pixelsOf(canvas, frameAt(i))));
    await pause();
  }
  return gif.end();
}

/** Makes a button start a film of the motion, and a second click on it cancel the film. */
function listenToGif(button) {
  let isFilming = false;
  button.addEventListener("click", async () => {
    if (isFilming) {
      isFilming = false;
      return;
    }
    isFilming = true;
    button.setAttribute("aria-pressed", "true");
    const [filmed, begin, speed] = [scene, state.t, state.speed];
    const frameOf = (i) => frameAt(begin + (i * FILM.hundredths * speed) / 100);
    // a change of the motion cancels the film, because the rest would show another motion
    const goesOn = (share) => {
      button.textContent = `${Math.round(100 * share)} %`;
      return isFilming && scene === filmed;
    };
    const bytes = await filmAsGif(element("scene-picture"), frameOf, FILM, goesOn);
    isFilming = false;
    button.setAttribute("aria-pressed", "false");
    button.textContent = "GIF";
    if (bytes) download(fileName("film", "gif"), new Blob([bytes], { type: "image/gif" }));
  });
}
