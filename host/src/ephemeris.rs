//! The core's ephemeris in the smallest table of a short list that fits: what a command holds does not know the size.

use crate::Failure;
use crate::bake::{Bake, Parts};
use crate::propagate::period;
use toytop::real::Real;
use toytop::{
    Complex, Ephemeris, ErrorBound, LaunchError, Motion, NoFit, Pose, Stepper, Tabular, Tick, Turns,
};

/// An ephemeris of any size.
pub trait AnySize<R>: Send + Sync {
    /// Segments and terms.
    fn size(&self) -> [usize; 2];

    /// How far it can be from the truth.
    fn error_bound(&self) -> ErrorBound;

    /// The moment t units of time after t = 0, t taken as exact.
    fn at(&self, t: f64) -> Instant<R>;

    /// Its numbers.
    fn parts(&self) -> Parts;
}

/// All that an ephemeris says of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instant<R> {
    /// Φ and Φ'.
    pub pose: Pose<R>,
    /// c = 2 s αβ, m; 2 αβ for a fixed tip.
    pub tip: Complex<R>,
    /// One turn a nutation period, 0 at u = e₁.
    pub nutation_phase: Turns,
}

impl<
    R: Real + Bake + Tabular<Wide = R, Coefficient: Send + Sync> + Send + Sync,
    const SEGMENTS: usize,
    const TERMS: usize,
> AnySize<R> for Ephemeris<R, SEGMENTS, TERMS>
{
    fn size(&self) -> [usize; 2] {
        [SEGMENTS, TERMS]
    }

    fn error_bound(&self) -> ErrorBound {
        Self::error_bound(self)
    }

    fn at(&self, t: f64) -> Instant<R> {
        let moment = Self::at(self, t);
        Instant { pose: moment.pose(), tip: moment.tip(), nutation_phase: moment.nutation_phase() }
    }

    fn parts(&self) -> Parts {
        Parts::of(&self.to_baked())
    }
}

/// Sets up one size, with the truncation allowed, rad.
type SetUp<R> = fn(&Motion, Tick, f64) -> Result<Box<dyn AnySize<R>>, NoFit>;

/// A size of the list, and how to set one up.
#[derive(Clone, Copy)]
pub struct Size<R> {
    segments: u32,
    terms: u32,
    set_up: SetUp<R>,
}

/// A scalar with its list of sizes.
///
/// Four times the segments from size to size, and as many terms as still save segments. Measured on 3000 random motions
/// with differences of the branch points down to 1e-9 and A/(ps) in \[1e-2, 1e3\]: in `f64` half of them need no more than
/// the first size, nine in ten no more than the third, one in 3000 more than the last; in `f32` none needs more than it.
pub trait Sizes:
    Real + Bake + Tabular<Wide = Self, Coefficient: Send + Sync> + Send + Sync + 'static
{
    /// The crate's own choice for most motions.
    const DEFAULT: Size<Self>;
    /// All but the largest, the smallest first.
    const SMALLER: &'static [Size<Self>];
    /// The largest.
    const LARGEST: Size<Self>;
}

impl Sizes for f64 {
    /// [`toytop::EphemerisF64`].
    const DEFAULT: Size<Self> = size::<128, 12, _>();
    const SMALLER: &'static [Size<Self>] =
        &[size::<16, 11, _>(), size::<64, 11, _>(), size::<256, 11, _>(), size::<1024, 11, _>()];
    const LARGEST: Size<Self> = size::<4096, 11, _>();
}

impl Sizes for f32 {
    /// [`toytop::EphemerisF32`].
    const DEFAULT: Size<Self> = size::<16, 8, _>();
    const SMALLER: &'static [Size<Self>] = &[size::<16, 7, _>(), size::<64, 7, _>(), size::<256, 7, _>()];
    const LARGEST: Size<Self> = size::<1024, 7, _>();
}

/// As many terms as a series has, so that fewest segments do: what is set up fastest.
const QUICK: &[Size<f64>] =
    &[size::<16, 16, _>(), size::<32, 16, _>(), size::<128, 16, _>(), size::<512, 16, _>()];

const fn size<const SEGMENTS: usize, const TERMS: usize, R: Sizes>() -> Size<R> {
    Size { segments: SEGMENTS as u32, terms: TERMS as u32, set_up: set_up::<SEGMENTS, TERMS, R> }
}

fn set_up<const SEGMENTS: usize, const TERMS: usize, R: Sizes>(
    motion: &Motion,
    tick: Tick,
    truncation: f64,
) -> Result<Box<dyn AnySize<R>>, NoFit> {
    let mut table = Box::new(Ephemeris::<R, SEGMENTS, TERMS>::EMPTY);
    table.set_up(motion, tick, truncation)?;
    Ok(table)
}

/// The smallest of the list that fits, at the rounding of the scalar.
///
/// # Errors
/// [`Failure::Method`]: none does; the message says which would.
pub fn smallest<R: Sizes>(motion: &Motion) -> Result<Box<dyn AnySize<R>>, Failure> {
    smallest_with_period(motion, period(motion))
}

/// The same, where the period (or the natural time, where there is none) is known: it takes a quadrature.
///
/// # Errors
/// As [`smallest`].
pub fn smallest_with_period<R: Sizes>(motion: &Motion, period: f64) -> Result<Box<dyn AnySize<R>>, Failure> {
    smallest_with_tick(motion, free_tick(motion, period)?)
}

/// In `f64` within 1e-13 rad, by the table that is set up fastest; the period (or the natural time) is known.
///
/// # Errors
/// As [`smallest`].
pub fn quickest(motion: &Motion, period: f64) -> Result<Box<dyn AnySize<f64>>, Failure> {
    first_that_fits(QUICK, motion, free_tick(motion, period)?, 1e-13)
}

fn smallest_with_tick<R: Sizes>(motion: &Motion, tick: Tick) -> Result<Box<dyn AnySize<R>>, Failure> {
    first_that_fits(R::SMALLER, motion, tick, truncation::<R>())
}

/// What `Ephemeris::new` allows.
fn truncation<R: Sizes>() -> f64 {
    4.0 * R::ROUNDING
}

fn first_that_fits<R: Sizes>(
    smaller: &[Size<R>],
    motion: &Motion,
    tick: Tick,
    truncation: f64,
) -> Result<Box<dyn AnySize<R>>, Failure> {
    let mut needed = 0;
    for size in smaller {
        if size.segments >= needed {
            match (size.set_up)(motion, tick, truncation) {
                Ok(table) => return Ok(table),
                // a refusal says how many segments of as many terms would do
                Err(refusal) => needed = refusal.segments.unwrap_or(u32::MAX),
            }
        }
    }
    let Size { segments, terms, set_up } = R::LARGEST;
    set_up(motion, tick, truncation).map_err(|refusal| {
        Failure::Method(format!(
            "no ephemeris: a table of {segments}x{terms} is the largest there is; {refusal}"
        ))
    })
}

/// The crate's default size if the motion fits, otherwise the smallest of the list that does.
///
/// # Errors
/// [`Failure::Method`]: none does; the message says which would.
pub fn default_or_smallest<R: Sizes>(motion: &Motion, tick: Tick) -> Result<Box<dyn AnySize<R>>, Failure> {
    (R::DEFAULT.set_up)(motion, tick, truncation::<R>()).or_else(|_| smallest_with_tick(motion, tick))
}

/// The table of this size.
///
/// # Errors
/// [`Failure::Input`]: none of the sizes there are. [`Failure::Method`]: the motion does not fit it.
pub fn of_size<R: Sizes>(
    size: [u32; 2],
    motion: &Motion,
    tick: Tick,
) -> Result<Box<dyn AnySize<R>>, Failure> {
    let mut sizes = [&[R::DEFAULT], R::SMALLER, &[R::LARGEST]].concat();
    sizes.sort_by_key(|size| [size.segments, size.terms]);
    let known = sizes.iter().find(|known| [known.segments, known.terms] == size).ok_or_else(|| {
        let name = |size: &Size<R>| format!("{}x{}", size.segments, size.terms);
        let allowed: Vec<_> = sizes.iter().map(name).collect();
        let [segments, terms] = size;
        Failure::Input(format!("--size: {segments}x{terms} must be one of {}", allowed.join(", ")))
    })?;
    (known.set_up)(motion, tick, truncation::<R>()).map_err(|refusal| {
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

fn tick(frequency: f64) -> Result<Tick, LaunchError> {
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
    fn sizes_chosen<R: Sizes>(motions: &[Motion]) -> Vec<usize> {
        let chosen = |motion: &Motion| {
            let table = smallest::<R>(motion).unwrap();
            let tick = tick(ticks_per_time(motion)).unwrap();
            for size in R::SMALLER.iter().filter(|size| (size.segments as usize) < table.size()[0]) {
                assert!(
                    (size.set_up)(motion, tick, 4.0 * R::ROUNDING).is_err(),
                    "{} segments would do",
                    size.segments
                );
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
        assert_eq!(sizes_chosen::<f64>(&motions), [16, 64, 256, 1024, 4096]);
        assert_eq!(sizes_chosen::<f32>(&motions), [16, 64, 256, 1024]);
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
