//! Start of a motion on the half period that a table covers.

use super::Span;
use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar};
use crate::table::series::expansion::{Expansion, PhasePoint};

/// Start of a motion, which is found while its half period is tabulated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    /// Half phase at the start, folded into [0, 1/4] turn.
    chi: Phase,
    /// Whether u is falling at the start.
    mirrored: bool,
    is_found: bool,
    /// Nutation phase and mean slow phases at t = 0, once they are found.
    pub(crate) phases: [Phase; 3],
    /// Delay by a relative rounding of χ or of its difference from a quarter turn, in half periods.
    pub(crate) delay: f64,
}

impl Start {
    pub(crate) const NONE: Self =
        Self { chi: Phase::ZERO, mirrored: false, is_found: false, phases: [Phase::ZERO; 3], delay: 0.0 };

    /// Start of a motion that is not found yet; that of one that does not nutate is u = e₁.
    pub(crate) fn new(motion: &Motion) -> Self {
        let start = if let NutationVariable::Nutating(chi) = motion.nutation { chi } else { Phase::ZERO };
        let (folded, rest) = start.halves();
        let mirrored = rest > Phase::QUARTER;
        let (folded, chi) = if mirrored { (folded + 1, Phase::HALF - rest) } else { (folded, rest) };
        let [alpha, beta] = motion.phases.map(|phase| phase + Phase::HALF.times(folded));
        Self { chi, mirrored, phases: [Phase::ZERO, alpha, beta], ..Self::NONE }
    }

    /// Finds the start, if it lies in this span, which ends at χ = `end`, or if the span is the last.
    #[inline(never)]
    pub(crate) fn search(&mut self, expansion: &Expansion, end: Phase, span: Span) {
        if self.is_found {
            return;
        }
        let Some(x) = self.coordinate(expansion, end, span.is_last()) else { return };
        let (PhasePoint { theta, .. }, slope) = expansion.at(x);
        let nearest = self.chi.min(Phase::QUARTER - self.chi).to_radians();
        let change = if slope > 0.0 { nearest / slope } else { 0.0 };
        let mirror = |phase: Phase| if self.mirrored { -phase } else { phase };
        let ([_, alpha, beta], [alpha_theta, beta_theta]) = (self.phases, theta.map(mirror));
        self.phases = [mirror(span.phase(x)), alpha - alpha_theta, beta - beta_theta];
        (self.is_found, self.delay) = (true, change * span.half_length());
    }

    /// Coordinate x of the start.
    fn coordinate(&self, expansion: &Expansion, end: Phase, is_last: bool) -> Option<f64> {
        // most motions start at a turning point, which is an end of the half period whatever the errors of the series
        match self.chi {
            Phase::ZERO => return Some(-1.0),
            Phase::QUARTER => return is_last.then_some(1.0),
            _ if end < self.chi && !is_last => return None,
            _ => {}
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
}
