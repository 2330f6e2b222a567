// The core, compiled to WebAssembly: a scenario in, constants and moments out, in the crate's own numbers.

/** What the keys of a scenario mean where they are left out. */
const DEFAULTS = { gravity: 9.80665, rotor_momentum: 0, precession: 0, nutation: 0, azimuth_deg: 0, roll_deg: 0, nutation_phase: 0, arg_alpha: 0, arg_beta: 0 };

/** Supports of the tip, in the order of the core's numbers. */
const SUPPORTS = ["sliding", "fixed", "free"];

const TOP_KEYS = ["transverse_inertia", "axial_inertia", "com_height", "mass", "mass_moment", "gravity", "rotor_momentum"];

/** Keys of each kind of motion, in the order in which the core takes their numbers. */
const MOTION_KEYS = {
  release: ["tilt_deg", "spin", "precession", "nutation", "azimuth_deg", "roll_deg"],
  state: ["alpha", "beta", "omega"],
  branch_points: ["e1", "e2", "e3", "sign_l_plus_n", "sign_l_minus_n", "nutation_phase", "arg_alpha", "arg_beta"],
};
const KINDS = Object.keys(MOTION_KEYS);

/** Numbers of a scenario as the core takes them: those of the top with 0 for what is not given, then those of the motion. */
function numbersOf({ top, motion }) {
  const value = (key, from) => from[key] ?? DEFAULTS[key] ?? 0;
  const ofTop = TOP_KEYS.map((key) => value(key, top));
  return [SUPPORTS.indexOf(top.support ?? "sliding"), ...ofTop, ...MOTION_KEYS[motion.kind].flatMap((key) => value(key, motion))];
}

/** How many numbers a key holds, where that is not one. */
const LENGTHS = { alpha: 2, beta: 2, omega: 3 };

/** A key of the motion that does not hold the numbers it has to; the core refuses the other errors. */
function missingKey({ motion }) {
  const holds = (key) => {
    const value = motion[key] ?? DEFAULTS[key];
    return key in LENGTHS ? Array.isArray(value) && value.length === LENGTHS[key] : typeof value === "number";
  };
  return MOTION_KEYS[motion.kind].find((key) => !holds(key));
}

/** Orientation, axis and tip of the ten numbers of a moment. */
function momentOf(numbers) {
  const [a, b, c, d, u, x, y, z, tipX, tipY] = numbers;
  return { alpha: [a, b], beta: [c, d], u, axis: [x, y, z], tip: [tipX, tipY] };
}

/** Numbers of a point of a curve: axis and tip. */
const COORDINATES = 5;
const MOST_POINTS = 4096;

class Core {
  /** The core of a page, from its bytes in base 64. */
  static async load(base64, names) {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const compiled = () => {
      // at once, so that the first picture is there with the page; a browser may refuse this of so many bytes
      try {
        return new WebAssembly.Module(bytes);
      } catch {
        return WebAssembly.compile(bytes);
      }
    };
    return new Core(new WebAssembly.Instance(await compiled(), {}).exports, names);
  }

  constructor(exports, names) {
    Object.assign(this, { exports, names, isLive: true });
    const { buffer } = exports.memory;
    this.numbers = new Float64Array(buffer, exports.numbers(), COORDINATES * MOST_POINTS);
    this.words = (length) => new TextDecoder().decode(new Uint8Array(buffer, exports.words(), length)).split("\n");
  }

  /** Shows a scenario: regime, class of the tip curve and constants by name, or what is refused. */
  launch(scenario) {
    const missing = missingKey(scenario);
    if (missing) return { refused: { parameter: missing, allowed: "given" } };
    this.numbers.set(numbersOf(scenario));
    const length = this.exports.launch(KINDS.indexOf(scenario.motion.kind));
    const [first, second] = this.words(Math.abs(length));
    if (length < 0) return { refused: { parameter: first, allowed: second } };
    const constants = Object.fromEntries(this.names.map((name, i) => [name, this.numbers[i]]));
    return { regime: first, tipClass: second, ...constants };
  }

  at(t) {
    this.exports.moment(t);
    return momentOf(this.numbers);
  }

  /** Axis and tip at equally spaced times, five numbers each. */
  curve(from, step, count) {
    this.exports.curve(from, step, count);
    return this.numbers.slice(0, COORDINATES * count);
  }

  startGhost(step) {
    this.exports.ghost(step);
  }

  /** The ghost's moment, the time that it has reached, and its distance from the exact orientation, rad. */
  ghostAt(t) {
    if (!this.exports.ghost_moment(t)) return null;
    const [reached, distance] = this.numbers.slice(10, 12);
    return { moment: momentOf(this.numbers), reached, distance };
  }
}
