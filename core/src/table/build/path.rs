//! Path of the phases from u = e₁ to u = e₂, span by span.

mod series;

pub(super) mod polynomial;

mod expansion;

pub(super) mod launch_search;

use super::error_budget::ErrorBudget;
use super::interval::Interval;
use crate::motion::Motion;
use crate::motion::ellipses::Ellipses;
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real, Ring};
use crate::table::time::Phases;
use expansion::{Expansion, ExpansionPoint, PathPhases};
use launch_search::LaunchSearch;
use polynomial::Polynomial;
use series::PowerSeries;

/// Depth of the longest span.
pub(super) const MIN_SPAN_DEPTH: u32 = 2;

/// Point of the path.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathPoint {
    phases: PathPhases,
    /// Truncation and rounding errors of the steps to it, rad.
    error: f64,
}

impl PathPoint {
    /// Turning point u = e₁.
    const FIRST: Self = Self { phases: PathPhases::ZERO, error: 0.0 };
}

/// Phase equations of a motion along half a period.
struct PathEquations<F> {
    equations: PhaseEquations<F>,
    /// Duration of half a period, s.
    duration: F,
    /// Residual rates minus ψ_α' and ψ_β', rad per half period.
    residual_offsets: [F; 2],
}

impl<F: Float> PathEquations<F> {
    /// Rates of χ, ψ_α, ψ_β, ρ_α and ρ_β, rad per half period.
    fn rates(&self, sine: f64, cosine: f64) -> [f64; 5] {
        let PhaseRates { chi, psi_alpha, psi_beta } =
            self.equations.rates(F::from_f64(sine), F::from_f64(cosine));
        let [chi, psi_alpha, psi_beta] = [chi, psi_alpha, psi_beta].map(|rate| self.duration * rate);
        let [alpha, beta] = self.residual_offsets;
        [chi, psi_alpha, psi_beta, psi_alpha + alpha, psi_beta + beta].map(F::to_f64)
    }
}

/// Scratch memory of a path: its phase equations, and its span.
#[derive(Debug)]
pub(super) struct PathScratch {
    pub(super) equations: PhaseEquations<Extended>,
    expansion: Expansion,
    /// Rates and value of an exponential in a or b.
    exponential: [PowerSeries; 4],
    /// Polynomials of a and b on the span.
    polynomials: [Polynomial; 2],
    /// Polynomial of a or b on a segment.
    segment: Polynomial,
}

impl PathScratch {
    pub(super) const ZERO: Self = Self {
        equations: PhaseEquations::ZERO,
        expansion: Expansion::ZERO,
        exponential: [PowerSeries::ZERO; 4],
        polynomials: [Polynomial::ZERO; 2],
        segment: Polynomial::ZERO,
    };

    #[inline(never)] // a copy of the equations must not stay on the stack of the quadrature
    pub(super) fn set_equations(&mut self, motion: &Motion) {
        self.equations = motion.equations();
    }
}

/// Path with phase equations in `F`. Its last span, with one expansion of the motion, has polynomials of a and b in scratch memory.
pub(super) struct Path<'a, F> {
    equations: PathEquations<F>,
    scratch: &'a mut PathScratch,
    pub(super) budget: &'a ErrorBudget,
    /// Coefficients of the exponentials in a and in b.
    exponentials: [[f64; 2]; 2],
    /// Sum of the rates of χ and of the residual phases at the faster end of the path, rad per half period.
    turning_point_rate: f64,
    pub(super) launch: LaunchSearch,
    span: Interval,
    /// End of the span.
    end: PathPoint,
    pause: &'a mut dyn FnMut(),
}

impl<'a, F: Float> Path<'a, F> {
    /// Path from u = e₁ on. The scratch memory has the equations of the motion.
    ///
    /// * `duration`: duration of half a period, s
    /// * `rates`: mean rates, turns/s
    pub(super) fn new(
        scratch: &'a mut PathScratch,
        budget: &'a ErrorBudget,
        motion: &Motion,
        duration: Extended,
        rates: Phases<Extended>,
        pause: &'a mut dyn FnMut(),
    ) -> Self {
        let Phases { alpha, beta, .. } = rates.map(|rate| Extended::TWO_PI * rate);
        let equations = PathEquations {
            equations: scratch.equations.map(F::from_extended),
            duration: F::from_extended(duration),
            residual_offsets: [motion.half_tau - alpha, -motion.half_tau - beta]
                .map(|rate| F::from_extended(duration * rate)),
        };
        let [first, last] = [(0.0, 1.0), (1.0, 0.0)].map(|(sine, cosine)| {
            let [chi, _, _, alpha, beta] = equations.rates(sine, cosine).map(Float::abs);
            chi + (alpha + beta)
        });
        let Ellipses { alpha, beta } = motion.ellipses;
        Self {
            equations,
            scratch,
            budget,
            exponentials: [alpha, beta].map(|ellipse| ellipse.exponentials()),
            turning_point_rate: first.larger_or_nan(last),
            launch: LaunchSearch::new(motion),
            span: Interval::HALF_PERIOD,
            end: PathPoint::FIRST,
            pause,
        }
    }

    /// End of the last span.
    pub(super) fn end(&self) -> PathPoint {
        self.end
    }

    /// Returns to the end of an earlier span.
    pub(super) fn return_to(&mut self, end: PathPoint) {
        self.end = end;
    }

    /// Continues the path by a span: expands the motion around its centre, computes the polynomials of a and b, and searches for the launch.
    /// `None` if they are not accurate; the end is then that of the span before.
    pub(super) fn advance(&mut self, span: Interval) -> Option<()> {
        let centre = self.step(span, self.end)?;
        let end = self.step(span, centre)?;
        let PathScratch { expansion, exponential, polynomials, .. } = &mut *self.scratch;
        let least = self.budget.dropped_q62;
        for (index, (polynomial, exponentials)) in polynomials.iter_mut().zip(self.exponentials).enumerate() {
            (self.pause)();
            *polynomial = Polynomial::ZERO;
            let sums = polynomial.parts.each_mut().map(|part| &mut part.coefficients);
            let terms = expansion.add_cayley_klein_series(index, exponentials, least, exponential, sums)?;
            (self.pause)();
            polynomial.drop_negligible_terms(terms, self.budget)?;
        }
        (self.pause)();
        self.launch.search(expansion, end.phases.chi, span);
        (self.span, self.end) = (span, end);
        Some(())
    }

    /// Polynomial of a (index 0) or b (1) on a segment of the last span.
    pub(super) fn polynomial_on(&mut self, segment: Interval, index: usize) -> Option<&mut Polynomial> {
        (self.pause)();
        let PathScratch { polynomials, segment: polynomial, .. } = &mut *self.scratch;
        let halvings = segment.depth - self.span.depth;
        polynomial.restrict(polynomials.get(index)?, segment.number(), halvings);
        Some(polynomial)
    }

    /// Upper bound on the rates of the residual phases on the last span, rad per half period.
    pub(super) fn greatest_residual_rate(&self) -> f32 {
        self.scratch.expansion.greatest_residual_rate() * (2_u32 << self.span.depth) as f32
    }

    /// Expands the motion around a point. Returns the point half a span later; `None` if the truncation error is too large.
    fn step(&mut self, span: Interval, from: PathPoint) -> Option<PathPoint> {
        (self.pause)();
        let half_length = span.half_length();
        // y is in units of two spans
        let unit = 4.0 * half_length;
        let allowed = half_length * self.budget.path_error;
        let (sine, cosine) = f64::sine_cosine(from.phases.chi);
        let PathEquations { equations, duration, .. } = &self.equations;
        let [chi_rate, alpha, beta, residual_alpha, residual_beta] =
            self.equations.rates(sine, cosine).map(|rate| unit * rate);
        (self.pause)();
        let origin = ExpansionPoint {
            phases: from.phases,
            sine,
            cosine,
            time_per_y: unit * duration.to_f64(),
            chi_rate,
            psi_rates: [alpha, beta],
            residual_rates: [residual_alpha, residual_beta],
            rotation_per_chi_error: (unit * self.turning_point_rate / chi_rate.abs()).max(1.0),
            negligible: self.budget.negligible_term(half_length),
        };
        let expansion = &mut self.scratch.expansion;
        expansion.expand(&equations.map(F::to_f64), &origin, self.pause);
        (self.pause)();
        let truncation = expansion.truncation_error();
        (truncation <= allowed).then(|| {
            let error = from.error + truncation + expansion.rounding_error();
            PathPoint { phases: expansion.at(1.0).0, error }
        })
    }

    /// Errors at the end of the path: of χ, as a delay in half periods, and of the residual phases, rad.
    pub(super) fn errors(&self) -> [f64; 2] {
        /// Delay by the roundings of χ at the launch and of the local coordinate, in half periods.
        const ROUNDING_DELAY: f64 = 4.0 * f64::OPERATION_ERROR;
        let PathPoint { phases: PathPhases { chi, residual }, error } = self.end;
        // from an odd number of quarter turns, rad
        let distance = |angle: Phase| {
            let (_, remainder) = (angle + Phase::QUARTER).split_half_turns();
            remainder.min(Phase::HALF - remainder).to_radians()
        };
        // at u = e₂, cos χ = 0 and the cosines of the residual phases are 0
        let [alpha, beta] = residual.map(distance);
        let [chi_rate, ..] = self.equations.rates(1.0, 0.0);
        let delay = ROUNDING_DELAY + error / self.turning_point_rate + distance(chi) / chi_rate;
        [delay, error + alpha.larger_or_nan(beta)]
    }
}
