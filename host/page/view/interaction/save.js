// Pictures, films, scenarios and links can be saved.

function download(name, blob) {
  const link = document.createElement("a");
  link.download = name;
  link.setAttribute("href", URL.createObjectURL(blob));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.getAttribute("href")), 1000);
}

/** Name of a file, from the name of the motion. */
const fileName = (what, ending) => `${document.title.split(":")[0].trim().replace(/[^\p{L}\p{N}]+/gu, "_")}_${what}.${ending}`;

function savePng(canvas, what) {
  canvas.toBlob((blob) => download(fileName(what, "png"), blob), "image/png");
}

/** Flat picture as SVG text, in the size in which it is shown. */
function svgOf(canvas, draw, colours) {
  const size = sizeOf(canvas);
  const pen = new SvgPen(colours.card, size);
  draw({ pen, size });
  return pen.toString();
}

/** Function that starts a film of a canvas, and ends it at the next call; `changed` is called with whether a film is recorded. */
function filmer(canvas, changed) {
  let recorder = null;
  return () => {
    if (recorder) {
      recorder.stop();
      return;
    }
    const type = ["video/webm;codecs=vp9", "video/webm", "video/mp4"].find((name) => MediaRecorder.isTypeSupported(name));
    const parts = [];
    recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type, videoBitsPerSecond: 6e6 });
    recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    recorder.addEventListener("stop", () => {
      recorder = null;
      changed(false);
      download(fileName("film", type.startsWith("video/mp4") ? "mp4" : "webm"), new Blob(parts, { type }));
    });
    recorder.start();
    changed(true);
  };
}

const canFilm = () => typeof MediaRecorder === "function" && typeof HTMLCanvasElement.prototype.captureStream === "function";

/** Copies a text; if the browser does not allow this, a prompt shows the text for copying by hand. */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    prompt("Copy this address:", text);
    return false;
  }
}
