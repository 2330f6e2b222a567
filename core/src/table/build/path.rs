//! Path along half a nutation period, from one expansion of the motion to the next, and the start on it.

use super::{HALF_PERIOD, Limits, MeanRates, OpenCell, Outline, PathPoint, SetUp, Span, Start};
use crate::motion::cayley_klein::Ellipses;
use crate::motion::phase_equations::PhaseRates;
use crate::motion::{Motion, NutationVariable};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar, Wide};
use crate::table::build::series::TERMS;
use crate::table::build::series::expansion::{Expansion, PhasePoint, Slopes, larger_or_nan};

/// Negligible term of the phases at x = 2 over that of α and β at x = 1. It limits the steps of tables with a large allowed error.
const PHASE_TERM: f64 = 32.0;

impl Start {
    /// Start whose place is not found yet; u = e₁ without a nutation.
    fn new(motion: &Motion) -> Self {
        let start = if let NutationVariable::Nutating(chi) = motion.nutation { chi } else { Phase::ZERO };
        let (folded, rest) = start.halves();
        let mirrored = rest > Phase::QUARTER;
        let (folded, chi) = if mirrored { (folded + 1, Phase::HALF - rest) } else { (folded, rest) };
        let [alpha, beta] = motion.phases.map(|phase| phase + Phase::HALF.times(folded));
        Self { chi: Some(chi), mirrored, phases: [Phase::ZERO, alpha, beta], delay: 0.0 }
    }

    /// Finds the place in this span, which ends at χ = `end`, if it is there or the span is the last.
    #[inline(never)]
    pub(super) fn search(&mut self, expansion: &Expansion, end: Phase, span: Span) {
        let Some(chi) = self.chi else { return };
        // a turning point is an end of the half period whatever the errors of the series
        let x = match chi {
            Phase::ZERO => -1.0,
            _ if (chi == Phase::QUARTER || end < chi) && span.end() < HALF_PERIOD => return,
            Phase::QUARTER => 1.0,
            _ => coordinate(expansion, chi),
        };
        let (PhasePoint { theta, .. }, slope) = expansion.at(x);
        let nearest = chi.min(Phase::QUARTER - chi).to_radians();
        let change = if slope > 0.0 { nearest / slope } else { 0.0 };
        let mirror = |phase: Phase| if self.mirrored { -phase } else { phase };
        let ([_, alpha, beta], [alpha_theta, beta_theta]) = (self.phases, theta.map(mirror));
        self.phases = [mirror(span.phase(x)), alpha - alpha_theta, beta - beta_theta];
        (self.chi, self.delay) = (None, change * span.half_length());
    }
}

/// Coordinate x of χ on a span, by Newton's method.
fn coordinate(expansion: &Expansion, chi: Phase) -> f64 {
    const STEPS: usize = 8;
    /// Step of some roundings.
    const LAST_STEP: f64 = 4.0 * f64::ROUNDING;
    let mut x = 0.0_f64;
    for _ in 0..STEPS {
        let (point, slope) = expansion.at(x);
        let miss = (point.chi - chi).to_radians();
        let next = if slope > 0.0 { (x - miss / slope).clamp(-1.0, 1.0) } else { x };
        let change = Float::abs(next - x);
        x = next;
        if change <= LAST_STEP {
            break;
        }
    }
    x
}

impl SetUp {
    /// Computes the equations, the mean rates in numbers of this many words, and the other constants; begins at u = e₁.
    #[inline(never)]
    pub(super) fn begin<const WORDS: usize>(
        &mut self,
        motion: &Motion,
        limits: Limits,
        pause: &mut dyn FnMut(),
    ) {
        self.compute_rates::<WORDS>(motion, pause);
        pause();
        (self.limits, self.start) = (limits, Start::new(motion));
        (self.cell, self.outline) = (OpenCell::NONE, Outline::NONE);
        let Ellipses { alpha, beta } = motion.ellipses::<f64>();
        for (series, ellipse) in self.series.iter_mut().zip([alpha, beta]) {
            series.exponentials = ellipse.exponentials();
        }
        let [alpha, beta] = self.rates.theta_offset.map(Float::to_f64);
        let speed = |rates: &PhaseRates<f64>| {
            Float::abs(rates.nutation) + (Float::abs(rates.slow_a + alpha) + Float::abs(rates.slow_b + beta))
        };
        let equations = self.equations.cast();
        let [begin, end] = [(0.0, 1.0), (1.0, 0.0)].map(|(sine, cosine)| equations.rates(sine, cosine));
        self.fastest = self.rates.half_period.to_f64() * larger_or_nan(speed(&begin), speed(&end));
        self.span = Span::FIRST;
        self.go_to(0, PathPoint::FIRST);
    }

    #[inline(never)] // the deepest stack of set-up, without the constants
    fn compute_rates<const WORDS: usize>(&mut self, motion: &Motion, pause: &mut dyn FnMut()) {
        let mut period = None;
        if !motion.is_steady() {
            self.equations = motion.equations();
            pause();
            period = motion.period::<WORDS>(&self.equations, pause);
        }
        self.rates = MeanRates::new(motion, period);
    }

    /// Begins a span at an earlier point.
    pub(super) fn go_to(&mut self, begin: usize, point: PathPoint) {
        self.span.begin = begin;
        (self.beginning, self.centre) = (point, None);
    }

    /// Goes on to the next span. It is twice as long where its expansion should converge and the series are accurate at
    /// x = 2 or `may_skip_accuracy`.
    pub(super) fn next_span(&mut self, may_skip_accuracy: bool) {
        let next = Span { begin: self.span.end(), ..self.span };
        let twice = Span { depth: self.span.depth - 1, ..next };
        let allowed = self.allowed();
        let accurate = may_skip_accuracy || self.expansion.truncation_error(2) <= allowed;
        let doubles = twice.exists() && self.expansion.may_double() && accurate;
        let x = if doubles { 3 } else { 2 };
        self.centre = self.after(x, f64::from(x) * allowed);
        self.beginning = self.end;
        self.span = if doubles { twice } else { next };
    }

    /// Halves the span one to four times, until the truncation error should be allowed. `None` where it becomes too short.
    pub(super) fn shorten_span(&mut self) -> Option<()> {
        // the last of sixteen terms over half the distance
        const PER_HALVING: f64 = 1.0 / (1_u32 << (TERMS - 1)) as f64;
        let (allowed, mut error) = (self.allowed(), self.expansion.truncation_error(1));
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

    /// Expands the motion around the centre of the span; `None` where a truncation error is too large.
    #[inline(never)]
    pub(super) fn expand_motion<const WORDS: usize>(&mut self, pause: &mut dyn FnMut()) -> Option<()> {
        let allowed = self.allowed();
        if self.centre.is_none() {
            self.expand::<WORDS>(pause);
            self.centre = Some(self.after(1, allowed)?);
        }
        self.expand::<WORDS>(pause);
        self.end = self.after(1, allowed)?;
        Some(())
    }

    /// Allowed truncation error of a step over half a span.
    fn allowed(&self) -> f64 {
        self.limits.steps * self.span.half_length()
    }

    /// Point around which the motion is expanded: the centre, or the beginning where that is not known.
    fn here(&self) -> &PathPoint {
        self.centre.as_ref().unwrap_or(&self.beginning)
    }

    fn expand<const WORDS: usize>(&mut self, pause: &mut dyn FnMut()) {
        pause();
        let slopes = self.slopes::<WORDS>();
        pause();
        self.expansion.expand(&self.equations, &slopes, pause);
        pause();
    }

    /// Derivatives of the phases, in wide numbers because a slow phase may hardly differ from its mean.
    #[inline(never)]
    fn slopes<const WORDS: usize>(&self) -> Slopes {
        // time of y = 1, two spans
        let unit = (1..self.span.depth).fold(self.rates.half_period, |unit, _| unit.halved());
        let point = self.here().phases;
        let (sine, cosine) = point.sine_cosine();
        let rates = self.equations.map(Wide::<WORDS>::resized).rates(sine.into(), cosine.into());
        let [alpha_offset, beta_offset] = self.rates.theta_offset.map(Wide::resized);
        let unit = Wide::resized(unit);
        let slope = |rate: Wide<WORDS>| (unit * rate).to_f64();
        let chi = slope(rates.nutation);
        let weight = 4.0 * self.fastest * self.span.half_length() / Float::abs(chi);
        Slopes {
            point,
            sine,
            cosine,
            unit: unit.to_f64(),
            chi,
            psi: [rates.slow_a, rates.slow_b].map(slope),
            theta: [rates.slow_a + alpha_offset, rates.slow_b + beta_offset].map(slope),
            weight: weight.max(1.0),
            // a term of this size causes an estimated error of a twentieth of it at x = 2, and of two thirds of it at x = 3
            least: (PHASE_TERM * self.limits.least).min(4.0 * self.allowed()),
        }
    }

    /// Point at `x`; `None` where the truncation error is above `allowed`.
    #[inline(never)]
    fn after(&self, x: u32, allowed: f64) -> Option<PathPoint> {
        let truncation_error = self.expansion.truncation_error(x);
        (truncation_error <= allowed).then(|| {
            let PathPoint { truncation, squares: [delays, angles], .. } = self.here();
            let (phases, slope) = self.expansion.at(x.into());
            let [chi, theta] = self.expansion.sizes(x);
            let delay = chi / slope as f32 * self.span.half_length() as f32;
            PathPoint {
                phases,
                truncation: truncation + truncation_error,
                squares: [delays + delay * delay, angles + theta * theta],
            }
        })
    }

    /// Orientation error by the path and the rounding of the start, rad.
    pub(super) fn path_error(&self) -> f64 {
        let speeds = &self.outline.speeds;
        let PathPoint { phases: PhasePoint { chi, theta }, truncation, squares } = self.end;
        // distance from an odd number of quarter turns, rad
        let miss = |angle: Phase| {
            let (_, rest) = (angle + Phase::QUARTER).halves();
            rest.min(Phase::HALF - rest).to_radians()
        };
        // at u = e₂, cos χ = 0 and cos θ = 0
        let [alpha, beta] = theta.map(miss);
        let nutation =
            self.rates.half_period.to_f64() * self.equations.cast::<f64>().rates(1.0, 0.0).nutation;
        let delay = truncation / self.fastest + miss(chi) / nutation;
        speeds.delayed(delay)
            + 2.0 * (truncation + alpha.max(beta))
            + speeds.rounding(squares.map(f64::from), self.start.delay)
    }
}
