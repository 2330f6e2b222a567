//! Start of a motion on the half period that a table covers.

use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar};
use crate::table::build::span::Span;
use crate::table::series::expansion::{Expansion, PhasePoint};

/// Data for finding the start of a motion while its half period is tabulated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StartSearch {
    /// Half phase of the start, folded into [0, 1/4] turn.
    chi: Phase,
    /// Whether u is falling at the start.
    mirrored: bool,
    /// Half turns of χ that the folding removed.
    folded: i64,
    /// Change of χ, rad, over a relative rounding of χ or of its difference from a quarter turn.
    per_rounding: f64,
}

/// Start on the half period.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct FoundStart {
    pub(crate) phase: Phase,
    theta: [Phase; 2],
    /// Sensitivity of the start time to a rounding of χ, in half periods.
    pub(crate) share: f64,
}

impl StartSearch {
    pub(crate) const EMPTY: Self = Self { chi: Phase::ZERO, mirrored: false, folded: 0, per_rounding: 0.0 };

    /// Search for the start of a motion; of one that does not nutate at u = e₁.
    pub(crate) fn new(motion: &Motion) -> Self {
        let start = match motion.nutation {
            NutationVariable::Nutating(chi) => chi,
            NutationVariable::Steady | NutationVariable::Aperiodic(_) => Phase::ZERO,
        };
        let (folded, rest) = start.halves();
        let mirrored = rest > Phase::QUARTER;
        let (folded, chi) = if mirrored { (folded + 1, Phase::HALF - rest) } else { (folded, rest) };
        let rest = Phase::QUARTER - chi;
        let per_rounding = (if rest < chi { rest } else { chi }).to_radians();
        Self { chi, mirrored, folded, per_rounding }
    }

    /// Start, if it lies in this span, which ends at χ = `end`, or if the span is the last.
    #[inline(never)]
    pub(crate) fn within(
        &self,
        expansion: &Expansion,
        end: Phase,
        is_last: bool,
        span: Span,
    ) -> Option<FoundStart> {
        let x = self.coordinate(expansion, end, is_last)?;
        let (PhasePoint { theta, .. }, slope) = expansion.at(x);
        let change = if slope > 0.0 { self.per_rounding / slope } else { 0.0 };
        let share = change * span.half_length();
        Some(FoundStart { phase: span.phase(x), theta, share })
    }

    /// Coordinate x of the start.
    fn coordinate(&self, expansion: &Expansion, end: Phase, is_last: bool) -> Option<f64> {
        // most motions start at a turning point, which is an end of the half period whatever the errors of the series
        match self.chi {
            Phase::ZERO => return Some(-1.0),
            Phase::QUARTER => return is_last.then_some(1.0),
            _ => {}
        }
        if (end - self.chi).to_radians() < 0.0 && !is_last {
            return None;
        }
        const NEWTON_STEPS: usize = 8;
        /// Step of some roundings, after which the next would be a rounding error.
        const LAST_STEP: f64 = 4.0 * f64::ROUNDING;
        let mut x = 0.0_f64;
        for _ in 0..NEWTON_STEPS {
            let (PhasePoint { chi, .. }, slope) = expansion.at(x);
            let miss = (chi - self.chi).to_radians();
            let next = if slope > 0.0 { (x - miss / slope).clamp(-1.0, 1.0) } else { x };
            let change = Float::abs(next - x);
            x = next;
            if change <= LAST_STEP {
                break;
            }
        }
        Some(x)
    }

    /// Nutation phase and mean slow phases at t = 0.
    pub(crate) fn start(&self, motion: &Motion, found: &FoundStart) -> [Phase; 3] {
        let [alpha, beta] = motion.phases;
        let mirror = |phase: Phase| if self.mirrored { -phase } else { phase };
        let half_turns = Phase::HALF.times(self.folded);
        let [alpha_theta, beta_theta] = found.theta.map(mirror);
        [mirror(found.phase), alpha + half_turns - alpha_theta, beta + half_turns - beta_theta]
    }
}
