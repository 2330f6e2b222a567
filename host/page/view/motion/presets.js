// The preset motions are the paper's nine curves, real tops, and limiting cases.

/** Top of the paper's curves: A = C = s = p = g = 1. */
const PAPERS_TOP = { support: "sliding", transverse_inertia: 1, axial_inertia: 1, com_height: 1, mass_moment: 1, gravity: 1 };

function branchPoints(top, [e1, e2, e3], minus) {
  return { units: "none", top, motion: { kind: "branch_points", e1, e2, e3, sign_l_plus_n: 1, sign_l_minus_n: minus } };
}

/** Groups of presets: each has a name, and presets by their names. */
function presetsOf({ name, scenario, figures, toy_top: toyTop }) {
  const { top } = toyTop;
  const thrown = (changes) => ({ top, motion: { ...toyTop.motion, ...changes } });
  const wheel = { support: "fixed", mass: 0.2, com_height: 0.06, transverse_inertia: 9.5e-4, axial_inertia: 4e-4, gravity: 9.81 };
  const tall = { support: "sliding", transverse_inertia: 1.1, axial_inertia: 0.8, com_height: 0.6, mass_moment: 0.9, gravity: 1 };
  const rod = { support: "fixed", mass: 0.3, com_height: 0.5, transverse_inertia: 0.075, axial_inertia: 0, gravity: 9.81 };
  const swung = (changes) => ({ top: rod, motion: { kind: "release", spin: 0, ...changes } });
  const thrownUp = (body, changes) => ({ top: { support: "free", ...body }, motion: { kind: "release", ...changes } });
  const released = (changes) => ({ top: wheel, motion: { kind: "release", tilt_deg: 70, spin: 250, ...changes } });
  return {
    "This page": { [name.replaceAll("_", " ")]: scenario },
    "Real tops": {
      // the critical spin of the toy top is 66.4 rad/s
      "Toy top, let go": thrown({}),
      "Toy top, pushed: loops": thrown({ precession: -6 }),
      "Toy top, tip held": withSupport(thrown({ nutation: 0.5 }), "fixed"),
      "Sleeping, just above the critical spin": thrown({ tilt_deg: 1, spin: 68.4 }),
      "Waking, just below the critical spin": thrown({ tilt_deg: 1, spin: 64.4 }),
      "Gyroscope, let go": released({ precession: 0 }),
      "Gyroscope, steady": released({ precession: 1.2 }),
      "Gyroscope in a frame that hardly turns": { top: { ...wheel, rotor_momentum: 0.1 }, motion: { kind: "release", tilt_deg: 70, spin: 0.5 } },
    },
    "The paper": Object.fromEntries(
      figures.flatMap(([figure, minus, e3s]) =>
        e3s.map((e3) => [`${figure[0].toUpperCase()}${figure.slice(1)}, e₃ = ${e3}`, branchPoints(PAPERS_TOP, [0.7, 0.9, e3], minus)]),
      ),
    ),
    "Pendulums and free bodies": {
      "Pendulum, in a plane": swung({ precession: 0, tilt_deg: 20 }),
      "Pendulum, round": swung({ precession: 2.5, tilt_deg: 130, spin: -1.607 }),
      "Thrown plate": thrownUp({ transverse_inertia: 1.1e-3, axial_inertia: 2e-3 }, { tilt_deg: 25, spin: 20, precession: 3, nutation: -4 }),
      "Thrown stick": thrownUp({ transverse_inertia: 1.1e-3, axial_inertia: 5e-5 }, { tilt_deg: 75, spin: 6, precession: 5 }),
    },
    Corners: {
      "Near the separatrix": branchPoints(tall, [0.2, 1 - 5e-7, 1 + 5e-7], 1),
      "Rising for ever": branchPoints(tall, [0.2, 1, 1], 1),
      "Held pendulum": { top: wheel, motion: { kind: "release", tilt_deg: 120, spin: 0, precession: 3 } },
    },
  };
}
