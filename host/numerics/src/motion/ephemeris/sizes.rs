//! The capacities that a table may have, and the choice among them.

use super::ticks::free_tick;
use super::{AnyScalar, Boxed, BoxedScalar};
use crate::Failure;
use crate::motion::Scalar;
use crate::motion::propagate::period;
use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisScalar, EphemerisView, ErrorBound, Micromath, Motion, TableTooSmall, Tick};

type SetUp = fn(u32, &Motion, Tick, f64) -> Result<Box<dyn AnyScalar>, TableTooSmall>;

/// Capacities of a scalar.
#[derive(Clone, Copy)]
struct Sizes {
    /// Segments of the crate's own type alias, which fits most motions.
    default: u32,
    /// Truncation error that `Ephemeris::new` allows, rad.
    truncation: f64,
    /// Coefficients of a polynomial.
    terms: usize,
    set_up: SetUp,
    needed: fn(&Motion, f64) -> Option<u32>,
}

impl Sizes {
    fn of(scalar: Scalar) -> Self {
        match scalar {
            Scalar::F64 => Self::with::<f64>(48),
            Scalar::F32 => Self::with::<f32>(25),
            Scalar::Q31 => Self::with::<I2F30>(32),
            Scalar::Q15 => Self::with::<I2F14>(16),
            Scalar::Micromath => Self::with::<Micromath>(25),
        }
    }

    /// Text of a refusal, with the least `--size` that would be enough or, where none is, the number of segments.
    fn explain(&self, refusal: &TableTooSmall, motion: &Motion) -> String {
        let fit = match (self.needed)(motion, self.truncation) {
            Some(segments) => match self.allowed().into_iter().find(|size| *size >= segments) {
                Some(size) if size > refusal.segments => format!("at least --size {size} would be enough"),
                _ => format!("{segments} segments of this degree would be enough"),
            },
            None => format!("not even {LARGEST} segments of this degree would be enough"),
        };
        format!("{refusal}; {fit}")
    }

    /// Capacities in ascending order, the default among them.
    fn allowed(&self) -> Vec<u32> {
        let mut allowed = CAPACITIES.to_vec();
        allowed.push(self.default);
        allowed.sort_unstable();
        allowed.dedup();
        allowed
    }

    fn with<R: BoxedScalar>(default: u32) -> Self {
        Self {
            default,
            truncation: 4.0 * R::ROUNDING,
            terms: R::TERMS,
            set_up: set_up::<R>,
            needed: EphemerisView::<R>::segments_needed,
        }
    }
}

/// Capacities besides the defaults, in ascending order; each is twice the one before.
const CAPACITIES: [u32; 10] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/// Largest capacity.
const LARGEST: u32 = CAPACITIES[CAPACITIES.len() - 1];

/// Empty table of this many segments, one of the defaults or of [`CAPACITIES`].
fn empty<R: EphemerisScalar>(segments: u32) -> Option<Box<EphemerisView<R>>> {
    fn boxed<R: EphemerisScalar, const N: usize>() -> Box<EphemerisView<R>> {
        Box::new(Ephemeris::<R, N>::EMPTY)
    }
    Some(match segments {
        8 => boxed::<R, 8>(),
        16 => boxed::<R, 16>(),
        25 => boxed::<R, 25>(),
        32 => boxed::<R, 32>(),
        48 => boxed::<R, 48>(),
        64 => boxed::<R, 64>(),
        128 => boxed::<R, 128>(),
        256 => boxed::<R, 256>(),
        512 => boxed::<R, 512>(),
        1024 => boxed::<R, 1024>(),
        2048 => boxed::<R, 2048>(),
        4096 => boxed::<R, 4096>(),
        _ => return None,
    })
}

fn set_up<R: BoxedScalar>(
    segments: u32,
    motion: &Motion,
    tick: Tick,
    truncation: f64,
) -> Result<Box<dyn AnyScalar>, TableTooSmall> {
    let mut table = empty::<R>(segments).ok_or(TableTooSmall { truncation, segments })?;
    table.set_up(motion, tick, truncation)?;
    Ok(Box::new(Boxed(table)))
}

/// Smallest table whose truncation error is within the rounding of the scalar.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough; the message states the size that would be.
pub fn smallest(scalar: Scalar, motion: &Motion) -> Result<Box<dyn AnyScalar>, Failure> {
    smallest_with_period(scalar, motion, period(motion))
}

/// Smallest table, as [`smallest`], for a motion whose period (or natural time, if it has no period) is known.
///
/// # Errors
/// As [`smallest`].
pub fn smallest_with_period(
    scalar: Scalar,
    motion: &Motion,
    period: f64,
) -> Result<Box<dyn AnyScalar>, Failure> {
    first_that_fits(&Sizes::of(scalar), motion, free_tick(motion, period)?)
}

/// Smallest table in `f64` with a truncation error of at most `truncation`, rad, for a motion whose period (or natural time) is known.
///
/// # Errors
/// As [`smallest`].
pub fn approximate(motion: &Motion, period: f64, truncation: f64) -> Result<Box<dyn AnyScalar>, Failure> {
    let sizes = Sizes { truncation, ..Sizes::of(Scalar::F64) };
    first_that_fits(&sizes, motion, free_tick(motion, period)?)
}

fn first_that_fits(sizes: &Sizes, motion: &Motion, tick: Tick) -> Result<Box<dyn AnyScalar>, Failure> {
    let mut needed = 0;
    for segments in CAPACITIES {
        if segments >= needed {
            match (sizes.set_up)(segments, motion, tick, sizes.truncation) {
                Ok(table) => return Ok(table),
                Err(refusal) if segments == LARGEST => {
                    let (terms, reason) = (sizes.terms, sizes.explain(&refusal, motion));
                    return Err(Failure::Method(format!(
                        "no ephemeris: a table of {LARGEST}x{terms} is the largest one; {reason}"
                    )));
                }
                Err(_) if needed == 0 => {
                    needed = (sizes.needed)(motion, sizes.truncation).unwrap_or(LARGEST);
                }
                Err(_) => {}
            }
        }
    }
    Err(Failure::Method("no ephemeris: no table is large enough".into()))
}

/// Table of the crate's default size if that is enough, otherwise the smallest that is.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough; the message states the size that would be.
pub fn default_or_smallest(
    scalar: Scalar,
    motion: &Motion,
    tick: Tick,
) -> Result<Box<dyn AnyScalar>, Failure> {
    let sizes = Sizes::of(scalar);
    (sizes.set_up)(sizes.default, motion, tick, sizes.truncation)
        .or_else(|_| first_that_fits(&sizes, motion, tick))
}

/// Table of this capacity.
///
/// # Errors
/// [`Failure::Input`]: there is no such capacity. [`Failure::Method`]: it is not enough for the motion.
pub fn of_size(
    scalar: Scalar,
    segments: u32,
    motion: &Motion,
    tick: Tick,
) -> Result<Box<dyn AnyScalar>, Failure> {
    let sizes = Sizes::of(scalar);
    let allowed = sizes.allowed();
    if !allowed.contains(&segments) {
        let names: Vec<_> = allowed.iter().map(u32::to_string).collect();
        return Err(Failure::Input(format!("--size: {segments}: must be one of {}", names.join(", "))));
    }
    (sizes.set_up)(segments, motion, tick, sizes.truncation).map_err(|refusal| {
        let reason = sizes.explain(&refusal, motion);
        Failure::Method(format!("no ephemeris of {segments} segments: {reason}"))
    })
}

/// Smallest table of fewer segments than another one, with an error bound that is larger by a hundredth at most; `None` if there is none.
#[must_use]
pub fn smaller(
    scalar: Scalar,
    motion: &Motion,
    tick: Tick,
    than: &dyn AnyScalar,
) -> Option<Box<dyn AnyScalar>> {
    const LARGER: f64 = 1.01;
    let (sizes, own, [segments, _]) = (Sizes::of(scalar), than.error_bound(), than.size());
    let within = |bound: ErrorBound| {
        bound.constant <= LARGER * own.constant && bound.per_tick <= LARGER * own.per_tick
    };
    let fewer = sizes.allowed().into_iter().take_while(|&size| (size as usize) < segments);
    fewer
        .filter_map(|size| (sizes.set_up)(size, motion, tick, sizes.truncation).ok())
        .find(|table| within(table.error_bound()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::ephemeris::tests::motion;

    /// Sizes that are chosen. Every smaller size is refused, and the motions of the test need every size.
    fn sizes_chosen(scalar: Scalar, motions: &[Motion]) -> Vec<usize> {
        let sizes = Sizes::of(scalar);
        let chosen = |motion: &Motion| {
            let table = smallest(scalar, motion).unwrap();
            let tick = free_tick(motion, period(motion)).unwrap();
            for segments in CAPACITIES.into_iter().filter(|&segments| (segments as usize) < table.size()[0]) {
                let refused = (sizes.set_up)(segments, motion, tick, sizes.truncation).is_err();
                assert!(refused, "{segments} segments would do");
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
        assert_eq!(sizes_chosen(Scalar::F64, &motions).first(), Some(&8));
        assert!(sizes_chosen(Scalar::F32, &motions).len() > 4);
    }
}
