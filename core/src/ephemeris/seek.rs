//! Start of a motion on the half period that an ephemeris tabulates.

use crate::ephemeris::mean_rates::{MeanRates, last_v, rise_time};
use crate::law::series::Expansion;
use crate::law::{Law, gudermannian};
use crate::motion::Motion;
use crate::motion::NutationVariable;
use crate::motion::start::chi;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Scalar};

/// Data for finding the start of a motion while its half period is tabulated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StartSearch {
    /// Half phase of the start, folded into [0, 1/4] turn.
    chi: Phase,
    /// Whether u is falling at the start.
    mirrored: bool,
    /// Half turns of χ that the folding removed.
    folded: i64,
    /// Change of χ at the start, rad, over a relative change of the number that is stored rounded: χ, its difference
    /// from a quarter turn, or v.
    per_rounding: f64,
    /// Nutation phase of a start beyond the end of the tabulated interval, where 1 - u is below the rounding.
    beyond: Option<Phase>,
}

impl StartSearch {
    /// Search for the start of a motion that starts at u = e₁.
    pub(crate) const EMPTY: Self =
        Self { chi: Phase::ZERO, mirrored: false, folded: 0, per_rounding: 0.0, beyond: None };

    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn new(motion: &Motion, law: &Law<Extended>, rates: &MeanRates) -> Self {
        match motion.nutation() {
            NutationVariable::Aperiodic(v) => {
                let (sine, cosine) = gudermannian(Float::abs(v));
                // most starts are found during the tabulation, which costs less than a precise quadrature
                let beyond = (Float::abs(v) > last_v(rates.rounding)).then(|| {
                    let time = rise_time(&law.cast(), Float::abs(v), 1024);
                    Phase::new(time / (2.0 * rates.half_period.to_f64()))
                });
                let beyond = beyond.filter(|phase| *phase > Phase::HALF);
                let per_rounding = Float::abs(v) * cosine;
                Self { chi: chi(sine, cosine), mirrored: v < 0.0, folded: 0, per_rounding, beyond }
            }
            NutationVariable::Nutating(start) => {
                let (folded, rest) = start.halves();
                let mirrored = rest > Phase::QUARTER;
                let (folded, chi) = if mirrored { (folded + 1, Phase::HALF - rest) } else { (folded, rest) };
                let rest = Phase::QUARTER - chi;
                let per_rounding = (if rest < chi { rest } else { chi }).to_radians();
                Self { chi, mirrored, folded, per_rounding, beyond: None }
            }
            NutationVariable::Steady(_) => Self::EMPTY,
        }
    }

    /// Coordinate x of the start, if it lies in this span, which ends at χ = `end` (or if the span is the last).
    pub(crate) fn within(&self, expansion: &Expansion, end: Phase, last: bool) -> Option<f64> {
        // most motions start at a turning point, which is an end of the half period whatever the errors of the series
        match self.chi {
            Phase::ZERO => return Some(-1.0),
            Phase::QUARTER => return last.then_some(1.0),
            _ => {}
        }
        if (end - self.chi).to_radians() < 0.0 && !last {
            return None;
        }
        const NEWTON_STEPS: usize = 8;
        /// Step of some roundings, after which the next would be a rounding error.
        const LAST_STEP: f64 = 4.0 * f64::ROUNDING;
        let mut x = 0.0_f64;
        for _ in 0..NEWTON_STEPS {
            let (chi, slope) = expansion.chi_and_slope(x);
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

    /// Change of x at the start over a relative change of the number that is stored rounded (see the field `per_rounding`).
    pub(crate) fn per_rounding(&self, expansion: &Expansion, x: f64) -> f64 {
        if self.per_rounding == 0.0 {
            return 0.0;
        }
        let (_, slope) = expansion.chi_and_slope(x);
        if slope > 0.0 { self.per_rounding / slope } else { 0.0 }
    }

    /// Nutation phase and mean slow phases at t = 0, from the phase and θ found on the half period.
    pub(crate) fn start(&self, motion: &Motion, phase: Phase, theta: [Phase; 2]) -> [Phase; 3] {
        let [alpha, beta] = motion.phases();
        let mirror = |phase: Phase| if self.mirrored { -phase } else { phase };
        let phase = mirror(self.beyond.unwrap_or(phase));
        let half_turns = Phase::HALF.times(self.folded);
        let [alpha_theta, beta_theta] = theta.map(mirror);
        [phase, alpha + half_turns - alpha_theta, beta + half_turns - beta_theta]
    }
}
