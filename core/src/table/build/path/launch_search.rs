//! Search for a launch on the path, and its nutation phase and mean phases.

use super::expansion::{Expansion, PathPhases};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::table::build::interval::{Interval, SHORTEST_SEGMENTS};
use crate::table::time::Phases;

/// Search for the phases of a launch, which ends once the path has reached its χ.
#[derive(Debug)]
pub(crate) struct LaunchSearch {
    /// Half phase χ of the launch, mirrored to the rising half; `None` once the path has reached it.
    chi: Option<Phase>,
    is_falling: bool,
    /// Nutation phase and mean phases of the launch; before the search, the slow phases instead of the mean ones.
    pub(crate) phases: Phases<Phase>,
}

impl LaunchSearch {
    /// Search for the launch of a motion.
    pub(crate) fn new(motion: &Motion) -> Self {
        let (half_turns, in_half_turn) = motion.half_phase.unwrap_or_default().split_half_turns();
        let is_falling = in_half_turn > Phase::QUARTER;
        let (half_turns, chi) = if is_falling {
            (half_turns + 1, Phase::HALF - in_half_turn)
        } else {
            (half_turns, in_half_turn)
        };
        let [alpha, beta] = motion.slow_phases.map(|phase| phase + Phase::HALF * half_turns);
        Self { chi: Some(chi), is_falling, phases: Phases { nutation: Phase::ZERO, alpha, beta } }
    }

    /// Finds the phases, if the launch is on this span. The last span always contains it.
    ///
    /// * `end`: χ at the end of the span
    pub(super) fn search(&mut self, expansion: &Expansion, end: Phase, span: Interval) {
        let Some(chi) = self.chi else { return };
        // a turning point is an end of the half period exactly
        let x = match chi {
            Phase::ZERO => -1.0,
            _ if (chi == Phase::QUARTER || end < chi) && span.end() < SHORTEST_SEGMENTS => return,
            Phase::QUARTER => 1.0,
            _ => coordinate_of(expansion, chi),
        };
        let (PathPhases { residual, .. }, _) = expansion.at(x);
        let mirror = |phase: Phase| if self.is_falling { -phase } else { phase };
        let [alpha_residual, beta_residual] = residual.map(mirror);
        self.phases = Phases {
            nutation: mirror(span.phase(x)),
            alpha: self.phases.alpha - alpha_residual,
            beta: self.phases.beta - beta_residual,
        };
        self.chi = None;
    }
}

/// Coordinate x of χ on a span, by Newton's method.
fn coordinate_of(expansion: &Expansion, chi: Phase) -> f64 {
    const STEPS: usize = 8;
    const LAST_STEP: f64 = 4.0 * f64::OPERATION_ERROR;
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
