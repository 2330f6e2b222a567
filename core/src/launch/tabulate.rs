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
use crate::nutation::series::{Expansion, Point, Slopes, TERMS, worse};
use crate::nutation::{Nutation, PhaseRates};
use crate::real::{DoubleDouble, Float, Scalar};
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
    let mut polynomials = [[0.0; TERMS]; 4];
    if motion.is_steady() {
        constants(&brackets, &mut polynomials);
        (0..segments).for_each(|segment| {
            store(segment, &polynomials);
        });
        let [alpha, beta] = motion.phases();
        return Tabulated { start: [Turns::ZERO, alpha, beta], ..Tabulated::default() };
    }
    let seek = Seek::new(motion, rates.half_period.to_f64());
    let law = motion.law();
    let mut march = March {
        law: &law,
        rounded: &law.cast(),
        rates,
        unit: rates.half_period / DoubleDouble::from((2 * segments) as f64),
        point: Point::default(),
        least: rates.rounding / (16 * segments) as f64,
        far: rates.rounding / segments as f64,
        remainder: 0.0,
    };
    let mut expansion = Expansion::EMPTY;
    march.expand(&mut expansion);
    march.to(&expansion, 1.0);
    let mut found = None;
    let mut dropped = 0.0_f64;
    for segment in 0..segments {
        march.expand(&mut expansion);
        combine(&brackets, &expansion, march.least, &mut polynomials);
        let cut_off = beyond_the_last(&polynomials);
        dropped = worse(dropped, economise_all(&mut polynomials, terms) + cut_off);
        dropped = worse(dropped, store(segment, &polynomials));
        let last = segment + 1 == segments;
        if found.is_none()
            && let Some(x) = seek.within(&expansion, last)
        {
            // half a turn of the nutation over all segments
            let centre = (2 * segment + 1) as i128 * Turns::ONE.to_bits() / (4 * segments) as i128;
            let phase = Turns::from_bits(centre) + Turns::new(x / (4 * segments) as f64);
            found = Some((phase, expansion.theta_at(x)));
        }
        if last || expansion.last_term(2.0) > march.far {
            march.to(&expansion, 1.0);
        } else {
            march.to(&expansion, 2.0);
            continue;
        }
        if !last {
            march.expand(&mut expansion);
            march.to(&expansion, 1.0);
        }
    }
    let (phase, theta) = found.unwrap_or_default();
    Tabulated {
        start: seek.start(motion, phase, theta),
        truncation: dropped + march.remainder,
        defect: if rates.returns { march.defect() } else { 0.0 },
    }
}

/// The way from centre to centre.
struct March<'a> {
    law: &'a Nutation<DoubleDouble>,
    rounded: &'a Nutation<f64>,
    rates: &'a Rates,
    /// Half a segment. An error here would add up over them.
    unit: DoubleDouble,
    point: Point,
    /// Terms below this change nothing.
    least: f64,
    /// A step from centre to centre that leaves out more than this, rad, goes by the border between them.
    far: f64,
    /// What the series left out on the way so far, judged by its last terms.
    remainder: f64,
}

impl March<'_> {
    /// Around the point that was reached.
    fn expand(&self, expansion: &mut Expansion) {
        self.rounded.expand(&self.point, &self.slopes(), self.unit.to_f64(), self.least, expansion);
    }

    /// In double-double: a slow phase may turn by thousands of radians, and hardly from its mean.
    #[inline(never)]
    fn slopes(&self) -> Slopes {
        let (sine, cosine) = self.point.sine_cosine();
        let rates = self.law.rates(sine.into(), cosine.into());
        let [alpha_excess, beta_excess] = self.rates.excess;
        let slope = |rate: DoubleDouble| (self.unit * rate).to_f64();
        Slopes {
            psi: PhaseRates {
                nutation: slope(rates.nutation),
                alpha: slope(rates.alpha),
                beta: slope(rates.beta),
            },
            theta: [slope(rates.alpha + alpha_excess), slope(rates.beta + beta_excess)],
        }
    }

    fn to(&mut self, expansion: &Expansion, x: f64) {
        self.remainder += expansion.last_term(x);
        self.point = expansion.point(x);
    }

    /// At the upper turning point cos χ = 0, and α and β with their mean rotation taken off are real: cos θ = 0.
    fn defect(&self) -> f64 {
        let miss = |angle: Turns| Float::abs(f64::sine_cosine(angle).1);
        let [alpha, beta] = self.point.theta.map(miss);
        2.0 * (miss(self.point.chi) + alpha.max(beta))
    }
}

/// α and β where the half phase stays 0.
fn constants(brackets: &Brackets<f64>, polynomials: &mut Polynomials) {
    let [re_alpha, _, re_beta, _] = polynomials;
    if let (Some(alpha), Some(beta)) = (re_alpha.first_mut(), re_beta.first_mut()) {
        let [plus, minus] = brackets.alpha.exponentials();
        *alpha = plus + minus;
        let [plus, minus] = brackets.beta.exponentials();
        *beta = plus + minus;
    }
}

/// The brackets times e^{iθ}, in real and imaginary parts.
#[inline(never)]
fn combine(brackets: &Brackets<f64>, expansion: &Expansion, least: f64, polynomials: &mut Polynomials) {
    let [re_alpha, im_alpha, re_beta, im_beta] = polynomials;
    expansion.turned(0, brackets.alpha.exponentials(), least, [re_alpha, im_alpha]);
    expansion.turned(1, brackets.beta.exponentials(), least, [re_beta, im_beta]);
}

/// What the series leave out beyond their last term, as an orientation error: as if they went on as their last four terms
/// do. Infinite where these do not fall.
fn beyond_the_last(polynomials: &Polynomials) -> f64 {
    /// Below it terms are rounding, and need not fall.
    const NEGLIGIBLE: f64 = 1e-18;
    let mut squares = 0.0;
    for polynomial in polynomials {
        let [.., c12, c13, c14, c15] = polynomial.map(Float::abs);
        // by pairs, since a series may be even or odd
        let (before, last) = (c12 + c13, c14 + c15);
        if last > NEGLIGIBLE {
            let ratio = last / before;
            let rest = if ratio < 1.0 { last * ratio / (1.0 - ratio) } else { f64::INFINITY };
            squares += rest * rest;
        }
    }
    2.0 * Float::sqrt(squares)
}

/// Shortens all four to `terms` coefficients by taking off multiples of Chebyshev polynomials from the top; returns a bound
/// of the change on [-1, 1], as an orientation error: the sum of the multiples bounds that of each.
fn economise_all(polynomials: &mut Polynomials, terms: usize) -> f64 {
    let mut dropped = [0.0; 4];
    for degree in (terms.max(1)..TERMS).rev() {
        let leading = polynomials.each_ref().map(|polynomial| polynomial.get(degree).copied().unwrap_or(0.0));
        if leading == [0.0; 4] {
            continue;
        }
        // T_n/2^{n-1} = Σ (-1)^j n/(n-j) C(n-j, j)/4^j x^{n-2j}, each term from the one before
        let n = degree as f64;
        let mut coefficient = 1.0;
        for j in 0..=degree / 2 {
            for (polynomial, leading) in polynomials.iter_mut().zip(leading) {
                if let Some(entry) = polynomial.get_mut(degree - 2 * j) {
                    *entry -= leading * coefficient;
                }
            }
            let (j, power) = (j as f64, n - 2.0 * j as f64);
            coefficient *= -power * (power - 1.0) / (4.0 * (j + 1.0) * (n - j - 1.0).max(1.0));
        }
        let scale = 1.0 / (1_u64 << (degree - 1)) as f64;
        dropped.iter_mut().zip(leading).for_each(|(sum, leading)| *sum += Float::abs(leading) * scale);
    }
    2.0 * Float::sqrt(dropped.into_iter().fold(0.0, |sum, dropped| sum + dropped * dropped))
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
            let mut four = [exact, [0.0; TERMS], [0.0; TERMS], [0.0; TERMS]];
            let bound = 0.5 * economise_all(&mut four, terms);
            let [short, ..] = four;
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
