//! Constants of the motion of a state, by their definitions in numbers of 512 bits, whose precision makes cancellation harmless. The core
//! computes them by formulas without cancellation.
//!
//! (u - e₁)(u - e₂)(u - e₃) = u³ - E u² - u + E - κ (l - nu)² with κ = 1/(2Apg) and E = (h - n²/2C)/(pg). Newton's method
//! from beyond the roots converges to e₁ and e₃ without passing them.

use super::law::Law;
use super::precise::{Precise, precise, product, root, rounded, to_f64};
use super::states::StateNumbers;

/// Number of 512 bits.
type Precise512 = Precise;

const BITS: usize = 512;
/// Distance below which two roots are equal. A double root is known to twice this number of digits, and no state in `f64` has roots at
/// such a small distance.
const SAME: f64 = 1e-60;
/// Greatest number of Newton steps, which halve the distance to a double root.
const MOST_STEPS: u32 = 4000;

/// Constants of a motion from a state, from which the truth starts.
#[derive(Clone, Debug)]
pub struct Launched {
    pub(super) law: Law,
    pub(super) half_tau: Precise,
    /// Values of cos χ and sin χ.
    pub(super) half_phase: [Precise; 2],
    pub(super) directions: [[Precise; 2]; 2],
}

impl Launched {
    /// Constants of this state.
    #[must_use]
    pub fn new(numbers: &StateNumbers) -> Self {
        let [_, _, _, p, _, _] = numbers.top.map(precise);
        Self::with_mass_moment(numbers, &p)
    }

    /// Constants of this state with another mass moment, which as a product of mass and height need not be an `f64`.
    #[must_use]
    pub fn with_mass_moment(numbers: &StateNumbers, p: &Precise) -> Self {
        let [a, c, s, _, g, k] = numbers.top.map(of_512_bits);
        let p = p.clone().with_precision(BITS).value();
        let one = of_512_bits(1.0);
        let two = of_512_bits(2.0);
        let [alpha, beta] = numbers.phi.map(|[re, im]| [of_512_bits(re), of_512_bits(im)]);
        let omega = numbers.omega.map(of_512_bits);
        let norm = norm_squared(&alpha) + norm_squared(&beta);
        let u = (norm_squared(&alpha) - norm_squared(&beta)) / &norm;
        // r₁ + i r₂ = -2αβ
        let [re, im] = product(&alpha, &beta);
        let r = [-&two * re / &norm, -&two * im / &norm, u.clone()];
        let spin = dot(&omega, &r);
        let l = &a * &omega[2] + ((&c - &a) * &spin + &k) * &u;
        let n = &c * &spin + &k;
        let udot = &omega[0] * &r[1] - &omega[1] * &r[0];
        // the numbers A |ω × r|² + ps u'² and E
        let across = dot(&omega, &omega) - &spin * &spin;
        let torque = to_f64(&(&p * &g)) > 0.0;
        // without torque A² u'² = |m|² (u - e₁)(e₂ - u), which is the law with D = 1, e₃ - u = 1 and g = |m|²/2A²
        let momentum_squared = &a * &a * &across + &n * &n;
        let rests = to_f64(&momentum_squared) == 0.0;
        let [e1, e2, e3] = if torque {
            let energy = &u + (&a * across + &p * &s * &udot * &udot) / (&two * &p * &g);
            let kappa = &one / (&two * &a * &p * &g);
            roots(&energy, &kappa, &l, &n)
        } else if rests {
            [u.clone(), u.clone(), &u + &one]
        } else {
            let middle = &l * &n / &momentum_squared;
            let horizontal = (&momentum_squared - &l * &l) * (&momentum_squared - &n * &n);
            let half = if to_f64(&horizontal) > 0.0 {
                root(&horizontal) / &momentum_squared
            } else {
                of_512_bits(0.0)
            };
            let e2 = &middle + &half;
            [&middle - &half, e2.clone(), e2 + &one]
        };
        let (s, g, a_over_p) = if torque {
            (s, g, &a / &p)
        } else {
            (of_512_bits(0.0), &momentum_squared / (&two * &a * &a), one.clone())
        };

        let gap = |low: &Precise512, high: &Precise512| {
            let gap = high - low;
            if to_f64(&gap) < SAME { of_512_bits(0.0) } else { gap }
        };
        let (one_plus_e1, one_minus_e2) = (gap(&-&one, &e1), gap(&e2, &one));
        let (e2_minus_e1, e3_minus_e2) = (gap(&e1, &e2), gap(&e2, &e3));
        let momentum = |sum: Precise512, vanishes: bool| {
            if vanishes { precise(0.0) } else { rounded(&(sum / (&two * &a))) }
        };
        let vanishing = [&one_plus_e1, &one_minus_e2].map(|gap| to_f64(gap) == 0.0);
        let momenta = [momentum(&l + &n, vanishing[0]), momentum(&l - &n, vanishing[1])];
        let still = to_f64(&e2_minus_e1) == 0.0;
        let half_phase = if still {
            [precise(1.0), precise(0.0)]
        } else {
            let part = |low: &Precise512, high: &Precise512| rounded(&root(&(gap(low, high) / &e2_minus_e1)));
            let (sine, cosine) = (part(&e1, &u), part(&u, &e2));
            [if to_f64(&udot) < 0.0 { -cosine } else { cosine }, sine]
        };
        let law = Law {
            s: rounded(&s),
            g: rounded(&g),
            one_plus_e1: rounded(&one_plus_e1),
            one_minus_e2: rounded(&one_minus_e2),
            e2_minus_e1: rounded(&e2_minus_e1),
            e3_minus_e2: rounded(&e3_minus_e2),
            torque,
            a_over_p: rounded(&a_over_p),
            momenta,
        };
        let half_tau = rounded(&((&spin - &n / &a) / &two));
        Self { law, half_tau, half_phase, directions: directions(&alpha, &beta, &omega) }
    }
}

/// Roots e₁ <= e₂ <= e₃.
fn roots(energy: &Precise512, kappa: &Precise512, l: &Precise512, n: &Precise512) -> [Precise512; 3] {
    let one = of_512_bits(1.0);
    let value_and_slope = |u: &Precise512| {
        let moment = l - n * u;
        let value = (u - energy) * (u * u - &one) - kappa * &moment * &moment;
        let slope = of_512_bits(3.0) * u * u - of_512_bits(2.0) * energy * u - &one
            + of_512_bits(2.0) * kappa * n * &moment;
        (value, slope)
    };
    let newton = |mut u: Precise512| {
        let mut before = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let (value, slope) = value_and_slope(&u);
            if to_f64(&slope) == 0.0 {
                break;
            }
            let step = value / slope;
            let size = to_f64(&step).abs();
            // the steps are monotone until rounding dominates
            if size == 0.0 || (size < 1e-70 && size >= before) {
                break;
            }
            before = size;
            u -= step;
        }
        u
    };
    let sum = energy + kappa * n * n;
    // e₂ from the sum of the roots, of which two are at least -1
    let high = &sum + of_512_bits(2.0);
    let e3 = newton(if to_f64(&high) < 2.0 { of_512_bits(2.0) } else { high });
    let e1 = newton(of_512_bits(-1.0));
    let e2 = &sum - &e1 - &e3;
    [e1, e2, e3]
}

/// Directions α/|α| and β/|β|, or those of the derivative of a parameter that is 0: there 2α' = (ω₂ - iω₁) β̄ and 2β' = -(ω₂ - iω₁) ᾱ.
fn directions(alpha: &[Precise512; 2], beta: &[Precise512; 2], omega: &[Precise512; 3]) -> [[Precise; 2]; 2] {
    let [w1, w2, _] = omega;
    let conjugate = |z: &[Precise512; 2]| [z[0].clone(), -&z[1]];
    let leaves =
        [product(&[w2.clone(), -w1], &conjugate(beta)), product(&[-w2, w1.clone()], &conjugate(alpha))];
    let unit = |z: &[Precise512; 2]| {
        let length = root(&norm_squared(z));
        (to_f64(&length) > 0.0).then(|| z.each_ref().map(|part| rounded(&(part / &length))))
    };
    let [alpha_leaves, beta_leaves] = leaves;
    let direction =
        |z, leaves| unit(z).or_else(|| unit(leaves)).unwrap_or_else(|| [precise(1.0), precise(0.0)]);
    [direction(alpha, &alpha_leaves), direction(beta, &beta_leaves)]
}

fn of_512_bits(x: f64) -> Precise512 {
    // every constructor has refused numbers that are not finite
    Precise512::try_from(x).unwrap_or(Precise512::ZERO).with_precision(BITS).value()
}

fn dot(a: &[Precise512; 3], b: &[Precise512; 3]) -> Precise512 {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn norm_squared([re, im]: &[Precise512; 2]) -> Precise512 {
    re * re + im * im
}

#[cfg(test)]
mod tests;
