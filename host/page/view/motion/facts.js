// The tables list the quantities of a motion and of its state at a time; the sentences describe the motion.

/** Definitions of the constants, as `toytop constants --help` prints them. */
const define = (name) => `${data.meanings[name]}.`;

/** Whether no torque acts; then e₃ is infinite and the angular momentum is constant. */
const isTorqueFree = ({ g }) => g === 0;

/** Whether the axis is vertical at all times. */
const isVertical = (regime) => regime.startsWith("sleeping") || regime === "hanging";

/** Angle between the axis and the angular momentum, in degrees. */
const coneAngle = ({ n, m_x, m_y, m_z }) => degrees(Math.acos(Math.max(-1, Math.min(1, n / Math.hypot(m_x, m_y, m_z)))));

/** Angle of the axis from the vertical, from its cosine u, in degrees. */
const tiltAt = (u) => degrees(Math.acos(Math.max(-1, Math.min(1, u))));

/** Tilts between which the plane would have to pull the tip down; null if there are none. */
function liftOff({ min_tilt_deg, lift_off_u }) {
  return Number.isNaN(lift_off_u) ? null : [min_tilt_deg, tiltAt(lift_off_u)].map((x) => `${decimals(x, 1)}°`);
}

const REGIMES = {
  nutating: "The axis nods between two tilts while it goes round.",
  regular_precession: "Regular precession: the axis goes round at a constant tilt.",
  sleeping_stable: "A sleeping top: it stands upright, and a push makes it nod a little.",
  sleeping_unstable: "It stands upright, but any push makes it fall.",
  hanging: "The body hangs straight down.",
  aperiodic: "The axis rises to the vertical and reaches it only in infinite time.",
};

/** Sentence about a motion without torque: the axis rests, or it precesses about the angular momentum. */
function torqueFree(constants) {
  const angle = coneAngle(constants);
  if (Number.isNaN(angle)) return "The body rests.";
  if (angle < 1e-3 || angle > 180 - 1e-3) return "No torque acts, and the axis stands still: it is that of the angular momentum.";
  return `No torque acts: the axis goes round the angular momentum, which stands still, at a constant angle of ${decimals(angle, 1)}°.`;
}

/** Sentence about the kind of a motion; where l = n = 0 exactly, the motion is in a plane. */
function motionOf(constants) {
  const { regime, l, n, e2, e3 } = constants;
  if (isTorqueFree(constants)) return torqueFree(constants);
  if (regime === "nutating" && l === 0 && n === 0) return e2 === 1 && e3 > 1 ? "It goes round in a vertical plane, over the top." : "It swings in a vertical plane.";
  return REGIMES[regime] ?? "";
}

/** Support and kind of a motion, and in what way a real top would move differently. */
function summaryOf(constants) {
  const { regime, support, min_normal_force, e1 } = constants;
  const real = [];
  if (min_normal_force < 0) real.push("lift off the plane");
  if (support === 0 && e1 < 0 && regime !== "sleeping_unstable") real.push("fall on its side");
  const begin = ["The tip slides without friction.", "The tip is held.", "The body is free."][support];
  return `${begin} ${motionOf(constants)}${real.length ? ` A real top would ${real.join(" and ")}.` : ""}`;
}

/** Reason for the class of the tip curve (Proposition 6 of the paper). */
function curveReason(constants) {
  const { tipClass, e1, e2, e3, sign_l_plus_n, sign_l_minus_n } = constants;
  const [left, right] = [short(e3 * (e2 - e1), 4), short(1 - e1 * e2, 4)];
  const signs = sign_l_plus_n === sign_l_minus_n ? "the same sign" : "different signs";
  if (isTorqueFree(constants) && ["loops", "smooth"].includes(tipClass)) {
    return tipClass === "loops" ? "Loops: |l| < |n|, so that the axis goes backwards on a part of its way." : "Smooth: |l| ≥ |n|, so that the axis never turns back.";
  }
  const compared = (sign) => `l + n and l − n have ${signs}, and e₃(e₂ − e₁) = ${left} ${sign} 1 − e₁e₂ = ${right}`;
  switch (tipClass) {
    case "loops":
      return `Loops: ${compared(">")}. The axis goes backwards at its highest.`;
    case "cusp":
      return `Cusps: ${compared("=")}. The axis stands still at its highest, as when it is let go there.`;
    case "smooth":
      return signs === "the same sign" ? `Smooth: l + n and l − n have ${signs}, so that the axis never turns back.` : `Smooth: ${compared("<")}.`;
    case "circle":
      return "A circle: e₁ = e₂, so that the tilt does not change.";
    case "through_origin":
      return "Through the centre: e₂ = 1 or e₁ = −1, so that the axis passes the vertical.";
    case "spiral":
      return "A spiral: e₂ = e₃ = 1, so that the axis comes to the vertical and stays.";
    default:
      return "A point: the axis is vertical.";
  }
}

/** Names, values, units and definitions of quantities for teaching. */
function teachersFacts(constants, { units }) {
  const { A, p, g, n, min_tilt_deg, max_tilt_deg, period, phi_per_period, spin, critical_spin: critical, min_normal_force, support } = constants;
  const rate = phi_per_period / period;
  const both = (x) => (units === "none" ? short(x, 4) : `${short(x, 4)} rad/s = ${short(perMinute(x), 4)}`);
  const lift = support === 0 ? liftOff(constants) : null;
  const weightless = isTorqueFree(constants);
  return [
    ["tilt", `${decimals(min_tilt_deg, 2)}° … ${decimals(max_tilt_deg, 2)}`, "°", "Angle between the axis and the vertical: the least and the greatest that it takes."],
    ["nutation period", short(period), "s", weightless ? "Time in which the axis goes once round the angular momentum." : "Time from one lowest place of the axis to the next. Nutation is the nodding of the axis."],
    ["nutation frequency", short(1 / period), "Hz", "Number of nods in a second."],
    ["mean precession", short(degrees(rate)), units === "none" ? "°" : "°/s", define("mean_precession_deg_per_s")],
    ...(units === "none" ? [] : [["mean precession in rpm", short(perMinute(rate)), "rpm", "Mean precession in revolutions per minute."]]),
    ["spin", both(spin), units === "none" ? "" : "rpm", `${define("spin_rpm")} It never changes.`],
    ...(weightless
      ? [["angle to the momentum", decimals(coneAngle(constants), 2), "°", "Angle between the axis and the angular momentum. Without torque it never changes."]]
      : [
          ["critical spin", Number.isFinite(critical) ? both(critical) : "–", units === "none" ? "" : "rpm", define("critical_spin_rpm")],
          ["if upright, it would", n * n > 4 * A * p * g ? "sleep" : "fall", "", "Whether the spin is above the critical spin."],
        ]),
    ...(support !== 0
      ? []
      : [
          ["least normal force", short(min_normal_force), "weights", define("min_normal_force")],
          ["lift-off", lift ? `between ${lift.join(" and ")}` : "nowhere", "", "Tilts at which the plane would have to pull."],
        ]),
  ];
}

/** Names, values, units and definitions of the paper's constants. */
function paperFacts(constants) {
  const { e1, e2, e3, e4, l, n, h, A, C, s, p, g, K, support, alpha_turns, beta_turns } = constants;
  const [slides, weight] = [support === 0, !isTorqueFree(constants)];
  return [
    ["e₁", short(e1, 8), "", define("e1")],
    ["e₂", short(e2, 8), "", define("e2")],
    ...(weight ? [["e₃", short(e3, 8), "", define("e3")]] : []),
    ...(slides ? [["e₄", short(e4, 8), "", define("e4")]] : []),
    ["l", short(l), "kg m²/s", `${define("l")} It never changes.`],
    ["n", short(n), "kg m²/s", `${define("n")} It never changes.`],
    ["h", short(h), "J", weight ? define("h") : "Energy."],
    ["α in a period", short(alpha_turns), "turns", define("alpha_turns")],
    ["β in a period", short(beta_turns), "turns", `${define("beta_turns")} The sum of both is the advance of the azimuth of the axis.`],
    ["A", short(A), "kg m²", support === 1 ? "Transverse moment of inertia about the tip." : "Transverse moment of inertia about the centre of mass."],
    ["C", short(C), "kg m²", "Moment of inertia about the axis of the top."],
    ...(K ? [["K", short(K), "kg m²/s", "Angular momentum of the rotor inside, relative to the body: n = C spin + K."]] : []),
    ...(slides ? [["s", short(s), "m", "Distance from the tip to the centre of mass."]] : []),
    ...(weight
      ? [
          ["p", short(p), "kg m", "Mass moment: mass times distance from the tip to the centre of mass."],
          ["g", short(g), "m/s²", "Gravity."],
        ]
      : []),
  ];
}

/** Names, values, units and definitions of the state at the time shown. */
function poseFacts({ alpha, beta, u, axis }, t, constants) {
  const { period, error, error_growth } = constants;
  return [
    ["tilt", decimals(tiltOf(axis), 3), "°", "Angle between the axis and the vertical, now."],
    ["azimuth", decimals(degrees(azimuthOf(axis)), 2), "°", "Direction in which the axis leans, seen from above."],
    ["u", decimals(u, 6), "", "Cosine of the tilt."],
    ["axis", axis.map((x) => decimals(x, 3)).join(", "), "", "Unit vector along the axis, from the tip to the centre of mass; its third component points up."],
    ["α", complexText(alpha), "", "First Cayley-Klein parameter of the orientation; as a quaternion w + z i."],
    ["β", complexText(beta), "", "Second Cayley-Klein parameter of the orientation; as a quaternion −y + x i."],
    ["periods", period > 0 ? decimals(t / period, 2) : "–", "", "Nutation periods since t = 0."],
    ["error at most", short(error + error_growth * Math.abs(t), 2), "rad", "Bound on the error of the orientation at this time; it counts roundings and does not grow by steps."],
  ];
}
