// The page shows angles in degrees and rates in turns a minute.

export const degrees = (radians) => (radians * 180) / Math.PI;
export const perMinute = (radiansPerSecond) => (radiansPerSecond * 60) / (2 * Math.PI);

/** Angle of an axis from the upward vertical, in degrees. */
export const tiltOf = ([x, y, z]) => degrees(Math.atan2(Math.hypot(x, y), z));
/** Azimuth of an axis, rad. */
export const azimuthOf = ([x, y]) => Math.atan2(y, x);
