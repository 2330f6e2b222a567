//! Ephemeris of the core with as many segments as a motion needs, behind a trait that hides scalar and capacity.

mod events;

mod aperiodic;
mod heap_table;

mod capacities;

pub use capacities::{ephemeris_for, ephemeris_with};
pub use events::{EventKind, EventQuery, MotionEvent};
pub use heap_table::{HeapTable, TableScalar};

use crate::motion::column::SampleColumn;
use crate::motion::sample::{Quantities, Sample};
use events::Condition;
use std::f64::consts::TAU;
use toytop::{ErrorBound, Motion, ParameterError, Phase, Pose};
use toytop_model::constants::MAX_TICKS;

/// Ephemeris of any scalar.
pub trait DynEphemeris: Send + Sync {
    /// Number of segments, and of coefficients of each polynomial.
    fn size(&self) -> [usize; 2];

    /// Ticks in a unit of time.
    fn ticks_per_time(&self) -> f64;

    /// Greatest distance of a time from t = 0 at which the ephemeris can be evaluated.
    fn furthest_time(&self) -> f64 {
        MAX_TICKS / self.ticks_per_time()
    }

    /// Upper bound on the orientation error, rad.
    fn error_bound(&self) -> ErrorBound;

    /// Upper bound on the error of ω, of Ω and of u', rad per unit time.
    fn rate_error_bound(&self) -> ErrorBound;

    /// Sample of the motion t units of time after t = 0, t taken as exact.
    fn at(&self, t: f64) -> Sample;

    /// Orientation, u and tip of the motion t units of time after t = 0, without its rates and tip angle.
    fn pose(&self, t: f64) -> Pose<f64, f64> {
        self.at(t).pose
    }

    /// Sample of the motion at tick n.
    fn at_tick(&self, n: i64) -> Sample;

    /// Writes one column at each time.
    fn fill(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]);

    /// First events at which a condition holds, of those that the query includes.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent>;
}

/// Writes one column of the quantities at each time.
fn fill<Q: Quantities>(column: SampleColumn, at: impl Fn(f64) -> Q, times: &[f64], rows: &mut [f64]) {
    for (t, row) in times.iter().zip(rows.chunks_exact_mut(column.names().len())) {
        column.write(&at(*t), row);
    }
}

/// Events of a query, in the order of their times.
///
/// # Errors
/// `tilt` or `radius`: the motion's top has no such event.
pub fn search(
    table: &dyn DynEphemeris,
    motion: &Motion,
    query: &EventQuery,
) -> Result<Vec<MotionEvent>, ParameterError> {
    let conditions = query.kind.conditions(motion)?.into_iter();
    let mut events: Vec<_> = conditions.flat_map(|condition| table.events(condition, query)).collect();
    events.sort_by(|a, b| a.t.total_cmp(&b.t));
    events.truncate(query.count);
    Ok(events)
}

/// Angle in radians of a phase known modulo 2^32 turns, nearest to `near`, a number of turns.
fn unwrapped(phase: Phase, near: f64) -> f64 {
    const MODULUS: f64 = (1_u64 << 32) as f64;
    let turns = phase.to_turns();
    TAU * (turns + MODULUS * ((near - turns) / MODULUS).round())
}

#[cfg(test)]
mod tests {
    use toytop::{InitialAngles, Motion, Signs, Top, TopParameters};
    use toytop_model::constants::MotionWithPeriod;

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
            let constants = MotionWithPeriod::new(motion);
            let (rate, period) = (constants.ticks_per_time(), constants.time_scale());
            assert!(rate * period >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(constants.furthest_time() / period >= 1e10);
        }
    }
}
