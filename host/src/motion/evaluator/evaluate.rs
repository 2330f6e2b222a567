//! Trait of a table in any scalar, and of a closed form.

use super::events::{Condition, EventQuery, MotionEvent};
use crate::motion::column::SampleColumn;
use crate::motion::sample::MotionSample;

/// Table in any scalar, or closed form.
pub trait Evaluate: Send + Sync {
    /// Sample at the time t, taken as exact.
    ///
    /// * `tick`: number of the tick at this time, if it is one
    /// * `column`: column whose numbers are computed; without it, all quantities
    fn sample(&self, t: f64, tick: Option<i64>, column: Option<SampleColumn>) -> MotionSample;

    /// First events at which a condition holds, of those that the query includes.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent>;
}
