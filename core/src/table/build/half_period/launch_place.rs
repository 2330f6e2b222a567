//! Place of a launch on the path along half a nutation period.

use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::Scalar;
use crate::table::build::expansion::{Expansion, PathPhases};
use crate::table::build::interval::{HALF_PERIOD, Interval};

/// Phases of a launch, and the place where a path reaches them.
#[derive(Debug)]
pub(crate) struct LaunchPlace {
    /// Half phase χ, folded into [0, 1/4] turn; `None` once its span is found.
    chi: Option<Phase>,
    is_falling: bool,
    /// Nutation phase and mean phases.
    pub(crate) phases: [Phase; 3],
}

impl LaunchPlace {
    pub(super) const ZERO: Self = Self { chi: None, is_falling: false, phases: [Phase::ZERO; 3] };

    /// Place of a launch, not found yet. Without a nutation it is u = e₁.
    pub(super) fn new(motion: &Motion) -> Self {
        let (half_turns, remainder) = motion.half_phase.unwrap_or_default().split_half_turns();
        let is_falling = remainder > Phase::QUARTER;
        let (half_turns, chi) =
            if is_falling { (half_turns + 1, Phase::HALF - remainder) } else { (half_turns, remainder) };
        let [alpha, beta] = motion.slow_phases.map(|phase| phase + Phase::HALF * half_turns);
        Self { chi: Some(chi), is_falling, phases: [Phase::ZERO, alpha, beta] }
    }

    /// Finds the place if it is in this span, which ends at χ = `end`, or if the span is the last.
    #[inline(never)]
    pub(super) fn search(&mut self, expansion: &Expansion, end: Phase, span: Interval) {
        let Some(chi) = self.chi else { return };
        // a turning point is an end of the half period exactly
        let x = match chi {
            Phase::ZERO => -1.0,
            _ if (chi == Phase::QUARTER || end < chi) && span.end() < HALF_PERIOD => return,
            Phase::QUARTER => 1.0,
            _ => coordinate_of(expansion, chi),
        };
        let (PathPhases { residual, .. }, _) = expansion.at(x);
        let mirror = |phase: Phase| if self.is_falling { -phase } else { phase };
        let ([_, alpha, beta], [alpha_residual, beta_residual]) = (self.phases, residual.map(mirror));
        self.phases = [mirror(span.phase(x)), alpha - alpha_residual, beta - beta_residual];
        self.chi = None;
    }
}

/// Coordinate x of χ on a span, by Newton's method.
fn coordinate_of(expansion: &Expansion, chi: Phase) -> f64 {
    const STEPS: usize = 8;
    const LAST_STEP: f64 = 4.0 * f64::ROUNDING;
    let mut x = 0.0_f64;
    for _ in 0..STEPS {
        let (phases, chi_rate) = expansion.at(x);
        let miss = (phases.chi - chi).to_radians();
        let next = if chi_rate > 0.0 { (x - miss / chi_rate).clamp(-1.0, 1.0) } else { x };
        let change = (next - x).abs();
        x = next;
        if change <= LAST_STEP {
            break;
        }
    }
    x
}
