// A top whose tip is held is drawn as a gyroscope on its stand.

/** Outline of axle, hub and wheel from the pivot up: heights and radii in units of the distance to the centre of mass. */
function wheelOutline(breadth) {
  const [inner, outer, half] = [0.8 * breadth, breadth, 0.1];
  return [
    [0, 0], [0.03, 0.035], [0.07, 0.045], [0.78, 0.045], [0.8, 0.13], [0.94, 0.13], [0.96, 0.16],
    [0.965, inner], [1 - half, inner + 0.02], [1 - half, outer - 0.02], [1 - 0.7 * half, outer],
    [1 + 0.7 * half, outer], [1 + half, outer - 0.02], [1 + half, inner + 0.02], [1.035, inner], [1.04, 0.16],
    [1.06, 0.13], [1.2, 0.13], [1.22, 0.045], [1.7, 0.045], [1.74, 0.03], [1.75, 0],
  ];
}

/** Colours of the wheel: a web with a stripe and four fields, a brass rim with a mark, a steel axle. */
function paintWheel(sector, radius, breadth) {
  const [stripe, brass] = [sector < SECTORS / 12, [201, 164, 84]];
  if (radius < 0.18) return PAINT.metal;
  if (radius > 0.78 * breadth) return stripe ? PAINT.mark : brass;
  if (stripe) return PAINT.mark;
  return sector % (SECTORS / 4) < SECTORS / 8 ? PAINT.red : PAINT.cream;
}

function gyroscope(breadth) {
  return bodyOf(wheelOutline(breadth), (_height, sector, radius) => paintWheel(sector, radius, breadth));
}

/** Height of the table below the stand, low enough for the body to pass above it. */
const TABLE_BELOW = -1.45;
/** Height of the arm for a body that hangs and never rises far. */
const ARM_ABOVE = 1.35;

/** Support of the tip: an arm above a hanging body, a bracket behind one that passes near its lowest position and rises, otherwise a post. */
function standOf({ e: [low, high] }) {
  if (low + high < -0.6) return "arm";
  return low < -0.75 ? "bracket" : "post";
}

/** Draws the stand, and a pin at the pivot. */
function drawStand(pen, camera, scene, colours) {
  const project = (point) => camera.project(point);
  const line = (points, width, style) => {
    trace(pen, points.map(project));
    stroke(pen, style, width * camera.scaleAt([0, 0, 0]));
  };
  const stand = standOf(scene);
  if (stand === "bracket") {
    const [x, y] = unit([camera.back[0], camera.back[1], 0]).map((part) => -1.3 * part);
    trace(pen, [[-0.25, -0.35], [0.25, -0.35], [0.25, 0.35], [-0.25, 0.35]].map(([u, z]) => project([x + u * camera.right[0], y + u * camera.right[1], z])), true);
    pen.fillStyle = colours.stand;
    pen.fill();
    for (const [width, style] of [[0.09, colours.stand], [0.03, colours.shine]]) line([[x, y, 0], [0, 0, 0]], width, style);
  } else if (stand === "arm") {
    const { reach } = scene.shape;
    const [x, y, foot] = [-0.8 * reach * camera.right[0], -0.8 * reach * camera.right[1], -0.95 * reach];
    trace(pen, circle(0.18 * reach, foot).map(([u, v, z]) => project([x + u, y + v, z])), true);
    pen.fillStyle = colours.stand;
    pen.fill();
    for (const [width, style] of [[0.09, colours.stand], [0.03, colours.shine]]) {
      line([[x, y, foot], [x, y, ARM_ABOVE], [0, 0, ARM_ABOVE], [0, 0, 0]], width, style);
    }
  } else {
    for (const [radius, height] of [[0.62, TABLE_BELOW], [0.55, TABLE_BELOW + 0.08], [0.16, TABLE_BELOW + 0.16]]) {
      trace(pen, circle(radius, height).map(project), true);
      pen.fillStyle = colours.stand;
      pen.fill();
      stroke(pen, colours.shine, 0.7);
    }
    line([[0, 0, TABLE_BELOW + 0.1], [0, 0, -0.06]], 0.1, colours.stand);
    line([[0, 0, TABLE_BELOW + 0.1], [0, 0, -0.06]], 0.03, colours.shine);
  }
  disc(pen, project([0, 0, 0]), 0.075 * camera.scaleAt([0, 0, 0]), colours.pin);
}
