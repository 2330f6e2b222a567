//! Errors of samples, rotation between two orientations, and drift of the first integrals.

use super::sample::MotionSample;
use nalgebra::Vector3;
use toytop::{Motion, Orientation, Top};
use toytop_model::equations::{Equations, FullState, Rates};

/// Greater of two errors; infinite where the second is no number.
pub fn greater_or_infinite(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// Distance of two vectors.
pub fn distance(x: [f64; 3], y: [f64; 3]) -> f64 {
    (Vector3::from(x) - Vector3::from(y)).norm()
}

/// Rotation vector x of the shorter rotation exp(x) that takes `from` to `to`, in the fixed frame, rad: `to` = exp(x) `from`, whatever
/// the signs of both.
pub fn rotation_between(from: &Orientation<f64>, to: &Orientation<f64>) -> [f64; 3] {
    let [w, x, y, z] = to.compose(&from.inverse()).quaternion();
    let sine = (x * x + y * y + z * z).sqrt();
    if sine == 0.0 {
        return [0.0; 3];
    }
    // the quaternion with w >= 0 belongs to the shorter rotation
    let scale = 2.0 * sine.atan2(w.abs()).copysign(w) / sine;
    [scale * x, scale * y, scale * z]
}

/// Errors of a sample.
#[derive(Clone, Copy, Default)]
pub struct Errors {
    /// Error of the orientation, 2 √(|Δα|² + |Δβ|²), rad.
    pub orientation: f64,
    /// Error of u.
    pub u: f64,
    /// Error of the tip in units of its scale.
    pub tip: f64,
    /// Error of the norm |α|² + |β|².
    pub norm: f64,
    /// Drifts, from α, β and Ω in `f64`.
    pub drift: Drifts,
}

impl Errors {
    /// Errors of a sample of a motion whose orientation is `truth`.
    pub fn between(motion: &Motion, sample: &MotionSample, truth: &Orientation<f64>) -> Self {
        let orientation = sample.orientation;
        let tip = sample.tip.scaled(1.0 / motion.top().tip_scale()) - truth.tip_over_s();
        Self {
            orientation: orientation.distance(truth),
            u: (sample.u - truth.u()).abs(),
            tip: tip.modulus(),
            norm: (orientation.norm_squared() - 1.0).abs(),
            drift: Drifts::new(motion, &orientation, orientation.adjoint(sample.rates.omega_body)),
        }
    }

    /// Greater errors of two samples.
    pub fn greater(self, other: Self) -> Self {
        Self {
            orientation: greater_or_infinite(self.orientation, other.orientation),
            u: greater_or_infinite(self.u, other.u),
            tip: greater_or_infinite(self.tip, other.tip),
            norm: greater_or_infinite(self.norm, other.norm),
            drift: self.drift.greater(other.drift),
        }
    }
}

/// Greatest of the differences |Δω|, |ΔΩ| and |Δu'|, rad per unit time.
pub fn rate_error(rates: &Rates, truth: &Rates) -> f64 {
    let vectors = [distance(rates.omega, truth.omega), distance(rates.omega_body, truth.omega_body)];
    vectors.into_iter().fold(greater_or_infinite(0.0, (rates.udot - truth.udot).abs()), greater_or_infinite)
}

/// First integrals [l, n, h] in kg m²/s and kg m²/s², by the full equations.
fn first_integrals(top: &Top, orientation: &Orientation<f64>, omega: [f64; 3]) -> [f64; 3] {
    let state = FullState::new(orientation, omega);
    Equations::new(top, &state).first_integrals(&state)
}

/// Units of the drifts: max(|l|, |n|, √(2 A p g)) for l and n, and max(|h|, p g) for h. Without torque, √(2 A |h|) takes the
/// place of √(2 A p g).
fn natural_scales(motion: &Motion) -> (f64, f64) {
    let (top, constants) = (motion.top(), motion.first_integrals());
    let weight = top.mass_moment() * top.gravity();
    let a = top.transverse_inertia();
    // for a free body at rest all of them are 0
    let energy = weight.max(constants.h.abs()).max(f64::MIN_POSITIVE);
    let momentum = (2.0 * a * weight).sqrt().max(constants.l.abs()).max(constants.n.abs());
    let momentum = if top.is_torque_free() { momentum.max((2.0 * a * energy).sqrt()) } else { momentum };
    (momentum, energy)
}

/// Differences of the first integrals between a state and a motion, in units of their natural scales.
#[derive(Clone, Copy, Default)]
pub struct Drifts {
    /// Difference of the vertical angular momentum.
    pub l: f64,
    /// Difference of the axial angular momentum.
    pub n: f64,
    /// Difference of the energy.
    pub h: f64,
}

impl Drifts {
    /// Drifts of this orientation and angular velocity in the fixed frame, rad per unit time.
    pub fn new(motion: &Motion, orientation: &Orientation<f64>, omega: [f64; 3]) -> Self {
        let (exact, (momentum, energy)) = (motion.first_integrals(), natural_scales(motion));
        let [l, n, h] = first_integrals(motion.top(), orientation, omega);
        let drift = |found: f64, exact: f64, scale: f64| (found - exact).abs() / scale;
        Self { l: drift(l, exact.l, momentum), n: drift(n, exact.n, momentum), h: drift(h, exact.h, energy) }
    }

    /// Greater drifts of two states.
    pub fn greater(self, other: Self) -> Self {
        Self {
            l: greater_or_infinite(self.l, other.l),
            n: greater_or_infinite(self.n, other.n),
            h: greater_or_infinite(self.h, other.h),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Complex, FirstIntegrals, State, TopParameters};

    #[test]
    fn the_rotation_between_two_orientations_does_not_see_signs() {
        let from = Orientation::from_quaternion([0.5, -0.5, 0.1, 0.7]).normalised();
        for x in [[1e-9, -2e-9, 3e-10], [0.3, -0.2, 1.1], [0.0; 3]] {
            let to = Orientation::exp(x).compose(&from);
            let negative = Orientation { alpha: -to.alpha, beta: -to.beta };
            for to in [to, negative] {
                let found = rotation_between(&from, &to);
                assert!(found.iter().zip(x).all(|(found, x)| (found - x).abs() < 1e-15), "{found:?}");
            }
        }
    }

    #[test]
    fn first_integrals_agree_with_the_core() {
        let sliding = Top::sliding(&TopParameters {
            transverse_inertia: 1.1,
            axial_inertia: 0.8,
            com_height: 0.6,
            mass_moment: 0.9,
            gravity: 9.81,
            ..TopParameters::default()
        });
        for top in [
            sliding,
            Top::fixed(&TopParameters {
                transverse_inertia: 1.1,
                axial_inertia: 0.8,
                mass_moment: 0.9,
                gravity: 2.0,
                ..TopParameters::default()
            }),
        ]
        .map(Result::unwrap)
        {
            let (alpha, beta) = (Complex::new(0.48, 0.64), Complex::new(-0.36, 0.48));
            let omega = [0.3, -0.7, 1.9];
            let core =
                FirstIntegrals::from_state(&top, &State::new(Orientation { alpha, beta }, omega).unwrap());
            let found = first_integrals(&top, &Orientation { alpha, beta }, omega);
            for (x, y) in found.into_iter().zip([core.l, core.n, core.h]) {
                assert!((x - y).abs() < 4e-15 * y.abs(), "{x} {y}");
            }
        }
    }
}
