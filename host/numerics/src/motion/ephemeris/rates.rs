//! Rates of a motion at one time, and the distance of two of them.

/// Rates at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    #[must_use]
    pub fn distance(&self, other: &Self) -> f64 {
        let apart = |x: [f64; 3], y: [f64; 3]| norm(std::array::from_fn(|i| x[i] - y[i]));
        let differences = [
            apart(self.omega, other.omega),
            apart(self.omega_body, other.omega_body),
            (self.udot - other.udot).abs(),
        ];
        differences.into_iter().fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { x.max(most) })
    }

    /// Angular speed |Ω|, rad per unit time.
    #[must_use]
    pub fn speed(&self) -> f64 {
        norm(self.omega_body)
    }
}

fn norm(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
