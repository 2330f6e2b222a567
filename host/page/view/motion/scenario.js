// A scenario is read from the fragment of an address, and written as such a fragment or as TOML, with the keys of scenario files.

/** Keys of a scenario whose values are numbers, in the order of the documentation. */
const NUMBER_KEYS = [...TOP_KEYS, ...Object.values(MOTION_KEYS).flat()];

/** Keys and values of a table of a scenario, in the order of the documentation. */
function inOrder(table) {
  const keys = ["support", "kind", ...NUMBER_KEYS];
  return keys.filter((key) => table[key] !== undefined).map((key) => [key, table[key]]);
}

/** Fragment `#mass=0.05&...&kind=release&tilt_deg=20&spin=150&t=3` of a scenario and of settings by name, which may be undefined. */
function toFragment({ units, top, motion }, settings) {
  const others = Object.entries({ units, ...settings }).filter(([, value]) => value !== undefined);
  const pairs = [...inOrder({ support: "sliding", ...top }), ...inOrder(motion), ...others];
  return `#${pairs.map(([key, value]) => `${key}=${value}`).join("&")}`;
}

/** Text with its percent escapes decoded; unchanged if an escape is invalid. */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Keys of an address whose values are words, with the allowed words. */
const WORDS = { support: SUPPORTS, kind: KINDS, units: ["SI", "none"] };
/** Keys of an address that are not keys of a scenario. */
const SETTINGS = ["t", "speed", "comparison"];

/** Number in the text of a key, or a list of numbers for a key that has several. */
function numbersIn(key, text) {
  const numbers = text.split(",").map(numberOf);
  return key in COMPONENTS ? numbers : numbers[0];
}

/** Reason why the keys and texts of an address are refused; undefined where each is known and its text is what the key allows. */
function refusalOfAddress(values) {
  const kind = values.get("kind");
  const ofKind = KINDS.includes(kind) && [...TOP_KEYS, ...MOTION_KEYS[kind]];
  for (const [key, text] of values) {
    if (Object.hasOwn(WORDS, key)) {
      if (!WORDS[key].includes(text)) return `${key}: must be one of ${WORDS[key].join(", ")}`;
    } else if (![...SETTINGS, ...NUMBER_KEYS].includes(key)) return `${key}: unknown key`;
    else if ([numbersIn(key, text ?? "")].flat().some(Number.isNaN)) return `${key}: must be a number`;
    else if (ofKind && !SETTINGS.includes(key) && !ofKind.includes(key)) return `${key}: not for kind=${kind}`;
  }
  const needsKind = [...values.keys()].some((key) => !SETTINGS.includes(key));
  return needsKind && !kind ? "kind: must be given" : undefined;
}

/** Scenario, time, speed and step of the comparison top in a fragment, or the reason why it is refused; missing numbers are NaN. */
function fromFragment(fragment) {
  const pairs = decoded(fragment.slice(1)).split("&").map((pair) => pair.split("="));
  const values = new Map(pairs.filter(([key]) => key !== ""));
  const refused = refusalOfAddress(values);
  if (refused) return { refused };
  const [t, speed, comparison] = SETTINGS.map((key) => numberOf(values.get(key) ?? ""));
  const kind = values.get("kind");
  if (kind === undefined) return { t, speed, comparison };
  const read = (keys) => Object.fromEntries(keys.filter((key) => values.has(key)).map((key) => [key, numbersIn(key, values.get(key))]));
  const support = values.get("support") ?? "sliding";
  const units = values.get("units") === "none" ? { units: "none" } : {};
  return { t, speed, comparison, scenario: { ...units, top: { support, ...read(TOP_KEYS) }, motion: { kind, ...read(MOTION_KEYS[kind]) } } };
}

/** Text of a scenario file, which `toytop` reads. */
function toToml({ units, top, motion }, name) {
  const value = (x) => (Array.isArray(x) ? `[${x.map(value).join(", ")}]` : typeof x === "string" ? `"${x}"` : String(x));
  const table = (title, entries) =>
    [`[${title}]`, ...inOrder(entries).map(([key, x]) => `${key} = ${value(x)}`), ""].join("\n");
  const head = units === undefined ? "" : `units = "${units}"\n\n`;
  return `# ${name.replace(/\s+/g, " ")}\n\n${head}${table("top", top)}\n${table("motion", motion)}`;
}

/** Scenario of a motion as a release, without the rotation of the body about its axis at t = 0. */
function asRelease(scenario, constants) {
  if (scenario.motion.kind === "release") return scenario;
  const { tilt, azimuth, spin, precession, nutation } = constants;
  const motion = { kind: "release", tilt_deg: degrees(tilt), spin, precession, nutation, azimuth_deg: degrees(azimuth) };
  return { ...scenario, motion };
}

/** Scenario of a motion by its branch points; it starts at the lowest position of the axis. */
function asBranchPoints(scenario, constants) {
  if (scenario.motion.kind === "branch_points") return scenario;
  const { e1, e2, e3, sign_l_plus_n, sign_l_minus_n } = constants;
  return { ...scenario, motion: { kind: "branch_points", e1, e2, e3, sign_l_plus_n, sign_l_minus_n } };
}

/** Mass, and distance s of the centre of mass from the tip. A scenario need not have both: missing ones are replaced by plausible values. */
function leverOf({ mass, mass_moment, com_height, transverse_inertia: a, axial_inertia: c }) {
  if (mass_moment !== undefined) {
    // half of the distance at which the body would be a flat disc
    const s = com_height ?? (0.5 * (a - 0.5 * c)) / mass_moment;
    return [mass_moment / s, s];
  }
  // a free body may have any mass: the distance is that of a body as slender as the toy top
  const m = mass ?? 1;
  return [m, com_height ?? Math.sqrt((1.5 * a) / m)];
}

/**
 * Scenario of a body with another support: the transverse inertia is about the tip if that is held, otherwise about the centre of
 * mass. A free body keeps mass, height and gravity, which have no effect, until it has a support again.
 */
function withSupport(scenario, support, constants) {
  const before = scenario.top.support ?? "sliding";
  if (before === support) return scenario;
  const { transverse_inertia: a, axial_inertia, gravity, rotor_momentum } = scenario.top;
  const [mass, com_height] = leverOf(scenario.top);
  const about = mass * com_height ** 2 * (Number(support === "fixed") - Number(before === "fixed"));
  const given = { ...(gravity && { gravity }), ...(rotor_momentum && { rotor_momentum }) };
  const top = { support, transverse_inertia: a + about, axial_inertia, com_height, mass, ...given };
  // branch points do not determine the motion of a free body
  return { ...(support === "free" ? asRelease(scenario, constants) : scenario), top };
}
