//! Series of a and b: each is the sum of two exponentials of the phases.

use super::{Expansion, MAX_TERMS, PowerSeries};
use crate::integer::{Limbs, shifted_right, to_units};
use crate::scalar::{Ring, SINE_BITS, sine_cosine_q57};
use crate::table::build::path::series::{BITS, UnitFactor, in_range, integrated};
use crate::table::evaluation::TABLE_BITS;

/// Difference of the fraction bits of a coefficient of a or b, 62, and of one of an exponential, 56.
const MORE_BITS: i32 = TABLE_BITS as i32 - BITS;

impl Expansion {
    /// Adds p e^{i(ρ+χ)} + q e^{i(ρ-χ)} to `sums`, with the residual phase ρ of this index. Returns the number of terms not below `least`.
    ///
    /// * `scratch`: rates of ρ + χ and of ρ - χ, and the exponential of one of them
    /// * `sums`: coefficients of x^k in units of 2^-62
    pub(crate) fn add_cayley_klein_series(
        &self,
        index: usize,
        [p, q]: [f64; 2],
        least: i64,
        scratch: &mut [PowerSeries; 4],
        mut sums: [&mut [i64; MAX_TERMS]; 2],
    ) -> Option<usize> {
        let [forwards, backwards, re, im] = scratch;
        let Self { chi, residual, origin, terms, .. } = self;
        let residual = residual.get(index)?;
        let residual_phase = *origin.residual.get(index)?;
        let at_origin = residual.at_origin.abs() + chi.at_origin.abs();
        let variation = residual.magnitude_of_variation() + chi.magnitude_of_variation();
        forwards.set_exponent(at_origin.larger_or_nan(variation));
        let exponent = forwards.exponent;
        backwards.exponent = exponent;
        let rates =
            [residual, chi].map(|rate| (rate, UnitFactor::new(rate.scale, &rate.variation, forwards)));
        for k in 0..*terms {
            let [residual, chi] = rates.each_ref().map(|(rate, factor)| match k {
                0 => to_units(rate.at_origin, exponent),
                _ => factor.times(rate.variation.coefficient(k)),
            });
            forwards.set(k, residual + chi)?;
            backwards.set(k, residual - chi)?;
        }
        let mut most = 0;
        for (rate, phase, scale) in [(&*forwards, origin.chi, p), (&*backwards, -origin.chi, q)] {
            let (sine, cosine) = sine_cosine_q57(residual_phase + phase);
            let scale = Limbs::new(to_units(scale, -SINE_BITS));
            let start = |part: i64| scale.times::<{ (2 * SINE_BITS - BITS) as u32 }>(part);
            re.set(0, start(cosine))?;
            im.set(0, start(sine))?;
            let computed = continue_exponential(rate, *terms, least, re, im)?;
            for (sum, part) in sums.iter_mut().zip([&*re, &*im]) {
                for (k, sum) in sum.iter_mut().enumerate().take(computed) {
                    *sum += part.coefficient(k);
                }
            }
            most = most.max(computed);
        }
        for sum in sums {
            for (k, sum) in (0..).zip(sum.iter_mut()).take(most) {
                // y = x/4: the coefficient of x^k is the coefficient of y^k over 4^k
                let shift = 2 * k - MORE_BITS;
                *sum = if shift > 0 { shifted_right(*sum, shift as u32) } else { *sum << -shift };
            }
        }
        Some(most)
    }
}

/// Solves z' = i z rate from the first coefficient in units of 2^-56, until two successive terms are at most `least` units of 2^-62 at x = 1. Returns
/// the number of terms.
fn continue_exponential(
    rate: &PowerSeries,
    terms: usize,
    least: i64,
    re: &mut PowerSeries,
    im: &mut PowerSeries,
) -> Option<usize> {
    // limit of a coefficient of yᵏ, in units of 2^-62
    let mut limit = least;
    let mut before = false;
    for k in 0..MAX_TERMS - 1 {
        let next = |part: &PowerSeries| {
            in_range(rate.product(part, 0..terms.min(k + 1), k, -rate.exponent))
                .map(|next| integrated(next, k))
        };
        let next_re = -next(im)?;
        let next_im = next(re)?;
        re.set(k + 1, next_re)?;
        im.set(k + 1, next_im)?;
        if limit < i64::MAX >> 3 {
            limit <<= 2;
        }
        let negligible = next_re.abs().max(next_im.abs()) <= limit >> MORE_BITS;
        if negligible && before {
            return Some(k + 2);
        }
        before = negligible;
    }
    Some(MAX_TERMS)
}

#[cfg(test)]
mod tests {
    use super::super::{ExpansionPoint, PathPhases};
    use super::*;
    use crate::body::{Top, TopParameters};
    use crate::complex::Complex;
    use crate::constants::{BranchPoints, Sign, Signs};
    use crate::motion::phase_equations::PhaseEquations;
    use crate::phase::Phase;
    use crate::scalar::{Extended, Float, Real};
    use crate::table::evaluation::TABLE_UNIT;

    fn equations(spread: f64, [e1, e2, e3]: [f64; 3]) -> PhaseEquations<Extended> {
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
        let integrals = e.extended_integrals(&top, signs);
        PhaseEquations::new(&top, &e, integrals.l_plus_n, signs, Extended::ZERO)
    }

    /// At other points of the segment the series have the rates of the equations, and a the value that the phases
    /// give.
    #[test]
    fn the_series_solve_the_equations() {
        let mut worst = [0.0_f64; 4];
        for (spread, e) in [
            (1.0, [-0.5, 0.5, 1.5]),
            (0.01, [-0.9, 1.0, 1.0 + 1e-6]),
            (1e3, [0.5, 0.5 + 1e-9, 1e4]),
            (1.0, [-0.3, 0.4, 1.0]),
            (1e-5, [-1.0, 0.26, 28.8]),
        ] {
            let exact = equations(spread, e);
            let rounded = exact.map(Float::to_f64);
            for turns in [0.0, 1e-9, 0.1, 0.17, 0.2499, 0.25] {
                let phases = PathPhases {
                    chi: Phase::from_turns(turns),
                    residual: [Phase::from_turns(0.3), Phase::from_turns(-0.4)],
                };
                let (sine, cosine) = f64::sine_cosine(phases.chi);
                let rates = exact.rates(sine.into(), cosine.into());
                let rates_there = rounded.rates(sine, cosine);
                let size =
                    [rates_there.chi, rates_there.psi_alpha, rates_there.psi_beta].into_iter().map(f64::abs);
                let unit = 0.02 * spread.sqrt().min(1.0) / size.fold(0.0, f64::max).max(1.0);
                let [chi, alpha, beta] =
                    [rates.chi, rates.psi_alpha, rates.psi_beta].map(|rate| (rate * unit.into()).to_f64());
                let origin = ExpansionPoint {
                    phases,
                    sine,
                    cosine,
                    time_per_y: 4.0 * unit,
                    negligible: 1e-18,
                    chi_rate: 4.0 * chi,
                    psi_rates: [4.0 * alpha, 4.0 * beta],
                    residual_rates: [4.0 * alpha, 4.0 * beta],
                    rotation_per_chi_error: (alpha.abs().max(beta.abs()) / chi).max(1.0),
                };
                let mut expansion = Expansion::ZERO;
                expansion.expand(&rounded, &origin, &mut || {});
                assert!(expansion.terms > 2, "{spread} {e:?} {turns}");
                for x in [-1.0, 0.5, 1.0] {
                    let (PathPhases { chi: at, residual }, slope) = expansion.at(x);
                    let (sine, cosine) = f64::sine_cosine(at);
                    let rates = exact.rates(sine.into(), cosine.into());
                    let of = |rate: Extended| (rate * unit.into()).to_f64();
                    let [alpha, beta] = expansion
                        .residual
                        .each_ref()
                        .map(|rate| 0.25 * rate.value(0.25 * x, expansion.terms));
                    worst[0] = worst[0].max(origin.rotation_per_chi_error * (slope - of(rates.chi)).abs());
                    worst[1] = worst[1].max((alpha - of(rates.psi_alpha)).abs());
                    worst[2] = worst[2].max((beta - of(rates.psi_beta)).abs());
                    let ([p, q], mut parts) = ([0.6, -0.3], [[0; MAX_TERMS]; 2]);
                    let mut scratch = [PowerSeries::ZERO; 4];
                    expansion.add_cayley_klein_series(0, [p, q], 5, &mut scratch, parts.each_mut()).unwrap();
                    let [re, im] = parts
                        .map(|part| part.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64 * TABLE_UNIT));
                    let [up, down] = [at, -at].map(|chi| Complex::cis(chi + residual[0]));
                    let truth = up.scaled(p) + down.scaled(q);
                    worst[3] = worst[3].max((re - truth.re).abs()).max((im - truth.im).abs());
                }
            }
        }
        assert!(worst.into_iter().all(|worst| (1e-19..5e-15).contains(&worst)), "{worst:?}");
    }
}
