// The 3-D picture shows the top on its plane, the gyroscope on its stand, or the free body.

/** Position of the tip in units of s; the tip of a held top and the centre of mass of a free body are at the origin. */
const baseOf = (scene, { foot: [x, y] }) => (scene.slides ? [x, y, 0] : [0, 0, 0]);
const endOf = (scene, state) => sum(baseOf(scene, state), state.axis, scene.shape.stick[1]);
function cameraOf({ scene, view }, size) {
  const [low, high] = scene.e;
  const gap = 0.25 * (high - low);
  const { reach } = scene.shape;
  if (scene.support === "free") return new Camera(view, [0, 0, 0], reach, size);
  if (!scene.slides) return new Camera(view, [0, 0, { arm: -0.3, bracket: 0, post: 0.2 }[standOf(scene)]], reach, size);
  return new Camera(view, [0, 0, 0.46 * (low + high)], 1.42 + gap, size);
}

/** Draws the plane at a height, as a disc with rings and spokes. */
function drawPlane(pen, project, size, colours, radius, height) {
  const rim = circle(radius, height).map(project);
  const [, middle] = project([0, 0, height]);
  const shade = pen.createLinearGradient(0, middle - 0.25 * size[1], 0, middle + 0.3 * size[1]);
  shade.addColorStop(0, colours.ground);
  shade.addColorStop(1, colours.rim);
  trace(pen, rim, true);
  pen.globalAlpha = 0.86;
  pen.fillStyle = shade;
  pen.fill();
  pen.globalAlpha = 1;
  stroke(pen, colours.grid, 1.2);
  for (let r = 0.25; r < radius; r += 0.25) {
    trace(pen, circle(r, height, 72).map(project));
    stroke(pen, colours.grid, 0.6);
  }
  for (let spoke = 0; spoke < 12; spoke++) {
    const [c, s] = [Math.cos((spoke * Math.PI) / 6), Math.sin((spoke * Math.PI) / 6)];
    trace(pen, [project([0.25 * c, 0.25 * s, height]), project([radius * c, radius * s, height])]);
    stroke(pen, colours.grid, 0.6);
  }
}

function drawScene(canvas, frame) {
  const { scene, now, colours } = frame;
  const { pen, size } = sheet(canvas, colours.card);
  const camera = cameraOf(frame, size);
  const base = baseOf(scene, now);
  const toSpace = (point) => sum(base, now.rotate(point));
  const faces = seenFaces(camera, scene.body, { toSpace, rotate: now.rotate });
  if (scene.slides) drawSliding(pen, size, camera, frame, faces, toSpace);
  else drawAround(pen, size, camera, frame, faces);
  if (frame.comparison) {
    const { comparison } = frame;
    drawComparison(pen, camera, scene.body, (point) => sum(baseOf(scene, comparison), comparison.rotate(point)), colours.comparison);
  }
}

function drawSliding(pen, size, camera, frame, faces, toSpace) {
  const { scene, now, past, colours } = frame;
  const project = (point) => camera.project(point);
  const onPlane = ([x, y]) => camera.project([x, y, 0]);
  const radius = Math.max(1.28 * greatestRadius(scene), 1.15 * scene.shape.size, 0.9);
  // the plane is transparent: parts below it are drawn first
  drawFaces(pen, camera, faces, -1);
  drawPlane(pen, project, size, colours, radius, 0);
  pen.save();
  trace(pen, circle(radius, 0).map(project), true);
  pen.clip();
  if (now.axis[2] > 0.15) drawShadow(pen, camera, scene.body, toSpace, "rgb(0 0 0 / 0.1)");
  pen.restore();
  scene.circles.forEach(({ radius: bound, dash }) => {
    trace(pen, circle(bound, 0).map(project));
    stroke(pen, colours.bound, 1.4, dash);
  });
  fading(pen, past.map(({ foot }) => onPlane(foot)), colours.tip, 2.6);
  disc(pen, onPlane(now.foot), 3.2, colours.tip);
  // the vertical line along which the centre of mass moves
  const vertical = [[0, 0, 0], [0, 0, 1.9]].map(project);
  trace(pen, vertical);
  stroke(pen, colours.faint, 1.2, [2, 4]);
  drawBody(pen, camera, frame, faces, 1);
  pen.globalAlpha = 0.3;
  trace(pen, vertical);
  stroke(pen, colours.faint, 1, [2, 4]);
  pen.globalAlpha = 1;
}

/** Draws a body that rotates about a point: its tip on a stand, or its centre of mass in the air. */
function drawAround(pen, size, camera, frame, faces) {
  const { scene, now, colours } = frame;
  const project = (point) => camera.project(point);
  const end = scene.shape.stick[1];
  const stand = scene.support === "free" ? null : standOf(scene);
  if (stand === "post") drawPlane(pen, project, size, colours, 1.1, TABLE_BELOW);
  scene.e.slice(0, 2).forEach((u, i) => {
    trace(pen, circle(end * Math.sqrt(Math.max(0, 1 - u * u)), end * u).map(project));
    stroke(pen, colours.bound, 1.2, DASHES[i]);
  });
  const momentum = (from, to) => {
    if (!scene.momentum) return;
    trace(pen, [from, to].map((length) => project(scene.momentum.map((part) => length * part))));
    stroke(pen, colours.pin, 2, [1, 5]);
  };
  // the stand is behind a body that leans towards the viewer; a bracket is always behind
  const isBehind = stand === "bracket" || dot(now.axis, camera.back) > 0;
  const [near, far] = scene.momentum && dot(scene.momentum, camera.back) > 0 ? [end, -end] : [-end, end];
  momentum(0, far);
  if (stand && isBehind) drawStand(pen, camera, scene, colours);
  drawBody(pen, camera, frame, faces, 0);
  if (stand && !isBehind) drawStand(pen, camera, scene, colours);
  momentum(0, near);
}

/** Draws the body with its axis, after the part of the axis' trail behind it and before the part in front of it. Side 1 is above the plane. */
function drawBody(pen, camera, { scene, now, past, colours }, faces, side) {
  const project = (point) => camera.project(point);
  const toSpace = (point) => sum(baseOf(scene, now), now.rotate(point));
  const ends = past.map((point) => project(endOf(scene, point)));
  const { stick: [from], middle } = scene.shape;
  const depth = project(toSpace([0, 0, middle]))[2];
  fading(pen, ends, colours.axis, 1.8, ([, , far]) => (far >= depth ? 0.9 : 0));
  const axis = [toSpace([0, 0, from]), endOf(scene, now)].map(project);
  const stick = () => {
    trace(pen, axis);
    stroke(pen, colours.ink, 1.6);
    disc(pen, axis[1], 3.6, colours.axis);
  };
  const leansAway = axis[1][2] > depth;
  if (leansAway) stick();
  drawFaces(pen, camera, faces, side);
  if (!leansAway) stick();
  fading(pen, ends, colours.axis, 1.8, ([, , far]) => (far < depth ? 0.9 : 0));
}
