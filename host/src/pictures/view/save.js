// Pictures, films, scenarios and links to keep.

function download(name, blob) {
  const link = document.createElement("a");
  link.download = name;
  link.setAttribute("href", URL.createObjectURL(blob));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.getAttribute("href")), 1000);
}

/** The name of a file that is about this motion. */
const fileName = (what, ending) => `${document.title.split(":")[0].trim().replace(/[^\p{L}\p{N}]+/gu, "_")}_${what}.${ending}`;

function savePng(canvas, what) {
  canvas.toBlob((blob) => download(fileName(what, "png"), blob), "image/png");
}

/** The text of a flat picture as SVG, of the size in which it is shown. */
function svgOf(canvas, draw, colours) {
  const size = sizeOf(canvas);
  const pen = new SvgPen(colours.card, size);
  draw({ pen, size });
  return pen.toString();
}

/** Films a canvas until it is called again; `changed` hears whether it is filming. */
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

/** Copies a text; where a browser does not allow that, the text is selected to be copied by hand. */
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    prompt("Copy this address:", text);
    return false;
  }
}
