//! Constants of a motion: from its branch points, or from a state.
//!
//! A state needs no special formulas: 192 digits absorb the cancellation.
//!
//! (u - e₁)(u - e₂)(u - e₃) = u³ - E u² - u + E - κ (l - nu)² with κ = 1/(2Apg) and E = (h - (n - K)²/2C)/(pg).

use super::float640::{
    Complex640, Float640, cis, conjugate, from_f64, from_i64, is_zero, norm_squared, product, square_root,
    to_f64,
};
use super::nutation::{HalfPhase, NutationConstants};
use crate::input::scenario::{Launch, MotionInput};
use std::f64::consts::PI;
use toytop::{InitialAngles, Orientation, Sign, Signs, Support};

/// Constants of a motion, and its state at the launch.
pub struct LaunchConstants {
    pub constants: NutationConstants,
    /// Half the difference of the spin and of n/A.
    pub half_spin_difference: Float640,
    pub half_phase: HalfPhase,
    /// Directions α/|α| and β/|β|; a parameter that is 0 has the direction of its derivative.
    pub directions: [Complex640; 2],
}

impl LaunchConstants {
    /// Constants of this input. Products of its numbers are not rounded.
    pub fn new(MotionInput { support, top, launch }: &MotionInput) -> Self {
        let [a, c, k] = [top.transverse_inertia, top.axial_inertia, top.rotor_momentum].map(from_f64);
        let s = from_f64(if *support == Support::Sliding { top.com_height } else { 0.0 });
        let p = match support {
            Support::Free => from_f64(0.0),
            _ if top.mass == 0.0 => from_f64(top.mass_moment),
            _ => from_f64(top.mass) * from_f64(top.com_height),
        };
        let g = from_f64(if *support == Support::Free { 0.0 } else { top.gravity });
        let top = [a, c, s, p, g, k];
        match *launch {
            Launch::BranchPoints { e, signs, phases } => Self::from_branch_points(&top, e, signs, phases),
            Launch::State { orientation, omega } => Self::from_state(&top, &orientation, omega),
        }
    }

    /// Whether u is constant: e₁ = e₂, or an upright top at rest with e₃ = 1.
    pub fn is_steady(&self) -> bool {
        let [[at_e1, at_e2], _, [_, e3_minus_e2]] = &self.constants.factors_at_ends;
        at_e1 == at_e2 || (is_zero(e3_minus_e2) && is_zero(&self.half_phase[0]))
    }

    fn from_state(
        [a, c, s, p, g, k]: &[Float640; 6],
        orientation: &Orientation<f64>,
        omega: [f64; 3],
    ) -> Self {
        let [alpha, beta] = [orientation.alpha, orientation.beta].map(|z| [z.re, z.im].map(from_f64));
        let [w1, w2, w3] = omega.map(from_f64);
        let norm = norm_squared(&alpha) + norm_squared(&beta);
        let u = (norm_squared(&alpha) - norm_squared(&beta)) / &norm;
        // r₁ + i r₂ = -2αβ
        let [r1, r2] = product(&alpha, &beta).map(|part| part * -2 / &norm);
        let spin: Float640 = &w1 * &r1 + &w2 * &r2 + &w3 * &u;
        let n = c * &spin + k;
        let l = a * &w3 + (&n - a * &spin) * &u;
        let udot: Float640 = &w1 * &r2 - &w2 * &r1;
        // |ω × r|²
        let across = w1.sqr() + w2.sqr() + w3.sqr() - spin.sqr();
        let momentum_squared = a.sqr() * &across + n.sqr();
        let weight = p * g * 2;
        let ([e1, e2], e3_minus_u, field) = if !is_zero(&weight) {
            let energy = &u + (a * across + p * s * udot.sqr()) / &weight;
            let [e1, e2, e3] = roots_of_cubic(&energy, &(from_i64(1) / (a * weight)), &l, &n);
            let e3_minus_u = [&e3 - &e1, e3 - &e2].map(root_difference);
            ([e1, e2], e3_minus_u, [s.clone(), g.clone(), a / p])
        } else {
            // A² u'² = |m|² (u - e₁)(e₂ - u): the integrands with D = 1, e₃ - u = 1 and g = |m|²/2A²
            let (middle, half) = if is_zero(&momentum_squared) {
                (u.clone(), from_i64(0))
            } else {
                let horizontal = (&momentum_squared - l.sqr()) * (&momentum_squared - n.sqr());
                (&l * &n / &momentum_squared, square_root(&horizontal) / &momentum_squared)
            };
            let field = [from_i64(0), momentum_squared / (a.sqr() * 2), from_i64(1)];
            ([&middle - &half, middle + half], [from_i64(1), from_i64(1)], field)
        };
        let half_spin_difference = (spin - &n / a) / from_i64(2);
        let constants = constants(a, [&e1, &e2], e3_minus_u, field, [&l + &n, l - n]);
        let [at_e1, at_e2] = &constants.factors_at_ends[0];
        let half_phase = if at_e1 == at_e2 {
            [from_i64(1), from_i64(0)]
        } else {
            let [cosine, sine] = [e2 - &u, u - e1].map(|part| square_root(&root_difference(part)));
            [cosine, if udot < Float640::ZERO { -sine } else { sine }]
        };
        let directions = directions(&alpha, &beta, [&w1, &w2]);
        Self { constants, half_spin_difference, half_phase, directions }
    }

    fn from_branch_points(
        [a, c, s, p, g, k]: &[Float640; 6],
        e: [f64; 3],
        signs: Signs,
        phases: InitialAngles,
    ) -> Self {
        let root_of = |sign, factors: [Float640; 3]| {
            let [x, y, z] = factors;
            square_root(&(a * p * g * 2 * x * y * z)) * if sign == Sign::Plus { 1 } else { -1 }
        };
        let [e1, e2, e3] = &e.map(from_f64);
        let l_plus_n = root_of(signs.l_plus_n, [e1 + 1, e2 + 1, e3 + 1]);
        let l_minus_n = root_of(signs.l_minus_n, [-e1 + 1, -e2 + 1, e3 - 1]);
        let n = (&l_plus_n - &l_minus_n) / from_i64(2);
        let spin = if is_zero(c) { from_i64(0) } else { (&n - k) / c };
        let half_spin_difference = (spin - n / a) / from_i64(2);
        let half_phase = if phases.theta.abs() == PI {
            // the f64 nearest to π stands for π
            [from_i64(0), from_f64(phases.theta.signum())]
        } else {
            cis(&from_f64(0.5 * phases.theta))
        };
        let directions = [phases.arg_alpha, phases.arg_beta].map(|angle| cis(&from_f64(angle)));
        let (e3_minus_u, field) = ([e3 - e1, e3 - e2], [s.clone(), g.clone(), a / p]);
        let constants = constants(a, [e1, e2], e3_minus_u, field, [l_plus_n, l_minus_n]);
        Self { constants, half_spin_difference, half_phase, directions }
    }
}

/// Constants from A, e₁ and e₂, the values of e₃ - u there, s, g and A/p, and l ± n.
fn constants(
    a: &Float640,
    [e1, e2]: [&Float640; 2],
    e3_minus_u: [Float640; 2],
    [s, g, a_over_p]: [Float640; 3],
    [l_plus_n, l_minus_n]: [Float640; 2],
) -> NutationConstants {
    let [one_plus_e1, one_minus_e2, swing] = [e1 + 1, -e2 + 1, e2 - e1].map(root_difference);
    let momentum = |sum: Float640, gap: &Float640| if is_zero(gap) { from_i64(0) } else { sum / (a * 2) };
    let momentum_rates = [momentum(l_plus_n, &one_plus_e1), momentum(l_minus_n, &one_minus_e2)];
    let above = [one_plus_e1.clone(), one_plus_e1 + &swing];
    let below = [&one_minus_e2 + swing, one_minus_e2];
    NutationConstants { s, g, a_over_p, factors_at_ends: [above, below, e3_minus_u], momentum_rates }
}

/// Difference of two roots; 0 where it is below the error of a double root, which is known to half of the digits.
fn root_difference(difference: Float640) -> Float640 {
    const SAME: f64 = 1e-60;
    if to_f64(&difference) < SAME { from_i64(0) } else { difference }
}

/// Roots e₁ <= e₂ <= e₃ of u³ - E u² - u + E - κ (l - nu)², by Viète's formula.
fn roots_of_cubic(energy: &Float640, kappa: &Float640, l: &Float640, n: &Float640) -> [Float640; 3] {
    // with v = u - mean: v³ - 3 q v - 2 r
    let mean = (energy + kappa * n.sqr()) / from_i64(3);
    let linear: Float640 = kappa * l * n * 2 - 1;
    let q = mean.sqr() - &linear / from_i64(3);
    let r = mean.sqr() * &mean + (kappa * l.sqr() - energy - &mean * linear) / from_i64(2);
    let radius = square_root(&q);
    // three equal roots have no angle
    let cube = (q * &radius).max(from_f64(1e-300));
    let angle = (r / cube).clamp(from_i64(-1), from_i64(1)).acos() / from_i64(3);
    let [forward, across] = cis(&angle).map(|part| part * &radius);
    let across = across * from_i64(3).sqrt();
    [&mean - &forward - &across, &mean - &forward + across, mean + forward * 2]
}

/// Directions α/|α| and β/|β|; a parameter that is 0 has the direction of its derivative: there 2α' = (ω₂ - iω₁) β̄ and 2β' = -(ω₂ - iω₁) ᾱ.
fn directions(alpha: &Complex640, beta: &Complex640, [w1, w2]: [&Float640; 2]) -> [Complex640; 2] {
    let direction = |z: &Complex640, other: &Complex640, sign: i64| {
        let leaving = product(&[w2 * sign, -w1 * sign], &conjugate(other));
        let z = [z, &leaving].into_iter().find(|z| !is_zero(&norm_squared(z)));
        z.map_or([from_i64(1), from_i64(0)], |z| {
            z.each_ref().map(|part| part / square_root(&norm_squared(z)))
        })
    };
    [direction(alpha, beta, 1), direction(beta, alpha, -1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Complex, TopParameters};

    /// Difference e₂ - e₁ of a state close to a regular precession: half of the digits of the cubic cancel, and 57 must remain.
    #[test]
    fn a_swing_of_the_last_place_is_known_to_all_digits() {
        // tilt 60°, precession 1, spin 3/2 would be steady; ω₃ is one unit in the last place too large
        let root = 0.75_f64.sqrt();
        let orientation = Orientation { alpha: Complex::new(root, 0.0), beta: Complex::new(-0.5, 0.0) };
        let launch = Launch::State { orientation, omega: [root, 0.0, 1.5_f64.next_up()] };
        let ones = TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 1.0,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        };
        let input = MotionInput { support: Support::Sliding, top: ones, launch };
        let LaunchConstants { constants, half_phase, .. } = LaunchConstants::new(&input);
        let [[one_plus_e1, one_plus_e2], [_, one_minus_e2], _] = &constants.factors_at_ends;
        assert!(to_f64(&(one_plus_e2 + one_minus_e2 - 2)).abs() < 1e-55);
        let swing = one_plus_e2 - one_plus_e1;
        assert!(to_f64(&(norm_squared(&half_phase) / &swing - 1)).abs() < 1e-55);
        let swing = to_f64(&swing);
        assert!(swing > 1e-18 && swing < 1e-14, "{swing:e}");
    }
}
