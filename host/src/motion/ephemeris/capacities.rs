//! Choice among the capacities that a table may have.

use super::aperiodic::AperiodicEphemeris;
use super::{DynEphemeris, HeapTable, TableScalar};
use crate::Failure;
use crate::motion::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::{
    Ephemeris, EphemerisMemory, EphemerisView, Motion, Regime, SetUpError, TableSettings, Tick, Workspace,
};
use toytop_model::constants::MotionWithPeriod;

/// Numbers of segments that are tried, smallest first.
const CAPACITIES: [u32; 10] = [8, 16, 32, 64, 128, 256, 512, 1024, 2048, MAX_CAPACITY];

const MAX_CAPACITY: u32 = 4096;

/// Ephemeris of a motion in the smallest table, or the closed form of an aperiodic motion, with the tick and the truncation error of
/// [`ephemeris_with`].
///
/// # Errors
/// As [`ephemeris_with`].
pub fn ephemeris_for(scalar: Scalar, motion: &Motion) -> Result<Box<dyn DynEphemeris>, Failure> {
    ephemeris_with(scalar, motion, None, None)
}

/// Ephemeris of a motion in the smallest table, or the closed form of an aperiodic motion, which has no truncation error.
///
/// * `tick`: length of a tick; without it, that of [`MotionWithPeriod`]
/// * `truncation`: greatest truncation error, rad; without it, a bound within the rounding of the scalar
///
/// # Errors
/// [`Failure::Method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
pub fn ephemeris_with(
    scalar: Scalar,
    motion: &Motion,
    tick: Option<Tick>,
    truncation: Option<f64>,
) -> Result<Box<dyn DynEphemeris>, Failure> {
    type Boxed = Result<Box<dyn DynEphemeris>, Failure>;
    fn table<R: TableScalar>(motion: &Motion, tick: Tick, truncation: Option<f64>) -> Boxed {
        let truncation = truncation.unwrap_or(R::TRUNCATION);
        Ok(Box::new(HeapTable::<R>::smallest(&CAPACITIES, motion, tick, truncation)?))
    }
    let constants = MotionWithPeriod::new(*motion);
    let tick = tick.unwrap_or_else(|| constants.tick());
    match scalar {
        Scalar::F64 => match AperiodicEphemeris::new(&constants) {
            Some(closed_form) => Ok(Box::new(closed_form)),
            None => table::<f64>(motion, tick, truncation),
        },
        _ if motion.regime() == Regime::Aperiodic => {
            Err(Failure::Method("an aperiodic motion has a closed form in f64, and no table".into()))
        }
        Scalar::F32 => table::<f32>(motion, tick, truncation),
        Scalar::Q31 => table::<I2F30>(motion, tick, truncation),
        Scalar::Q15 => table::<I2F14>(motion, tick, truncation),
    }
}

/// Segments of the crate's own type of a scalar, which fits most motions.
fn default_capacity(scalar: Scalar) -> u32 {
    match scalar {
        Scalar::F64 => 48,
        Scalar::F32 => 25,
        Scalar::Q31 => 32,
        Scalar::Q15 => 16,
    }
}

/// Capacities that a user may choose for a scalar, in ascending order.
fn capacities_of(scalar: Scalar) -> Vec<u32> {
    let mut capacities = [&CAPACITIES[..], &[default_capacity(scalar)]].concat();
    capacities.sort_unstable();
    capacities.dedup();
    capacities
}

impl<R: TableScalar> HeapTable<R> {
    /// Table of a motion whose truncation error is within the rounding of the scalar.
    ///
    /// * `segments`: capacity; without it, the default or the next one that is enough
    ///
    /// # Errors
    /// [`Failure::Input`]: no table has this many segments. [`Failure::Method`]: they are too few; the message states a sufficient capacity.
    pub fn with_segments(motion: &Motion, tick: Tick, segments: Option<u32>) -> Result<Self, Failure> {
        let mut capacities = capacities_of(R::SCALAR);
        match segments {
            None => capacities.retain(|capacity| *capacity >= default_capacity(R::SCALAR)),
            Some(segments) if capacities.contains(&segments) => capacities = vec![segments],
            Some(segments) => {
                let names: Vec<_> = capacities.iter().map(u32::to_string).collect();
                let names = names.join(", ");
                return Err(Failure::Input(format!("--segments: {segments}: must be one of {names}")));
            }
        }
        Self::smallest(&capacities, motion, tick, R::TRUNCATION)
    }

    /// Table with the first of these capacities that is enough.
    fn smallest(capacities: &[u32], motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, Failure> {
        let needed = EphemerisView::<R>::segments_needed(motion, truncation).unwrap_or(u32::MAX);
        let enough = |capacities: &[u32]| capacities.iter().copied().find(|capacity| *capacity >= needed);
        let most = capacities.last().copied().unwrap_or(MAX_CAPACITY);
        let mut memory = memory::<R>(enough(capacities).unwrap_or(most));
        let refused = |error| {
            let enough = match (error, enough(&capacities_of(R::SCALAR))) {
                (SetUpError::TooSmall { .. }, Some(capacity)) => {
                    format!("; at least --segments {capacity} would be enough")
                }
                (SetUpError::TooSmall { .. }, None) => {
                    format!("; not even {MAX_CAPACITY} segments of this degree would be enough")
                }
                _ => String::new(),
            };
            Failure::Method(format!("no ephemeris: {error}{enough}"))
        };
        let settings = TableSettings { truncation: Some(truncation), ..TableSettings::new(tick) };
        memory.set_up(&mut Workspace::new(), motion, &settings, &mut || {}).map_err(refused)?;
        Ok(Self(memory))
    }
}

/// Memory of a table of this many segments, one of the [capacities](capacities_of).
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::ephemeris::tests::motion;

    /// Sizes that are chosen. Every smaller size is refused, and the motions of the test need every size.
    fn sizes_chosen<R: TableScalar>(motions: &[Motion]) -> Vec<usize> {
        let chosen = |motion: &Motion| {
            let table = ephemeris_for(R::SCALAR, motion).unwrap();
            let tick = MotionWithPeriod::new(*motion).tick();
            for segments in CAPACITIES.into_iter().filter(|&segments| (segments as usize) < table.size()[0]) {
                let refused = HeapTable::<R>::with_segments(motion, tick, Some(segments)).is_err();
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
        assert_eq!(sizes_chosen::<f64>(&motions).first(), Some(&8));
        assert!(sizes_chosen::<f32>(&motions).len() > 4);
    }

    #[test]
    fn an_aperiodic_motion_has_a_closed_form_in_f64_alone() {
        let motion = motion(1.0, [0.2, 1.0, 1.0]);
        assert_eq!(ephemeris_for(Scalar::F64, &motion).unwrap().size()[0], 0);
        for scalar in [Scalar::F32, Scalar::Q31, Scalar::Q15] {
            let refusal = ephemeris_for(scalar, &motion).err().unwrap().to_string();
            assert_eq!(refusal, "an aperiodic motion has a closed form in f64, and no table");
        }
    }
}
