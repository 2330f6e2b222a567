//! The truth at any time of a motion that starts at u = e₁: from the nearest of many places in its first period.

use super::exact::{Exact, Point};
use toytop::real::{DoubleDouble, Float};
use toytop::{Complex, Phi};

/// A motion with places all over its first period.
#[derive(Debug)]
pub struct Places<'a> {
    exact: Exact<'a>,
    period: Point,
    places: Vec<Point>,
}

impl<'a> Places<'a> {
    /// `parts` places, evenly spread in χ.
    #[must_use]
    pub fn new(exact: Exact<'a>, parts: u32) -> Self {
        let period = exact.period();
        let mut places: Vec<Point> = vec![exact.start()];
        for part in 1..parts {
            let chi = period.chi * DoubleDouble::from(f64::from(part) / f64::from(parts));
            places.extend(places.last().map(|last| exact.go(last, chi)));
        }
        Self { exact, period, places }
    }

    /// Φ at t >= 0, t taken as exact.
    #[must_use]
    pub fn phi(&self, t: f64) -> Phi<DoubleDouble> {
        let period = self.period.t.to_f64();
        let periods = (t / period).floor();
        let rest = (DoubleDouble::from(t) - self.period.t * periods.into()).to_f64();
        let base = self.places.iter().rev().find(|place| place.t.to_f64() <= rest);
        let base = base.unwrap_or(&self.places[0]);
        let later = self.exact.later(base, &self.period, periods);
        self.exact.phi(&self.exact.at_time(&later, base.chi, t), t)
    }
}

/// To the rounding of `f64`.
#[must_use]
pub fn narrowed(phi: &Phi<DoubleDouble>) -> Phi<f64> {
    let narrow = |z: Complex<DoubleDouble>| Complex::new(z.re.to_f64(), z.im.to_f64());
    Phi { alpha: narrow(phi.alpha), beta: narrow(phi.beta) }
}
