// A scene has what the pictures need of a motion besides its states: bounds, times, and the size of the body.

/** Line styles of the bounds in all pictures: solid, dashed, dotted. */
const DASHES = [[], [5, 4], [1, 4]];

/** Bounding circles of the tip curve in units of s, by name; none where the tip rests. */
function circlesOf({ regime, e1, e2, min_tilt_deg, max_tilt_deg }) {
  const radius = (tilt) => Math.max(0, Math.sin((tilt * Math.PI) / 180));
  const lower = { radius: radius(max_tilt_deg), name: "u = e₁", dash: DASHES[0] };
  const upper = { radius: radius(min_tilt_deg), name: "u = e₂", dash: DASHES[1] };
  if (isVertical(regime)) return [];
  if (regime === "regular_precession") return [{ ...upper, name: "u = e₁ = e₂" }];
  const circles = e1 < 0 && e2 > 0 ? [lower, upper, { radius: 1, name: "u = 0", dash: DASHES[2] }] : [lower, upper];
  return circles.filter((circle) => circle.radius > 1e-9);
}

/** Radius within which the plane has to be visible, in units of s. */
const greatestRadius = ({ circles }) => circles.reduce((most, { radius }) => Math.max(most, radius), circles.length ? 0 : 0.25);

/**
 * Number of parts in which the pictures draw a motion. It is greater near the separatrix, where the axis rests for most of the period and
 * falls in the rest. It is even in a period, so that a motion that begins at one turning point has a point at the other.
 */
function partsOf({ regime, period, natural_time, span }) {
  if (regime === "aperiodic") return 1600;
  if (regime !== "nutating") return 360;
  return Math.round(span / period) * 2 * Math.round(Math.max(24, Math.min(80, (30 * period) / natural_time)));
}

/** Initial speed, units of time in a second: once round in ten seconds, but slower if the body would rotate too fast for the eye. */
function speedOf({ spin, precession, span }) {
  return roundBelow(Math.min(span / 10, 30 / Math.max(1e-9, Math.hypot(spin, precession))));
}

/** Greatest radius of the drawn body, in units of s: that of a disc with this moment of inertia C, if the plane leaves space for it. */
function breadthOf({ support, A, C, s, p, e1 }) {
  if (support === 1) return Math.max(0.45, Math.min(0.8, Math.sqrt((4 * C) / Math.max(1e-3 * A, 2 * A - C))));
  const disc = Math.sqrt((2 * C) / (p * s));
  // seen from the tip, the greatest radius, at the height 1, has the greatest angle from the axis
  const room = (0.93 * e1) / Math.sqrt(Math.max(1e-9, 1 - e1 * e1));
  const most = room < 0.45 ? 0.7 : Math.min(0.82, room);
  return Math.max(0.45, Math.min(most, disc));
}

/**
 * Shape of the drawn body: `make` is its function and `size` the argument of that; `stick` are the ends of the visible part of the
 * axis, `middle` is the height of the middle, and `reach` the radius of the picture. Lengths are in units of s, or of a free body's size.
 */
function shapeOf(constants) {
  const { support, A, C } = constants;
  if (support === 2) {
    const slenderness = Math.sqrt(Math.max(0, 2 * A - C) / Math.max(C, 1e-6 * A));
    return { make: spheroid, size: slenderness, stick: [spheroidSize(slenderness)[0], 1.4], middle: 0, reach: 1.5 };
  }
  if (C === 0) return { make: pendulum, size: 0.2, stick: [1.2, 1.4], middle: 0.9, reach: 1.55 };
  return { make: support === 1 ? gyroscope : turnedTop, size: breadthOf(constants), stick: [1.7, 2.1], middle: 1.2, reach: 2.2 };
}

/** Last body that was made, which most changes of the motion do not change. */
let lastBody = {};

function bodyFor({ make, size }) {
  if (lastBody.make !== make || lastBody.size !== size) lastBody = { make, size, body: make(size) };
  return lastBody.body;
}

/** Direction of the angular momentum where it is constant and not 0; otherwise null. */
function momentumOf({ m_x, m_y, m_z }) {
  const size = Math.hypot(m_x, m_y, m_z);
  return size > 0 ? [m_x / size, m_y / size, m_z / size] : null;
}

function sceneOf(constants) {
  const { s, e1, e2, e3, span } = constants;
  const support = SUPPORTS[constants.support];
  const slides = support === "sliding";
  const shape = shapeOf(constants);
  return {
    constants,
    support,
    slides,
    scale: slides ? s : 1,
    e: isTorqueFree(constants) ? [e1, e2] : [e1, e2, e3],
    tilts: [constants.max_tilt_deg, constants.min_tilt_deg],
    momentum: momentumOf(constants),
    circles: circlesOf(constants),
    span,
    parts: partsOf(constants),
    speed: speedOf(constants),
    shape,
    body: bodyFor(shape),
  };
}
