// The three pictures: the top on its plane, the plane from above, the axis on the unit sphere.

/** Lengths are in units of s; for a tip that is held, of the axis as it is drawn. */
function motionOf(scene, table) {
  const length = table.tip_scale / 2;
  const at = (tick) => {
    const moment = momentAt(table, tick);
    const rotate = rotation(moment);
    // the tip of a held top stays; what moves on the plane is the foot of its axis
    const foot = scene.held ? rotate.axis.slice(0, 2) : moment.tip.map((x) => x / length);
    return { moment, rotate, axis: rotate.axis, foot };
  };
  const base = ({ foot: [x, y] }) => (scene.held ? [0, 0, 0] : [x, y, 0]);
  return { at, base, end: (now) => sum(base(now), now.axis, END) };
}

/** How far out the plane has to be seen. */
function widest(scene) {
  return scene.circles.reduce((most, { radius }) => Math.max(most, radius), scene.circles.length ? 0 : 0.25);
}

/** What all pictures draw the bounds with: whole, dashed, dotted as in `toytop plot`. */
const DASHES = [[], [5, 4], [1, 4]];

/** The top on its plane. */
function drawScene(canvas, { scene, motion, body, now, past, view, colours }) {
  const { pen, size } = sheet(canvas);
  const [low, high] = scene.e.slice(0, 2);
    const target = [0, 0, 0.5 * (low + high) * (scene.held ? 1 : 0.92)];
  const camera = new Camera(view, target, (scene.held ? 1.5 : 1.42) + 0.25 * (high - low), size);
  const place = (point) => sum(motion.base(now), now.rotate(point));
  const onPlane = ([x, y]) => camera.project([x, y, 0]);
  const project = (point) => camera.project(point);
  const radius = Math.max(1.28 * widest(scene), 1.15 * scene.breadth, scene.held ? 1.25 : 0.9);

  const faces = seenFaces(camera, body, { place, rotate: now.rotate });
  // what is below the plane is seen through it
  drawFaces(pen, camera, faces, -1);
  trace(pen, circle(radius, 0).map(project), true);
  const [left, right] = [onPlane([0, 0])[1] - 0.25 * size[1], onPlane([0, 0])[1] + 0.3 * size[1]];
  const shade = pen.createLinearGradient(0, left, 0, right);
  shade.addColorStop(0, colours.ground);
  shade.addColorStop(1, colours.rim);
  pen.globalAlpha = 0.86;
  pen.fillStyle = shade;
  pen.fill();
  pen.globalAlpha = 1;
  stroke(pen, colours.grid, 1.2);
  for (let r = 0.25; r < radius; r += 0.25) {
    trace(pen, circle(r, 0).map(project));
    stroke(pen, colours.grid, 0.6);
  }
  for (let spoke = 0; spoke < 12; spoke++) {
    const [c, s] = [Math.cos((spoke * Math.PI) / 6), Math.sin((spoke * Math.PI) / 6)];
    trace(pen, [onPlane([0.25 * c, 0.25 * s]), onPlane([radius * c, radius * s])]);
    stroke(pen, colours.grid, 0.6);
  }
  pen.save();
  trace(pen, circle(radius, 0).map(project), true);
  pen.clip();
  if (now.axis[2] > 0.15) drawShadow(pen, camera, body, place, "rgb(0 0 0 / 0.1)");
  pen.restore();
  scene.circles.forEach((bound, i) => {
    trace(pen, circle(bound.radius, 0).map(project));
    stroke(pen, colours.bound, 1.4, DASHES[i]);
  });
  fading(pen, past.map(({ foot }) => onPlane(foot)), colours.tip, 2.6);
  disc(pen, onPlane(now.foot), 3.2, colours.tip);

  // the vertical over the origin, on which the centre of mass goes up and down
  const vertical = [[0, 0, 0], [0, 0, scene.held ? END : 1.9]].map(project);
  trace(pen, vertical);
  stroke(pen, colours.faint, 1.2, [2, 4]);

  const ends = past.map((moment) => project(motion.end(moment)));
  const depth = project(place([0, 0, 1.2]))[2];
  fading(pen, ends, colours.axis, 1.8, ([, , far]) => (far >= depth ? 0.9 : 0));
  const axis = [place([0, 0, 1.8]), motion.end(now)].map(project);
  const stick = () => {
    trace(pen, axis);
    stroke(pen, colours.ink, 1.6);
    disc(pen, axis[1], 3.6, colours.axis);
  };
  const leansAway = axis[1][2] > depth;
  if (leansAway) stick();
  drawFaces(pen, camera, faces, 1);
  if (!leansAway) stick();
  pen.globalAlpha = 0.3;
  trace(pen, vertical);
  stroke(pen, colours.faint, 1, [2, 4]);
  pen.globalAlpha = 1;
  fading(pen, ends, colours.axis, 1.8, ([, , far]) => (far < depth ? 0.9 : 0));
}

/** The plane from above, with the bounds by name. */
function drawPlan(canvas, { scene, now, past, colours }) {
  const { pen, size: [width, height] } = sheet(canvas);
  const scale = (0.5 * Math.min(width, height) - 22) / (widest(scene) || 1);
  const place = ([x, y]) => [0.5 * width + scale * x, 0.5 * height - scale * y];
  const [cx, cy] = place([0, 0]);
  trace(pen, [[cx - 5, cy], [cx + 5, cy]]);
  stroke(pen, colours.faint, 1);
  trace(pen, [[cx, cy - 5], [cx, cy + 5]]);
  stroke(pen, colours.faint, 1);
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.fillStyle = colours.faint;
  scene.circles.forEach(({ radius, name }, i) => {
    trace(pen, circle(radius, 0).map(place), true);
    stroke(pen, colours.bound, 1.2, DASHES[i]);
    // outside the largest; inside the others, where the curve is not, above or below
    if (radius >= widest(scene)) pen.fillText(name, cx, cy - scale * radius - 6);
    else if (scale * radius > 34) pen.fillText(name, cx, i ? cy - scale * radius + 15 : cy + scale * radius - 7);
  });
  fading(pen, past.map(({ foot }) => place(foot)), colours.tip, 2);
  disc(pen, place(now.foot), 4, colours.tip);
}

/** The end of the axis on the unit sphere, from where the top is looked at. */
function drawSphere(canvas, { scene, now, past, view, colours }) {
  const { pen, size } = sheet(canvas);
  // from higher up: most tops are near the upper pole
  const camera = new Camera({ ...view, elevation: Math.min(1.5, view.elevation + 0.4) }, [0, 0, 0], 1.09, size);
  const project = (point) => camera.project(point);
  // a point of the sphere is seen if it is before the circle where lines of sight touch
  const seen = (point) => dot(point, camera.position) >= 1;
  const edge = camera.focus / Math.sqrt(camera.distance ** 2 - 1);
  const [cx, cy] = camera.middle;
  const shade = pen.createRadialGradient(cx - 0.35 * edge, cy - 0.45 * edge, 0.1 * edge, cx, cy, edge);
  shade.addColorStop(0, colours.ground);
  shade.addColorStop(1, colours.sphere);
  disc(pen, [cx, cy], edge, shade);
  const onSphere = (points, style, width, dash) => {
    for (const [front, alpha] of [[false, 0.25], [true, 1]]) {
      pen.globalAlpha = alpha;
      pen.beginPath();
      points.forEach((point, i) => {
        const [x, y] = project(point);
        if (i && seen(point) === front) pen.lineTo(x, y);
        else pen.moveTo(x, y);
      });
      stroke(pen, style, width, dash);
    }
    pen.globalAlpha = 1;
  };
  const parallel = (u) => circle(Math.sqrt(Math.max(0, 1 - u * u)), u);
  [-60, -30, 0, 30, 60].forEach((degrees) => onSphere(parallel(Math.sin((degrees * Math.PI) / 180)), colours.grid, 0.7));
  [0, 30, 60, 90, 120, 150].forEach((degrees) => {
    const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    onSphere(circle(1, 0).map(([x, y]) => [x * c, x * s, y]), colours.grid, 0.7);
  });
  [...new Set(scene.e.slice(0, 2))].forEach((u, i) => onSphere(parallel(u), colours.bound, 1.3, DASHES[i]));
  const places = past.map(({ axis }) => [...project(axis), seen(axis)]);
  for (const front of [false, true]) {
    fading(pen, places, colours.axis, 2, (place) => (place[3] === front ? (front ? 1 : 0.3) : 0));
  }
  const tip = project(now.axis);
  trace(pen, [project([0, 0, 0]), tip]);
  stroke(pen, colours.ink, 1.3);
  disc(pen, project([0, 0, 0]), 2.2, colours.ink);
  disc(pen, tip, 4, colours.axis);
}
