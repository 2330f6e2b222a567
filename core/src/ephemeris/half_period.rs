//! Steps along half a nutation period, from one expansion of the law to the next.

use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::speeds::Speeds;
use crate::law::series::{Expansion, PhasePoint, Slopes, TERMS, larger_or_nan};
use crate::law::{Law, PhaseRates};
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring, Scalar};

/// Position reached by the steps, with the errors so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Position {
    pub(crate) point: PhasePoint,
    /// Truncation error of the series so far, estimated from their last terms.
    pub(crate) remainder: f64,
    /// Sums of the squares of the terms that the steps add up: of χ as delays, in units of half a period, and of θ,
    /// rad.
    pub(crate) squares: [f64; 2],
}

/// Steps through the half period, with the expansion around the last position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPeriod {
    law: Law<Extended>,
    /// Length of the half period.
    length: f64,
    /// Whether the nutation is periodic.
    is_periodic: bool,
    /// Constant rates of θ_A and θ_B besides ψ_A' and ψ_B', rad per unit time.
    theta_offset: [Extended; 2],
    /// Magnitude below which a term of the series is negligible.
    least: f64,
    /// Expansion around the border of a cell or the centre of a segment.
    expansion: Expansion,
    /// Rates at the point of the expansion.
    slopes: Slopes,
    /// Unit of x in the expansion, as a time and in units of half a period.
    unit: f64,
    part: f64,
    current: Position,
    /// Position at the beginning of the cell.
    border: Position,
    /// Sum of the rates of χ, θ_A and θ_B at the turning point where it is greater, rad per unit time; the weight of
    /// an error of χ.
    fastest: f64,
}

impl HalfPeriod {
    /// Half period before [`HalfPeriod::begin`].
    pub(crate) const EMPTY: Self = Self {
        law: Law::ZERO,
        length: 0.0,
        is_periodic: true,
        theta_offset: [Extended::ZERO; 2],
        least: 0.0,
        expansion: Expansion::EMPTY,
        slopes: Slopes::ZERO,
        unit: 0.0,
        part: 0.0,
        current: Position::BEGINNING,
        border: Position::BEGINNING,
        fastest: 0.0,
    };

    /// Begins at u = e₁.
    pub(crate) fn begin(&mut self, motion: &Motion, rates: &MeanRates, least: f64) {
        self.law = motion.law();
        self.length = rates.half_period.to_f64();
        (self.is_periodic, self.theta_offset, self.least) = (rates.is_periodic, rates.theta_offset, least);
        self.fastest = larger_or_nan(self.speed(0.0, 1.0), self.speed(1.0, 0.0));
    }

    pub(crate) fn law(&self) -> &Law<Extended> {
        &self.law
    }

    pub(crate) fn position(&self) -> &Position {
        &self.current
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
        self.slopes = self.slopes(unit);
    }

    /// Begins the expansion of the law around the position reached.
    #[inline(never)] // the frame with the law in f64 must not remain on the stack below the following calls
    pub(crate) fn begin_expansion(&mut self) {
        let Self { law, expansion, current, slopes, unit, least, .. } = self;
        law.cast().begin_expansion(&current.point, slopes, *unit, *least, expansion);
    }

    /// Continues the expansion. Returns whether it is complete.
    pub(crate) fn proceed(&mut self) -> bool {
        self.expansion.proceed()
    }

    /// Derivatives of the phases, in extended precision: a slow phase may turn by thousands of radians and hardly differ
    /// from its mean.
    #[inline(never)]
    fn slopes(&self, unit: Extended) -> Slopes {
        let sine_cosine = self.current.point.sine_cosine();
        let (sine, cosine) = sine_cosine;
        let rates = self.law.rates(sine.into(), cosine.into());
        let [alpha_offset, beta_offset] = self.theta_offset;
        let slope = |rate: Extended| (unit * rate).to_f64();
        let weight = self.fastest * unit.to_f64() / Float::abs(slope(rates.nutation));
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

    /// Speed of α and β at given sin χ and cos χ, rad per unit time.
    #[inline(never)] // the stack frames of set-up must not add up
    fn speed(&self, sine: f64, cosine: f64) -> f64 {
        let rates = self.law.cast().rates(sine, cosine);
        let [alpha_offset, beta_offset] = self.theta_offset.map(Float::to_f64);
        let slow = Float::abs(rates.alpha + alpha_offset) + Float::abs(rates.beta + beta_offset);
        Float::abs(rates.nutation) + slow
    }

    /// Series of α (`which` = 0) or of β (1): see [`Expansion::turned`].
    pub(crate) fn turned(
        &mut self,
        which: usize,
        exponentials: [f64; 2],
        parts: [&mut [i64; TERMS]; 2],
    ) -> Option<()> {
        self.expansion.turned(which, exponentials, self.least, parts)
    }

    /// Moves to x; `None` where the truncation error there exceeds `share`.
    pub(crate) fn to(&mut self, x: i64, share: f64) -> Option<()> {
        self.current = self.after(x, share)?;
        Some(())
    }

    /// Makes x = 1 the border of the next cell; `None` where the truncation error there exceeds `share`.
    pub(crate) fn move_border(&mut self, share: f64) -> Option<()> {
        self.border = self.after(1, share)?;
        Some(())
    }

    /// Moves to the border of the cell.
    pub(crate) fn return_to_border(&mut self) {
        self.current = self.border;
    }

    /// Moves to u = e₁.
    pub(crate) fn restart(&mut self) {
        (self.current, self.border) = (Position::BEGINNING, Position::BEGINNING);
    }

    #[inline(never)]
    fn after(&self, x: i64, share: f64) -> Option<Position> {
        let truncation_error = self.expansion.truncation_error(x);
        (truncation_error <= share).then(|| {
            let [chi, theta] = self.expansion.sizes(x);
            let delay = self.part * chi / self.expansion.chi_slope(x);
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
        let miss = |angle: Phase| Float::abs(f64::sine_cosine(angle).1);
        let PhasePoint { chi, theta } = self.border.point;
        let [alpha, beta] = theta.map(miss);
        let at_the_end = self.law.cast::<f64>().rates(1.0, 0.0).nutation * self.length;
        speeds.delay(miss(chi) / at_the_end) + 2.0 * alpha.max(beta)
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
