// The reduced motion is that of a point of energy 0 in the potential -f(u) = -(u - e₁)(u - e₂)(u - e₃), whose roots can be dragged. Without
// torque there is no e₃, and the potential is (u - e₁)(u - e₂).

/** Share of the width in which the well and its surroundings are drawn to scale. */
const TO_SCALE = 0.74;

const potentialAt = (u, [e1, e2, e3]) => (u - e1) * (u - e2) * (e3 === undefined ? 1 : e3 - u);

/**
 * Maps between u or its potential and the picture. The well and its surroundings are to scale; the rest of the u axis, with e₃, is
 * compressed into the remaining width.
 */
function potentialLayout([width, height], [e1, e2, e3]) {
  const [left, right, top, bottom] = [14, width - 14, 22, height - 34];
  const room = 0.7 * Math.max(e2 - e1, 0.04);
  const [from, to] = [Math.max(-1.03, e1 - room), Math.min(1.03, e2 + room)];
  const share = e3 === undefined ? 1 : TO_SCALE;
  const [scale, rest] = [(share * (right - left)) / (to - from), ((1 - share) / share) * (to - from)];
  const squeezed = (u) => (u <= to ? u : to + (rest * (u - to)) / (u - to + rest));
  const unsqueezed = (x) => (x <= to ? x : to + (rest * (x - to)) / Math.max(1e-9, rest - (x - to)));
  const depth = (u) => potentialAt(u, [e1, e2, e3]);
  const size = Math.max(Math.abs(depth(0.5 * (e1 + e2))), 0.06 * room * room * (e3 === undefined ? 1 : e3 - e2), 1e-12);
  const zero = top + 0.45 * (bottom - top);
  return {
    x: (u) => left + (squeezed(u) - from) * scale,
    u: (x) => unsqueezed(from + (x - left) / scale),
    y: (u) => zero - (depth(u) / size) * 0.42 * (bottom - top),
    zero,
    range: [from, to],
    edges: [left, right, top, bottom],
  };
}

/** Layout at the start of a drag, kept until its end so that the axis does not move under the pointer. */
const dragged = { layout: null };

function drawPotential({ pen, size }, { scene, now, colours }) {
  const layout = dragged.layout ?? potentialLayout(size, scene.e);
  const { x, u, zero, range, edges: [left, right, top, bottom] } = layout;
  const depths = potentialLayout(size, scene.e);
  const y = (at) => depths.y(at);
  write(pen, colours.faint, "left");
  pen.fillText(scene.e.length > 2 ? "−(u − e₁)(u − e₂)(u − e₃)" : "(u − e₁)(u − e₂)", 6, 13);
  // vertical lines at u = -1 and u = 1, where the axis is vertical
  for (const wall of [-1, 1].filter((at) => at >= range[0])) {
    trace(pen, [[x(wall), top], [x(wall), bottom]]);
    stroke(pen, colours.grid, 1);
  }
  trace(pen, [[left, zero], [right, zero]]);
  stroke(pen, colours.faint, 1, [3, 3]);
  pen.beginPath();
  let isInside = false;
  for (let i = 0; i <= 300; i++) {
    const px = left + ((right - left - 1) * i) / 300;
    const py = y(u(px));
    const inside = py >= top && py <= bottom;
    if (inside && isInside) pen.lineTo(px, py);
    else if (inside) pen.moveTo(px, py);
    isInside = inside;
  }
  stroke(pen, colours.bound, 1.6);
  const [e1, e2] = scene.e;
  const well = Array.from({ length: 81 }, (_, i) => e1 + ((e2 - e1) * i) / 80).map((at) => [x(at), y(at)]);
  pen.globalAlpha = 0.16;
  trace(pen, well, true);
  pen.fillStyle = colours.axis;
  pen.fill();
  pen.globalAlpha = 1;
  trace(pen, well);
  stroke(pen, colours.axis, 2.2);
  write(pen, colours.faint, "center", 11);
  for (const at of ticksIn(Math.max(-1, range[0]), Math.min(1, range[1]), 5)) {
    trace(pen, [[x(at), bottom], [x(at), bottom + 4]]);
    stroke(pen, colours.faint, 1);
    pen.fillText(short(at, 4), x(at), bottom + 16);
  }
  pen.fillText("u = cos(tilt)", 0.5 * (left + x(range[1])), size[1] - 4);
  if (scene.e.length > 2) pen.fillText("not to scale", 0.5 * (x(range[1]) + right), size[1] - 4);
  scene.e.forEach((root, i) => {
    const close = i && Math.abs(x(root) - x(scene.e[i - 1])) < 17;
    // the name is beside the curve if there is enough space between e₁ and e₂
    const aside = x(scene.e[1]) - x(scene.e[0]) > 44 ? [9, -9, 9][i] : 0;
    disc(pen, [x(root), zero], 6.5, colours.card);
    pen.beginPath();
    pen.arc(x(root), zero, 6.5, 0, 2 * Math.PI);
    stroke(pen, colours.tip, 2);
    write(pen, colours.ink, "center", 12);
    pen.fillText(`e${"₁₂₃"[i]}`, x(root) + (close ? 0 : aside), close ? zero + 22 : zero - 11);
  });
  disc(pen, [x(now.axis[2]), y(now.axis[2])], 5, colours.axis);
}
