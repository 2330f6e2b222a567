//! Evaluator of a motion: a table with as many segments as it needs, in any scalar, or the closed form of an aperiodic motion.

mod events;

mod evaluate;

mod boxed_table;
mod closed_form;

pub use boxed_table::{BoxedTable, SEGMENTS};
pub use events::{EventKind, EventQuery, MotionEvent};

use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::column::SampleColumn;
use crate::motion::sample::MotionSample;
use closed_form::rate_error_bound;
use evaluate::Evaluate;
use fixed::types::{I2F14, I2F30};
use toytop::{Complex, ErrorBound, Orientation, ParameterError, TableScalar, TableSettings};
use toytop_model::aperiodic::AperiodicMotion;
use toytop_model::motion_with_period::{MAX_TICKS, MotionWithPeriod};

/// Evaluator of a motion: the core's table in any scalar and size, or the closed form of an aperiodic motion.
pub struct MotionEvaluator {
    /// Number of segments of the table, and of coefficients of each polynomial; `None` for a closed form.
    pub size: Option<[usize; 2]>,
    /// Ticks in a unit of time.
    pub ticks_per_time: f64,
    /// Upper bound on the orientation error, rad.
    pub error_bound: ErrorBound,
    /// Upper bound on the error of ω, of Ω and of u', rad per unit time.
    pub rate_error_bound: ErrorBound,
    /// Motion, with its period.
    pub motion: MotionWithPeriod,
    evaluator: Box<dyn Evaluate>,
}

impl MotionEvaluator {
    /// Smallest table of a motion, or the closed form of an aperiodic motion, in ticks of [`MotionWithPeriod::tick`].
    ///
    /// # Errors
    /// [`Failure::method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
    pub fn new(motion: &MotionWithPeriod, scalar: Scalar) -> Result<Self, Failure> {
        Self::with_settings(motion, scalar, &TableSettings::new(motion.tick()))
    }

    /// Evaluator of a scenario's motion in `f64`.
    ///
    /// # Errors
    /// As [`new`](Self::new), with the name of the scenario.
    pub fn of_scenario(scenario: &Scenario) -> Result<Self, Failure> {
        Self::new(&scenario.motion, Scalar::F64).map_err(|failure| failure.at(&scenario.name))
    }

    /// Evaluator as [`new`](Self::new) makes it, with other settings of its table. A closed form ignores them: its tick is that of the motion.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_settings(
        motion: &MotionWithPeriod,
        scalar: Scalar,
        settings: &TableSettings,
    ) -> Result<Self, Failure> {
        if let Some(form) = AperiodicMotion::new(motion) {
            let reason = || Failure::method("an aperiodic motion has a closed form in f64, and no table");
            return (scalar == Scalar::F64).then(|| Self::with_closed_form(motion, form)).ok_or_else(reason);
        }
        match scalar {
            Scalar::F64 => Self::with_table::<f64>(motion, settings),
            Scalar::F32 => Self::with_table::<f32>(motion, settings),
            Scalar::Q31 => Self::with_table::<I2F30>(motion, settings),
            Scalar::Q15 => Self::with_table::<I2F14>(motion, settings),
        }
    }

    fn with_closed_form(motion: &MotionWithPeriod, form: AperiodicMotion) -> Self {
        Self {
            size: None,
            ticks_per_time: form.ticks_per_time,
            error_bound: form.error_bound(),
            rate_error_bound: rate_error_bound(&form),
            motion: *motion,
            evaluator: Box::new(form),
        }
    }

    /// Evaluator by the table with the least number of segments that is enough.
    fn with_table<R: TableScalar>(
        motion: &MotionWithPeriod,
        settings: &TableSettings,
    ) -> Result<Self, Failure>
    where
        BoxedTable<R>: Evaluate + 'static,
    {
        let memory = BoxedTable::<R>::new(motion, settings, SEGMENTS)?;
        let table = memory.table();
        Ok(Self {
            size: Some([table.capacity(), R::TERMS]),
            ticks_per_time: table.clock().ticks_per_time[0],
            error_bound: table.error_bound(),
            rate_error_bound: table.rate_error_bound(),
            motion: *motion,
            evaluator: Box::new(memory),
        })
    }

    /// Greatest distance of a time from t = 0 at which the motion can be evaluated.
    pub fn furthest_time(&self) -> f64 {
        MAX_TICKS / self.ticks_per_time
    }

    /// Sample t units of time after t = 0, t taken as exact.
    pub fn at(&self, t: f64) -> MotionSample {
        self.evaluator.sample(t, None, None)
    }

    /// Sample at tick n.
    pub fn at_tick(&self, n: i64) -> MotionSample {
        self.evaluator.sample(n as f64 / self.ticks_per_time, Some(n), None)
    }

    /// Orientation t units of time after t = 0.
    pub fn orientation(&self, t: f64) -> Orientation<f64> {
        self.evaluator.sample(t, None, Some(SampleColumn::Quaternion)).orientation
    }

    /// Position of the tip t units of time after t = 0, m.
    pub fn tip(&self, t: f64) -> Complex<f64> {
        self.evaluator.sample(t, None, Some(SampleColumn::Tip)).tip
    }

    /// Events of a query, in the order of their times.
    ///
    /// # Errors
    /// `tilt` or `radius`: the motion's top has no such event.
    pub fn events(&self, query: &EventQuery) -> Result<Vec<MotionEvent>, ParameterError> {
        let mut events = Vec::new();
        for condition in query.kind.conditions(&self.motion)? {
            events.extend(self.evaluator.events(condition, query));
        }
        events.sort_by(|a, b| a.sample.t.total_cmp(&b.sample.t));
        events.truncate(query.count);
        Ok(events)
    }

    /// Writes one column at each time, and computes no other.
    pub fn write(&self, column: SampleColumn, times: &[f64], rows: &mut [f64]) {
        let rows = rows.chunks_exact_mut(column.names().len());
        times
            .iter()
            .zip(rows)
            .for_each(|(t, row)| column.write(&self.evaluator.sample(*t, None, Some(column)), row));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{InitialAngles, Motion, Signs, Top, TopParameters};

    fn motion(a: f64, e: [f64; 3]) -> MotionWithPeriod {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: 0.8 * a,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })
        .unwrap();
        let motion = Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default());
        MotionWithPeriod::new(motion.unwrap())
    }

    #[test]
    fn a_tick_is_shorter_than_a_turn_and_a_thousandth_of_a_period() {
        for motion in
            [motion(1.0, [0.2, 0.8, 1.5]), motion(1e-6, [0.2, 0.8, 1e6]), motion(1e9, [0.2, 0.8, 1.5])]
        {
            let (rate, period) = (motion.ticks_per_time(), motion.characteristic_time());
            assert!(rate * period >= 1000.0 && rate.log2().fract() == 0.0);
            assert!(motion.furthest_time() / period >= 1e10);
        }
    }

    #[test]
    fn an_aperiodic_motion_has_a_closed_form_in_f64_alone() {
        let motion = motion(1.0, [0.2, 1.0, 1.0]);
        assert!(MotionEvaluator::new(&motion, Scalar::F64).unwrap().size.is_none());
        for scalar in [Scalar::F32, Scalar::Q31, Scalar::Q15] {
            let refusal = MotionEvaluator::new(&motion, scalar).err().unwrap().to_string();
            assert_eq!(refusal, "an aperiodic motion has a closed form in f64, and no table");
        }
    }

    /// Sizes that are chosen. Every smaller size is refused, and the motions of the test need every size.
    fn sizes_chosen<R: TableScalar>(scalar: Scalar, motions: &[MotionWithPeriod]) -> Vec<usize> {
        let chosen = |motion: &MotionWithPeriod| {
            let [chosen, _] = MotionEvaluator::new(motion, scalar).unwrap().size.unwrap();
            let settings = TableSettings::new(motion.tick());
            for segments in (3..12).map(|n| 1 << n).filter(|&segments| (segments as usize) < chosen) {
                let refused = BoxedTable::<R>::new(motion, &settings, segments..=segments).is_err();
                assert!(refused, "{segments} segments would do");
            }
            chosen
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
        assert_eq!(sizes_chosen::<f64>(Scalar::F64, &motions).first(), Some(&8));
        assert!(sizes_chosen::<f32>(Scalar::F32, &motions).len() > 4);
    }
}
