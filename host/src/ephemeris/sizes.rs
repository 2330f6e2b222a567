//! The tables that are compiled, and the choice among them.

use super::ticks::free_tick;
use super::{AnySize, Tabled};
use crate::Failure;
use crate::cli::Scalar;
use crate::micromath::Micromath;
use crate::propagate::period;
use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, Motion, NoFit, Tick};

/// Sets up one size, with the truncation allowed, rad.
type SetUp = fn(&Motion, Tick, f64) -> Result<Box<dyn AnySize>, NoFit>;

/// A size of the list, and how to set one up.
#[derive(Clone, Copy)]
struct Size {
    segments: u32,
    terms: u32,
    set_up: SetUp,
}

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
    first_that_fits(&Sizes::of(scalar), motion, free_tick(motion, period)?)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ephemeris::tests::motion;

    /// Every smaller size refuses; and the motions here need every size there is.
    fn sizes_chosen(scalar: Scalar, motions: &[Motion]) -> Vec<usize> {
        let Sizes { smaller, truncation, .. } = Sizes::of(scalar);
        let chosen = |motion: &Motion| {
            let table = smallest(scalar, motion).unwrap();
            let tick = free_tick(motion, period(motion)).unwrap();
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
}
