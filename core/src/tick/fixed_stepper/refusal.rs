//! Which motions and ticks a table in fixed point cannot follow.

use super::flow::Flow;
use super::map::Survey;
use core::fmt;

/// Why a motion cannot be stepped in fixed point by this tick, with a table of this size.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoTickMap {
    /// It rises to the vertical and stays there: χ would have to come to rest, and stays unstable in any rounding.
    Aperiodic,
    /// In a tick this phase turns by more, or by more differing angles, than a quarter of a turn.
    TickTooLong {
        /// `"nutation"`, `"alpha"` or `"beta"`.
        phase: &'static str,
    },
    /// The polynomials miss what this phase turns by in a tick.
    TooCoarse {
        /// `"nutation"`, `"alpha"` or `"beta"`.
        phase: &'static str,
        /// By how much, as a share of what the orientation turns by.
        miss: f64,
        /// How many segments of as many terms would do; `None` if 512 would not, beyond which nobody looks.
        segments: Option<u32>,
    },
}

impl NoTickMap {
    const PHASES: [&'static str; 3] = ["nutation", "alpha", "beta"];
    const MOST_SEGMENTS: usize = 512;
    /// What the polynomials may miss: along the way, a rounding of `f32`. It has either sign, so little of it adds up.
    const MOST_MISS: f64 = 1.0 / (1_u64 << 24) as f64;

    /// The shifts of the table, if all is well. The slow phases turn by `drift` turns a tick besides the law.
    pub(super) fn check(
        flow: &Flow,
        survey: &Survey,
        drift: f64,
        [segments, terms]: [usize; 2],
    ) -> Result<[u32; 3], Self> {
        let [fastest, ..] = survey.highest;
        // the negation, because it may be no number
        if !matches!(fastest.partial_cmp(&0.25), Some(core::cmp::Ordering::Less)) {
            return Err(Self::TickTooLong { phase: "nutation" });
        }
        let (phase, miss) = Self::worst(survey, drift);
        if miss > Self::MOST_MISS {
            let mut more = segments;
            let segments = loop {
                more *= 2;
                if more > Self::MOST_SEGMENTS {
                    break None;
                }
                let (_, miss) = Self::worst(&Survey::of(flow, more, terms), drift);
                if miss <= Self::MOST_MISS {
                    break Some(more as u32);
                }
            };
            return Err(Self::TooCoarse { phase, miss, segments });
        }
        let mut shifts = [0; 3];
        for ((ours, shift), phase) in shifts.iter_mut().zip(survey.shifts()).zip(Self::PHASES) {
            *ours = shift.ok_or(Self::TickTooLong { phase })?;
        }
        Ok(shifts)
    }

    /// The phase that is missed most, and by what share of the angle turned.
    fn worst(survey: &Survey, drift: f64) -> (&'static str, f64) {
        let turned = survey.turned(drift);
        let shares = survey.astray(survey.missed, drift).map(|astray| astray / turned);
        let all = Self::PHASES.into_iter().zip(shares);
        all.fold(
            ("nutation", 0.0),
            |worst, now| if now.1 <= worst.1 || worst.1.is_nan() { worst } else { now },
        )
    }
}

impl fmt::Display for NoTickMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Aperiodic => {
                write!(f, "the motion is aperiodic: it rises to the vertical in infinite time")
            }
            Self::TickTooLong { phase } => write!(f, "the tick is too long: {phase} turns too far in one"),
            Self::TooCoarse { phase, miss, segments } => {
                write!(f, "the table misses the {phase} phase by {miss:.1e} of the angle turned; ")?;
                match segments {
                    Some(segments) => write!(f, "{segments} segments of this degree would fit"),
                    None => write!(f, "not even {} segments of this degree would fit", Self::MOST_SEGMENTS),
                }
            }
        }
    }
}

impl core::error::Error for NoTickMap {}
