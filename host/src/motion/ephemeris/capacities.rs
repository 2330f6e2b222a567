//! Choice among the capacities that a table may have.

use super::aperiodic::ClosedFormSource;
use super::{HeapTable, MotionEphemeris, TableScalar};
use crate::Failure;
use crate::motion::Scalar;
use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisMemory, Motion, Regime, SetUpError, Table, TableSettings, Tick, Workspace};
use toytop_model::constants::MotionWithPeriod;

type Memory<R> = Box<EphemerisMemory<Table<R>>>;

/// Number of segments of a table, and function that makes its memory.
type Capacity<R> = (u32, fn() -> Memory<R>);

/// Capacities that a table may have, in ascending order.
fn capacities<R: TableScalar>() -> [Capacity<R>; 12] {
    fn memory<R: TableScalar, const SEGMENTS: usize>() -> Memory<R> {
        Box::new(EphemerisMemory::<Ephemeris<R, SEGMENTS>>::new())
    }
    [
        (8, memory::<R, 8>),
        (16, memory::<R, 16>),
        (25, memory::<R, 25>),
        (32, memory::<R, 32>),
        (48, memory::<R, 48>),
        (64, memory::<R, 64>),
        (128, memory::<R, 128>),
        (256, memory::<R, 256>),
        (512, memory::<R, 512>),
        (1024, memory::<R, 1024>),
        (2048, memory::<R, 2048>),
        (4096, memory::<R, 4096>),
    ]
}

/// Whether a user may choose this number of segments.
fn is_offered<R: TableScalar>(segments: u32) -> bool {
    segments.is_power_of_two() || segments == R::SEGMENTS
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
) -> Result<MotionEphemeris, Failure> {
    let constants = MotionWithPeriod::new(*motion);
    if scalar == Scalar::F64 {
        if let Some(closed_form) = ClosedFormSource::new(&constants) {
            return Ok(closed_form.ephemeris());
        }
    } else if motion.regime() == Regime::Aperiodic {
        return Err(Failure::Method("an aperiodic motion has a closed form in f64, and no table".into()));
    }
    let settings =
        TableSettings { truncation, ..TableSettings::new(tick.unwrap_or_else(|| constants.tick())) };
    fn table<R: TableScalar>(motion: &Motion, settings: TableSettings) -> Result<MotionEphemeris, Failure> {
        Ok(HeapTable::<R>::smallest(motion, settings, u32::is_power_of_two)?.ephemeris())
    }
    match scalar {
        Scalar::F64 => table::<f64>(motion, settings),
        Scalar::F32 => table::<f32>(motion, settings),
        Scalar::Q31 => table::<I2F30>(motion, settings),
        Scalar::Q15 => table::<I2F14>(motion, settings),
    }
}

impl<R: TableScalar> HeapTable<R> {
    /// Table of a motion whose truncation error is within the rounding of the scalar.
    ///
    /// * `segments`: capacity; without it, that of the core's own type or the next one that is enough
    ///
    /// # Errors
    /// [`Failure::Input`]: no table has this many segments. [`Failure::Method`]: they are too few; the message states a sufficient capacity.
    pub fn with_segments(motion: &Motion, tick: Tick, segments: Option<u32>) -> Result<Self, Failure> {
        let offered =
            capacities::<R>().map(|(capacity, _)| capacity).into_iter().filter(|&n| is_offered::<R>(n));
        if let Some(segments) = segments.filter(|segments| !offered.clone().any(|n| n == *segments)) {
            let names = offered.map(|n| n.to_string()).collect::<Vec<_>>().join(", ");
            return Err(Failure::Input(format!("{segments}: must be one of {names}")));
        }
        Self::smallest(motion, TableSettings::new(tick), |capacity| match segments {
            None => is_offered::<R>(capacity) && capacity >= R::SEGMENTS,
            Some(segments) => capacity == segments,
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
        let [.., largest] = &capacities;
        let allowed = || capacities.iter().filter(|(capacity, _)| is_allowed(*capacity));
        let (_, memory) = allowed().find(|(n, _)| *n >= needed).or(allowed().last()).unwrap_or(largest);
        let mut memory = memory();
        let failure = |error| {
            let enough = capacities.iter().find(|(n, _)| is_offered::<R>(*n) && *n >= needed);
            let hint = match enough {
                _ if !matches!(error, SetUpError::TableTooSmall { .. }) => String::new(),
                Some((n, _)) => format!("; at least {n} segments would be enough"),
                None => format!("; not even {} segments of this degree would be enough", largest.0),
            };
            Failure::Method(format!("no ephemeris: {error}{hint}"))
        };
        let settings = TableSettings { truncation: Some(truncation), ..settings };
        memory.set_up(&mut Workspace::new(), motion, &settings, &mut || {}).map_err(failure)?;
        Ok(Self(memory))
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
            for segments in (3..12).map(|n| 1 << n).filter(|&segments| (segments as usize) < table.size[0]) {
                let refused = HeapTable::<R>::with_segments(motion, tick, Some(segments)).is_err();
                assert!(refused, "{segments} segments would do");
            }
            table.size[0]
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
        assert_eq!(ephemeris_for(Scalar::F64, &motion).unwrap().size[0], 0);
        for scalar in [Scalar::F32, Scalar::Q31, Scalar::Q15] {
            let refusal = ephemeris_for(scalar, &motion).err().unwrap().to_string();
            assert_eq!(refusal, "an aperiodic motion has a closed form in f64, and no table");
        }
    }
}
