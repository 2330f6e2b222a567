//! Parts of toytop that its sibling crates share; not covered by semantic versioning.

pub use crate::error::{finite, require};
pub use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
pub use crate::phase::integer_parts;
pub use crate::su2::quotient;
pub use crate::table::Ticks;
pub use crate::top::ScaledTop;

use crate::constants::{BranchPoints, FirstIntegrals};
use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::Extended;

/// Constants of a motion and its phases at t = 0, in extended precision.
#[derive(Clone, Copy, Debug)]
pub struct Constants {
    /// Branch points.
    pub e: BranchPoints<Extended>,
    /// First integrals.
    pub integrals: FirstIntegrals<Extended>,
    /// Parameters of the top.
    pub top: ScaledTop<Extended>,
    /// Half phase χ at t = 0 of a motion that nutates.
    pub chi: Option<Phase>,
    /// Variable v at t = 0 of an aperiodic motion.
    pub v: Option<f64>,
    /// Slow phases at t = 0.
    pub phases: [Phase; 2],
    /// Rate τ/2, rad per unit time.
    pub half_tau: Extended,
    /// Equations of the phases.
    pub law: PhaseEquations<Extended>,
}

impl Constants {
    /// Constants of a launched motion.
    #[must_use]
    pub fn new(motion: &Motion) -> Self {
        let (chi, v) = match motion.nutation {
            NutationVariable::Nutating(chi) => (Some(chi), None),
            NutationVariable::Aperiodic(v) => (None, Some(v)),
            NutationVariable::Steady => (None, None),
        };
        Self {
            e: motion.e,
            integrals: motion.integrals,
            top: motion.scaled_top(),
            chi,
            v,
            phases: motion.phases,
            half_tau: motion.half_tau,
            law: motion.equations(),
        }
    }
}

/// Constant 2π.
pub const TWO_PI: Extended = Extended::TWO_PI;

/// Phase of an angle in rad.
#[must_use]
pub fn phase_of(angle: Extended) -> Phase {
    angle.in_turns().to_phase()
}

impl Motion {
    /// Nutation period, and the rotations during it about the vertical and of the body about its axis; whole turns do not count.
    #[doc(hidden)]
    #[must_use]
    pub fn period_and_turns(&self) -> Option<(Extended, [Phase; 2])> {
        let period = self.period::<2>(&self.equations(), &mut || {})?;
        Some((period.time, period.rotations(self.half_tau)))
    }
}
