//! Samples of an ephemeris of any scalar, in `f64`.

use crate::motion::greater;
use crate::motion::propagate::Sample;
use toytop::su2::OrientationRate;
use toytop::{Complex, Phase};

/// Sample of an ephemeris with more than every method has.
pub struct TimedSample {
    /// α, β and u in the precision of the scalar; rates, tip and tip angle in that of its type for lengths and rates (`f32` for fixed
    /// point).
    pub sample: Sample,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<f64>,
    /// Position of the tip in units of s, c/s = 2αβ, in the precision of the scalar.
    pub tip_over_s: Complex<f64>,
    /// Nutation phase: one turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Phase,
}

/// Rates at one time.
pub struct RateSample {
    /// Angular velocity ω in the fixed frame, rad per unit time.
    pub omega: [f64; 3],
    /// Angular velocity Ω in the body frame, rad per unit time.
    pub omega_body: [f64; 3],
    /// Rate u' of the cosine of the tilt, per unit time.
    pub udot: f64,
}

impl RateSample {
    /// Greatest of the differences |Δω|, |ΔΩ| and |Δu'|, rad per unit time; infinite where one of them is no number.
    pub fn distance(&self, other: &Self) -> f64 {
        let apart = |x: [f64; 3], y: [f64; 3]| norm([x[0] - y[0], x[1] - y[1], x[2] - y[2]]);
        let vectors = [apart(self.omega, other.omega), apart(self.omega_body, other.omega_body)];
        vectors.into_iter().fold(greater(0.0, (self.udot - other.udot).abs()), greater)
    }

    /// Angular speed |Ω|, rad per unit time.
    pub fn speed(&self) -> f64 {
        norm(self.omega_body)
    }
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
