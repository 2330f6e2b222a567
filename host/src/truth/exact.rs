//! Motion to more than thirty digits at any time: time and arguments as integrals over the half phase χ.
//!
//! ```text
//! dt/dχ = √(2 D/(g (e₃ - u))),    D = A/p + s (1 - u²),    u = e₁ cos²χ + e₂ sin²χ
//! arg α' = (l + n)/(2A (1 + u)) + τ/2,    arg β' = (l - n)/(2A (1 - u)) - τ/2,    τ = (1/C - 1/A) n
//! ```
//!
//! |α|² = (1 + u)/2 and |β|² = (1 - u)/2; where e₁ = -1 (e₂ = 1) α (β) changes sign instead of turning.

use super::half_period::{HalfPeriod, Integrals};
use super::integrals::{Integrands, TurningPoint};
use super::launch::Launched;
use super::motions::Numbers;
pub use super::precise::PreciseOrientation;
use super::precise::{
    ComplexPrecise, Precise, cis, conjugate, is_zero, precise, product, root, to_f64, to_nearest, whole,
};
use crate::motion::ephemeris::RateSample;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Motion with its integrals from turning point to turning point.
pub struct Exact {
    integrands: Integrands<Precise>,
    coarse: Integrands<f64>,
    half_tau: Precise,
    /// Directions α/|α| and β/|β| at t = 0, or those of the derivative where the parameter is 0.
    directions: [ComplexPrecise; 2],
    /// Half phase at t = 0, and the integrals from χ = 0 to it.
    start: (HalfPhase, Integrals),
    /// Integrals of a motion in which u is not constant.
    half_period: Option<HalfPeriod>,
}

/// Half phase χ = nπ ± y with y in [0, π/2].
struct HalfPhase {
    /// Number n.
    half_turns: i64,
    /// Whether χ = nπ + y.
    rising: bool,
    /// Turning point nearest to y.
    end: TurningPoint,
    /// Sine of the difference of y from it.
    sine: Precise,
}

/// Behaviour of u.
#[derive(PartialEq)]
pub enum MotionKind {
    /// Constant u.
    Steady,
    /// Oscillation of u between e₁ and e₂.
    Nutating,
    /// Convergence of u to 1.
    Aperiodic,
}

impl Exact {
    /// Motion of these numbers.
    pub fn new(numbers: &Numbers) -> Self {
        Self::with_mass_moment(numbers, &precise(numbers.top[3]))
    }

    /// Motion of these numbers with another mass moment, which as a product of mass and height need not be an `f64`.
    pub fn with_mass_moment(numbers: &Numbers, p: &Precise) -> Self {
        Self::with_panels(Launched::new(numbers, p), 0)
    }

    fn with_panels(launched: Launched, finer: usize) -> Self {
        let Launched { integrands, half_tau, half_phase, directions } = launched;
        let (coarse, start) =
            (integrands.map(to_f64), (HalfPhase::new(half_phase), [(); 3].map(|()| whole(0))));
        let mut exact = Self { coarse, integrands, half_tau, directions, start, half_period: None };
        if exact.kind() != MotionKind::Steady {
            let half_period = HalfPeriod::new(&exact.integrands, &exact.coarse, finer);
            exact.start.1 = passed(&half_period, &exact.start.0);
            exact.half_period = Some(half_period);
        }
        exact
    }

    /// Kind of motion, by the branch points of the truth.
    pub fn kind(&self) -> MotionKind {
        let Integrands { one_minus_e2, e2_minus_e1, e3_minus_e2, .. } = &self.integrands;
        let HalfPhase { end, sine, .. } = &self.start.0;
        let upright = *end == TurningPoint::Upper && is_zero(sine) && is_zero(one_minus_e2);
        if is_zero(e2_minus_e1) || (is_zero(e3_minus_e2) && upright) {
            MotionKind::Steady
        } else if is_zero(e3_minus_e2) {
            MotionKind::Aperiodic
        } else {
            MotionKind::Nutating
        }
    }

    /// Nutation period; `None` for a motion that does not nutate.
    pub fn period(&self) -> Option<Precise> {
        self.half_period
            .as_ref()
            .filter(|half_period| half_period.arrives)
            .map(|half_period| &half_period.whole[0] * 2)
    }

    /// Time after the start at which χ has this value, rad; 0 for a steady motion.
    pub fn time_of(&self, half_phase: f64) -> Precise {
        let half_turns = (half_phase / PI).round();
        let angle = half_phase - PI * half_turns;
        let (end, sine) = match angle.abs() {
            y if y <= FRAC_PI_4 => (TurningPoint::Lower, y.sin()),
            y => (TurningPoint::Upper, (FRAC_PI_2 - y).sin()),
        };
        let half_turns = half_turns as i64;
        self.time_of_place(&HalfPhase { half_turns, rising: angle >= 0.0, end, sine: precise(sine) })
    }

    fn time_of_place(&self, place: &HalfPhase) -> Precise {
        self.half_period
            .as_ref()
            .map_or(whole(0), |half_period| &passed(half_period, place)[0] - &self.start.1[0])
    }

    /// Time after the start, in one of the periods, at which Φ without its mean rotation changes fastest; 0 for a motion that does not
    /// nutate.
    pub fn fastest(&self) -> Precise {
        const PER_OCTAVE: u32 = 4;
        let Some(half_period) = &self.half_period else { return whole(0) };
        let [time, alpha, beta] = half_period.whole.each_ref().map(to_f64);
        let mut best = (f64::NEG_INFINITY, TurningPoint::Lower, 0.0);
        for end in [TurningPoint::Lower, TurningPoint::Upper] {
            let Some(depth) = self.coarse.depth(end) else { continue };
            let octaves = (4.0 / depth).log2().clamp(2.0, 60.0) as u32;
            let sines =
                (0..PER_OCTAVE * octaves).map(|i| (-0.5 - f64::from(i) / f64::from(PER_OCTAVE)).exp2());
            for sine in sines.chain([0.0]) {
                let speed = self.coarse.relative_speed_squared(end, sine, [alpha / time, beta / time]);
                if speed > best.0 {
                    best = (speed, end, sine);
                }
            }
        }
        let (_, end, sine) = best;
        self.time_of_place(&HalfPhase { half_turns: 0, rising: true, end, sine: precise(sine) })
    }

    /// Orientation Φ at a time after the start, which is taken as exact.
    pub fn at(&self, t: &Precise) -> PreciseOrientation {
        let (heights, turned, signs) = match &self.half_period {
            None => {
                // u is e₂, both if u is constant and for the upright top
                let heights = self.integrands.heights(TurningPoint::Upper, &whole(0));
                let turned = [0, 1].map(|i| match &self.integrands.momenta[i] {
                    momentum if is_zero(momentum) || is_zero(&heights[i]) => whole(0),
                    momentum => momentum / &heights[i] * t,
                });
                (heights, turned, [1, 1])
            }
            Some(half_period) => {
                let (start, passed) = &self.start;
                let (place, now) = at(half_period, &(&passed[0] + t));
                let turned = [&now[1] - &passed[1], &now[2] - &passed[2]];
                (self.integrands.heights(place.end, &place.sine), turned, self.signs(start, &place))
            }
        };
        let drift = &self.half_tau * t;
        let parameter = |i: usize, angle: Precise| {
            let modulus = root(&(heights[i].clone() >> 1)) * signs[i];
            product(&self.directions[i], &cis(&angle)).map(|part| part * &modulus)
        };
        let [alpha, beta] = turned;
        PreciseOrientation { alpha: parameter(0, alpha + &drift), beta: parameter(1, beta - drift) }
    }

    /// Signs of α and β: -1 for a parameter that has passed through 0 an odd number of times since the start, otherwise 1.
    fn signs(&self, then: &HalfPhase, now: &HalfPhase) -> [i32; 2] {
        let ([cosine, sine], [cosine_then, sine_then]) = (now.signs(), then.signs());
        // the direction of a parameter that is 0 at the start is that of its derivative
        let alpha = if sine_then == 0 { cosine_then } else { sine_then };
        let beta = if cosine_then == 0 { -sine_then } else { cosine_then };
        let change =
            |gap: &Precise, now: i32, then: i32| if is_zero(gap) && now != 0 { now * then } else { 1 };
        [
            change(&self.integrands.one_plus_e1, sine, alpha),
            change(&self.integrands.one_minus_e2, cosine, beta),
        ]
    }

    /// Rates at a time after the start, which is taken as exact, by central differences of Φ, without a formula of the rates.
    ///
    /// * `unit`: a time, such as the period; a shorter one is taken where the body rotates by more than 10^8 rad in it
    pub fn rates(&self, t: &Precise, unit: f64) -> RateSample {
        /// Half the time between the two orientations, as a share of the unit of time. The relative error of the rates is below 1e-20, and
        /// as many digits of the difference remain.
        const SHARE: f64 = 1.0 / (1_u64 << 60) as f64;
        /// Greatest angle in the unit of time, rad.
        const GREATEST_TURN: f64 = 1e8;
        let step = precise(unit) * precise(SHARE);
        let (before, after) = (self.at(&(t - &step)), self.at(&(t + &step)));
        let per_time = |x: Precise| to_f64(&(x / &step));
        let (beta, alpha) = (&before.beta, &before.alpha);
        // the sums Φ₊ Φ₋⁻¹ and Φ₋⁻¹ Φ₊, and twice the change of u
        let sum = |x: ComplexPrecise, y: ComplexPrecise| [&x[0] + &y[0], &x[1] + &y[1]];
        let negative = |[re, im]: &ComplexPrecise| [-re, -im];
        let stretched = product(&after.alpha, &conjugate(alpha));
        let turned = product(&after.beta, &conjugate(beta));
        let fixed = sum(product(&after.beta, alpha), product(&after.alpha, &negative(beta)));
        let body =
            sum(product(&conjugate(alpha), &after.beta), product(&negative(beta), &conjugate(&after.alpha)));
        let axial = [&stretched[1] + &turned[1], &stretched[1] - &turned[1]];
        let vector = |[re, im]: ComplexPrecise, axial: &Precise| {
            [per_time(im), -per_time(re), per_time(axial.clone())]
        };
        let udot = per_time((after.u() - before.u()) >> 1);
        let (omega, omega_body) = (vector(fixed, &axial[0]), vector(body, &axial[1]));
        let rates = RateSample { omega, omega_body, udot };
        // if the two orientations are far apart, the difference gives a speed that is too low, but still above this limit
        let shorter = GREATEST_TURN / rates.speed();
        if shorter < 0.5 * unit { self.rates(t, shorter) } else { rates }
    }
}

/// Integrals from χ = 0 to a place.
fn passed(half_period: &HalfPeriod, place: &HalfPhase) -> Integrals {
    place.with_turns(half_period, half_period.passed(place.end, &place.sine))
}

/// Half phase at a time after χ = 0, and the integrals there.
fn at(half_period: &HalfPeriod, time: &Precise) -> (HalfPhase, Integrals) {
    // times are less than 2^63 ticks, and a period contains many ticks
    let period = &half_period.whole[0] * 2;
    let half_turns = if half_period.arrives { to_nearest(&(time / &period)).unwrap_or(i64::MAX) } else { 0 };
    let late = time - period * half_turns;
    let rising = late >= whole(0);
    let (end, sine, there) = half_period.at(&if rising { late } else { -late });
    let place = HalfPhase { half_turns, rising, end, sine };
    let passed = place.with_turns(half_period, there);
    (place, passed)
}

impl HalfPhase {
    /// Half phase with this cos χ and sin χ.
    fn new([cosine, sine]: [Precise; 2]) -> Self {
        let zero = whole(0);
        let half_turns = match (cosine < zero, sine < zero) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => -1,
        };
        let rising = (cosine < zero) == (sine < zero);
        let size = |x: Precise| if x < zero { -x } else { x };
        let (cosine, sine) = (size(cosine), size(sine));
        let (end, sine) =
            if sine <= cosine { (TurningPoint::Lower, sine) } else { (TurningPoint::Upper, cosine) };
        Self { half_turns, rising, end, sine }
    }

    /// Integrals from χ = 0, from those of y.
    fn with_turns(&self, half_period: &HalfPeriod, there: Integrals) -> Integrals {
        let sense = if self.rising { 1 } else { -1 };
        [0, 1, 2].map(|i| &half_period.whole[i] * 2 * self.half_turns + &there[i] * sense)
    }

    /// Signs of cos χ and sin χ.
    fn signs(&self) -> [i32; 2] {
        let sense = if self.half_turns % 2 == 0 { 1 } else { -1 };
        let sign = if self.rising { sense } else { -sense };
        match (self.end, is_zero(&self.sine)) {
            (TurningPoint::Lower, true) => [sense, 0],
            (TurningPoint::Upper, true) => [0, sign],
            _ => [sense, sign],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::random::Random;
    use crate::truth::tests::numbers;

    /// With other panels only the error of the quadrature changes; at tick 2^62 it is still below 1e-15 rad.
    #[test]
    fn other_panels_the_same_truth() {
        let mut worst = 0.0_f64;
        for stream in 0..60 {
            let numbers = numbers(&mut Random::new(7, stream));
            let exact = Exact::new(&numbers);
            if exact.kind() != MotionKind::Nutating {
                continue;
            }
            let finer = Exact::with_panels(Launched::new(&numbers, &precise(numbers.top[3])), 1);
            let [Some(half_period), Some(finer)] = [&exact.half_period, &finer.half_period] else {
                panic!("both nutate")
            };
            for (i, (a, b)) in half_period.whole.iter().zip(&finer.whole).enumerate() {
                let size = if i == 0 { to_f64(a) } else { 1.0 + to_f64(a).abs() };
                worst = worst.max(to_f64(&(a - b)).abs() / size);
            }
        }
        assert!(worst < 1e-35 && worst > 0.0, "{worst:e}");
    }

    /// The time of the place at a time is this time, also at large times.
    #[test]
    fn a_place_and_its_time() {
        let mut worst = 0.0_f64;
        for stream in 0..60 {
            let mut random = Random::new(8, stream);
            let exact = Exact::new(&numbers(&mut random));
            let (Some(period), Some(half_period)) = (exact.period(), &exact.half_period) else { continue };
            for time in [random.share(), -random.share(), 1e15 * random.share()] {
                let time = &period * precise(time);
                let (place, [t, alpha, _]) = at(half_period, &time);
                let [back, alpha_back, _] = passed(half_period, &place);
                worst = worst.max(to_f64(&((&back - &time) / &period)).abs());
                assert!(to_f64(&((t - time) / &period)).abs() < 1e-40);
                assert!(to_f64(&(alpha - alpha_back)).abs() < 1e-20);
            }
        }
        assert!(worst < 1e-20, "{worst:e}");
    }
}
