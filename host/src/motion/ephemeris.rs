//! Ephemeris of a motion, with as many segments as it needs, in any scalar.

mod events;

mod aperiodic;
mod heap_table;

mod capacities;

pub use capacities::{ephemeris_for, ephemeris_with};
pub use events::{EventKind, EventQuery, MotionEvent};
pub use heap_table::{HeapScalar, HeapTable};

use crate::motion::column::SampleColumn;
use crate::motion::sample::{Quantities, Sample};
use aperiodic::ClosedFormEvaluator;
use events::Condition;
use fixed::types::{I2F14, I2F30};
use toytop::{ErrorBound, Motion, ParameterError, Pose};
use toytop_model::motion_constants::MAX_TICKS;

/// Ephemeris of a motion: the core's table in any scalar and size, or the closed form of an aperiodic motion.
pub struct MotionEphemeris {
    /// Number of segments; 0 without a table.
    pub segments: usize,
    /// Number of coefficients of each polynomial; 0 without a table.
    pub terms: usize,
    /// Ticks in a unit of time.
    pub ticks_per_time: f64,
    /// Upper bound on the orientation error, rad.
    pub error_bound: ErrorBound,
    /// Upper bound on the error of ω, of Ω and of u', rad per unit time.
    pub rate_error_bound: ErrorBound,
    evaluator: Evaluator,
}

/// Table in a scalar, or closed form, that computes samples and events.
enum Evaluator {
    F64(HeapTable<f64>),
    F32(HeapTable<f32>),
    Q31(HeapTable<I2F30>),
    Q15(HeapTable<I2F14>),
    ClosedForm(Box<ClosedFormEvaluator>),
}

impl MotionEphemeris {
    fn from_table<R: HeapScalar>(heap: HeapTable<R>, evaluator: fn(HeapTable<R>) -> Evaluator) -> Self {
        let table = heap.table();
        let [ticks_per_time, _] = table.clock().ticks_per_time;
        Self {
            segments: table.capacity(),
            terms: R::TERMS,
            ticks_per_time,
            error_bound: table.error_bound(),
            rate_error_bound: table.rate_error_bound(),
            evaluator: evaluator(heap),
        }
    }

    fn from_closed_form(form: ClosedFormEvaluator) -> Self {
        Self {
            segments: 0,
            terms: 0,
            ticks_per_time: form.ticks_per_time(),
            error_bound: form.error_bound(),
            rate_error_bound: form.rate_error_bound(),
            evaluator: Evaluator::ClosedForm(Box::new(form)),
        }
    }

    /// Greatest distance of a time from t = 0 at which the ephemeris can be evaluated.
    pub fn furthest_time(&self) -> f64 {
        MAX_TICKS / self.ticks_per_time
    }

    /// Sample t units of time after t = 0, t taken as exact.
    pub fn at(&self, t: f64) -> Sample {
        self.read(t, None, Sample::new)
    }

    /// Sample at tick n.
    pub fn at_tick(&self, n: i64) -> Sample {
        self.read(n as f64 / self.ticks_per_time, Some(n), Sample::new)
    }

    /// Orientation, u and tip t units of time after t = 0.
    pub fn pose(&self, t: f64) -> Pose<f64, f64> {
        self.read(t, None, |now| now.pose())
    }

    /// Writes one column at each time, and computes no other.
    pub fn write(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        for (t, row) in times.iter().zip(rows.chunks_exact_mut(column.names().len())) {
            self.read(*t, None, |now| column.write(now, row));
        }
    }

    /// Result of `read` for the motion at the time t, taken as exact.
    ///
    /// * `tick`: number of the tick at this time, if it is one
    fn read<T>(&self, t: f64, tick: Option<i64>, read: impl FnOnce(&dyn Quantities) -> T) -> T {
        match &self.evaluator {
            Evaluator::F64(table) => read(&table.at(t, tick)),
            Evaluator::F32(table) => read(&table.at(t, tick)),
            Evaluator::Q31(table) => read(&table.at(t, tick)),
            Evaluator::Q15(table) => read(&table.at(t, tick)),
            Evaluator::ClosedForm(form) => read(&form.at(t)),
        }
    }

    /// First events at which a condition holds, of those that the query includes.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        match &self.evaluator {
            Evaluator::F64(table) => table.events(condition, query),
            Evaluator::F32(table) => table.events(condition, query),
            Evaluator::Q31(table) => table.events(condition, query),
            Evaluator::Q15(table) => table.events(condition, query),
            Evaluator::ClosedForm(form) => form.events(condition, query),
        }
    }
}

/// Events of a query, in the order of their times.
///
/// # Errors
/// `tilt` or `radius`: the motion's top has no such event.
pub fn search(
    ephemeris: &MotionEphemeris,
    motion: &Motion,
    query: &EventQuery,
) -> Result<Vec<MotionEvent>, ParameterError> {
    let conditions = query.kind.conditions(motion)?.into_iter();
    let mut events: Vec<_> = conditions.flat_map(|condition| ephemeris.events(condition, query)).collect();
    events.sort_by(|a, b| a.t.total_cmp(&b.t));
    events.truncate(query.count);
    Ok(events)
}

#[cfg(test)]
mod tests {
    use toytop::{InitialAngles, Motion, Signs, Top, TopParameters};
    use toytop_model::motion_constants::MotionConstants;

    pub(super) fn motion(a: f64, e: [f64; 3]) -> Motion {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: 0.8 * a,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default()).unwrap()
    }

    #[test]
    fn a_tick_is_shorter_than_a_turn_and_a_thousandth_of_a_period() {
        for motion in
            [motion(1.0, [0.2, 0.8, 1.5]), motion(1e-6, [0.2, 0.8, 1e6]), motion(1e9, [0.2, 0.8, 1.5])]
        {
            let constants = MotionConstants::new(motion);
            let (rate, period) = (constants.ticks_per_time(), constants.time_scale());
            assert!(rate * period >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(constants.furthest_time() / period >= 1e10);
        }
    }
}
