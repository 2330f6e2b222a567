// The charts show tilt and precession against time, over the interval that the slider covers.

/** Multiples of a round step in a range, about `most` or fewer. */
function ticksIn(low, high, most) {
  const step = roundBelow((2.5 * (high - low)) / most) || 1;
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(high / step + 1e-9) - first + 1) }, (_, i) => (first + i) * step);
}

/** Angles continued from point to point over whole turns, or over half turns where the axis passes the vertical, in degrees. */
function continued(angles, unit = 2 * Math.PI) {
  let last = angles.find((angle) => !Number.isNaN(angle)) ?? 0;
  return angles.map((angle) => {
    if (!Number.isNaN(angle)) last = angle - unit * Math.round((angle - last) / unit);
    return degrees(last);
  });
}

const passesVertical = ({ tipClass }) => ["through_origin", "spiral"].includes(tipClass);

/** Azimuth of an axis; NaN where it is vertical but for roundings. */
const azimuthOrNaN = ([x, y]) => (Math.hypot(x, y) < 1e-9 ? NaN : azimuthOf([x, y]));

/** Range of the values with a margin, never empty. */
function withMargin(values) {
  const [low, high] = values.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
  const room = Math.max(0.08 * (high - low), 1e-6 * Math.max(1, Math.abs(high)), high - low < 1e-9 ? 1 : 0);
  return [low - room, high + room];
}

const CHARTS = {
  tilt: { name: "tilt in °", values: ({ points }) => points.map(({ axis }) => tiltOf(axis)) },
  precession: {
    name: "azimuth of the axis in °",
    values: ({ points }, constants) => continued(points.map(({ axis }) => azimuthOrNaN(axis)), passesVertical(constants) ? Math.PI : undefined),
  },
};

function drawChart({ pen, size: [width, height] }, { scene, scenario, interval, t, colours }, kind) {
  if (kind === "precession" && isVertical(scene.constants.regime)) {
    write(pen, colours.faint, "center");
    pen.fillText("The axis is vertical: it has no azimuth.", 0.5 * width, 0.5 * height);
    return;
  }
  const values = (interval[kind] ??= CHARTS[kind].values(interval, scene.constants));
  const { from, to } = interval;
  const bounds = kind === "tilt" ? scene.tilts : [];
  const [low, high] = withMargin([...values, ...bounds]);
  const [left, right, top, bottom] = [52, width - 26, 22, height - 34];
  const x = (time) => left + ((time - from) / (to - from)) * (right - left);
  const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
  write(pen, colours.faint, "left");
  pen.fillText(CHARTS[kind].name, 6, 13);
  write(pen, colours.faint, "right", 11);
  for (const value of ticksIn(low, high, 6)) {
    trace(pen, [[left, y(value)], [right, y(value)]]);
    stroke(pen, colours.grid, 0.7);
    pen.fillText(short(value, 6), left - 5, y(value) + 4);
  }
  write(pen, colours.faint, "center", 11);
  // far from t = 0 the labels count from the start of the interval, because whole times would have too many digits
  const far = Math.abs(from) > 1e4 * (to - from);
  const origin = far ? from : 0;
  for (const time of ticksIn(from - origin, to - origin, width > 420 ? 8 : 5)) {
    trace(pen, [[x(time + origin), bottom], [x(time + origin), bottom + 4]]);
    stroke(pen, colours.faint, 1);
    pen.fillText(short(time, 6), x(time + origin), bottom + 16);
  }
  const unit = scenario.units === "none" ? "" : " in s";
  pen.fillText(far ? `t − ${short(from, 10)}${unit}` : `t${unit}`, 0.5 * (left + right), height - 4);
  bounds.forEach((bound, i) => {
    trace(pen, [[left, y(bound)], [right, y(bound)]]);
    stroke(pen, colours.bound, 1.2, DASHES[i]);
    write(pen, colours.faint, "left", 11);
    if (i === 0 || bounds[0] - bounds[1] > 0.1 * (high - low)) pen.fillText(`e${"₁₂"[i]}`, right + 5, y(bound) + 4);
  });
  trace(pen, values.map((value, i) => [x(from + ((to - from) * i) / (values.length - 1)), y(value)]));
  stroke(pen, colours.axis, 1.8);
  trace(pen, [[x(t), top], [x(t), bottom]]);
  stroke(pen, colours.ink, 1, [2, 3]);
  const index = Math.max(0, Math.min(values.length - 1, ((t - from) / (to - from)) * (values.length - 1)));
  const [before, after] = [values[Math.floor(index)], values[Math.ceil(index)]];
  disc(pen, [x(t), y(before + (index % 1) * (after - before))], 4, colours.axis);
}
