//! Series of α and β: solutions of linear equations whose rates are those of the phases.

use super::{Expansion, Rate, TABLE_BITS, larger_or_nan};
use crate::scalar::Float;
use crate::table::series::sincos::{FRACTION, sine_cosine};
use crate::table::series::{BITS, Block, Factor, Split, TERMS, in_range, integrated, scaled, scaled_product};

/// Coefficient of x^k in units of 2^-62, from that of yᵏ = (x/4)^k in units of 2^-56.
fn of_x(coefficient: i64, k: usize) -> i64 {
    match 2 * k as i32 - (TABLE_BITS - BITS) {
        shift @ 1.. => ((coefficient >> (shift - 1)) + 1) >> 1,
        shift => coefficient << -shift,
    }
}

impl Expansion {
    /// Ellipse p e^{iχ} + q e^{-iχ} times e^{iθ}, with θ of this index. Its coefficients of x^k are written to `sums`, which must be 0.
    /// Returns the number of terms that are not below `least`; `None` where they do not converge.
    #[inline(never)]
    pub(crate) fn parameter_series(
        &mut self,
        slow: usize,
        [p, q]: [f64; 2],
        least: i64,
        mut sums: [&mut [i64; TERMS]; 2],
    ) -> Option<usize> {
        let Self { chi: fast, theta, origin, scratch: [forwards, backwards, re, im, _], terms, .. } = self;
        let (slow, theta) = (theta.get(slow)?, *origin.theta.get(slow)?);
        // θ' + χ' and θ' - χ' in a common unit
        let size = |rate: &Rate| rate.variation.magnitude_times(Float::abs(rate.scale));
        let slopes = Float::abs(slow.slope) + Float::abs(fast.slope);
        forwards.scale_for(larger_or_nan(slopes, size(slow) + size(fast)));
        let exponent = forwards.exponent;
        backwards.exponent = exponent;
        let rates = [slow, fast].map(|rate| (rate, Factor::new(rate.scale, &rate.variation, forwards)));
        for k in 0..*terms {
            let [slow, fast] = rates.each_ref().map(|(rate, factor)| match k {
                0 => scaled(rate.slope, exponent),
                _ => factor.times(rate.variation.get(k)),
            });
            forwards.put(k, slow + fast)?;
            backwards.put(k, slow - fast)?;
        }
        let mut most = 0;
        for (rate, chi, scale) in [(&*forwards, origin.chi, p), (&*backwards, -origin.chi, q)] {
            let (sine, cosine) = sine_cosine(theta + chi);
            let scale = Split::of(scaled(scale, -FRACTION));
            let start = |part: i64| scaled_product::<{ (2 * FRACTION - BITS) as u32 }>(scale, part);
            re.put(0, start(cosine))?;
            im.put(0, start(sine))?;
            let computed = exponential(rate, *terms, least, re, im)?;
            for (sum, part) in sums.iter_mut().zip([&*re, &*im]) {
                for (k, sum) in sum.iter_mut().enumerate().take(computed) {
                    *sum += part.get(k);
                }
            }
            most = most.max(computed);
        }
        for sum in sums {
            sum.iter_mut().enumerate().take(most).for_each(|(k, sum)| *sum = of_x(*sum, k));
        }
        Some(most)
    }
}

/// Continues the solution re + i im of z' = i z rate from its first coefficient, in units of 2^-56, until two terms in succession are at
/// most `least` units of 2^-62 at x = 1. Returns the number of terms; `None` where it does not converge.
#[inline(never)]
fn exponential(rate: &Block, terms: usize, least: i64, re: &mut Block, im: &mut Block) -> Option<usize> {
    // limit of a coefficient of yᵏ, in units of 2^-62
    let (mut limit, mut before) = (least, false);
    for k in 0..TERMS - 1 {
        let next = |part: &Block| {
            in_range(rate.product(part, 0..terms.min(k + 1), k, -rate.exponent))
                .map(|next| integrated(next, k))
        };
        let (next_re, next_im) = (-next(im)?, next(re)?);
        re.put(k + 1, next_re)?;
        im.put(k + 1, next_im)?;
        if limit < i64::MAX >> 3 {
            limit <<= 2;
        }
        let negligible = next_re.abs().max(next_im.abs()) <= limit >> (TABLE_BITS - BITS);
        if negligible && before {
            return Some(k + 2);
        }
        before = negligible;
    }
    Some(TERMS)
}

#[cfg(test)]
mod tests {
    use super::super::{PhasePoint, Slopes};
    use super::*;
    use crate::body::{Top, TopParameters};
    use crate::complex::Complex;
    use crate::constants::{BranchPoints, Sign, Signs};
    use crate::motion::phase_equations::PhaseEquations;
    use crate::phase::Phase;
    use crate::scalar::{Extended, Scalar};
    use crate::table::series::expansion::TABLE_UNIT;

    fn law(spread: f64, [e1, e2, e3]: [f64; 3]) -> PhaseEquations<Extended> {
        let parameters = TopParameters {
            transverse_inertia: spread,
            axial_inertia: 0.7 * spread,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        };
        let top = Top::sliding(&parameters).unwrap();
        let e = BranchPoints::<Extended>::from_roots([e1, e2, e3]).unwrap();
        let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
        PhaseEquations::new(&top, &e, e.scaled_integrals(&top, signs).l_plus_n, signs)
    }

    /// At other points of the segment the series have the rates of the law, and α and β the value that the phases
    /// give.
    #[test]
    fn the_series_obey_the_law() {
        let mut worst = [0.0_f64; 4];
        for (spread, e) in [
            (1.0, [-0.5, 0.5, 1.5]),
            (0.01, [-0.9, 1.0, 1.0 + 1e-6]),
            (1e3, [0.5, 0.5 + 1e-9, 1e4]),
            (1.0, [-0.3, 0.4, 1.0]),
            (1e-5, [-1.0, 0.26, 28.8]),
        ] {
            let exact = law(spread, e);
            let rounded: PhaseEquations<f64> = exact.cast();
            for turns in [0.0, 1e-9, 0.1, 0.17, 0.2499, 0.25] {
                let point = PhasePoint { chi: Phase::new(turns), theta: [Phase::new(0.3), Phase::new(-0.4)] };
                let (sine, cosine) = point.sine_cosine();
                let rates = exact.rates(sine.into(), cosine.into());
                let beyond = rounded.rates(sine, cosine);
                let size = [beyond.nutation, beyond.slow_a, beyond.slow_b].into_iter().map(f64::abs);
                let unit = 0.02 * spread.sqrt().min(1.0) / size.fold(0.0, f64::max).max(1.0);
                let [chi, alpha, beta] =
                    [rates.nutation, rates.slow_a, rates.slow_b].map(|rate| (rate * unit.into()).to_f64());
                let slopes = Slopes {
                    point,
                    sine,
                    cosine,
                    unit: 4.0 * unit,
                    least: 1e-18,
                    chi: 4.0 * chi,
                    psi: [4.0 * alpha, 4.0 * beta],
                    theta: [4.0 * alpha, 4.0 * beta],
                    weight: (alpha.abs().max(beta.abs()) / chi).max(1.0),
                };
                let mut expansion = Expansion::EMPTY;
                expansion.expand(&exact, &slopes, &mut || {});
                assert!(expansion.terms > 2, "{spread} {e:?} {turns}");
                for x in [-1.0, 0.5, 1.0] {
                    let (PhasePoint { chi: at, theta }, slope) = expansion.at(x);
                    let (sine, cosine) = f64::sine_cosine(at);
                    let rates = exact.rates(sine.into(), cosine.into());
                    let of = |rate: Extended| (rate * unit.into()).to_f64();
                    let [alpha, beta] =
                        expansion.theta.each_ref().map(|rate| 0.25 * rate.value(0.25 * x, expansion.terms));
                    worst[0] = worst[0].max(slopes.weight * (slope - of(rates.nutation)).abs());
                    worst[1] = worst[1].max((alpha - of(rates.slow_a)).abs());
                    worst[2] = worst[2].max((beta - of(rates.slow_b)).abs());
                    let ([p, q], mut parts) = ([0.6, -0.3], [[0; TERMS]; 2]);
                    expansion.parameter_series(0, [p, q], 5, parts.each_mut()).unwrap();
                    let [re, im] = parts
                        .map(|part| part.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64 * TABLE_UNIT));
                    let [up, down] = [at, -at].map(|chi| Complex::cis(chi + theta[0]));
                    let truth = up.scaled(p) + down.scaled(q);
                    worst[3] = worst[3].max((re - truth.re).abs()).max((im - truth.im).abs());
                }
            }
        }
        assert!(worst.into_iter().all(|worst| (1e-19..5e-15).contains(&worst)), "{worst:?}");
    }
}
