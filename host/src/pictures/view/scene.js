// Properties of a motion that the pictures need besides its states: bounds, times, and the size of the body.

/** Bounding circles of the tip curve in units of s, by name; none where the tip rests. */
function circlesOf({ regime, e1, e2, one_plus_e1, one_minus_e2 }) {
  const radius = (plus, minus) => Math.sqrt(Math.max(0, plus * minus));
  const lower = { radius: radius(one_plus_e1, 2 - one_plus_e1), name: "u = e₁", dash: DASHES[0] };
  const upper = { radius: radius(2 - one_minus_e2, one_minus_e2), name: "u = e₂", dash: DASHES[1] };
  if (isVertical(regime)) return [];
  if (regime === "regular_precession") return [{ ...upper, name: "u = e₁ = e₂" }];
  const circles = e1 < 0 && e2 > 0 ? [lower, upper, { radius: 1, name: "u = 0", dash: DASHES[2] }] : [lower, upper];
  return circles.filter(({ radius }) => radius > 0);
}

const isVertical = (regime) => regime.startsWith("sleeping") || regime === "hanging";

/**
 * Number of parts in which a period is drawn. It is greater near the separatrix, where the axis rests for most of the period and falls
 * in the rest. It is even, so that a motion that begins at one turning point has a point at the other.
 */
const partsOf = ({ period, natural_time }) => 2 * Math.round(Math.max(24, Math.min(80, (30 * period) / natural_time)));

/** Time that a curve covers, s, and its number of parts: once round the centre, within limits. */
function spanOf(shown, core) {
  const { regime, period, phi_per_period, natural_time } = shown;
  const round = (2 * Math.PI) / Math.abs(phi_per_period);
  if (regime === "nutating") {
    const periods = round > 96 ? 3 : Math.max(3, Math.min(24, Math.ceil(round)));
    return { span: periods * period, parts: periods * partsOf(shown) };
  }
  if (regime === "aperiodic") return { span: riseOf(core, natural_time), parts: 1600 };
  const once = round * period;
  return { span: !isVertical(regime) && once > 0 && Number.isFinite(once) ? once : natural_time, parts: 360 };
}

/** Time after which the axis of an aperiodic motion remains near the vertical, s. */
function riseOf(core, natural) {
  const step = 0.25 * natural;
  const curve = core.curve(0, step, MOST_POINTS - 1);
  for (let i = MOST_POINTS - 2; i > 0; i--) {
    if (Math.hypot(curve[COORDINATES * i], curve[COORDINATES * i + 1]) > 4e-3) return step * (i + 1);
  }
  return step;
}

/** Initial speed, units of time in a second: once round in ten seconds, but slower if the body would rotate too fast for the eye. */
function speedOf({ spin, precession }, span) {
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
function shapeOf(shown) {
  const { support, A, C } = shown;
  if (support === 2) {
    const slenderness = Math.sqrt(Math.max(0, 2 * A - C) / Math.max(C, 1e-6 * A));
    return { make: spheroid, size: slenderness, stick: [spheroidSize(slenderness)[0], 1.4], middle: 0, reach: 1.5 };
  }
  if (C === 0) return { make: pendulum, size: 0.2, stick: [1.2, 1.4], middle: 0.9, reach: 1.55 };
  return { make: support === 1 ? gyroscope : turnOnLathe, size: breadthOf(shown), stick: [1.7, 2.1], middle: 1.2, reach: 2.2 };
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

function sceneOf(shown, core) {
  const { s, e1, e2, e3 } = shown;
  const support = SUPPORTS[shown.support];
  const slides = support === "sliding";
  const [shape, stretch] = [shapeOf(shown), spanOf(shown, core)];
  return {
    shown,
    support,
    slides,
    scale: slides ? s : 1,
    e: isTorqueFree(shown) ? [e1, e2] : [e1, e2, e3],
    momentum: momentumOf(shown),
    circles: circlesOf(shown),
    ...stretch,
    speed: speedOf(shown, stretch.span),
    shape,
    body: bodyFor(shape),
  };
}
