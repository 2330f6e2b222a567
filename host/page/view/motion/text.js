// Numbers are written for the page, and read from what is typed.

/** Number with n decimals, without a minus before zero. */
const decimals = (x, n = 4) => {
  const text = x.toFixed(n);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
};

/** Number with at most n significant digits, without trailing zeros. */
const short = (x, n = 5) => {
  if (!Number.isFinite(x)) return "–";
  const [digits, power] = String(Number(x.toPrecision(n))).replace("-", "−").split("e");
  return power === undefined ? digits : `${digits} · 10${superscript(power)}`;
};

const superscript = (power) => [...power.replace("+", "").replace("-", "−")].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("");

/** A complex number in rectangular form. */
const complexText = ([re, im]) => {
  const size = decimals(Math.abs(im));
  const minus = im < 0 && Number(size) !== 0;
  return `${decimals(re)} ${minus ? "−" : "+"} ${size} i`;
};

/** Units that do not depend on the units of a scenario. */
const PURE = ["", "°", "turns", "weights", "rad"];

/** Name of a unit; empty if it depends on the units of a scenario and the scenario has none. */
const unitName = (unit, { units }) => (units === "none" && !PURE.includes(unit) ? "" : unit);

/** Length with its unit: mm below one metre, otherwise m. */
function lengthText(metres, scenario) {
  if (scenario.units === "none") return short(metres, 3);
  const [scale, unit] = Math.abs(metres) < 1 ? [1e3, "mm"] : [1, "m"];
  return `${short(metres * scale, 3)} ${unit}`;
}

/** The largest of 1, 2 and 5 times a power of ten that is at most x. */
function roundBelow(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([5, 2, 1].find((digit) => digit * power <= x * (1 + 1e-12)) ?? 1);
}

/** Number of a typed text, with a point or a comma; NaN if the text is no number. */
function numberOf(text) {
  const trimmed = text.trim().replace(",", ".").replace("−", "-");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(trimmed) ? Number(trimmed) : NaN;
}

// Angles are shown in degrees, and rates in turns a minute.

const degrees = (radians) => (radians * 180) / Math.PI;
const perMinute = (radiansPerSecond) => (radiansPerSecond * 60) / (2 * Math.PI);

/** Angle of an axis from the upward vertical, in degrees. */
const tiltOf = ([x, y, z]) => degrees(Math.atan2(Math.hypot(x, y), z));
/** Azimuth of an axis, rad. */
const azimuthOf = ([x, y]) => Math.atan2(y, x);
