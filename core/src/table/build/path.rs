//! Path along half a nutation period, from one expansion of the motion to the next.

use super::expansion::{Expansion, Origin, PathPhases};
use super::limits::{Limits, max_or_nan};
use super::mean_rates::MeanRates;
use super::series::MOST_TERMS;
use super::speeds::Speeds;
use crate::motion::Motion;
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, Scalar, power_of_two};
use crate::table::data::cell::{CELLS, Cell};

/// One of the 2^depth equal parts of half a period. Positions are in shortest segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) begin: usize,
    pub(super) depth: u32,
}

pub(super) const HALF_PERIOD: usize = 1 << Span::DEEPEST;

pub(super) const CELL: usize = HALF_PERIOD / CELLS;

impl Span {
    const SHALLOWEST: u32 = 2;
    /// Greatest depth, that of the shortest segment.
    pub(super) const DEEPEST: u32 = Cell::DEEPEST;

    /// Longest span from u = e₁ on.
    pub(super) const FIRST: Self = Self { begin: 0, depth: Self::SHALLOWEST };

    /// Whether the half period is divided so.
    pub(super) fn exists(self) -> bool {
        self.depth >= Self::SHALLOWEST && self.begin.is_multiple_of(HALF_PERIOD >> self.depth)
    }

    pub(super) fn end(self) -> usize {
        self.begin + (HALF_PERIOD >> self.depth)
    }

    /// Half the length, in half periods.
    pub(super) fn half_length(self) -> f64 {
        power_of_two(-1 - self.depth as i32)
    }

    /// Nutation phase at x in [-1, 1].
    pub(super) fn phase(self, x: f64) -> Phase {
        // the half period is half a turn
        let unit = Phase::from_bits(Phase::QUARTER.to_bits() >> Self::DEEPEST);
        unit * (self.begin + self.end()) as i64 + Phase::from_turns(0.5 * x * self.half_length())
    }
}

/// Ratio of the negligible terms of the phases, at x = 2, and of a and b, at x = 1.
const PHASE_TERM: f64 = 32.0;

/// Point of the path.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathPoint {
    pub(super) phases: PathPhases,
    /// Truncation and rounding errors of the steps to it, rad.
    error: f64,
}

impl PathPoint {
    pub(super) const FIRST: Self = Self { phases: PathPhases::ZERO, error: 0.0 };
}

/// Span of the path with the expansion of the motion around its centre.
#[derive(Debug)]
pub(super) struct Path {
    // constants of the motion
    pub(super) equations: PhaseEquations<Extended>,
    pub(super) rounded_equations: PhaseEquations<f64>,
    half_period: Extended,
    /// Residual rates minus ψ_α' and ψ_β', rad/s.
    residual_offsets: [Extended; 2],
    /// Sum of the rates of χ and of the residual phases at the faster end of the path, rad per half period.
    endpoint_rate: f64,
    /// Allowed truncation error of all steps, rad.
    allowed: f64,
    /// Negligible term of the phases, rad.
    negligible: f64,
    pub(super) span: Span,
    pub(super) beginning: PathPoint,
    /// `None` if it is not known yet.
    centre: Option<PathPoint>,
    pub(super) end: PathPoint,
    pub(super) expansion: Expansion,
}

impl Path {
    pub(super) const ZERO: Self = Self {
        equations: PhaseEquations::ZERO,
        rounded_equations: PhaseEquations::ZERO,
        half_period: Extended::ZERO,
        residual_offsets: [Extended::ZERO; 2],
        endpoint_rate: 0.0,
        allowed: 0.0,
        negligible: 0.0,
        span: Span { begin: 0, depth: 0 },
        beginning: PathPoint::FIRST,
        centre: None,
        end: PathPoint::FIRST,
        expansion: Expansion::ZERO,
    };

    /// Begins at u = e₁. The equations must be set.
    #[inline(never)]
    pub(super) fn begin(
        &mut self,
        motion: &Motion,
        half_period: Extended,
        rates: &MeanRates,
        limits: &Limits,
    ) {
        let [_, alpha, beta] = rates.rates.map(|rate| Extended::TWO_PI * rate);
        self.half_period = half_period;
        self.residual_offsets = [motion.half_tau - alpha, -motion.half_tau - beta];
        (self.allowed, self.negligible) = (limits.steps, PHASE_TERM * limits.negligible);
        let [alpha, beta] = self.residual_offsets.map(Float::to_f64);
        self.rounded_equations = self.equations.cast();
        let [begin, end] = [(0.0, 1.0), (1.0, 0.0)].map(|(sine, cosine)| {
            let PhaseRates { half_phase, psi_alpha, psi_beta } = self.rounded_equations.rates(sine, cosine);
            half_phase.abs() + ((psi_alpha + alpha).abs() + (psi_beta + beta).abs())
        });
        self.endpoint_rate = half_period.to_f64() * max_or_nan(begin, end);
        self.span = Span::FIRST;
        self.set_beginning(0, PathPoint::FIRST);
    }

    /// Begins a span at a point that was reached before.
    pub(super) fn set_beginning(&mut self, begin: usize, point: PathPoint) {
        self.span.begin = begin;
        (self.beginning, self.centre) = (point, None);
    }

    /// Goes on to the next span. It is twice as long if [`Expansion::may_double`] allows it and the phases at x = 2 are accurate.
    ///
    /// * `tries_longer`: whether to double the span without accurate phases at x = 2
    pub(super) fn go_to_next_span(&mut self, tries_longer: bool) {
        let next = Span { begin: self.span.end(), ..self.span };
        let twice = Span { depth: self.span.depth - 1, ..next };
        let allowed = self.allowed_step();
        let accurate = tries_longer || self.expansion.truncation_error(2) <= allowed;
        let doubles = twice.exists() && self.expansion.may_double() && accurate;
        let x = if doubles { 3 } else { 2 };
        self.centre = self.point_at(x, f64::from(x) * allowed);
        self.beginning = self.end;
        self.span = if doubles { twice } else { next };
    }

    /// Halves the span up to four times; `None` if it becomes too short.
    pub(super) fn shorten_span(&mut self) -> Option<()> {
        // the last of sixteen terms over half the distance
        const PER_HALVING: f64 = 1.0 / (1_u32 << (MOST_TERMS - 1)) as f64;
        let (allowed, mut error) = (self.allowed_step(), self.expansion.truncation_error(1));
        for _ in 0..4 {
            error *= PER_HALVING;
            self.span.depth += 1;
            if !(error > allowed && error < f64::INFINITY) {
                break;
            }
        }
        self.centre = None;
        (self.span.depth <= Span::DEEPEST).then_some(())
    }

    /// Expands the motion around the centre of the span; `None` if a truncation error is too large. If the centre is not known yet,
    /// an expansion around the beginning finds it.
    ///
    /// * `WORDS`: size of the numbers for the rates at the origin
    #[inline(never)]
    pub(super) fn expand<const WORDS: usize>(&mut self, pause: &mut dyn FnMut()) -> Option<()> {
        loop {
            pause();
            // a slow phase may hardly differ from its mean, which the table of an `f64` must resolve
            let origin = match WORDS {
                1 => self.origin(&self.rounded_equations, Float::to_f64),
                _ => self.origin(&self.equations, |constant| constant),
            };
            self.expansion.expand(&self.rounded_equations, &origin, pause);
            pause();
            let next = self.point_at(1, self.allowed_step())?;
            if self.centre.is_some() {
                self.end = next;
                return Some(());
            }
            self.centre = Some(next);
        }
    }

    /// Allowed truncation error of a step over half a span.
    fn allowed_step(&self) -> f64 {
        self.allowed * self.span.half_length()
    }

    fn centre_or_beginning(&self) -> &PathPoint {
        self.centre.as_ref().unwrap_or(&self.beginning)
    }

    /// Origin of the next expansion, computed in numbers of this type.
    #[inline(never)]
    fn origin<F: Float>(&self, equations: &PhaseEquations<F>, convert: fn(Extended) -> F) -> Origin {
        // two spans
        let unit = (1..self.span.depth).fold(self.half_period, |unit, _| unit.halved());
        let phases = self.centre_or_beginning().phases;
        let (sine, cosine) = phases.sine_cosine();
        let PhaseRates { half_phase, psi_alpha, psi_beta } =
            equations.rates(F::from_f64(sine), F::from_f64(cosine));
        let [alpha_offset, beta_offset] = self.residual_offsets.map(convert);
        let unit = convert(unit);
        let by_y = |rate: F| (unit * rate).to_f64();
        let chi_rate = by_y(half_phase);
        let weight = 4.0 * self.endpoint_rate * self.span.half_length() / chi_rate.abs();
        Origin {
            phases,
            sine,
            cosine,
            unit: unit.to_f64(),
            chi_rate,
            psi_rates: [psi_alpha, psi_beta].map(by_y),
            residual_rates: [psi_alpha + alpha_offset, psi_beta + beta_offset].map(by_y),
            weight: weight.max(1.0),
            // an estimated error of a twentieth of it at x = 2, of two thirds at x = 3
            negligible: self.negligible.min(4.0 * self.allowed_step()),
        }
    }

    /// Point at `x`; `None` if the truncation error is above `allowed`.
    #[inline(never)]
    fn point_at(&self, x: u32, allowed: f64) -> Option<PathPoint> {
        let truncation_error = self.expansion.truncation_error(x);
        (truncation_error <= allowed).then(|| {
            let x = x.into();
            let (phases, _) = self.expansion.at(x);
            let error =
                self.centre_or_beginning().error + truncation_error + self.expansion.rounding_error(x);
            PathPoint { phases, error }
        })
    }

    /// Orientation error by the steps to u = e₂, and by the roundings of the launch, rad.
    pub(super) fn error(&self, speeds: &Speeds) -> f64 {
        /// Delay by the roundings of χ at the launch and of the local coordinate, in half periods.
        const ROUNDING_DELAY: f64 = 4.0 * f64::ROUNDING;
        let PathPoint { phases: PathPhases { chi, residual }, error } = self.end;
        // distance from an odd number of quarter turns, rad
        let miss = |angle: Phase| {
            let (_, remainder) = (angle + Phase::QUARTER).split_half_turns();
            remainder.min(Phase::HALF - remainder).to_radians()
        };
        // at u = e₂, cos χ = 0 and the cosines of the residual phases are 0
        let [alpha, beta] = residual.map(miss);
        let nutation = self.half_period.to_f64() * self.rounded_equations.rates(1.0, 0.0).half_phase;
        let delay = ROUNDING_DELAY + error / self.endpoint_rate + miss(chi) / nutation;
        speeds.error_of_delay(delay) + 2.0 * (error + alpha.max(beta))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_has_the_phases_of_its_position() {
        assert!(Span::FIRST.exists() && !Span { begin: CELL, ..Span::FIRST }.exists());
        let second = Span { begin: Span::FIRST.end(), ..Span::FIRST };
        assert_eq!((second.phase(-1.0), second.phase(1.0)), (Phase::from_bits(1 << 93), Phase::QUARTER));
        let last = Span { begin: HALF_PERIOD - 1, depth: Span::DEEPEST };
        assert_eq!((last.end(), last.phase(1.0)), (HALF_PERIOD, Phase::HALF));
    }
}
