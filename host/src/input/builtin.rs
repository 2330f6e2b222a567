//! Built-in motions, which `compare` runs without a scenario file.

use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use toytop::{Sign, Signs};

/// Scenarios of the paper's figures 2 and 3, of seven tops in SI units, and of two motions near the separatrix.
///
/// # Errors
/// None: every one is valid, and a test runs them.
pub fn scenarios() -> Result<Vec<Scenario>, Failure> {
    let mut scenarios = figures()?.concat();
    for (name, text) in SAMPLES {
        scenarios.push(Scenario::parse(name, text)?);
    }
    for (gap, _) in SEPARATRIX {
        // e₂ and e₃ are on both sides of 1 and so close that the axis stays near the vertical for a long part of every period; A and C differ
        let top = "transverse_inertia = 1.1\naxial_inertia = 0.8\ncom_height = 0.6\nmass_moment = 0.9";
        let e = [0.2, 1.0 - 0.5 * gap, 1.0 + 0.5 * gap];
        scenarios.push(curve(&separatrix_name(gap), top, e, SAME)?);
    }
    Ok(scenarios)
}

/// Bounds on the errors of a built-in motion over ten periods, rad, in place of those of any motion.
#[derive(Clone, Copy)]
pub struct OwnBounds {
    /// Bound on the error of the full solver.
    pub full_solver: f64,
    /// Bound on the error of the stepper in f32. In f64 the bound of the full solver is larger.
    pub stepper_f32: f64,
}

impl OwnBounds {
    /// Bound on the error of the stepper alone, rad.
    pub fn stepper(&self, scalar: Scalar) -> f64 {
        match scalar {
            Scalar::F64 => 0.0,
            _ => self.stepper_f32,
        }
    }
}

/// e₃ - e₂ of the two motions near the separatrix, and their bounds. The measured errors are 1.7e-11 and 5e-6 rad for the first, 4.1e-9
/// and 1.6e-5 rad for the second.
const SEPARATRIX: [(f64, OwnBounds); 2] = [
    (1e-3, OwnBounds { full_solver: 1e-10, stepper_f32: 2e-5 }),
    (1e-6, OwnBounds { full_solver: 1e-8, stepper_f32: 5e-5 }),
];

/// Own bounds of a built-in motion; `None` for every other motion.
pub fn own_bounds(scenario: &Scenario) -> Option<OwnBounds> {
    SEPARATRIX.iter().find(|(gap, _)| scenario.name == separatrix_name(*gap)).map(|(_, bounds)| *bounds)
}

fn separatrix_name(gap: f64) -> String {
    format!("near separatrix {gap:e}")
}

/// Scenario file of the toy top.
pub const TOY_TOP: &str = include_str!("../../scenarios/toy_top.toml");

/// Scenario files that are not figures of the paper.
const SAMPLES: [(&str, &str); 7] = [
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
///
/// # Errors
/// None: every one is valid, and a test runs them.
pub fn figures() -> Result<[Vec<Scenario>; 2], Failure> {
    let top = "transverse_inertia = 1\naxial_inertia = 1\ncom_height = 1\nmass_moment = 1";
    let [second, third] = FIGURES.map(|(figure, signs, e3s)| {
        let curve = |e3: &f64| curve(&format!("{figure} e3={e3}"), top, [0.7, 0.9, *e3], signs);
        e3s.iter().map(curve).collect::<Result<_, _>>()
    });
    Ok([second?, third?])
}

fn curve(name: &str, top: &str, [e1, e2, e3]: [f64; 3], signs: Signs) -> Result<Scenario, Failure> {
    let [plus, minus] = [signs.l_plus_n, signs.l_minus_n].map(Sign::factor);
    // {:?} has the digits that read back the same number
    let numbers =
        format!("e1 = {e1:?}\ne2 = {e2:?}\ne3 = {e3:?}\nsign_l_plus_n = {plus}\nsign_l_minus_n = {minus}");
    let text =
        format!("units = \"none\"\n[top]\ngravity = 1\n{top}\n[motion]\nkind = \"branch_points\"\n{numbers}");
    Scenario::parse(name, &text)
}
