//! Source of samples and events.

use super::events::{Condition, EventQuery, MotionEvent};
use crate::motion::column::SampleColumn;
use crate::motion::sample::Sample;
use toytop::Pose;

/// Table or closed form, from which samples and events are computed.
pub trait MotionSource: Send + Sync {
    /// Sample at the time t, taken as exact.
    ///
    /// * `tick`: number of the tick at this time, if it is one
    fn sample(&self, t: f64, tick: Option<i64>) -> Sample;

    /// Orientation, u and tip at the time t.
    fn pose(&self, t: f64) -> Pose<f64, f64>;

    /// Writes one column at each time, and computes no other.
    fn write(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]);

    /// First events at which a condition holds, of those that the query includes.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent>;
}
