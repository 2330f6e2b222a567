// Pointers and arrow keys turn the 3-D pictures and drag the branch points.

/** Turns the 3-D pictures when they are dragged. */
function listenToTurns(canvas, turn, reset) {
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) turn(-0.008 * event.movementX, 0.008 * event.movementY);
  });
  canvas.addEventListener("dblclick", reset);
}

/**
 * Lets e₁, e₂ and e₃ be dragged along the potential: `roots` returns those shown, `set` takes a key and a number, and `release` is called
 * at the end.
 */
function listenToRoots(canvas, roots, set, release) {
  const pointerX = ({ offsetX }) => offsetX / unitOf();
  const layout = () => dragged.layout ?? potentialLayout(sizeOf(canvas), roots());
  let root = null;
  const nearest = (x) => {
    // without torque the roots do not determine the motion
    if (roots().length < 3) return null;
    const at = roots().map((u) => Math.abs(layout().x(u) - x));
    const least = Math.min(...at);
    // if two roots are equal, the one that can move towards the pointer is taken
    const [first, last] = [at.indexOf(least), at.lastIndexOf(least)];
    return least < 26 ? (x < layout().x(roots()[first]) ? first : last) : null;
  };
  canvas.addEventListener("pointerdown", (event) => {
    root = nearest(pointerX(event));
    if (root === null) return;
    dragged.layout = layout();
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    canvas.style.cursor = root !== null || nearest(pointerX(event)) !== null ? "ew-resize" : "default";
    if (root === null) return;
    const u = layout().u(pointerX(event));
    const bounds = [[-1, 0.9999], [-0.9999, 1], [1, 1e4]][root];
    const x = Math.max(bounds[0], Math.min(bounds[1], u));
    set(`e${root + 1}`, Number(x.toPrecision(Math.abs(x) > 10 ? 3 : 4)));
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, () => {
      [root, dragged.layout] = [null, null];
      release();
    });
  }
}
