//! Source of samples and events.

use super::events::{Condition, EventQuery, MotionEvent};
use crate::motion::sample::SampleQuantities;

/// Table or closed form, from which samples and events are computed.
pub trait MotionSource: Send + Sync {
    /// Calls `read` with the motion at the time t, taken as exact.
    ///
    /// * `tick`: number of the tick at this time, if it is one
    fn read(&self, t: f64, tick: Option<i64>, read: &mut dyn FnMut(&dyn SampleQuantities));

    /// First events at which a condition holds, of those that the query includes.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent>;
}
