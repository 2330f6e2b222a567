// Points of the motion are computed once and kept.

/** State of a motion at a time, with its rotation from body to fixed coordinates. Lengths are in units of s. */
function drawnPose(scene, pose) {
  const rotate = rotation(pose);
  const foot = scene.slides ? pose.tip.map((x) => x / scene.scale) : pose.axis.slice(0, 2);
  return { pose, rotate, axis: pose.axis, foot };
}

/** Points of the motion at whole multiples of a time step, each computed once. */
class Points {
  constructor(core, scene) {
    this.core = core;
    this.scene = scene;
    this.stride = scene.span / scene.parts;
    this.points = new Map();
  }

  /** Points in the interval of length `span` before t. */
  before(t) {
    const { span } = this.scene;
    const first = Math.ceil((t >= 0 ? Math.max(0, t - span) : t - span) / this.stride);
    const last = Math.floor(t / this.stride);
    return this.between(first, last);
  }

  /** Points from the number `first` to the number `last`. */
  between(first, last) {
    let missing = first;
    while (missing <= last && this.points.has(missing)) missing++;
    if (missing <= last) this.compute(missing, Math.min(MAX_POINTS, last - missing + 1));
    return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => this.points.get(first + i)).filter(Boolean);
  }

  /** Deletes the points that are more than two spans away from t. */
  forget(t) {
    if (this.points.size < 6 * this.scene.parts) return;
    const far = (number) => Math.abs(number * this.stride - t) > 2 * this.scene.span;
    for (const number of [...this.points.keys()].filter(far)) this.points.delete(number);
  }

  compute(first, count) {
    const { stride, scene } = this;
    const numbers = this.core.curve(first * stride, stride, count);
    for (let i = 0; i < count; i++) this.points.set(first + i, pointOf(scene, numbers, i));
  }
}

/** Axis, and its projection onto the plane or the tip, of a point of a curve. */
function pointOf(scene, numbers, i) {
  const at = COORDINATES * i;
  const [x, y] = [numbers[at], numbers[at + 1]];
  const foot = scene.slides ? [numbers[at + 3] / scene.scale, numbers[at + 4] / scene.scale] : [x, y];
  return { axis: [x, y, numbers[at + 2]], foot };
}

/** Points of the interval that the slider covers. */
function intervalOf(points, { span, parts }, number) {
  return { number, from: number * span, to: (number + 1) * span, points: points.between(number * parts, (number + 1) * parts) };
}
