//! Pictures of a motion: its span of time, its geometry, and the page for a browser.
//!
//! | module | contents |
//! |---|---|
//! | [`curve`] | curve of the tip, bounds between which the axis stays |
//! | [`page`] | page for a browser |

pub mod curve;

pub mod page;

use crate::Failure;
use crate::motion::evaluator::MotionEvaluator;
use crate::motion::sample::MotionSample;
use crate::motion::times::require_within;
use crate::output::significant;
use toytop_model::display_duration::{cycle, display_duration, periods};

/// Motion between two times.
pub struct MotionSpan {
    evaluator: MotionEvaluator,
    /// First and last time, s.
    pub ends: [f64; 2],
    /// Number of nutation periods, where they determine the last time.
    pub periods: Option<u32>,
}

/// Greatest number of nutation periods or turns in a picture: more would fill its frame.
pub const MAX_CYCLES: f64 = 1000.0;

impl MotionSpan {
    /// Motion of an evaluator between two times, s. Without them it begins at 0 and is about one turn of the tip around the centre: a whole number of
    /// nutation periods, one turn where u is constant, or the time until the tip of an aperiodic motion is at the centre.
    ///
    /// * `most_cycles`: greatest number of nutation periods or turns
    ///
    /// # Errors
    /// [`Failure::input`]: times beyond the reach of the evaluator, or too many cycles.
    pub fn new(
        evaluator: MotionEvaluator,
        times: Option<[f64; 2]>,
        most_cycles: f64,
    ) -> Result<Self, Failure> {
        let motion = &evaluator.motion;
        require_within(times.into_iter().flatten(), evaluator.furthest_time(), " s")?;
        let longest = most_cycles * cycle(motion);
        if let Some([from, until]) = times.filter(|[from, until]| until - from > longest)
            && !motion.regime().is_vertical()
        {
            let [from, until, longest] =
                [(from, 17), (until, 17), (longest, 4)].map(|(t, n)| significant(t, n));
            let reason = format!("must span at most {longest} ({most_cycles} nutation periods or turns)");
            return Err(Failure::input(reason).at(format!("{from}..{until}")));
        }
        let periods = periods(motion).filter(|_| times.is_none());
        let ends = times.unwrap_or_else(|| [0.0, display_duration(motion, |t| evaluator.tip(t).modulus())]);
        Ok(Self { evaluator, ends, periods })
    }

    /// Sample at a time.
    pub fn at(&self, t: f64) -> MotionSample {
        self.evaluator.at(t)
    }

    /// Times of this number, evenly spread, both ends included.
    pub fn times(&self, count: u64) -> impl Iterator<Item = f64> {
        let [from, until] = self.ends;
        (0..count).map(move |i| from + (until - from) * i as f64 / (count.max(2) - 1) as f64)
    }

    /// Times of a curve: enough in each cycle of the motion that they show no alias of it.
    pub fn times_of_curve(&self) -> impl Iterator<Item = f64> {
        const MIN_POINTS: u64 = 1500;
        const POINTS_IN_A_CYCLE: f64 = 64.0;
        let [from, until] = self.ends;
        let cycles = ((until - from) / cycle(&self.evaluator.motion)).ceil().min(MAX_CYCLES);
        self.times(MIN_POINTS.max((POINTS_IN_A_CYCLE * cycles) as u64 + 1))
    }

    /// First and last time as text, with as many digits as distinguish a thousandth of the span.
    pub fn ends_as_text(&self) -> [String; 2] {
        let [from, until] = self.ends;
        let parts = from.abs().max(until.abs()) / (until - from);
        let digits = 4 + parts.log10().clamp(0.0, 13.0).ceil() as usize;
        self.ends.map(|t| significant(t, digits))
    }
}
