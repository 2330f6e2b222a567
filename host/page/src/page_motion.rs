//! Motion in `f64` by its table or its closed form: the orientation at any time, at the same cost.

use toytop::{
    Complex, Motion, Orientation, ParameterError, Regime, SizedTable, Table, TableMemory, TableScalar,
    TableSettings, Workspace,
};
use toytop_model::aperiodic::AperiodicMotion;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Motion by the table with the largest capacity that there is, or by the closed form if it is aperiodic.
pub struct PageMotion {
    memory: TableMemory<SizedTable<f64, 4096>>,
    closed_form: ClosedForm,
    ticks_per_time: f64,
}

/// Closed form of an aperiodic motion, which has no table.
#[repr(u8)] // the first variant is 0, so that a static table takes no space in a file
#[allow(clippy::large_enum_variant)] // there is no heap
enum ClosedForm {
    None,
    Some(AperiodicMotion),
}

/// Orientation, u, axis and tip at one time: Re α, Im α, Re β, Im β, u, r₁, r₂, r₃, c₁, c₂.
pub type PoseNumbers = [f64; 10];

/// Truncation errors that a table may have, rad: the least one that the capacity allows is taken.
const TRUNCATIONS: [f64; 4] = [f64::TRUNCATION, 1e-12, 1e-9, 1e-6];

impl PageMotion {
    /// Table before its first motion. All its bits are 0, so that it takes no space in a file.
    pub const EMPTY: Self =
        Self { memory: TableMemory::new(), closed_form: ClosedForm::None, ticks_per_time: 0.0 };

    /// Sets the table up for another motion.
    ///
    /// # Errors
    /// `e3`: the motion is so close to the separatrix that no table holds it.
    pub fn set_up(&mut self, motion: &MotionWithPeriod) -> Result<(), ParameterError> {
        self.ticks_per_time = motion.ticks_per_time();
        self.closed_form = AperiodicMotion::new(motion).map_or(ClosedForm::None, ClosedForm::Some);
        let settings = TableSettings::new(motion.tick());
        let mut fits = |truncation: &f64| {
            let settings = TableSettings { truncation: Some(*truncation), ..settings };
            self.memory.set_up(&mut Workspace::new(), motion, settings, &mut || {}).is_ok()
        };
        if matches!(self.closed_form, ClosedForm::Some(_)) || TRUNCATIONS.iter().any(&mut fits) {
            return Ok(());
        }
        let allowed = "further from e2: no table holds this motion";
        Err(ParameterError::new("e3", allowed))
    }

    /// Whether the table can hold a motion, or a closed form follows it.
    pub fn fits(motion: &Motion) -> bool {
        let [.., coarsest] = TRUNCATIONS;
        motion.regime() == Regime::Aperiodic || Table::<f64>::segments_needed(motion, coarsest).is_ok()
    }

    /// Orientation and tip at t, with t taken as exact; the identity before the first motion.
    pub fn at(&self, t: f64) -> (Orientation<f64>, Complex<f64>) {
        match (&self.closed_form, self.memory.get()) {
            (ClosedForm::Some(motion), _) => {
                let (state, tip) = motion.at(t);
                (state.orientation, tip)
            }
            (ClosedForm::None, Some(table)) => {
                let sample = table.at(t);
                (sample.orientation(), sample.tip())
            }
            (ClosedForm::None, None) => (Orientation::IDENTITY, Complex::ZERO),
        }
    }

    /// Bound on the orientation error at t = 0, rad, and its growth, rad per unit time.
    pub fn error_bound(&self) -> [f64; 2] {
        let bound = match (&self.closed_form, self.memory.get()) {
            (ClosedForm::Some(motion), _) => motion.error_bound(),
            (ClosedForm::None, Some(table)) => table.error_bound(),
            (ClosedForm::None, None) => return [f64::INFINITY; 2],
        };
        [bound.constant, bound.per_tick * self.ticks_per_time]
    }
}

/// Numbers of an orientation and a tip.
pub fn pose_numbers((orientation, tip): (Orientation<f64>, Complex<f64>)) -> PoseNumbers {
    let (Orientation { alpha, beta }, [x, y, z]) = (orientation, orientation.axis());
    [alpha.re, alpha.im, beta.re, beta.im, orientation.u().clamp(-1.0, 1.0), x, y, z, tip.re, tip.im]
}
