// What the pictures need to know of a motion besides its moments: bounds, times, and the size of the body.

/** Bounding circles of the tip curve in units of s, by name; none where the tip rests. */
function circlesOf({ regime, e1, e2, one_plus_e1, one_minus_e2 }) {
  const radius = (plus, minus) => Math.sqrt(Math.max(0, plus * minus));
  const lower = { radius: radius(one_plus_e1, 2 - one_plus_e1), name: "u = e₁" };
  const upper = { radius: radius(2 - one_minus_e2, one_minus_e2), name: "u = e₂" };
  if (isVertical(regime)) return [];
  if (regime === "regular_precession") return [{ ...upper, name: "u = e₁ = e₂" }];
  const circles = e1 < 0 && e2 > 0 ? [lower, upper, { radius: 1, name: "u = 0" }] : [lower, upper];
  return circles.filter(({ radius }) => radius > 0);
}

const isVertical = (regime) => regime.startsWith("sleeping") || regime === "hanging";

/** How long a curve is followed, s, and in how many parts: once round the centre, within bounds. */
function spanOf(shown, core) {
  const { regime, period, phi_per_period, natural_time } = shown;
  const round = (2 * Math.PI) / Math.abs(phi_per_period);
  if (regime === "nutating") {
    const periods = round > 96 ? 3 : Math.max(3, Math.min(24, Math.ceil(round)));
    return { span: periods * period, parts: Math.min(MOST_POINTS - 1, periods * 80) };
  }
  if (regime === "aperiodic") return { span: riseOf(core, natural_time), parts: 1600 };
  const once = round * period;
  return { span: !isVertical(regime) && once > 0 && Number.isFinite(once) ? once : natural_time, parts: 360 };
}

/** How long until an aperiodic motion has come to the vertical for good. */
function riseOf(core, natural) {
  const step = 0.25 * natural;
  const curve = core.curve(0, step, MOST_POINTS - 1);
  for (let i = MOST_POINTS - 2; i > 0; i--) {
    if (Math.hypot(curve[COORDINATES * i], curve[COORDINATES * i + 1]) > 4e-3) return step * (i + 1);
  }
  return step;
}

/** Units of time a second at first: once round in ten seconds, where the body does not turn too fast for the eye. */
function speedOf({ spin, precession }, span) {
  return roundBelow(Math.min(span / 10, 30 / Math.max(1e-9, Math.hypot(spin, precession))));
}

/** The greatest radius of the body that is drawn, in units of s: that of a disc with this C/A, where there is room. */
function breadthOf({ held, A, C, s, p, e1 }) {
  if (held) return Math.max(0.45, Math.min(0.8, Math.sqrt((4 * C) / Math.max(1e-3 * A, 2 * A - C))));
  const disc = Math.sqrt((2 * C) / (p * s));
  // no point of the outline is wider, seen from the tip, than its greatest radius at the height 1
  const room = (0.93 * e1) / Math.sqrt(Math.max(1e-9, 1 - e1 * e1));
  const most = room < 0.45 ? 0.7 : Math.min(0.82, room);
  return Math.max(0.45, Math.min(most, disc));
}

/** The body that was made last: most changes keep it. */
let lastBody = {};

function bodyFor(isHeld, breadth) {
  if (lastBody.isHeld !== isHeld || lastBody.breadth !== breadth) {
    lastBody = { isHeld, breadth, body: isHeld ? gyroscope(breadth) : turnOnLathe(breadth) };
  }
  return lastBody.body;
}

function sceneOf(shown, core) {
  const { held, s, e1, e2, e3 } = shown;
  const [breadth, stretch] = [breadthOf(shown), spanOf(shown, core)];
  return {
    shown,
    held: held === 1,
    scale: held === 1 ? 1 : s,
    e: [e1, e2, e3],
    circles: circlesOf(shown),
    ...stretch,
    speed: speedOf(shown, stretch.span),
    breadth,
    body: bodyFor(held === 1, breadth),
  };
}
