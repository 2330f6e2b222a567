//! Time at which a nutation is fastest.

use super::{Exact, Place};
use crate::truth::law::End;
use crate::truth::precise::{Precise, precise, to_f64};

/// Number of places that are compared in each octave of the distance from a turning point.
const PER_OCTAVE: f64 = 4.0;

impl Exact {
    /// Time after the start, in one of the periods, at which Φ without its mean rotation changes fastest; 0 for a motion that does not
    /// nutate.
    #[must_use]
    pub fn fastest(&self) -> Precise {
        let Some(passage) = &self.passage else { return precise(0.0) };
        let [time, alpha, beta] = passage.half.each_ref().map(to_f64);
        let mean_rates = [alpha / time, beta / time];
        let mut best = (f64::NEG_INFINITY, Place { quarter: 0, beyond: precise(0.0) });
        for (quarter, end) in [(0, End::Lower), (1, End::Upper)] {
            let Some(depth) = self.coarse.depth(end) else { continue };
            let octaves = (4.0 / depth).log2().clamp(2.0, 60.0);
            let distances =
                (0..(PER_OCTAVE * octaves) as u32).map(|i| (-0.5 - f64::from(i) / PER_OCTAVE).exp2());
            for beyond in distances.chain([0.0]) {
                let relative_speed_squared = self.coarse.relative_speed_squared(end, beyond, mean_rates);
                if relative_speed_squared > best.0 {
                    best = (relative_speed_squared, Place { quarter, beyond: precise(beyond) });
                }
            }
        }
        self.time_of_place(&best.1)
    }
}
