//! The incremental propagator in fixed point: one table look-up and three Horner sums a tick.
//!
//! The law is autonomous, and its rates depend on χ alone; so what the phases turn by in one tick of fixed length is a
//! function of χ at the start of the tick. Set-up finds these three functions, in f64, from the law's own series, and keeps
//! them as polynomials ([`map`]): a step is the *exact* flow up to their error, for short ticks and long. A Runge-Kutta
//! step would need four sine-cosine pairs and four times the sums, and would miss the flow besides.
//!
//! The flow backwards is the flow forwards seen in a mirror, χ → -χ: the same table does both.

mod flow;
mod map;
mod refusal;

use super::stepper::Stepper;
use super::table::{ErrorBound, Tick};
use crate::cayley_klein::{Bracket, Brackets};
use crate::complex::Complex;
use crate::launch::{Course, Motion, Rates};
use crate::real::{Float, Scalar, angle, high_product, sine_cosine_q31};
use crate::su2::Phi;
use crate::turns::{Rate, Turns};
use fixed::types::I2F30;
use flow::Flow;
use map::{Survey, TickMap, full_scale};
pub use refusal::NoTickMap;

/// Steps a motion forward and back by ticks of fixed length, in integers of 32 bits: no root, no division, and nothing a
/// tick computes can overflow.
///
/// State: the half phase χ and the slow phases A and B, integers of 2^-96 turns. Orientation, unit norm and first integrals
/// are functions of them, so they cannot drift; what adds up from tick to tick is an error *along* the motion, of which
/// [`FixedStepper::error_bound`] says how large it can become.
///
/// `SEGMENTS` (a power of two) polynomials of `TERMS` coefficients cover half a turn of χ: 12 · SEGMENTS · TERMS bytes, 3 KiB
/// as it comes, and some 200 bytes more. More are needed near the separatrix and where A/(ps) is small; [`NoTickMap`] says
/// how many.
///
/// Cost: 3 (TERMS - 1) upper-word products and sums a step, whatever the data: modelled, 208 cycles on a Cortex-M4F and 886
/// on a Cortex-M0+, and 207 and 1274 to read Φ. (A step of [`Stepper`] in `f32` is 2160 on the Cortex-M4F.)
///
/// Error: over three periods below 8e-9 rad, nearly all of it in reading Φ, for ticks of a sixteenth of a period as for a
/// thousandth; after 10⁶ ticks, a thousand periods, mostly below 2e-7 rad (1e-6 where A/(ps) = 1/16).
///
/// Range, step by step: a partial sum is below 2^31 by the scale of the table, its shift is at most 31 bits of 64,
/// phases wrap as turns do, and what is read off is at most 1 in numbers that go to 2.
///
/// ```
/// use toytop::{FixedStepper, Heaviness, Motion, Release, State, Tick, Top};
/// let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81)?;
/// let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
/// let motion = Motion::launch(&top, &State::release(&release)?)?;
/// let mut stepper = <FixedStepper>::new(&motion, Tick::hertz(1000)?)?;
/// for _ in 0..1000 {
///     stepper.step(); // cannot fail
/// }
/// assert!(stepper.phi().u() > 0.8);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedStepper<const SEGMENTS: usize = 32, const TERMS: usize = 8> {
    map: TickMap<SEGMENTS, TERMS>,
    /// χ, A and B.
    phases: [Turns; 3],
    /// α and β.
    ellipses: [Ellipse; 2],
    /// (e₁ + e₂)/2 and (e₂ - e₁)/2.
    middle_and_swing: [i32; 2],
    /// φ less what it is read off from; `None` where φ does not exist.
    phi_origin: Option<Turns>,
    bound: ErrorBound,
}

/// p e^{iχ} + q e^{-iχ}: a Cayley-Klein parameter with its slow phase taken off.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ellipse {
    /// p and q, times 2^31: |p| + |q| <= 1.
    parts: [i32; 2],
    /// +1, -1, or 0 if it passes through 0.
    winding: i32,
}

impl<const SEGMENTS: usize, const TERMS: usize> FixedStepper<SEGMENTS, TERMS> {
    /// At t = 0 of the motion. Cost: 2 · SEGMENTS series of 16 terms in `f64` for ticks that are short against a
    /// segment, up to TERMS + 2 times as many for long ones; next to nothing where u is constant.
    ///
    /// # Errors
    /// [`NoTickMap`]: the motion is aperiodic, the tick too long, or the polynomials too coarse.
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, NoTickMap> {
        let length = tick.length();
        let over_a_tick = |rate: Rate| rate.over(length.hi()) + rate.over(length.lo());
        let [alpha, beta] = motion.phases();
        let brackets = motion.brackets::<f64>();
        let place = |phases, map, per_tick| {
            let mut stepper = Self {
                map,
                phases,
                ellipses: [&brackets.alpha, &brackets.beta].map(Ellipse::of),
                middle_and_swing: middle_and_swing(&brackets, motion.is_steady()),
                phi_origin: None,
                bound: ErrorBound { constant: PHI_ERROR, per_tick },
            };
            let start = Stepper::<f64>::new(motion).tip().angle;
            stepper.phi_origin = start.map(|start| start.phi - stepper.continued_phi());
            stepper
        };
        let chi = match motion.course() {
            Course::Aperiodic(_) => return Err(NoTickMap::Aperiodic),
            Course::Steady(_) => {
                let rates = Rates::of(motion, <f64 as Scalar>::ROUNDING);
                let turns = rates.turns.map(|turns| turns * length);
                let turned: f64 = turns.iter().map(|turns| Float::abs(turns.to_f64())).sum();
                let per_tick = 2.0 * TURN * (Turns::RESOLUTION + rates.relative_error * turned);
                let map = TickMap::constant(turns.map(Turns::of));
                return Ok(place([Turns::ZERO, alpha, beta], map, per_tick));
            }
            Course::Nutating(chi) => chi,
        };
        let flow = Flow::new(motion, length.to_f64());
        let survey = Survey::of(&flow, SEGMENTS, TERMS);
        let drift = over_a_tick(motion.drift().0);
        let shifts = NoTickMap::check(&flow, &survey, drift.to_f64(), [SEGMENTS, TERMS])?;
        let mut map = TickMap::constant([Turns::ZERO; 3]);
        map.put(&flow, survey.means(), shifts, [Turns::ZERO, drift, -drift]);
        let mut errors = shifts.map(|shift| SUM_ERROR * full_scale(shift));
        errors.iter_mut().zip(survey.missed).for_each(|(error, missed)| *error += missed);
        let [chi_error, alpha_error, beta_error] = survey.astray(errors, drift.to_f64());
        let per_tick = chi_error + alpha_error + beta_error;
        Ok(place([chi, alpha, beta], map, per_tick))
    }

    /// How far the orientation can be from the truth of the motion, rad, after so many steps.
    #[must_use]
    pub fn error_bound(&self) -> ErrorBound {
        self.bound
    }

    /// One tick forward.
    #[inline(always)]
    pub fn step(&mut self) {
        let [chi, ..] = self.phases;
        let increments = self.map.increments(chi);
        for (phase, increment) in self.phases.iter_mut().zip(increments) {
            *phase += increment;
        }
    }

    /// One tick back.
    #[inline(always)]
    pub fn step_back(&mut self) {
        let [chi, ..] = self.phases;
        let increments = self.map.increments(-chi);
        for (phase, increment) in self.phases.iter_mut().zip(increments) {
            *phase += -increment;
        }
    }

    /// The orientation Φ: four sine-cosine pairs and eight products. Error: below 1e-8 rad besides that of the phases.
    #[inline(always)]
    #[must_use]
    pub fn phi(&self) -> Phi<I2F30> {
        let [chi, alpha, beta] = self.phases.map(Turns::fraction);
        let [of_alpha, of_beta] = &self.ellipses;
        Phi { alpha: of_alpha.at(chi, alpha), beta: of_beta.at(chi, beta) }
    }

    /// u, the cosine of the tilt: one sine-cosine pair and one product. Error: below 4e-9 besides that of χ.
    #[inline(always)]
    #[must_use]
    pub fn u(&self) -> I2F30 {
        let [chi, ..] = self.phases;
        let [middle, swing] = self.middle_and_swing;
        let (_, cosine) = sine_cosine_q31(leading(chi.fraction() << 1));
        // e₁ and e₂ are in [-1, 1], and so is all between: no more than 2^30 and two roundings
        I2F30::from_bits(middle - high_product(swing, cosine))
    }

    /// The tip in units of s, c/s = 2αβ (2αβ for a fixed tip). Error: below 2.5e-8 besides that of the phases.
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<I2F30> {
        let (_, tip) = self.phi_and_tip();
        tip
    }

    /// Φ and the tip in one evaluation.
    #[inline(always)]
    #[must_use]
    pub fn phi_and_tip(&self) -> (Phi<I2F30>, Complex<I2F30>) {
        let phi = self.phi();
        // |αβ| <= 1/2, so twice as much is far from 2
        let product = phi.alpha * phi.beta;
        (phi, product + product)
    }

    /// The tip angle φ, continued along the motion as that of [`Stepper`]; `None` where the axis is vertical for ever. Error: below
    /// 2.5e-8 rad over |c|/2s, besides that of the phases: near the centre an angle says little.
    ///
    /// Read off from the phases, so it cannot drift away from Φ. One sine-cosine pair, eight products, and 29 rotations by
    /// shifts and sums: some 740 modelled cycles on a Cortex-M4F, 2100 on a Cortex-M0+.
    #[must_use]
    pub fn tip_angle(&self) -> Option<Turns> {
        self.phi_origin.map(|origin| origin + self.continued_phi())
    }

    /// A stepper in `f64` with the same phases, of the motion that this one was made from: for what fixed point does not say
    /// (rates, the rest of a tick), on a host.
    #[must_use]
    pub fn in_f64(&self, motion: &Motion) -> Stepper<f64> {
        Stepper::new(motion).with_phases(self.phases)
    }

    /// arg α + arg β, continued along the motion: ±χ each, and a correction within a quarter turn.
    fn continued_phi(&self) -> Turns {
        let [chi, alpha, beta] = self.phases;
        let (sine, cosine) = sine_cosine_q31(leading(chi.fraction() << 1));
        let [a, b] = self.ellipses.each_ref().map(|ellipse| ellipse.correction(sine, cosine));
        // each part is at most 2^30, so a product is at most 2^28, and the sums 2^29
        let re = high_product(a.re, b.re) - high_product(a.im, b.im);
        let im = high_product(a.re, b.im) + high_product(a.im, b.re);
        let windings = self.ellipses.iter().fold(0, |sum, ellipse| sum + ellipse.winding);
        let correction = Turns::from_bits(i128::from(angle(re, im) as i32) << 64);
        alpha + beta + chi.times(windings.into()) + correction
    }
}

const TURN: f64 = 2.0 * core::f64::consts::PI;

/// Of Φ from given phases, rad.
const PHI_ERROR: f64 = 1e-8;

/// Of a sum, as a share of its full scale: coefficients and products round off at most two units, the place one.
const SUM_ERROR: f64 = 3.0 / (1_u64 << 31) as f64;

/// The upper 32 of 64 bits.
#[inline(always)]
fn leading(phase: u64) -> u32 {
    (phase >> 32) as u32
}

/// x times 2^bits, as near as 32 bits hold it.
fn scaled(x: f64, bits: u32) -> i32 {
    libm::round(x * (1_u64 << bits) as f64) as i32
}

/// In units of 2^-30 and 2^-31.
fn middle_and_swing(brackets: &Brackets<f64>, steady: bool) -> [i32; 2] {
    let [alpha, beta] = [&brackets.alpha, &brackets.beta].map(|bracket| {
        let [p, q] = bracket.exponentials();
        [p + q, p - q].map(|axis| axis * axis)
    });
    let mut ends = alpha;
    ends.iter_mut().zip(beta).for_each(|(end, beta)| *end -= beta);
    let [lower, upper] = if steady { [ends[0]; 2] } else { ends };
    [scaled(0.5 * (lower + upper), 30), scaled(0.5 * (upper - lower), 31)]
}

impl Ellipse {
    fn of(bracket: &Bracket<f64>) -> Self {
        Self { parts: bracket.exponentials().map(|part| scaled(part, 31)), winding: bracket.winding() }
    }

    /// Its value, turned by the slow phase. No overflow: in units of 2^-30 either part is at most |p| + |q| <= 1.
    #[inline(always)]
    fn at(&self, chi: u64, slow: u64) -> Complex<I2F30> {
        let [p, q] = self.parts;
        let (sine, cosine) = sine_cosine_q31(leading(slow.wrapping_add(chi)));
        let (back_sine, back_cosine) = sine_cosine_q31(leading(slow.wrapping_sub(chi)));
        // each product is rounded down: one unit for two
        let sum = |ahead, back| I2F30::from_bits(high_product(p, ahead) + high_product(q, back) + 1);
        Complex::new(sum(cosine, back_cosine), sum(sine, back_sine))
    }

    /// With ±χ taken off its argument: the larger part and the smaller, turned by ∓2χ; 1 where it passes through 0. In units
    /// of 2^-30.
    fn correction(&self, sine: i32, cosine: i32) -> Complex<i32> {
        let [p, q] = self.parts;
        let (larger, smaller, sine) = match self.winding {
            0 => return Complex::new(1 << 30, 0),
            1 => (p, q, sine.saturating_neg()),
            _ => (q, p, sine),
        };
        Complex::new((larger >> 1) + high_product(smaller, cosine), high_product(smaller, sine))
    }
}
