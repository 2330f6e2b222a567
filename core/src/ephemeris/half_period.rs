//! Steps along half a nutation period, from one expansion of the law to the next.

use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::speeds::Speeds;
use crate::law::series::{Expansion, PhasePoint, Slopes, TERMS, UNIT, larger_or_nan};
use crate::law::{Law, PhaseRates};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, RateNumber, Ring};

/// Position reached by the steps, with the errors so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Position {
    pub(crate) point: PhasePoint,
    /// Truncation error of the series so far, estimated from their last terms.
    pub(crate) remainder: f64,
    /// Sums of the squares of the terms that the steps add up: of χ as delays, in units of half a period, and of θ,
    /// rad.
    pub(crate) squares: [f32; 2],
}

/// Negligible term of the phases at x = 2 over that of α and β at x = 1. A term after the sixth is sixty times as large at
/// x = 2, and what the series of the phases omit counts as a truncation error of the steps.
const PHASE_TERM: f64 = 32.0;

/// Steps through the half period, with the expansion around the last position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPeriod {
    law: Law<Extended>,
    rounded_law: Law<f64>,
    /// Length of the half period.
    length: f64,
    /// Whether the nutation is periodic.
    is_periodic: bool,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B', rad per unit time.
    theta_offset: [Extended; 2],
    /// Derivatives of the phases at the position reached, for an expansion whose unit of x is a time. They are computed in the numbers of
    /// the mean rates, and called by a pointer, so that the rest is compiled once for all scalars.
    slopes_of: fn(&Self, Extended) -> Slopes,
    /// Magnitude below which a term of the series of the phases is negligible at x = 2.
    least: f64,
    /// Magnitude below which a term of the series of α and β is negligible at x = 1, in their units.
    least_units: i64,
    /// Expansion around the border or the centre of a span.
    expansion: Expansion,
    /// Rates at the point of the expansion.
    slopes: Slopes,
    /// Unit of x in the expansion, as a time and in units of half a period.
    unit: f64,
    part: f64,
    current: Position,
    /// Positions at the beginning and at the end of the span.
    border: Position,
    end: Position,
    /// Position at the beginning of a cell: see [`HalfPeriod::mark`].
    marked: Position,
    /// Sum of the rates of χ, θ_A and θ_B at the turning point where it is greater, rad per unit time; the weight of
    /// an error of χ.
    fastest: f64,
    /// dχ/dt at u = e₂, rad per unit time.
    nutation_at_end: f64,
}

impl HalfPeriod {
    /// Half period before [`HalfPeriod::find_law`].
    pub(crate) const EMPTY: Self = Self {
        law: Law::ZERO,
        rounded_law: Law::ZERO,
        length: 0.0,
        is_periodic: true,
        theta_offset: [Extended::ZERO; 2],
        slopes_of: |_, _| Slopes::ZERO,
        least: 0.0,
        least_units: 0,
        expansion: Expansion::EMPTY,
        slopes: Slopes::ZERO,
        unit: 0.0,
        part: 0.0,
        current: Position::BEGINNING,
        border: Position::BEGINNING,
        end: Position::BEGINNING,
        marked: Position::BEGINNING,
        fastest: 0.0,
        nutation_at_end: 0.0,
    };

    /// Computes the law of a motion in the numbers of the mean rates, before [`HalfPeriod::begin`].
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn find_law<N: RateNumber>(&mut self, motion: &Motion) {
        self.slopes_of = Self::slopes::<N>;
        self.law = motion.law::<N>().map(N::into);
    }

    /// Begins at u = e₁. Terms of α and β below `least` are negligible.
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn begin(&mut self, rates: &MeanRates, least: f64) {
        self.rounded_law = self.law.cast();
        self.length = rates.half_period.to_f64();
        (self.is_periodic, self.theta_offset) = (rates.is_periodic, rates.theta_offset);
        (self.least, self.least_units) = (PHASE_TERM * least, (least / UNIT) as i64);
        let [begin, end] =
            [(0.0, 1.0), (1.0, 0.0)].map(|(sine, cosine)| self.rounded_law.rates(sine, cosine));
        self.fastest = larger_or_nan(self.speed(&begin), self.speed(&end));
        self.nutation_at_end = end.nutation;
    }

    pub(crate) fn law(&self) -> &Law<Extended> {
        &self.law
    }

    /// Position at the end of the last span.
    pub(crate) fn end(&self) -> &Position {
        &self.end
    }

    pub(crate) fn expansion(&self) -> &Expansion {
        &self.expansion
    }

    /// Unit of x in the expansion, in units of half a period.
    pub(crate) fn part(&self) -> f64 {
        self.part
    }

    /// Greatest sum of the rates of χ, θ_A and θ_B at a turning point, rad per half period.
    pub(crate) fn fastest_per_half_period(&self) -> f64 {
        self.fastest * self.length
    }

    /// Computes the rates at the position reached, for an expansion around it whose unit of x is a time `unit`.
    pub(crate) fn prepare(&mut self, unit: Extended) {
        self.unit = unit.to_f64();
        self.part = self.unit / self.length;
        self.slopes = (self.slopes_of)(self, unit);
    }

    /// Begins the expansion of the law around the position reached, for steps whose truncation error may be `share`.
    pub(crate) fn begin_expansion(&mut self, share: f64) {
        let Self { rounded_law, expansion, current, slopes, unit, least, .. } = self;
        // a negligible term causes an estimated error of about a twentieth of it at x = 2, and of two thirds of it at x = 3
        let least = least.min(4.0 * share);
        rounded_law.begin_expansion(&current.point, slopes, *unit, least, expansion);
    }

    /// Continues the expansion. Returns whether it is complete.
    pub(crate) fn proceed(&mut self) -> bool {
        self.expansion.proceed()
    }

    /// Magnitude below which a term of the series of α and β is negligible, in units of 2^-62. What follows two such terms is not larger.
    pub(crate) fn least_term(&self) -> f32 {
        self.least_units as f32
    }

    /// Derivatives of the phases, in the numbers of the mean rates: a slow phase may turn by thousands of radians and hardly differ
    /// from its mean.
    #[inline(never)]
    fn slopes<N: RateNumber>(&self, unit: Extended) -> Slopes {
        let sine_cosine = self.current.point.sine_cosine();
        let (sine, cosine) = sine_cosine;
        let rates = self.law.map(N::from).rates(N::from_f64(sine), N::from_f64(cosine));
        let [alpha_offset, beta_offset] = self.theta_offset.map(N::from);
        let unit = N::from(unit);
        let slope = |rate: N| (unit * rate).to_f64();
        let weight = self.fastest * self.unit / Float::abs(slope(rates.nutation));
        Slopes {
            sine_cosine,
            psi: PhaseRates {
                nutation: slope(rates.nutation),
                alpha: slope(rates.alpha),
                beta: slope(rates.beta),
            },
            theta: [slope(rates.alpha + alpha_offset), slope(rates.beta + beta_offset)],
            weight: if weight > 1.0 { weight } else { 1.0 },
        }
    }

    /// Speed of α and β at these rates of the phases, rad per unit time.
    fn speed(&self, rates: &PhaseRates<f64>) -> f64 {
        let [alpha_offset, beta_offset] = self.theta_offset.map(Float::to_f64);
        let slow = Float::abs(rates.alpha + alpha_offset) + Float::abs(rates.beta + beta_offset);
        Float::abs(rates.nutation) + slow
    }

    /// Series of α (`which` = 0) or of β (1), and the number of its terms: see [`Expansion::turned`].
    pub(crate) fn turned(
        &mut self,
        which: usize,
        exponentials: [f64; 2],
        parts: [&mut [i64; TERMS]; 2],
    ) -> Option<usize> {
        self.expansion.turned(which, exponentials, self.least_units, parts)
    }

    /// Steps from the border to the centre; `None` where the truncation error there exceeds `share`.
    pub(crate) fn step_to_centre(&mut self, share: f64) -> Option<()> {
        self.current = self.after(1, share)?;
        Some(())
    }

    /// Computes the end of the span from its centre; `None` where the truncation error there exceeds `share`.
    pub(crate) fn reach_end(&mut self, share: f64) -> Option<()> {
        self.end = self.after(1, share)?;
        Some(())
    }

    /// Half phase χ at the end of the span.
    pub(crate) fn end_chi(&self) -> Phase {
        self.end.point.chi
    }

    /// Whether the series are accurate at x = 2, so that spans of twice the length may do.
    pub(crate) fn reaches_twice_as_far(&self, share: f64) -> bool {
        self.expansion.truncation_error(2) <= share
    }

    /// Number of halvings of the span, from one to four, after which the truncation error at its end should be at most `share`;
    /// one where the series do not converge.
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

    /// Goes on to the next span, whose centre is at `x`, or to its border where the truncation error at the centre would exceed
    /// `share`. Returns whether the position is the centre.
    pub(crate) fn leave(&mut self, x: i32, share: f64) -> bool {
        self.border = self.end;
        let centre = self.after(x, share);
        self.current = centre.unwrap_or(self.border);
        centre.is_some()
    }

    /// Returns to the border of the span.
    pub(crate) fn return_to_border(&mut self) {
        self.current = self.border;
    }

    /// Marks the border of the span, where a cell begins.
    pub(crate) fn mark(&mut self) {
        self.marked = self.border;
    }

    /// Returns to the position marked.
    pub(crate) fn return_to_mark(&mut self) {
        (self.current, self.border) = (self.marked, self.marked);
    }

    /// Moves to u = e₁.
    pub(crate) fn restart(&mut self) {
        (self.current, self.border, self.marked) =
            (Position::BEGINNING, Position::BEGINNING, Position::BEGINNING);
    }

    #[inline(never)]
    fn after(&self, x: i32, share: f64) -> Option<Position> {
        let truncation_error = self.expansion.truncation_error(x);
        (truncation_error <= share).then(|| {
            let [chi, theta] = self.expansion.sizes(x);
            let delay = self.part as f32 * chi;
            let [delays, angles] = self.current.squares;
            Position {
                point: self.expansion.point(x),
                remainder: self.current.remainder + truncation_error,
                squares: [delays + delay * delay, angles + theta * theta],
            }
        })
    }

    /// Error at the upper turning point, as an orientation error in rad; 0 for an aperiodic motion. There cos χ = 0, and
    /// α and β without their mean rotation are real, so cos θ = 0. An error of χ is a delay, which is multiplied by the
    /// greatest speed.
    pub(crate) fn defect(&self, speeds: &Speeds) -> f64 {
        if !self.is_periodic {
            return 0.0;
        }
        // distance from an odd number of quarter turns, rad
        let miss = |angle: Phase| {
            let (quadrant, rest) = angle.quadrant();
            let rest = Float::abs(rest.to_radians());
            if quadrant & 1 == 1 { rest } else { core::f64::consts::FRAC_PI_2 - rest }
        };
        let PhasePoint { chi, theta } = self.end.point;
        let [alpha, beta] = theta.map(miss);
        speeds.delay(miss(chi) / (self.nutation_at_end * self.length)) + 2.0 * alpha.max(beta)
    }
}

impl Position {
    /// Position u = e₁.
    const BEGINNING: Self = Self {
        point: PhasePoint { chi: Phase::ZERO, theta: [Phase::ZERO; 2] },
        remainder: 0.0,
        squares: [0.0; 2],
    };
}
