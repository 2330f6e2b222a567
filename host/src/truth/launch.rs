//! Constants of a motion: from its branch points, or from a state.
//!
//! Those of a state follow from their definitions in numbers of 512 bits, whose precision makes cancellation harmless. The core computes
//! them by formulas without cancellation.
//!
//! (u - e₁)(u - e₂)(u - e₃) = u³ - E u² - u + E - κ (l - nu)² with κ = 1/(2Apg) and E = (h - n²/2C)/(pg). Newton's method
//! from beyond the roots converges to e₁ and e₃ without passing them.

use super::integrals::Integrands;
use super::motions::{Numbers, Start};
use super::precise::{
    ComplexPrecise, Precise, cis, conjugate, is_zero, precise, product, root, rounded, to_f64, whole,
};
use std::f64::consts::PI;
use toytop::{InitialPhases, Sign, Signs};

/// Constants of a motion, from which the truth starts.
pub struct Launched {
    pub integrands: Integrands<Precise>,
    pub half_tau: Precise,
    /// Values of cos χ and sin χ at t = 0.
    pub half_phase: [Precise; 2],
    pub directions: [ComplexPrecise; 2],
}

impl Launched {
    /// Constants of these numbers with another mass moment, which as a product of mass and height need not be an `f64`.
    pub fn new(numbers: &Numbers, p: &Precise) -> Self {
        match numbers.start {
            Start::BranchPoints { e, signs, phases } => {
                Self::from_branch_points(numbers.top, p, e, signs, phases)
            }
            Start::State { phi, omega } => Self::from_state(numbers.top, p, phi, omega),
        }
    }

    fn from_state(top: [f64; 6], p: &Precise, phi: [[f64; 2]; 2], omega: [f64; 3]) -> Self {
        let [a, c, s, _, g, k] = top.map(of_512_bits);
        let p = p.clone().with_precision(BITS).value();
        let [alpha, beta] = phi.map(|z| z.map(of_512_bits));
        let omega = omega.map(of_512_bits);
        let norm = norm_squared(&alpha) + norm_squared(&beta);
        let u = (norm_squared(&alpha) - norm_squared(&beta)) / &norm;
        // r₁ + i r₂ = -2αβ
        let [r1, r2] = product(&alpha, &beta).map(|part| -part * 2 / &norm);
        let spin: Precise = &omega[0] * &r1 + &omega[1] * &r2 + &omega[2] * &u;
        let n = &c * &spin + &k;
        let l = &a * &omega[2] + (&n - &a * &spin) * &u;
        let udot: Precise = &omega[0] * &r2 - &omega[1] * &r1;
        // |ω × r|²
        let across = norm_squared(&[omega[0].clone(), omega[1].clone()]) + omega[2].sqr() - spin.sqr();
        let momentum_squared = a.sqr() * &across + n.sqr();
        let torque = !is_zero(&(&p * &g));
        let [e1, e2, e3] = if torque {
            let weight = &p * &g * 2;
            let energy = &u + (&a * across + &p * &s * udot.sqr()) / &weight;
            roots(&energy, &(of_512_bits(1.0) / (&a * weight)), &l, &n)
        } else if is_zero(&momentum_squared) {
            [u.clone(), u.clone(), &u + 1]
        } else {
            let middle = &l * &n / &momentum_squared;
            let horizontal = (&momentum_squared - l.sqr()) * (&momentum_squared - n.sqr());
            let half = root(&horizontal) / &momentum_squared;
            let e2 = &middle + &half;
            [middle - half, e2.clone(), e2 + 1]
        };
        // without torque A² u'² = |m|² (u - e₁)(e₂ - u), which are the integrands with D = 1, e₃ - u = 1 and g = |m|²/2A²
        let [s, g, a_over_p] =
            if torque { [s, g, &a / p] } else { [whole(0), momentum_squared / (a.sqr() * 2), whole(1)] };
        let [one_plus_e1, one_minus_e2] = [&e1 + 1, -&e2 + 1].map(gap);
        let [e2_minus_e1, e3_minus_e2] = [&e2 - &e1, e3 - &e2].map(gap);
        let momentum = |sum: Precise, gap: &Precise| if is_zero(gap) { whole(0) } else { sum / (&a * 2) };
        let momenta = [momentum(&l + &n, &one_plus_e1), momentum(l - &n, &one_minus_e2)];
        let half_phase = if is_zero(&e2_minus_e1) {
            [whole(1), whole(0)]
        } else {
            let [cosine, sine] = [e2 - &u, u - e1].map(|part| root(&(gap(part) / &e2_minus_e1)));
            match (udot < whole(0), is_zero(&e3_minus_e2)) {
                (false, _) => [cosine, sine],
                (true, false) => [-cosine, sine],
                // an aperiodic motion that falls begins at χ = -π/2, not at π/2
                (true, true) => [cosine, -sine],
            }
        };
        let integrands = Integrands {
            s,
            g,
            a_over_p,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1,
            e3_minus_e2,
            torque,
            momenta,
        };
        let half_tau = rounded(&((spin - n / a) / whole(2)));
        let directions = directions(&alpha, &beta, &omega);
        Self {
            integrands: integrands.map(rounded),
            half_tau,
            half_phase: half_phase.map(|x| rounded(&x)),
            directions,
        }
    }

    fn from_branch_points(
        top: [f64; 6],
        p: &Precise,
        e: [f64; 3],
        signs: Signs,
        phases: InitialPhases,
    ) -> Self {
        let ([e1, e2, e3], [a, c, s, _, g, k]) = (e.map(precise), top.map(precise));
        let (one_plus_e1, one_minus_e2) = (&e1 + 1, -&e2 + 1);
        let weight = &a * p * &g * 2;
        let plus = &weight * &one_plus_e1 * (&e2 + 1) * (&e3 + 1);
        let minus = weight * (-&e1 + 1) * &one_minus_e2 * (&e3 - 1);
        let signed = |sign, square: &Precise| root(square) * if sign == Sign::Plus { 1 } else { -1 };
        let [l_plus_n, l_minus_n] = [signed(signs.l_plus_n, &plus), signed(signs.l_minus_n, &minus)];
        let n = (&l_plus_n - &l_minus_n) / whole(2);
        let spin = if is_zero(&c) { whole(0) } else { (&n - k) / c };
        let half_tau = (spin - n / &a) / whole(2);
        let integrands = Integrands {
            s,
            g,
            a_over_p: &a / p,
            one_plus_e1,
            one_minus_e2,
            e2_minus_e1: &e2 - e1,
            e3_minus_e2: e3 - e2,
            torque: true,
            momenta: [l_plus_n, l_minus_n].map(|sum| sum / (&a * 2)),
        };
        let half_phase = if phases.theta.abs() == PI {
            // the f64 nearest to π stands for π
            [whole(0), precise(phases.theta.signum())]
        } else {
            cis(&precise(0.5 * phases.theta))
        };
        let directions = [phases.arg_alpha, phases.arg_beta].map(|angle| cis(&precise(angle)));
        Self { integrands, half_tau, half_phase, directions }
    }
}

const BITS: usize = 512;

fn of_512_bits(x: f64) -> Precise {
    precise(x).with_precision(BITS).value()
}

/// Difference of two roots; 0 where it is so small that they are equal. A double root is known to twice this number of digits, and no state
/// in `f64` has roots at such a small distance.
fn gap(difference: Precise) -> Precise {
    const SAME: f64 = 1e-60;
    if to_f64(&difference) < SAME { whole(0) } else { difference }
}

/// Roots e₁ <= e₂ <= e₃.
fn roots(energy: &Precise, kappa: &Precise, l: &Precise, n: &Precise) -> [Precise; 3] {
    /// Greatest number of Newton steps, which halve the distance to a double root.
    const MOST_STEPS: u32 = 4000;
    let value_and_slope = |u: &Precise| {
        let moment = l - n * u;
        let value = (u - energy) * (u.sqr() - 1) - kappa * moment.sqr();
        let slope = u.sqr() * 3 - energy * u * 2 - 1 + kappa * n * moment * 2;
        (value, slope)
    };
    let newton = |mut u: Precise| {
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
    let sum = energy + kappa * n.sqr();
    // e₂ from the sum of the roots, of which two are at least -1
    let high: Precise = &sum + 2;
    let e3 = newton(high.max(of_512_bits(2.0)));
    let e1 = newton(of_512_bits(-1.0));
    let e2 = sum - &e1 - &e3;
    [e1, e2, e3]
}

/// Directions α/|α| and β/|β|, or those of the derivative of a parameter that is 0: there 2α' = (ω₂ - iω₁) β̄ and 2β' = -(ω₂ - iω₁) ᾱ.
fn directions(alpha: &ComplexPrecise, beta: &ComplexPrecise, omega: &[Precise; 3]) -> [ComplexPrecise; 2] {
    let [w1, w2, _] = omega;
    let leaving =
        [product(&[w2.clone(), -w1], &conjugate(beta)), product(&[-w2, w1.clone()], &conjugate(alpha))];
    let direction = |z: &ComplexPrecise, leaving: &ComplexPrecise| {
        let z = [z, leaving].into_iter().find(|z| !is_zero(&norm_squared(z)));
        z.map_or([whole(1), whole(0)], |z| {
            let length = root(&norm_squared(z));
            z.each_ref().map(|part| rounded(&(part / &length)))
        })
    };
    [direction(alpha, &leaving[0]), direction(beta, &leaving[1])]
}

fn norm_squared([re, im]: &ComplexPrecise) -> Precise {
    re.sqr() + im.sqr()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Difference e₂ - e₁ of a state that is close to a regular precession: half of its digits cancel in a cubic, so that of 512 bits more than
    /// 57 digits must remain. u - e₁ and e₂ - u add up to it.
    #[test]
    fn a_swing_of_the_last_place_is_known_to_all_digits() {
        // tilt 60°, precession 1, spin 3/2 would be steady; ω₃ is one unit in the last place too large
        let root = 0.75_f64.sqrt();
        let start = Start::State { phi: [[root, 0.0], [-0.5, 0.0]], omega: [root, 0.0, 1.5_f64.next_up()] };
        let numbers = Numbers { top: [1.0, 1.0, 1.0, 1.0, 1.0, 0.0], start };
        let Launched { integrands, half_phase, .. } = Launched::new(&numbers, &precise(1.0));
        assert!(to_f64(&(norm_squared(&half_phase) - 1)).abs() < 1e-55);
        let sum = &integrands.one_plus_e1 + &integrands.e2_minus_e1 + &integrands.one_minus_e2;
        assert!(to_f64(&(sum - 2)).abs() < 1e-55);
        let swing = to_f64(&integrands.e2_minus_e1);
        assert!(swing > 1e-18 && swing < 1e-14, "{swing:e}");
    }
}
