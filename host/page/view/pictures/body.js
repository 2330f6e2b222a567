// Top, pendulum and spheroid are drawn as bodies of revolution, whose marks show the spin.

/** Outline of the top from the tip up: heights in units of s (the centre of mass is at 1), radii in units of the greatest. */
const OUTLINE = [
  [0, 0], [0.02, 0.035], [0.1, 0.05], [0.3, 0.13], [0.5, 0.3], [0.68, 0.58], [0.8, 0.84], [0.9, 0.97], [0.99, 1],
  [1.07, 0.955], [1.14, 0.83], [1.2, 0.62], [1.25, 0.36], [1.3, 0.2],
];
/** Outline of the stem above it: heights and radii in units of s. */
const STEM = [[1.36, 0.085], [1.5, 0.065], [1.68, 0.062], [1.74, 0.085], [1.79, 0.09], [1.83, 0.075], [1.85, 0]];
const STEM_FROM = 1.3;

const SECTORS = 48;
/** Number of sectors that a face covers, by its radius, so that its edge is at most 0.01 from the circle. */
const sectorsAt = (radius) => (radius < 0.14 ? 4 : radius < 0.5 ? 2 : 1);
const PAINT = { red: [196, 58, 43], cream: [246, 232, 202], wood: [205, 152, 92], metal: [150, 158, 168], mark: [38, 84, 160] };

/** Colour at a height and a sector: rings, which look the same at every angle, and petals and a stripe, which show the rotation. */
function paint(height, sector) {
  if (height < 0.09) return PAINT.metal;
  if (height > STEM_FROM - 0.02) return PAINT.wood;
  const stripe = sector < SECTORS / 12;
  if (height > 0.9 && height < 0.985) return stripe ? PAINT.mark : PAINT.cream;
  if (height > 1.06 && height < 1.22) {
    if (stripe) return PAINT.mark;
    return sector % (SECTORS / 6) < SECTORS / 12 ? PAINT.cream : PAINT.red;
  }
  if (stripe && height > 0.3 && height < 1.22) return PAINT.mark;
  if (height > 0.36 && height < 0.46) return PAINT.cream;
  return PAINT.red;
}

/** Catmull-Rom spline through the points of an outline, in parts of about this length. */
function smooth(points, length) {
  const at = (i) => points[Math.max(0, Math.min(points.length - 1, i))];
  const between = (i, t) =>
    [0, 1].map((k) => {
      const [p, q, r, s] = [at(i - 1)[k], at(i)[k], at(i + 1)[k], at(i + 2)[k]];
      return q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)));
    });
  const stretches = points.slice(1).map(([z, r], i) => {
    const parts = Math.ceil(Math.hypot(z - points[i][0], r - points[i][1]) / length);
    return Array.from({ length: parts }, (_, j) => between(i, j / parts));
  });
  return [...stretches.flat(), points[points.length - 1]];
}

/** Body of revolution in body coordinates: rings of points, all points, and faces, whose corners are indices of points. */
function bodyOf(outline, colourAt) {
  const angle = (sector) => (2 * Math.PI * (sector - SECTORS / 24)) / SECTORS;
  const ring = ([z, r]) => Array.from({ length: SECTORS }, (_, i) => [r * Math.cos(angle(i)), r * Math.sin(angle(i)), z]);
  const rings = outline.map(ring);
  const faces = [];
  for (let i = 0; i + 1 < rings.length; i++) {
    const [[z0, r0], [z1, r1]] = [outline[i], outline[i + 1]];
    if (z1 === z0 && r1 === r0) continue;
    const width = sectorsAt(Math.max(r0, r1));
    for (let j = 0; j < SECTORS; j += width) {
      const middle = angle(j + 0.5 * width);
      const normal = unit([(z1 - z0) * Math.cos(middle), (z1 - z0) * Math.sin(middle), r0 - r1]);
      const next = (j + width) % SECTORS;
      const corners = [[i, j], [i, next], [i + 1, next], [i + 1, j]].map(([row, sector]) => SECTORS * row + sector);
      faces.push({ corners, normal, colour: colourAt((z0 + z1) / 2, j, (r0 + r1) / 2) });
    }
  }
  return { rings, points: rings.flat(), faces };
}

/** Top with this greatest radius, in units of s. */
function turnedTop(breadth) {
  const outline = smooth([...OUTLINE.map(([z, r]) => [z, Math.max(r * breadth, z > 1 ? 0.09 : 0)]), ...STEM], 0.085);
  return bodyOf(outline, paint);
}

/** Rod with a ball at its end, which is drawn for a body without an axial moment of inertia. */
function pendulum() {
  const ball = Array.from({ length: 15 }, (_, i) => (Math.PI * (i / 14 - 0.5))).map((t) => [1 + 0.2 * Math.sin(t), Math.max(0.03, 0.2 * Math.cos(t))]);
  return bodyOf([[0, 0], [0.02, 0.03], [0.4, 0.03], ...ball, [1.2, 0]], (height, sector) => {
    if (height < 0.81) return PAINT.metal;
    return sector < SECTORS / 12 ? PAINT.mark : PAINT.red;
  });
}

/** Half the height and the radius of a spheroid, from their quotient; the larger is 1. */
const spheroidSize = (slenderness) => [Math.max(0.05, Math.min(1, slenderness)), Math.max(0.05, Math.min(1, 1 / slenderness))];

/** Free body: a homogeneous spheroid about its centre of mass, with this quotient of half the height and the radius. */
function spheroid(slenderness) {
  const [half, radius] = spheroidSize(slenderness);
  const outline = Array.from({ length: 25 }, (_, i) => Math.PI * (i / 24 - 0.5)).map((t) => [half * Math.sin(t), radius * Math.cos(t)]);
  return bodyOf(outline, (height, sector, r) => {
    if (sector < SECTORS / 12) return PAINT.mark;
    const isOdd = (sector % (SECTORS / 4) < SECTORS / 8) !== height < 0;
    return r < 0.25 * radius ? PAINT.wood : isOdd ? PAINT.cream : PAINT.red;
  });
}

/** Direction of the light: from above, and a little from the viewer's left. */
function light(camera) {
  return unit(sum(sum([0, 0, 0.9], camera.back, 0.55), camera.right, -0.6));
}

/**
 * Visible faces, the farthest first. `toSpace` takes points from body to fixed coordinates, and `rotate` directions. The loops of this
 * file visit hundreds of faces for each picture; they make few temporary arrays, for speed.
 */
function seenFaces(camera, body, { toSpace, rotate }) {
  const space = body.points.map(toSpace);
  const pixels = space.map((point) => camera.project(point));
  const seen = [];
  for (const face of body.faces) {
    const [first, , third] = face.corners;
    const [p, q] = [space[first], space[third]];
    const n = rotate(face.normal);
    if (dot(n, camera.position) > 0.5 * (dot(n, p) + dot(n, q))) seen.push({ face, n, depth: pixels[first][2] + pixels[third][2] });
  }
  return { space, pixels, seen: seen.sort((a, b) => b.depth - a.depth) };
}

/** Part of a face above the plane (side 1) or below it (side -1). */
function cut(points, side) {
  return points.flatMap((p, i) => {
    const q = points[(i + 1) % points.length];
    const kept = side * p[2] >= 0 ? [p] : [];
    return p[2] * q[2] < 0 ? [...kept, sum(p, sum(q, p, -1), p[2] / (p[2] - q[2]))] : kept;
  });
}

/** Outline, in pixels, of the part of a face on this side of the plane; side 0 is the whole face. */
function outlineOf(camera, { space, pixels }, { corners }, side) {
  let within = 0;
  for (const corner of corners) {
    if (side * space[corner][2] >= 0) within++;
  }
  if (within === corners.length) return corners.map((corner) => pixels[corner]);
  if (within === 0) return [];
  const part = cut(corners.map((corner) => space[corner]), side);
  return part.map((point) => camera.project(point));
}

/** Path of a face that is enlarged a little, because otherwise the background would show between two faces. */
function traceFace(pen, outline) {
  let [middleX, middleY] = [0, 0];
  for (const corner of outline) {
    middleX += corner[0] / outline.length;
    middleY += corner[1] / outline.length;
  }
  pen.beginPath();
  for (const corner of outline) {
    const dx = corner[0] - middleX;
    const dy = corner[1] - middleY;
    const share = 1 + 0.8 / Math.max(0.2, Math.sqrt(dx * dx + dy * dy));
    pen.lineTo(middleX + share * dx, middleY + share * dy);
  }
  pen.closePath();
}

function drawFaces(pen, camera, faces, side) {
  const lamp = light(camera);
  const half = unit(sum(lamp, camera.back));
  for (const { face, n } of faces.seen) {
    const outline = outlineOf(camera, faces, face, side);
    if (outline.length < 3) continue;
    const diffuse = 0.42 + 0.46 * Math.max(0, dot(n, lamp)) + 0.12 * Math.max(0, dot(n, camera.back));
    const gloss = 46 * Math.max(0, dot(n, half)) ** 22;
    const [r, g, b] = face.colour;
    const shade = (part) => Math.min(255, part * diffuse + gloss);
    pen.fillStyle = `#${(0x1000000 + (shade(r) << 16) + (shade(g) << 8) + (shade(b) | 0)).toString(16).slice(1)}`;
    traceFace(pen, outline);
    pen.fill();
  }
}

/** Draws the shadow of the body on the plane, with the light vertically above. */
function drawShadow(pen, camera, body, toSpace, style) {
  pen.beginPath();
  for (const ring of body.rings.filter((_, i) => i % 2 === 1)) {
    ring.map(toSpace).forEach(([x, y], i) => {
      const [a, b] = camera.project([x, y, 0]);
      if (i) pen.lineTo(a, b);
      else pen.moveTo(a, b);
    });
    pen.closePath();
  }
  pen.fillStyle = style;
  pen.fill("nonzero");
}

/** Draws the comparison top: some rings of the body and its axis, without faces. */
function drawComparison(pen, camera, body, toSpace, style) {
  const last = body.rings.length - 1;
  for (const ring of body.rings.filter((_, i) => i % 3 === 1)) {
    trace(pen, ring.map((point) => camera.project(toSpace(point))), true);
    stroke(pen, style, 0.8);
  }
  for (let sector = 0; sector < SECTORS; sector += SECTORS / 6) {
    trace(pen, body.rings.map((ring) => camera.project(toSpace(ring[sector]))));
    stroke(pen, style, 0.8);
  }
  trace(pen, [body.rings[0][0], body.rings[last][0]].map((point) => camera.project(toSpace(point))));
  stroke(pen, style, 1.6, [5, 4]);
}
