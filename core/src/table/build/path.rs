//! Path along half a nutation period, from one expansion of the motion to the next.

use crate::motion::Motion;
use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, Wide};
use crate::table::build::errors::Speeds;
use crate::table::build::mean_rates::MeanRates;
use crate::table::series::expansion::{Expansion, PhasePoint, Polynomial, Slopes, TABLE_UNIT, larger_or_nan};
use crate::table::series::integers::TERMS;

/// Position on the path, with the errors up to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Position {
    pub(crate) point: PhasePoint,
    /// Truncation error of the series, estimated from their last terms.
    pub(crate) remainder: f64,
    /// Sums of the squares of the steps' terms: of χ as delays, in half periods, and of θ, rad.
    pub(crate) squares: [f32; 2],
}

impl Position {
    /// Position u = e₁.
    pub(crate) const BEGINNING: Self = Self { point: PhasePoint::ZERO, remainder: 0.0, squares: [0.0; 2] };
}

/// Negligible term of the phases at x = 2 over that of α and β at x = 1. A term after the sixth is sixty times as large at x = 2.
const PHASE_TERM: f64 = 32.0;

/// Path, with the expansion around its last position.
#[derive(Debug)]
pub(crate) struct Path {
    law: PhaseEquations<Extended>,
    rounded_law: PhaseEquations<f64>,
    /// Derivatives of the phases, in the numbers of the mean rates.
    slopes_of: Option<fn(&Self, Extended) -> Slopes>,
    half_period: Extended,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B', rad per unit time.
    theta_offset: [Extended; 2],
    /// Magnitude below which a term of α or β is negligible at x = 1.
    least: f64,
    expansion: Expansion,
    /// Unit of x in the expansion, in units of half a period.
    part: f64,
    /// Point of the expansion: the centre of a span, or its border.
    here: Position,
    is_at_centre: bool,
    /// Beginning and end of the span.
    border: Position,
    end: Position,
    /// Greatest sum of the rates of χ, θ_A and θ_B at a turning point, rad per half period.
    fastest: f64,
    /// dχ/dt at u = e₂, rad per half period.
    nutation_at_end: f64,
}

impl Path {
    pub(crate) const EMPTY: Self = Self {
        law: PhaseEquations::ZERO,
        rounded_law: PhaseEquations::ZERO,
        slopes_of: None,
        half_period: Extended::ZERO,
        theta_offset: [Extended::ZERO; 2],
        least: 0.0,
        expansion: Expansion::EMPTY,
        part: 0.0,
        here: Position::BEGINNING,
        is_at_centre: false,
        border: Position::BEGINNING,
        end: Position::BEGINNING,
        fastest: 0.0,
        nutation_at_end: 0.0,
    };

    /// Computes the equations of a motion, and its mean rates in numbers of this many words.
    #[inline(never)]
    pub(crate) fn mean_rates<const WORDS: usize>(
        &mut self,
        motion: &Motion,
        between: &mut dyn FnMut(),
    ) -> MeanRates {
        if motion.is_steady() {
            return MeanRates::steady(motion);
        }
        self.slopes_of = Some(Self::slopes::<WORDS>);
        self.law = motion.equations();
        self.rounded_law = self.law.cast();
        between();
        MeanRates::new(motion, motion.period::<WORDS>(&self.law, between))
    }

    /// Begins at u = e₁. Terms of α and β below `least` are negligible.
    #[inline(never)]
    pub(crate) fn begin(&mut self, rates: &MeanRates, least: f64) {
        (self.half_period, self.theta_offset, self.least) = (rates.half_period, rates.theta_offset, least);
        let length = self.half_period.to_f64();
        let [begin, end] =
            [(0.0, 1.0), (1.0, 0.0)].map(|(sine, cosine)| self.rounded_law.rates(sine, cosine));
        self.fastest = length * larger_or_nan(self.speed(&begin), self.speed(&end));
        self.nutation_at_end = length * end.nutation;
        self.go_to(&Position::BEGINNING);
    }

    pub(crate) fn end(&self) -> &Position {
        &self.end
    }

    pub(crate) fn expansion(&self) -> &Expansion {
        &self.expansion
    }

    pub(crate) fn part(&self) -> f64 {
        self.part
    }

    pub(crate) fn fastest(&self) -> f64 {
        self.fastest
    }

    /// Negligible term of α and β in units of 2^-62. What follows two such terms is not larger.
    pub(crate) fn least_term(&self) -> i64 {
        (self.least / TABLE_UNIT) as i64
    }

    /// Expands the motion around the centre of the span, whose half is 2^-`depth` of a half period. Returns whether the truncation errors
    /// at its centre and at its end are at most `share`.
    #[inline(never)]
    pub(crate) fn expand_span(&mut self, depth: u32, share: f64, between: &mut dyn FnMut()) -> bool {
        if !self.is_at_centre {
            self.expand(depth, share, between);
            let Some(centre) = self.after(1, share) else { return false };
            (self.here, self.is_at_centre) = (centre, true);
            between();
        }
        self.expand(depth, share, between);
        let end = self.after(1, share);
        between();
        self.end = end.unwrap_or(self.end);
        end.is_some()
    }

    /// Goes on to the next span, whose centre is at `x` if the error there is at most `share`.
    pub(crate) fn leave(&mut self, x: u32, share: f64) {
        self.border = self.end;
        match self.after(x, share) {
            Some(centre) => (self.here, self.is_at_centre) = (centre, true),
            None => self.return_to_border(),
        }
    }

    /// Returns to the border of the span.
    pub(crate) fn return_to_border(&mut self) {
        (self.here, self.is_at_centre) = (self.border, false);
    }

    /// Position at the beginning of the span.
    pub(crate) fn border(&self) -> &Position {
        &self.border
    }

    /// Begins a span at an earlier position.
    pub(crate) fn go_to(&mut self, position: &Position) {
        self.border = *position;
        self.return_to_border();
    }

    /// Whether the series are accurate at x = 2, so that spans of twice the length may do.
    pub(crate) fn reaches_twice_as_far(&self, share: f64) -> bool {
        self.expansion.truncation_error(2) <= share
    }

    /// Number of halvings of the span, from one to four, after which the truncation error at its end should be at most `share`.
    pub(crate) fn halvings(&self, share: f64) -> u32 {
        // the last of sixteen terms over half the distance
        const PER_HALVING: f64 = 1.0 / (1_u32 << (TERMS - 1)) as f64;
        const MOST: u32 = 4;
        let (mut error, mut halvings) = (PER_HALVING * self.expansion.truncation_error(1), 1);
        while error > share && error < f64::INFINITY && halvings < MOST {
            (error, halvings) = (PER_HALVING * error, halvings + 1);
        }
        halvings
    }

    /// Series of α (`which` = 0) or of β (1), and the number of its terms: see [`Expansion::turned`].
    pub(crate) fn turned(
        &mut self,
        which: usize,
        exponentials: [f64; 2],
        parts: &mut Polynomial,
    ) -> Option<usize> {
        let least = self.least_term();
        self.expansion.turned(which, exponentials, least, parts)
    }

    /// Error at the upper turning point, where cos χ = 0 and cos θ = 0, as an orientation error in rad.
    pub(crate) fn defect(&self, speeds: &Speeds) -> f64 {
        // distance from an odd number of quarter turns, rad
        let miss = |angle: Phase| {
            let (quadrant, rest) = angle.quadrant();
            let rest = Float::abs(rest.to_radians());
            if quadrant & 1 == 1 { rest } else { core::f64::consts::FRAC_PI_2 - rest }
        };
        let PhasePoint { chi, theta } = self.end.point;
        let [alpha, beta] = theta.map(miss);
        speeds.delay(miss(chi) / self.nutation_at_end) + 2.0 * alpha.max(beta)
    }

    /// Expands the motion around the position reached, where x = 1 stands for 2^-`depth` of a half period.
    fn expand(&mut self, depth: u32, share: f64, between: &mut dyn FnMut()) {
        let Some(slopes_of) = self.slopes_of else { return };
        let unit = (0..depth).fold(self.half_period, |unit, _| unit.halved());
        self.part = 1.0 / (1_u64 << depth) as f64;
        let slopes = slopes_of(self, unit);
        between();
        let Self { rounded_law, expansion, here, least, .. } = self;
        // a negligible term causes an estimated error of about a twentieth of it at x = 2, and of two thirds of it at x = 3
        let least = (PHASE_TERM * *least).min(4.0 * share);
        expansion.expand(rounded_law, &here.point, &slopes, unit.to_f64(), least, between);
        between();
    }

    /// Derivatives of the phases. A slow phase may hardly differ from its mean.
    #[inline(never)]
    fn slopes<const WORDS: usize>(&self, unit: Extended) -> Slopes {
        let sine_cosine = self.here.point.sine_cosine();
        let (sine, cosine) = sine_cosine;
        let rates = self.law.map(Wide::<WORDS>::resized).rates(sine.into(), cosine.into());
        let [alpha_offset, beta_offset] = self.theta_offset.map(Wide::resized);
        let unit = Wide::resized(unit);
        let slope = |rate: Wide<WORDS>| (unit * rate).to_f64();
        let weight = self.fastest * self.part / Float::abs(slope(rates.nutation));
        Slopes {
            sine_cosine,
            chi: slope(rates.nutation),
            psi: [rates.alpha, rates.beta].map(slope),
            theta: [rates.alpha + alpha_offset, rates.beta + beta_offset].map(slope),
            weight: if weight > 1.0 { weight } else { 1.0 },
        }
    }

    /// Speed of α and β at these rates of the phases, rad per unit time.
    fn speed(&self, rates: &PhaseRates<f64>) -> f64 {
        let [alpha_offset, beta_offset] = self.theta_offset.map(Float::to_f64);
        let slow = Float::abs(rates.alpha + alpha_offset) + Float::abs(rates.beta + beta_offset);
        Float::abs(rates.nutation) + slow
    }

    /// Position at `x`; `None` where its truncation error exceeds `share`.
    #[inline(never)]
    fn after(&self, x: u32, share: f64) -> Option<Position> {
        let truncation_error = self.expansion.truncation_error(x);
        (truncation_error <= share).then(|| {
            let (point, slope) = self.expansion.at(x.into());
            let [chi, theta] = self.expansion.sizes(x);
            let delay = self.part as f32 * chi / slope as f32;
            let [delays, angles] = self.here.squares;
            Position {
                point,
                remainder: self.here.remainder + truncation_error,
                squares: [delays + delay * delay, angles + theta * theta],
            }
        })
    }
}
