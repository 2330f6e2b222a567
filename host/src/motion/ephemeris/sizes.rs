//! Capacities that a table may have, and the choice among them.

use super::aperiodic::AperiodicMotion;
use super::parts::TableScalar;
use super::{AnyEphemeris, Table};
use crate::Failure;
use crate::motion::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::{
    Ephemeris, EphemerisMemory, EphemerisView, ErrorBound, Motion, Regime, SetUp, SetUpError, Tick,
};
use toytop_model::ticks::tick;

/// Capacity of a table.
#[derive(Clone, Copy)]
pub enum Size {
    /// Smallest that is enough.
    Smallest,
    /// Smallest with a truncation error of at most this, rad.
    Within(f64),
    /// Capacity of the crate's own type if that is enough, otherwise the smallest that is.
    Default,
    /// Number of segments.
    Exactly(u32),
}

/// Capacities besides the defaults, in ascending order.
const CAPACITIES: [u32; 10] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096];

/// Segments of the crate's own type of a scalar, which fits most motions.
fn default_size(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 48,
        Scalar::F32 => 25,
        Scalar::Q31 => 32,
        Scalar::Q15 => 16,
    }
}

/// Capacities of a scalar in ascending order.
fn allowed(scalar: Scalar) -> Vec<u32> {
    let mut allowed = [&CAPACITIES[..], &[default_size(scalar)]].concat();
    allowed.sort_unstable();
    allowed.dedup();
    allowed
}

/// Table of a motion in a scalar with ticks of this length, whose truncation error is within the rounding of the scalar.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough, or the given size is not; the message states the size that would be.
/// [`Failure::Input`]: there is no such size.
pub fn table(
    scalar: Scalar,
    motion: &Motion,
    tick: Tick,
    size: Size,
) -> Result<Box<dyn AnyEphemeris>, Failure> {
    let of_scalar = match scalar {
        Scalar::F64 => table_in::<f64>,
        Scalar::F32 => table_in::<f32>,
        Scalar::Q31 => table_in::<I2F30>,
        Scalar::Q15 => table_in::<I2F14>,
    };
    of_scalar(motion, tick, size)
}

fn table_in<R: TableScalar>(
    motion: &Motion,
    tick: Tick,
    size: Size,
) -> Result<Box<dyn AnyEphemeris>, Failure> {
    let truncation = if let Size::Within(truncation) = size { truncation } else { R::TRUNCATION };
    let mut allowed = allowed(R::SCALAR);
    let mut largest = format!("4096x{} segments, the most", R::TERMS);
    let tried = match size {
        Size::Smallest | Size::Within(_) => CAPACITIES.to_vec(),
        Size::Default => allowed.iter().copied().filter(|size| *size >= default_size(R::SCALAR)).collect(),
        Size::Exactly(segments) if allowed.contains(&segments) => {
            largest = format!("{segments} segments");
            vec![segments]
        }
        Size::Exactly(segments) => {
            let names: Vec<_> = allowed.iter().map(u32::to_string).collect();
            return Err(Failure::Input(format!("--size: {segments}: must be one of {}", names.join(", "))));
        }
    };
    let mut refusal = String::new();
    for segments in tried {
        let mut memory = memory::<R>(segments);
        match memory.set_up(&mut SetUp::within(truncation), motion, tick, 0, &mut || {}) {
            Ok(_) => return Ok(Box::new(Table(memory))),
            Err(error @ SetUpError::TooSmall { .. }) => refusal = error.to_string(),
            Err(error) => return Err(Failure::Method(format!("no ephemeris: {error}"))),
        }
    }
    let needed = EphemerisView::<R>::segments_needed(motion, truncation);
    allowed.retain(|size| needed.is_some_and(|needed| *size >= needed));
    let enough = match (needed, allowed.first()) {
        (_, Some(size)) => format!("at least --size {size}"),
        (Some(needed), None) => format!("{needed} segments of this degree"),
        (None, None) => "not even 4096 segments of this degree".to_owned(),
    };
    Err(Failure::Method(format!("no ephemeris of {largest}: {refusal}; {enough} would be enough")))
}

/// Memory of a table of this many segments, one of the [`allowed`] capacities.
fn memory<R: TableScalar>(segments: u32) -> Box<EphemerisMemory<EphemerisView<R>>> {
    fn boxed<R: TableScalar, const N: usize>() -> Box<EphemerisMemory<EphemerisView<R>>> {
        Box::new(EphemerisMemory::<Ephemeris<R, N>>::new())
    }
    match segments {
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
        _ => boxed::<R, 4096>(),
    }
}

/// Refusal of a scalar for an aperiodic motion, which has no table and whose closed form is in `f64`.
///
/// # Errors
/// [`Failure::Method`]: the motion is aperiodic, and the scalar is not `f64`.
pub fn require_scalar(scalar: Scalar, motion: &Motion) -> Result<(), Failure> {
    if motion.regime() == Regime::Aperiodic && scalar != Scalar::F64 {
        return Err(Failure::Method("an aperiodic motion has a closed form in f64, and no table".into()));
    }
    Ok(())
}

/// Smallest table whose truncation error is within the rounding of the scalar, or the closed form of an aperiodic motion.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough; the message states the size that would be.
pub fn smallest(scalar: Scalar, motion: &Motion) -> Result<Box<dyn AnyEphemeris>, Failure> {
    at_any_time(scalar, motion, Size::Smallest)
}

/// Smallest table in `f64` with a truncation error of at most `truncation`, rad.
///
/// # Errors
/// As [`smallest`].
pub fn approximate(motion: &Motion, truncation: f64) -> Result<Box<dyn AnyEphemeris>, Failure> {
    at_any_time(Scalar::F64, motion, Size::Within(truncation))
}

fn at_any_time(scalar: Scalar, motion: &Motion, size: Size) -> Result<Box<dyn AnyEphemeris>, Failure> {
    if let Some(closed_form) = AperiodicMotion::new(motion) {
        return Ok(Box::new(closed_form));
    }
    let tick = tick(motion).map_err(|error| Failure::Method(error.to_string()))?;
    table(scalar, motion, tick, size)
}

/// Smallest table of fewer segments than another one, with an error bound that is larger by a hundredth at most; `None` if there is none.
pub fn smaller(
    scalar: Scalar,
    motion: &Motion,
    tick: Tick,
    than: &dyn AnyEphemeris,
) -> Option<Box<dyn AnyEphemeris>> {
    const LARGER: f64 = 1.01;
    let (own, [segments, _]) = (than.error_bound(), than.size());
    let close = |bound: ErrorBound| {
        bound.constant <= LARGER * own.constant && bound.per_tick <= LARGER * own.per_tick
    };
    let fewer = allowed(scalar).into_iter().filter(|&size| (size as usize) < segments);
    fewer
        .filter_map(|size| table(scalar, motion, tick, Size::Exactly(size)).ok())
        .find(|table| close(table.error_bound()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::ephemeris::tests::motion;

    /// Sizes that are chosen. Every smaller size is refused, and the motions of the test need every size.
    fn sizes_chosen(scalar: Scalar, motions: &[Motion]) -> Vec<usize> {
        let chosen = |motion: &Motion| {
            let table = smallest(scalar, motion).unwrap();
            let tick = tick(motion).unwrap();
            for segments in CAPACITIES.into_iter().filter(|&segments| (segments as usize) < table.size()[0]) {
                let refused = super::table(scalar, motion, tick, Size::Exactly(segments)).is_err();
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
        let mut motions = vec![motion(1.0, [0.5, 0.5, 2.0])];
        for exponent in 0..13 {
            let small = 2_f64.powi(-exponent);
            motions.push(motion(1.0, [-0.5, 1.0 - 0.2 * small, 1.0 + 0.2 * small * small]));
            motions.push(motion(small, [-0.99, 0.999, 1.02]));
        }
        assert_eq!(sizes_chosen(Scalar::F64, &motions).first(), Some(&8));
        assert!(sizes_chosen(Scalar::F32, &motions).len() > 4);
        // an aperiodic motion has a closed form and no table
        assert_eq!(smallest(Scalar::F32, &motion(1.0, [0.2, 1.0, 1.0])).unwrap().size()[0], 0);
    }
}
