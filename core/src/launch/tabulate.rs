//! Half a nutation period as short polynomials: the other half is its mirror image.
//!
//! With their mean rotation taken off, α and β are periodic and analytic in time, and conjugate on the two sides of a
//! turning point. So half a period, from u = e₁ to u = e₂, is cut into equal segments; around the centre of each the law
//! is expanded ([`crate::nutation::series`]) and the expansion shortened to the degree wanted (economised: what is
//! dropped are multiples of Chebyshev polynomials, so the sum of their coefficients bounds the error).
//!
//! An aperiodic motion is tabulated in the same way, from its lowest point until u = 1 to rounding; a steady one is a
//! single constant.

use super::Motion;
use super::rates::Rates;
use super::seek::Seek;
use crate::cayley_klein::Brackets;
use crate::nutation::series::{Expansion, Point, TERMS};
use crate::real::{Float, Scalar};
use crate::turns::Turns;

/// The coefficients, lowest first, of Re α, Im α, Re β and Im β as polynomials in x ∈ [-1, 1] on one segment.
pub(crate) type Polynomials = [[f64; TERMS]; 4];

/// What a tabulation says besides its polynomials.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tabulated {
    /// Nutation phase at t = 0 (one turn a period, 0 at u = e₁), and the mean slow phases of α and β there.
    pub(crate) start: [Turns; 3],
    /// Bound, as an orientation error in rad, of what shortening the series costs, and of what sixteen terms leave.
    pub(crate) truncation: f64,
    /// How far the march through the segments misses the upper turning point, where it must end, rad.
    pub(crate) defect: f64,
}

/// Hands the polynomials of each of `segments` segments to `store`, which says what it cannot hold of them (an orientation
/// error); only their first `terms` coefficients count.
#[inline(never)]
pub(crate) fn tabulate(
    motion: &Motion,
    rates: &Rates,
    segments: usize,
    terms: usize,
    mut store: impl FnMut(usize, &Polynomials) -> f64,
) -> Tabulated {
    let brackets = motion.brackets::<f64>();
    if motion.is_steady() {
        let constant = constants(&brackets);
        (0..segments).for_each(|segment| {
            store(segment, &constant);
        });
        let [alpha, beta] = motion.phases();
        return Tabulated { start: [Turns::ZERO, alpha, beta], ..Tabulated::default() };
    }
    let law = motion.law().cast::<f64>();
    let unit = rates.half_period / (2 * segments) as f64; // half a segment
    let seek = Seek::new(motion, rates.half_period);
    let mut march = March { point: Point::LOWEST, remainder: 0.0 };
    march.to(&law.expand(&march.point, unit, rates.excess), 1.0);
    let mut found = None;
    let mut dropped = 0.0_f64;
    for segment in 0..segments {
        let expansion = law.expand(&march.point, unit, rates.excess);
        let mut polynomials = combine(&brackets, &expansion);
        dropped = worse(dropped, economise_all(&mut polynomials, terms));
        dropped = worse(dropped, store(segment, &polynomials));
        let last = segment + 1 == segments;
        if found.is_none()
            && let Some(x) = seek.within(&expansion, last)
        {
            let phase = (segment as f64 + 0.5 * (1.0 + x)) / (2 * segments) as f64;
            found = Some((phase, expansion.theta_at(x)));
        }
        if last || expansion.last_term(2.0) > FAR {
            march.to(&expansion, 1.0);
        } else {
            march.to(&expansion, 2.0);
            continue;
        }
        if !last {
            march.to(&law.expand(&march.point, unit, rates.excess), 1.0);
        }
    }
    let (phase, theta) = found.unwrap_or_default();
    Tabulated {
        start: seek.start(motion, phase, theta),
        truncation: dropped + march.remainder,
        defect: if rates.returns { march.defect() } else { 0.0 },
    }
}

/// A step from centre to centre that leaves out more than this, rad, goes by the border between them.
const FAR: f64 = 1e-15;

/// The larger of two, or NaN if one is.
fn worse(a: f64, b: f64) -> f64 {
    if b <= a { a } else { b }
}

/// The way from centre to centre.
struct March {
    point: Point,
    /// What the series left out on the way so far, judged by its last term.
    remainder: f64,
}

impl March {
    fn to(&mut self, expansion: &Expansion, x: f64) {
        self.remainder += expansion.last_term(x);
        self.point = expansion.point(x);
    }

    /// At the upper turning point cos χ = 0, and α and β with their mean rotation taken off are real: cos θ = 0.
    fn defect(&self) -> f64 {
        let miss = |angle: f64| Float::abs(f64::sine_cosine(Turns::from_radians(angle)).1);
        let [alpha, beta] = self.point.theta;
        2.0 * (Float::abs(self.point.cosine) + miss(alpha).max(miss(beta)))
    }
}

/// α and β where the half phase stays 0.
fn constants(brackets: &Brackets<f64>) -> Polynomials {
    let mut polynomials = [[0.0; TERMS]; 4];
    let [re_alpha, _, re_beta, _] = &mut polynomials;
    if let (Some(alpha), Some(beta)) = (re_alpha.first_mut(), re_beta.first_mut()) {
        let [plus, minus] = brackets.alpha.exponentials();
        *alpha = plus + minus;
        let [plus, minus] = brackets.beta.exponentials();
        *beta = plus + minus;
    }
    polynomials
}

/// The brackets times e^{iθ}, in real and imaginary parts.
#[inline(never)]
fn combine(brackets: &Brackets<f64>, expansion: &Expansion) -> Polynomials {
    let [re_alpha, im_alpha] = expansion.turned(0, brackets.alpha.exponentials());
    let [re_beta, im_beta] = expansion.turned(1, brackets.beta.exponentials());
    [re_alpha, im_alpha, re_beta, im_beta].map(|series| *series.coefficients())
}

/// Shortens all four; returns a bound of the change, as an orientation error.
fn economise_all(polynomials: &mut Polynomials, terms: usize) -> f64 {
    let sum = polynomials.iter_mut().fold(0.0, |sum, polynomial| {
        let dropped = economise(polynomial, terms);
        sum + dropped * dropped
    });
    2.0 * Float::sqrt(sum)
}

/// Shortens to `terms` coefficients by taking off multiples of Chebyshev polynomials from the top; returns the sum of
/// the multiples, which bounds the change on [-1, 1].
fn economise(polynomial: &mut [f64; TERMS], terms: usize) -> f64 {
    let mut dropped = 0.0;
    for degree in (terms.max(1)..TERMS).rev() {
        let leading = polynomial.get(degree).copied().unwrap_or(0.0);
        // T_n/2^{n-1} = Σ (-1)^j n/(n-j) C(n-j, j)/4^j x^{n-2j}, each term from the one before
        let n = degree as f64;
        let mut coefficient = leading;
        for j in 0..=degree / 2 {
            if let Some(entry) = polynomial.get_mut(degree - 2 * j) {
                *entry -= coefficient;
            }
            let (j, power) = (j as f64, n - 2.0 * j as f64);
            coefficient *= -power * (power - 1.0) / (4.0 * (j + 1.0) * (n - j - 1.0).max(1.0));
        }
        dropped += Float::abs(leading) / (1_u64 << (degree - 1)) as f64;
    }
    dropped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn economising_stays_within_what_it_says() {
        let mut exact = [0.0; TERMS];
        exact
            .iter_mut()
            .enumerate()
            .for_each(|(k, c)| *c = 0.3_f64.powi(k as i32) * (1.0 + (k as f64).sin()));
        for terms in 1..TERMS {
            let mut short = exact;
            let bound = economise(&mut short, terms);
            assert!(short[terms..].iter().all(|c| c.abs() < 1e-16));
            let value = |p: &[f64; TERMS], x: f64| p.iter().rev().fold(0.0, |sum, c| sum * x + c);
            let worst = (0..=1000).fold(0.0_f64, |worst, i| {
                let x = f64::from(i) / 500.0 - 1.0;
                worst.max((value(&short, x) - value(&exact, x)).abs())
            });
            assert!(
                worst <= bound * 1.000_001 + 1e-15 && worst > 0.3 * bound,
                "{terms}: {worst:e} {bound:e}"
            );
        }
    }
}
