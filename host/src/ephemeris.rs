//! The core's ephemeris in the smallest table of a short list that fits: what a command holds does not know the size.

use crate::Failure;
use crate::bake::Parts;
use crate::cli::Scalar;
use crate::micromath::Micromath;
use crate::propagate::{Sample, period};
use fixed::types::{I2F14, I2F30};
use toytop::real::Float;
use toytop::su2::PhiRate;
use toytop::{
    Complex, Ephemeris, ErrorBound, LaunchError, Motion, NoFit, Phi, Stepper, Tabular, Tick, Turns,
};

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

/// Sets up one size, with the truncation allowed, rad.
type SetUp = fn(&Motion, Tick, f64) -> Result<Box<dyn AnySize>, NoFit>;

/// A size of the list, and how to set one up.
#[derive(Clone, Copy)]
pub struct Size {
    segments: u32,
    terms: u32,
    set_up: SetUp,
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

/// The sizes of a scalar.
///
/// Mostly four times the segments from size to size, and as many terms as still save segments. Measured on 3000 random
/// motions with differences of the branch points down to 1e-9 and A/(ps) in \[1e-2, 1e3\]: half of them need no more than
/// the first size, in `f64` nine in ten 37 segments and none more than 550, in `f32` nine in ten 19 and none more than 202.
struct Sizes {
    /// The crate's own choice for most motions; for fixed point, what the smallest chips are measured with.
    default: Size,
    /// All but the largest, the smallest first.
    smaller: &'static [Size],
    largest: Size,
    /// What `Ephemeris::new` allows, rad.
    truncation: f64,
}

impl Sizes {
    const fn of(scalar: Scalar) -> Self {
        match scalar {
            Scalar::F64 => Self {
                default: size::<48, 11, f64>(),
                smaller: const {
                    &[
                        size::<16, 11, f64>(),
                        size::<32, 11, f64>(),
                        size::<128, 11, f64>(),
                        size::<512, 11, f64>(),
                    ]
                },
                largest: size::<4096, 11, f64>(),
                truncation: truncation::<f64>(),
            },
            Scalar::F32 => Self::single::<f32>(),
            Scalar::Q31 => Self {
                default: size::<32, 4, I2F30>(),
                smaller: const { &[size::<16, 6, I2F30>(), size::<32, 6, I2F30>(), size::<128, 6, I2F30>()] },
                largest: size::<1024, 6, I2F30>(),
                truncation: truncation::<I2F30>(),
            },
            Scalar::Q15 => Self {
                default: size::<16, 3, I2F14>(),
                smaller: const { &[size::<16, 4, I2F14>(), size::<32, 4, I2F14>(), size::<128, 4, I2F14>()] },
                largest: size::<512, 4, I2F14>(),
                truncation: truncation::<I2F14>(),
            },
            Scalar::Micromath => Self::single::<Micromath>(),
        }
    }

    /// Those of `f32`, whoever's sines there are.
    const fn single<R: Tabled>() -> Self {
        Self {
            default: size::<25, 5, R>(),
            smaller: const { &[size::<16, 6, R>(), size::<32, 6, R>(), size::<128, 6, R>()] },
            largest: size::<1024, 6, R>(),
            truncation: truncation::<R>(),
        }
    }
}

const fn truncation<R: Tabled>() -> f64 {
    4.0 * R::ROUNDING
}

/// As many terms as a series has, so that fewest segments do: what is set up fastest.
const QUICK: &[Size] =
    &[size::<16, 16, f64>(), size::<32, 16, f64>(), size::<128, 16, f64>(), size::<512, 16, f64>()];

const fn size<const SEGMENTS: usize, const TERMS: usize, R: Tabled>() -> Size {
    Size { segments: SEGMENTS as u32, terms: TERMS as u32, set_up: set_up::<SEGMENTS, TERMS, R> }
}

fn set_up<const SEGMENTS: usize, const TERMS: usize, R: Tabled>(
    motion: &Motion,
    tick: Tick,
    truncation: f64,
) -> Result<Box<dyn AnySize>, NoFit> {
    let mut table = Box::new(Ephemeris::<R, SEGMENTS, TERMS>::EMPTY);
    table.set_up(motion, tick, truncation)?;
    Ok(table)
}

/// The smallest of the list that fits, at the rounding of the scalar.
///
/// # Errors
/// [`Failure::Method`]: none does; the message says which would.
pub fn smallest(scalar: Scalar, motion: &Motion) -> Result<Box<dyn AnySize>, Failure> {
    smallest_with_period(scalar, motion, period(motion))
}

/// The same, where the period (or the natural time, where there is none) is known: it takes a quadrature.
///
/// # Errors
/// As [`smallest`].
pub fn smallest_with_period(
    scalar: Scalar,
    motion: &Motion,
    period: f64,
) -> Result<Box<dyn AnySize>, Failure> {
    smallest_with_tick(scalar, motion, free_tick(motion, period)?)
}

/// In `f64` within 1e-13 rad, by the table that is set up fastest; the period (or the natural time) is known.
///
/// # Errors
/// As [`smallest`].
pub fn quickest(motion: &Motion, period: f64) -> Result<Box<dyn AnySize>, Failure> {
    const WITHIN: f64 = 1e-13;
    let sizes = Sizes { smaller: QUICK, truncation: WITHIN, ..Sizes::of(Scalar::F64) };
    first_that_fits(&sizes, motion, free_tick(motion, period)?)
}

/// The same as [`smallest`], for ticks of this length.
///
/// # Errors
/// As [`smallest`].
pub fn smallest_with_tick(scalar: Scalar, motion: &Motion, tick: Tick) -> Result<Box<dyn AnySize>, Failure> {
    first_that_fits(&Sizes::of(scalar), motion, tick)
}

fn first_that_fits(sizes: &Sizes, motion: &Motion, tick: Tick) -> Result<Box<dyn AnySize>, Failure> {
    let mut needed = 0;
    for size in sizes.smaller {
        if size.segments >= needed {
            match (size.set_up)(motion, tick, sizes.truncation) {
                Ok(table) => return Ok(table),
                // a refusal says how many segments of as many terms would do
                Err(refusal) => needed = refusal.segments.unwrap_or(u32::MAX),
            }
        }
    }
    let Size { segments, terms, set_up } = sizes.largest;
    set_up(motion, tick, sizes.truncation).map_err(|refusal| {
        Failure::Method(format!(
            "no ephemeris: a table of {segments}x{terms} is the largest there is; {refusal}"
        ))
    })
}

/// The crate's default size if the motion fits, otherwise the smallest of the list that does.
///
/// # Errors
/// [`Failure::Method`]: none does; the message says which would.
pub fn default_or_smallest(scalar: Scalar, motion: &Motion, tick: Tick) -> Result<Box<dyn AnySize>, Failure> {
    let sizes = Sizes::of(scalar);
    (sizes.default.set_up)(motion, tick, sizes.truncation).or_else(|_| first_that_fits(&sizes, motion, tick))
}

/// The table of this size.
///
/// # Errors
/// [`Failure::Input`]: none of the sizes there are. [`Failure::Method`]: the motion does not fit it.
pub fn of_size(
    scalar: Scalar,
    size: [u32; 2],
    motion: &Motion,
    tick: Tick,
) -> Result<Box<dyn AnySize>, Failure> {
    let Sizes { default, smaller, largest, truncation } = Sizes::of(scalar);
    let mut sizes = [&[default], smaller, &[largest]].concat();
    sizes.sort_by_key(|size| [size.segments, size.terms]);
    let known = sizes.iter().find(|known| [known.segments, known.terms] == size).ok_or_else(|| {
        let name = |size: &Size| format!("{}x{}", size.segments, size.terms);
        let allowed: Vec<_> = sizes.iter().map(name).collect();
        let [segments, terms] = size;
        Failure::Input(format!("--size: {segments}x{terms} must be one of {}", allowed.join(", ")))
    })?;
    (known.set_up)(motion, tick, truncation).map_err(|refusal| {
        let [segments, terms] = size;
        Failure::Method(format!("no ephemeris of {segments}x{terms}: {refusal}"))
    })
}

/// Ticks in a unit of time, a power of two: an ephemeris that is asked for times only is free to choose. At least a
/// thousand in a period, and more than one in a turn.
#[must_use]
pub fn ticks_per_time(motion: &Motion) -> f64 {
    ticks_for(motion, period(motion))
}

/// The same, where the period (or the natural time) is known.
#[must_use]
pub fn ticks_for(motion: &Motion, period: f64) -> f64 {
    let [x, y, z] = Stepper::<f64>::new(motion).pose().omega();
    let rate = (x * x + y * y + z * z).sqrt().max(1000.0 / period);
    rate.log2().ceil().clamp(-MOST_EXPONENT, MOST_EXPONENT).exp2()
}

pub(crate) fn free_tick(motion: &Motion, period: f64) -> Result<Tick, Failure> {
    tick(ticks_for(motion, period)).map_err(|error| Failure::Method(error.to_string()))
}

/// 2^31 fits the numerator and the denominator of a [`Tick`].
const MOST_EXPONENT: f64 = 31.0;

/// So many ticks in a unit of time, or one in so many: a whole number.
pub(crate) fn tick(frequency: f64) -> Result<Tick, LaunchError> {
    if frequency >= 1.0 { Tick::hertz(frequency as u32) } else { Tick::ratio(1, frequency.recip() as u32) }
}

/// The times that can be asked for are within ± this: ticks are counted in 64 bits.
#[must_use]
pub fn furthest_time(motion: &Motion) -> f64 {
    62_f64.exp2() / ticks_per_time(motion)
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Heaviness, Signs, Start, Top};

    fn motion(a: f64, e: [f64; 3]) -> Motion {
        let top = Top::sliding(a, 0.8 * a, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
        Motion::from_branch_points(&top, e, Signs::default(), &Start::default()).unwrap()
    }

    /// Every smaller size refuses; and the motions here need every size there is.
    fn sizes_chosen(scalar: Scalar, motions: &[Motion]) -> Vec<usize> {
        let Sizes { smaller, truncation, .. } = Sizes::of(scalar);
        let chosen = |motion: &Motion| {
            let table = smallest(scalar, motion).unwrap();
            let tick = tick(ticks_per_time(motion)).unwrap();
            for size in smaller.iter().filter(|size| (size.segments as usize) < table.size()[0]) {
                let refused = (size.set_up)(motion, tick, truncation).is_err();
                assert!(refused, "{} segments would do", size.segments);
            }
            table.size()[0]
        };
        let mut sizes: Vec<_> = motions.iter().map(chosen).collect();
        sizes.sort_unstable();
        sizes.dedup();
        sizes
    }

    #[test]
    fn the_smallest_that_fits() {
        let mut motions = vec![motion(1.0, [0.5, 0.5, 2.0]), motion(1.0, [0.2, 1.0, 1.0])];
        for exponent in 0..13 {
            let small = 2_f64.powi(-exponent);
            motions.push(motion(1.0, [-0.5, 1.0 - 0.2 * small, 1.0 + 0.2 * small * small]));
            motions.push(motion(small, [-0.99, 0.999, 1.02]));
        }
        assert_eq!(sizes_chosen(Scalar::F64, &motions), [16, 32, 128, 512, 4096]);
        assert_eq!(sizes_chosen(Scalar::F32, &motions), [16, 32, 128, 1024]);
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
