//! The constants of the motion of a state, by their definitions in numbers of 512 bits, where no cancellation matters: the
//! core finds them in double-double by rearranging the formulas so that nothing cancels.
//!
//! (u - e₁)(u - e₂)(u - e₃) = u³ - E u² - u + E - κ (l - nu)² with κ = 1/(2Apg) and E = (h - n²/2C)/(pg). Newton's method
//! from beyond the roots tends to e₁ and e₃ without ever passing them.

use super::states::StateNumbers;
use dashu_float::round::mode::HalfEven;
use toytop::Complex;
use toytop::real::{DoubleDouble, Ring};

/// A number of 512 bits.
type Wide = dashu_float::FBig<HalfEven>;

const BITS: usize = 512;
/// Roots that are closer are one: twice the digits that are left of a double root, and no state in `f64` comes near it.
const SAME: f64 = 1e-60;
/// A double root is approached by halves.
const MOST_STEPS: u32 = 4000;

/// What of a state the truth starts from.
#[derive(Clone, Copy, Debug)]
pub struct Launched {
    pub(super) s: DoubleDouble,
    pub(super) g: DoubleDouble,
    pub(super) a_over_p: DoubleDouble,
    pub(super) one_plus_e1: DoubleDouble,
    pub(super) one_minus_e2: DoubleDouble,
    pub(super) e2_minus_e1: DoubleDouble,
    pub(super) e3_minus_e2: DoubleDouble,
    /// (l ± n)/(2A).
    pub(super) momenta: [DoubleDouble; 2],
    pub(super) half_tau: DoubleDouble,
    /// cos χ + i sin χ.
    pub(super) half_phase: Complex<DoubleDouble>,
    pub(super) directions: [Complex<DoubleDouble>; 2],
}

impl Launched {
    /// The constants of this state.
    #[must_use]
    pub fn new(numbers: &StateNumbers) -> Self {
        let [a, c, s, p, g] = numbers.top.map(wide);
        let one = wide(1.0);
        let two = wide(2.0);
        let [alpha, beta] = numbers.phi.map(|[re, im]| [wide(re), wide(im)]);
        let omega = numbers.omega.map(wide);
        let norm = norm_squared(&alpha) + norm_squared(&beta);
        let u = (norm_squared(&alpha) - norm_squared(&beta)) / &norm;
        // r₁ + i r₂ = -2αβ
        let [re, im] = product(&alpha, &beta);
        let r = [-&two * re / &norm, -&two * im / &norm, u.clone()];
        let spin = dot(&omega, &r);
        let l = &a * &omega[2] + (&c - &a) * &spin * &u;
        let n = &c * &spin;
        let udot = &omega[0] * &r[1] - &omega[1] * &r[0];
        // A |ω × r|² + ps u'², and E
        let across = dot(&omega, &omega) - &spin * &spin;
        let energy = &u + (&a * across + &p * &s * &udot * &udot) / (&two * &p * &g);
        let kappa = &one / (&two * &a * &p * &g);
        let [e1, e2, e3] = roots(&energy, &kappa, &l, &n);

        let gap = |low: &Wide, high: &Wide| {
            let gap = high - low;
            if to_f64(&gap) < SAME { wide(0.0) } else { gap }
        };
        let (one_plus_e1, one_minus_e2) = (gap(&-&one, &e1), gap(&e2, &one));
        let (e2_minus_e1, e3_minus_e2) = (gap(&e1, &e2), gap(&e2, &e3));
        let momentum = |sum: Wide, vanishes: bool| {
            if vanishes { DoubleDouble::ZERO } else { narrow(&(sum / (&two * &a))) }
        };
        let vanishing = [&one_plus_e1, &one_minus_e2].map(|gap| to_f64(gap) == 0.0);
        let momenta = [momentum(&l + &n, vanishing[0]), momentum(&l - &n, vanishing[1])];
        let still = to_f64(&e2_minus_e1) == 0.0;
        let half_phase = if still {
            Complex::ONE
        } else {
            let part = |low: &Wide, high: &Wide| narrow(&root(&(gap(low, high) / &e2_minus_e1)));
            let (sine, cosine) = (part(&e1, &u), part(&u, &e2));
            Complex::new(if to_f64(&udot) < 0.0 { -cosine } else { cosine }, sine)
        };
        Self {
            s: narrow(&s),
            g: narrow(&g),
            a_over_p: narrow(&(&a / &p)),
            one_plus_e1: narrow(&one_plus_e1),
            one_minus_e2: narrow(&one_minus_e2),
            e2_minus_e1: narrow(&e2_minus_e1),
            e3_minus_e2: narrow(&e3_minus_e2),
            momenta,
            half_tau: narrow(&((&one / &c - &one / &a) * &n / &two)),
            half_phase,
            directions: directions(&alpha, &beta, &omega),
        }
    }
}

/// e₁ <= e₂ <= e₃.
fn roots(energy: &Wide, kappa: &Wide, l: &Wide, n: &Wide) -> [Wide; 3] {
    let one = wide(1.0);
    let value_and_slope = |u: &Wide| {
        let moment = l - n * u;
        let value = (u - energy) * (u * u - &one) - kappa * &moment * &moment;
        let slope = wide(3.0) * u * u - wide(2.0) * energy * u - &one + wide(2.0) * kappa * n * &moment;
        (value, slope)
    };
    let newton = |mut u: Wide| {
        let mut before = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let (value, slope) = value_and_slope(&u);
            if to_f64(&slope) == 0.0 {
                break;
            }
            let step = value / slope;
            let size = to_f64(&step).abs();
            // monotone until rounding takes over
            if size == 0.0 || (size < 1e-70 && size >= before) {
                break;
            }
            before = size;
            u -= step;
        }
        u
    };
    let sum = energy + kappa * n * n;
    // the sum of the roots, and two of them at least -1
    let high = &sum + wide(2.0);
    let e3 = newton(if to_f64(&high) < 2.0 { wide(2.0) } else { high });
    let e1 = newton(wide(-1.0));
    let e2 = &sum - &e1 - &e3;
    [e1, e2, e3]
}

/// α/|α| and β/|β|; where one is 0, of its derivative: there 2α' = (ω₂ - iω₁) β̄ and 2β' = -(ω₂ - iω₁) ᾱ.
fn directions(alpha: &[Wide; 2], beta: &[Wide; 2], omega: &[Wide; 3]) -> [Complex<DoubleDouble>; 2] {
    let [w1, w2, _] = omega;
    let conjugate = |z: &[Wide; 2]| [z[0].clone(), -&z[1]];
    let leaves =
        [product(&[w2.clone(), -w1], &conjugate(beta)), product(&[-w2, w1.clone()], &conjugate(alpha))];
    let unit = |z: &[Wide; 2]| {
        let length = root(&norm_squared(z));
        (to_f64(&length) > 0.0).then(|| Complex::new(narrow(&(&z[0] / &length)), narrow(&(&z[1] / &length))))
    };
    let [alpha_leaves, beta_leaves] = leaves;
    let direction = |z, leaves| unit(z).or_else(|| unit(leaves)).unwrap_or(Complex::ONE);
    [direction(alpha, &alpha_leaves), direction(beta, &beta_leaves)]
}

fn wide(x: f64) -> Wide {
    // a number that is not finite is refused by every constructor before it gets here
    Wide::try_from(x).unwrap_or(Wide::ZERO).with_precision(BITS).value()
}

fn to_f64(x: &Wide) -> f64 {
    x.to_f64().value()
}

/// To 32 digits.
fn narrow(x: &Wide) -> DoubleDouble {
    let high = to_f64(x);
    DoubleDouble::new(high, to_f64(&(x - wide(high))))
}

/// The square root of a number that is not negative.
fn root(x: &Wide) -> Wide {
    if to_f64(x) > 0.0 { x.sqrt() } else { wide(0.0) }
}

fn dot(a: &[Wide; 3], b: &[Wide; 3]) -> Wide {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn norm_squared([re, im]: &[Wide; 2]) -> Wide {
    re * re + im * im
}

fn product(a: &[Wide; 2], b: &[Wide; 2]) -> [Wide; 2] {
    [&a[0] * &b[0] - &a[1] * &b[1], &a[0] * &b[1] + &a[1] * &b[0]]
}

#[cfg(test)]
mod tests;
