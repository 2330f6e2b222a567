// The core, as WebAssembly, takes a scenario and returns the constants of the motion and its state at any time, in the crate's bits.
// The comparison top is integrated by the Runge-Kutta method.

/** First scenario of the page, names that the core and scenario files share, and meanings of the constants. */
const data = JSON.parse(document.getElementById("data").textContent);

const namesOf = (keys) => keys.map(([name]) => name);

/** Supports of the tip, keys of a top, and keys of each kind of motion, in the order in which the core takes their numbers. */
const SUPPORTS = data.keys.supports;
const TOP_KEYS = namesOf(data.keys.top);
const MOTION_KEYS = Object.fromEntries(data.keys.kinds.map(([kind, keys]) => [kind, namesOf(keys)]));
/** Default values of keys; null for a required one. */
const DEFAULTS = Object.fromEntries([data.keys.top, ...data.keys.kinds.map(([, keys]) => keys)].flat());
const KINDS = Object.keys(MOTION_KEYS);

/** Numbers of a scenario in the order in which the core takes them: those of the top, then those of the motion. */
function numbersOf({ top, motion }) {
  const value = (key, from) => from[key] ?? DEFAULTS[key] ?? 0;
  const topNumbers = TOP_KEYS.map((key) => value(key, top));
  return [...topNumbers, ...MOTION_KEYS[motion.kind].flatMap((key) => value(key, motion))];
}

/** Number of components of the keys that hold vectors. */
const COMPONENTS = { alpha: 2, beta: 2, omega: 3 };

/** Required keys of a top with this support. */
function keysOfTop({ support = "sliding", mass_moment }) {
  const lever = support === "free" ? [] : [mass_moment === undefined ? "mass" : "mass_moment"];
  if (support === "sliding" || lever[0] === "mass") lever.push("com_height");
  return ["transverse_inertia", "axial_inertia", ...lever];
}

/** Keys of a scenario that do not have their numbers; the core refuses all other errors. */
function missingKeys({ top, motion }) {
  const holds = (key) => {
    const value = motion[key] ?? DEFAULTS[key];
    return key in COMPONENTS ? Array.isArray(value) && value.length === COMPONENTS[key] : typeof value === "number";
  };
  return [...keysOfTop(top).filter((key) => top[key] === undefined), ...MOTION_KEYS[motion.kind].filter((key) => !holds(key))];
}

/** Message of a refusal: missing keys by their names in a scenario, a number by its name in words. */
const refusalText = ({ missing, parameter, allowed }) =>
  missing ? `${missing.join(", ")}: must be given` : `${parameter.replaceAll("_", " ")}: must be ${allowed}`;

/** Orientation, axis and tip, from the ten numbers that the core returns for a time. */
function poseOf(numbers) {
  const [a, b, c, d, u, x, y, z, tipX, tipY] = numbers;
  return { alpha: [a, b], beta: [c, d], u, axis: [x, y, z], tip: [tipX, tipY] };
}

/** Number of coordinates of a point of a curve: axis and tip. */
const COORDINATES = 5;
const MAX_POINTS = 4096;

class Core {
  /** Core of a page, from its bytes in base 64. */
  static async load(base64, names) {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const compiled = () => {
      // compiled synchronously, so that the page opens with its first picture; a browser may refuse this for a module of this size
      try {
        return new WebAssembly.Module(bytes);
      } catch {
        return WebAssembly.compile(bytes);
      }
    };
    return new Core(new WebAssembly.Instance(await compiled(), {}).exports, names);
  }

  constructor(exports, names) {
    this.exports = exports;
    this.names = names;
    const { buffer } = exports.memory;
    this.numbers = new Float64Array(buffer, exports.numbers(), COORDINATES * MAX_POINTS);
    this.words = (length) => new TextDecoder().decode(new Uint8Array(buffer, exports.words(), length)).split("\n");
  }

  /** Launches a scenario: returns the regime, the class of the tip curve and the constants by name, or the refused parameter. */
  launch(scenario) {
    const missing = missingKeys(scenario);
    if (missing.length > 0) return { refused: { missing } };
    this.numbers.set(numbersOf(scenario));
    const length = this.exports.launch(SUPPORTS.indexOf(scenario.top.support ?? "sliding"), KINDS.indexOf(scenario.motion.kind));
    const [first, second] = this.words(Math.abs(length));
    if (length < 0) return { refused: { parameter: first, allowed: second } };
    const constants = Object.fromEntries(this.names.map((name, i) => [name, this.numbers[i]]));
    return { regime: first, tipClass: second, ...constants };
  }

  at(t) {
    this.exports.pose(t);
    return poseOf(this.numbers);
  }

  /** Axis and tip at equally spaced times, five numbers for each time. */
  curve(from, step, count) {
    this.exports.curve(from, step, count);
    return this.numbers.slice(0, COORDINATES * count);
  }

  startComparison(step) {
    this.exports.runge_kutta(step);
  }

  /** Pose of the comparison top, the time that its integration has reached, and its distance from the exact orientation, rad. */
  comparisonAt(t) {
    if (!this.exports.runge_kutta_pose(t)) return null;
    const [reached, distance] = this.numbers.slice(10, 12);
    return { pose: poseOf(this.numbers), reached, distance };
  }
}
