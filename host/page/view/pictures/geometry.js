// Rotations turn points of the body into space, and the camera projects them onto the picture.

/** Rotation x = Φ X Φ⁻¹ as a function from body to fixed coordinates; the third body axis is the top's axis. */
function rotation({ alpha: [a, b], beta: [c, d], u }) {
  // α², β², αβ and α times β conjugate
  const [aa, bb] = [[a * a - b * b, 2 * a * b], [c * c - d * d, 2 * c * d]];
  const [product, mixed] = [[a * c - b * d, a * d + b * c], [a * c + b * d, b * c - a * d]];
  const first = [aa[0] - bb[0], aa[1] - bb[1], 2 * mixed[0]];
  const second = [-aa[1] - bb[1], aa[0] + bb[0], -2 * mixed[1]];
  const axis = [-2 * product[0], -2 * product[1], u];
  const turned = (x, y, z, i) => x * first[i] + y * second[i] + z * axis[i];
  const rotate = ([x, y, z]) => [turned(x, y, z, 0), turned(x, y, z, 1), turned(x, y, z, 2)];
  return Object.assign(rotate, { axis });
}

const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
const sum = (x, y, k = 1) => [x[0] + k * y[0], x[1] + k * y[1], x[2] + k * y[2]];
const unit = (x) => x.map((coordinate) => coordinate / Math.hypot(...x));

/** Perspective view of `target` from an azimuth and an elevation, in which a sphere of radius `reach` about `target` fits the picture. */
class Camera {
  constructor({ azimuth, elevation }, target, reach, [width, height]) {
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    this.back = [ce * ca, ce * sa, se];
    this.right = [-sa, ca, 0];
    this.up = [-se * ca, -se * sa, ce];
    this.distance = 4.2 * reach;
    this.position = sum(target, this.back, this.distance);
    this.middle = [width / 2, height / 2];
    this.focus = (Math.min(width, height) / 2) * Math.sqrt(4.2 ** 2 - 1);
  }

  /** Position on the picture in pixels, and distance from the camera along the line of sight. */
  project(point) {
    const p = sum(point, this.position, -1);
    const depth = -dot(p, this.back);
    const scale = this.focus / depth;
    return [this.middle[0] + scale * dot(p, this.right), this.middle[1] - scale * dot(p, this.up), depth];
  }

  /** Number of pixels of a unit of length at a point. */
  scaleAt(point) {
    return this.focus / -dot(sum(point, this.position, -1), this.back);
  }
}

/** Points of a horizontal circle in space, at equal angles. */
function circle(radius, height, corners = 120) {
  const corner = (_, i) => (2 * Math.PI * i) / corners;
  return Array.from({ length: corners + 1 }, corner).map((t) => [radius * Math.cos(t), radius * Math.sin(t), height]);
}
