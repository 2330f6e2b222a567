//! The core's ephemeris in the smallest table of a short list that fits: what a command holds does not know the size.

mod sizes;
mod ticks;

pub use sizes::{default_or_smallest, of_size, quickest, smallest, smallest_with_period};
pub(crate) use ticks::tick;
pub use ticks::{furthest_time, ticks_for, ticks_per_time};

use crate::bake::Parts;
use crate::micromath::Micromath;
use crate::propagate::Sample;
use fixed::types::{I2F14, I2F30};
use toytop::real::Float;
use toytop::su2::PhiRate;
use toytop::{Complex, Ephemeris, ErrorBound, Phi, Tabular, Turns};

/// An ephemeris of any scalar and size.
pub trait AnySize: Send + Sync {
    /// Segments and terms.
    fn size(&self) -> [usize; 2];

    /// How far it can be from the truth.
    fn error_bound(&self) -> ErrorBound;

    /// The moment t units of time after t = 0, t taken as exact.
    fn at(&self, t: f64) -> Instant;

    /// What an interrupt reads: Φ, u and the tip of tick n, in the scalar's own arithmetic.
    fn at_tick(&self, n: i64) -> Reading;

    /// Its numbers; `None` where nothing else would know how to read them.
    fn parts(&self) -> Option<Parts>;
}

/// A tick, in `f64` without rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Φ.
    pub phi: Phi<f64>,
    /// The cosine of the tilt.
    pub u: f64,
    /// c/s = 2αβ.
    pub tip_over_s: Complex<f64>,
}

/// All that an ephemeris says of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant {
    /// α, β and u as the scalar has them; the rates and the tip as its wide companion has them (`f32` beside fixed point). The
    /// tip angle is not known.
    pub sample: Sample,
    /// Φ'.
    pub rate: PhiRate<f64>,
    /// One turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Turns,
}

impl<R: Tabled, const SEGMENTS: usize, const TERMS: usize> AnySize for Ephemeris<R, SEGMENTS, TERMS> {
    fn size(&self) -> [usize; 2] {
        [SEGMENTS, TERMS]
    }

    fn error_bound(&self) -> ErrorBound {
        Self::error_bound(self)
    }

    fn at_tick(&self, n: i64) -> Reading {
        let phi = Self::at_tick(self, n).phi();
        let product = phi.alpha * phi.beta;
        let exact = |z: Complex<R>| Complex::new(z.re.into(), z.im.into());
        Reading {
            phi: Phi { alpha: exact(phi.alpha), beta: exact(phi.beta) },
            u: phi.u().into(),
            tip_over_s: exact(product + product),
        }
    }

    fn at(&self, t: f64) -> Instant {
        let moment = Self::at(self, t);
        let (phi, pose) = (moment.phi(), moment.pose());
        let exact = |z: Complex<R>| Complex::new(z.re.into(), z.im.into());
        let wide = |z: Complex<R::Wide>| Complex::new(z.re.to_f64(), z.im.to_f64());
        let sample = Sample {
            u: phi.u().into(),
            alpha: exact(phi.alpha),
            beta: exact(phi.beta),
            ..Sample::of(t, &pose, moment.wide_tip(), None)
        };
        let rate = PhiRate { alpha: wide(pose.rate.alpha), beta: wide(pose.rate.beta) };
        Instant { sample, rate, nutation_phase: moment.nutation_phase() }
    }

    fn parts(&self) -> Option<Parts> {
        R::parts(self)
    }
}

/// A scalar that an ephemeris is made in.
pub trait Tabled:
    Tabular<Coefficient: Send + Sync, Wide: Send + Sync> + Into<f64> + Send + Sync + 'static
{
    /// The numbers of a table; `None` where nothing but this program reads them.
    fn parts<const SEGMENTS: usize, const TERMS: usize>(
        _: &Ephemeris<Self, SEGMENTS, TERMS>,
    ) -> Option<Parts> {
        None
    }
}

macro_rules! baked {
    ($($scalar:ty)*) => { $(
        impl Tabled for $scalar {
            fn parts<const S: usize, const T: usize>(table: &Ephemeris<Self, S, T>) -> Option<Parts> {
                Some(Parts::of(&table.to_baked()))
            }
        }
    )* };
}

baked!(f64 f32 I2F30 I2F14);
impl Tabled for Micromath {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::propagate::period;
    use toytop::{Heaviness, Motion, Signs, Start, Top};

    pub(super) fn motion(a: f64, e: [f64; 3]) -> Motion {
        let top = Top::sliding(a, 0.8 * a, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
        Motion::from_branch_points(&top, e, Signs::default(), &Start::default()).unwrap()
    }

    #[test]
    fn a_tick_is_shorter_than_a_turn_and_a_thousandth_of_a_period() {
        for motion in
            [motion(1.0, [0.2, 0.8, 1.5]), motion(1e-6, [0.2, 0.8, 1e6]), motion(1e9, [0.2, 0.8, 1.5])]
        {
            let rate = ticks_per_time(&motion);
            assert!(rate * period(&motion) >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(furthest_time(&motion) / period(&motion) >= 1e10);
        }
    }
}
