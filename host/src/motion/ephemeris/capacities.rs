//! Choice among the capacities that a table may have.

use super::aperiodic::ClosedFormEvaluator;
use super::heap_table::{Capacity, capacity};
use super::{Evaluator, HeapScalar, HeapTable, MotionEphemeris};
use crate::Failure;
use crate::motion::Scalar;
use toytop::{Motion, Regime, SetUpError, SizedTable, Table, TableMemory, TableSettings, Tick, Workspace};
use toytop_model::motion_constants::MotionConstants;

/// Capacities that a table may have, in ascending order: powers of two, and the capacity of the core's own type.
fn capacities<R: HeapScalar>() -> Vec<Capacity<R>> {
    macro_rules! capacities {
        ($($segments:literal)*) => {
            vec![R::OWN_CAPACITY, $(capacity(TableMemory::<SizedTable<R, $segments>>::new)),*]
        };
    }
    let mut capacities = capacities!(8 16 32 64 128 256 512 1024 2048 4096);
    capacities.sort_by_key(|(segments, _)| *segments);
    capacities.dedup_by_key(|(segments, _)| *segments);
    capacities
}

/// As [`ephemeris_with`], with its default tick and truncation error.
///
/// # Errors
/// As [`ephemeris_with`].
pub fn ephemeris_for(scalar: Scalar, motion: &Motion) -> Result<MotionEphemeris, Failure> {
    ephemeris_with(scalar, motion, None, None)
}

/// Ephemeris of a motion in the smallest table, or the closed form of an aperiodic motion, which has no truncation error.
///
/// * `tick`: length of a tick; by default [`MotionConstants::tick`]
/// * `truncation`: greatest truncation error, rad; without it, a bound within the rounding of the scalar
///
/// # Errors
/// [`Failure::Method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
pub fn ephemeris_with(
    scalar: Scalar,
    motion: &Motion,
    tick: Option<Tick>,
    truncation: Option<f64>,
) -> Result<MotionEphemeris, Failure> {
    let constants = MotionConstants::new(*motion);
    if scalar == Scalar::F64 {
        if let Some(closed_form) = ClosedFormEvaluator::new(&constants) {
            return Ok(MotionEphemeris::from_closed_form(closed_form));
        }
    } else if motion.regime() == Regime::Aperiodic {
        return Err(Failure::Method("an aperiodic motion has a closed form in f64, and no table".into()));
    }
    let settings =
        TableSettings { truncation, ..TableSettings::new(tick.unwrap_or_else(|| constants.tick())) };
    fn smallest<R: HeapScalar>(
        motion: &Motion,
        settings: TableSettings,
        evaluator: fn(HeapTable<R>) -> Evaluator,
    ) -> Result<MotionEphemeris, Failure> {
        let table = HeapTable::smallest(motion, settings, u32::is_power_of_two)?;
        Ok(MotionEphemeris::from_table(table, evaluator))
    }
    match scalar {
        Scalar::F64 => smallest(motion, settings, Evaluator::F64),
        Scalar::F32 => smallest(motion, settings, Evaluator::F32),
        Scalar::Q31 => smallest(motion, settings, Evaluator::Q31),
        Scalar::Q15 => smallest(motion, settings, Evaluator::Q15),
    }
}

impl<R: HeapScalar> HeapTable<R> {
    /// Table of a motion whose truncation error is within the rounding of the scalar.
    ///
    /// * `segments`: capacity; by default the capacity of the core's own type, or the next larger one that fits
    ///
    /// # Errors
    /// [`Failure::Input`]: no table has this many segments. [`Failure::Method`]: they are too few; the message states a sufficient capacity.
    pub fn with_segments(motion: &Motion, tick: Tick, segments: Option<u32>) -> Result<Self, Failure> {
        let offered = capacities::<R>().into_iter().map(|(capacity, _)| capacity);
        if let Some(segments) = segments
            && !offered.clone().any(|capacity| capacity == segments)
        {
            let names = offered.map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
            return Err(Failure::Input(format!("{segments}: must be one of {names}")));
        }
        let (own, _) = R::OWN_CAPACITY;
        Self::smallest(motion, TableSettings::new(tick), |capacity| {
            segments.map_or(capacity >= own, |segments| capacity == segments)
        })
    }

    /// Table with the smallest capacity that is allowed and enough.
    fn smallest(
        motion: &Motion,
        settings: TableSettings,
        is_allowed: impl Fn(u32) -> bool,
    ) -> Result<Self, Failure> {
        let truncation = settings.truncation.unwrap_or(R::TRUNCATION);
        let needed = Table::<R>::segments_needed(motion, truncation).unwrap_or(u32::MAX);
        let capacities = capacities::<R>();
        let is_enough = |(capacity, _): &&Capacity<R>| *capacity >= needed;
        let allowed = || capacities.iter().filter(|(capacity, _)| is_allowed(*capacity));
        let (_, memory) = allowed().find(is_enough).or(allowed().last()).expect("4096 is a power of two");
        let mut memory = memory();
        let failure = |error| {
            let hint = match capacities.iter().find(is_enough) {
                _ if !matches!(error, SetUpError::TableTooSmall { .. }) => String::new(),
                Some((n, _)) => format!("; at least {n} segments would be enough"),
                None => "; not even 4096 segments of this degree would be enough".to_owned(),
            };
            Failure::Method(format!("no ephemeris: {error}{hint}"))
        };
        let settings = TableSettings { truncation: Some(truncation), ..settings };
        memory.set_up(&mut Workspace::new(), motion, settings, &mut || {}).map_err(failure)?;
        Ok(Self(memory))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::ephemeris::tests::motion;

    /// Sizes that are chosen. Every smaller size is refused, and the motions of the test need every size.
    fn sizes_chosen<R: HeapScalar>(motions: &[Motion]) -> Vec<usize> {
        let chosen = |motion: &Motion| {
            let table = ephemeris_for(R::SCALAR, motion).unwrap();
            let tick = MotionConstants::new(*motion).tick();
            for segments in (3..12).map(|n| 1 << n).filter(|&segments| (segments as usize) < table.segments) {
                let refused = HeapTable::<R>::with_segments(motion, tick, Some(segments)).is_err();
                assert!(refused, "{segments} segments would do");
            }
            table.segments
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
        assert_eq!(ephemeris_for(Scalar::F64, &motion).unwrap().segments, 0);
        for scalar in [Scalar::F32, Scalar::Q31, Scalar::Q15] {
            let refusal = ephemeris_for(scalar, &motion).err().unwrap().to_string();
            assert_eq!(refusal, "an aperiodic motion has a closed form in f64, and no table");
        }
    }
}
