// The page shows angles in degrees and rates in turns a minute.

const degrees = (radians) => (radians * 180) / Math.PI;
const perMinute = (radiansPerSecond) => (radiansPerSecond * 60) / (2 * Math.PI);

/** Angle of an axis from the upward vertical, in degrees. */
const tiltOf = ([x, y, z]) => degrees(Math.atan2(Math.hypot(x, y), z));
/** Azimuth of an axis, rad. */
const azimuthOf = ([x, y]) => Math.atan2(y, x);
