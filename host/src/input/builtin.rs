//! Built-in motions, which `compare` runs without a scenario file.

use crate::input::scenario::{Launch, MotionInput, Scenario, Units};
use toytop::{InitialAngles, Sign, Signs, Support, TopParameters};

/// Scenarios of the paper's figures 2 and 3, of seven tops in SI units, and of two motions near the separatrix.
pub fn scenarios() -> Vec<Scenario> {
    let from_files = SCENARIO_FILES.map(|(name, text)| Scenario::parse(name, text).expect("a valid file"));
    let near_separatrix = NEAR_SEPARATRIX.map(|(name, gap)| {
        // e₂ and e₃ are on both sides of 1, so that the axis stays near the vertical for a long part of every period; A and C differ
        let e = [0.2, 1.0 - 0.5 * gap, 1.0 + 0.5 * gap];
        curve(name.to_owned(), [1.1, 0.8, 0.6, 0.9], e, SAME)
    });
    figures().into_iter().chain(from_files).chain(near_separatrix).collect()
}

/// Motions near the separatrix: name, and e₃ - e₂.
const NEAR_SEPARATRIX: [(&str, f64); 2] = [("near separatrix 1e-3", 1e-3), ("near separatrix 1e-6", 1e-6)];

/// Scenario file of the toy top.
pub const TOY_TOP: &str = include_str!("../../scenarios/toy_top.toml");

/// Scenario files that are not figures of the paper.
const SCENARIO_FILES: [(&str, &str); 7] = [
    ("toy top 150 rad/s", TOY_TOP),
    ("sleeping top", include_str!("../../scenarios/sleeping.toml")),
    ("Lagrange top", include_str!("../../scenarios/lagrange.toml")),
    ("gyrostat", include_str!("../../scenarios/gyrostat.toml")),
    ("free body", include_str!("../../scenarios/free_body.toml")),
    ("pendulum", include_str!("../../scenarios/pendulum.toml")),
    ("spherical pendulum", include_str!("../../scenarios/spherical_pendulum.toml")),
];

/// Signs l + n > 0 > l - n.
const DIFFERENT: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
/// Signs l + n > 0, l - n > 0.
const SAME: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };

/// Values of e₃ in figures 2 and 3, where e₁ = 0.7, e₂ = 0.9 and A = C = s = p = g = 1.
pub const FIGURES: [(&str, Signs, &[f64]); 2] =
    [("figure 2", SAME, &[1.0, 2.0, 100.0]), ("figure 3", DIFFERENT, &[1.0, 1.1, 1.3, 1.85, 2.5, 3.0])];

/// Curves of the paper's figures 2 and 3.
pub fn figures() -> Vec<Scenario> {
    let curves = FIGURES.iter().flat_map(|(figure, signs, e3s)| {
        e3s.iter().map(move |e3| curve(format!("{figure} e3={e3}"), [1.0; 4], [0.7, 0.9, *e3], *signs))
    });
    curves.collect()
}

/// Scenario without units of a sliding top with A, C, s, p and gravity 1.
fn curve(name: String, top: [f64; 4], e: [f64; 3], signs: Signs) -> Scenario {
    let [transverse_inertia, axial_inertia, com_height, mass_moment] = top;
    let parameters = TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass_moment,
        gravity: 1.0,
        ..TopParameters::default()
    };
    let launch = Launch::BranchPoints { e, signs, phases: InitialAngles::default() };
    let input = MotionInput { support: Support::Sliding, top: parameters, launch };
    Scenario { name, motion: input.motion().expect("a valid motion"), input, units: Units::Unnamed }
}
