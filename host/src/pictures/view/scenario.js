// A scenario as text: the fragment of an address, and TOML. Its keys are those of `toytop`'s scenario files.

/** A number as it is typed, with a point or a comma; NaN for what is none. */
function numberOf(text) {
  const trimmed = text.trim().replace(",", ".").replace("−", "-");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(trimmed) ? Number(trimmed) : NaN;
}

/** Keys of a table of a scenario and what they hold, in the order in which its documentation has them. */
function inOrder(table) {
  const keys = ["support", ...TOP_KEYS, "kind", ...Object.values(MOTION_KEYS).flat()];
  return keys.filter((key) => table[key] !== undefined).map((key) => [key, table[key]]);
}

/** `#mass=0.05&...&kind=release&tilt_deg=20&spin=150&t=3`: a scenario, and settings by name that may be undefined. */
function toFragment({ units, top, motion }, settings) {
  const others = Object.entries({ units, ...settings }).filter(([, value]) => value !== undefined);
  const pairs = [...inOrder({ support: "sliding", ...top }), ...inOrder(motion), ...others];
  return `#${pairs.map(([key, value]) => `${key}=${value}`).join("&")}`;
}

/** A text without its percent signs; as it is where it is none of an address. */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** What a fragment says: a scenario, a time, a speed and the step of a ghost, or NaN for what it does not. Other keys are left out. */
function fromFragment(fragment) {
  const values = new Map(decoded(fragment.slice(1)).split("&").map((pair) => pair.split("=")));
  const [t, speed, ghost] = ["t", "speed", "ghost"].map((key) => numberOf(values.get(key) ?? ""));
  const kind = values.get("kind");
  if (!KINDS.includes(kind)) return { t, speed, ghost };
  const read = (keys) =>
    Object.fromEntries(
      keys.filter((key) => values.has(key)).map((key) => {
        const numbers = (values.get(key) ?? "").split(",").map(numberOf);
        return [key, MOTION_KEYS.state.includes(key) ? numbers : numbers[0]];
      }),
    );
  const support = SUPPORTS.includes(values.get("support")) ? values.get("support") : "sliding";
  const units = values.get("units") === "none" ? { units: "none" } : {};
  return { t, speed, ghost, scenario: { ...units, top: { support, ...read(TOP_KEYS) }, motion: { kind, ...read(MOTION_KEYS[kind]) } } };
}

/** The text of a scenario file, which `toytop` reads. */
function toToml({ units, top, motion }, name) {
  const value = (x) => (Array.isArray(x) ? `[${x.map(value).join(", ")}]` : typeof x === "string" ? `"${x}"` : String(x));
  const table = (title, entries) =>
    [`[${title}]`, ...inOrder(entries).map(([key, x]) => `${key} = ${value(x)}`), ""].join("\n");
  const head = units === undefined ? "" : `units = "${units}"\n\n`;
  return `# ${name.replace(/\s+/g, " ")}\n\n${head}${table("top", top)}\n${table("motion", motion)}`;
}

/** The same motion as a release, as far as angles and rates at t = 0 tell it. */
function asRelease(scenario, shown) {
  if (scenario.motion.kind === "release") return scenario;
  const { tilt, azimuth, spin, precession, nutation } = shown;
  const motion = { kind: "release", tilt_deg: degrees(tilt), spin, precession, nutation, azimuth_deg: degrees(azimuth) };
  return { ...scenario, motion };
}

/** The same motion by its branch points, which starts at the lowest place of the axis. */
function asBranchPoints(scenario, shown) {
  if (scenario.motion.kind === "branch_points") return scenario;
  const { e1, e2, e3, sign_l_plus_n, sign_l_minus_n } = shown;
  return { ...scenario, motion: { kind: "branch_points", e1, e2, e3, sign_l_plus_n, sign_l_minus_n } };
}

/** The same body with its tip held or let go: the transverse inertia is about the tip, or about the centre of mass. */
function withSupport(scenario, support) {
  const { top } = scenario;
  const { mass, mass_moment, transverse_inertia: a, axial_inertia: c } = top;
  if ((top.support ?? "sliding") === support) return scenario;
  // a held top need not say where its centre of mass is: halfway to where the body would be a disc
  const s = top.com_height ?? (0.5 * (a - 0.5 * c)) / mass_moment;
  const m = mass ?? mass_moment / s;
  const about = support === "fixed" ? a + m * s * s : a - m * s * s;
  const { gravity, rotor_momentum } = top;
  const given = { ...(gravity !== undefined && { gravity }), ...(rotor_momentum !== undefined && { rotor_momentum }) };
  return { ...scenario, top: { support, transverse_inertia: about, axial_inertia: c, com_height: s, mass: m, ...given } };
}

const degrees = (radians) => (radians * 180) / Math.PI;
