//! Expansion of the law around a point: its constants, and the first coefficients.

use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::{Float, times_power_of_two};
use crate::table::series::block::{Block, Factor};
use crate::table::series::coefficients::{Recurrence, SlowFactors};
use crate::table::series::expansion::{Expansion, PhasePoint, Slopes, larger_or_nan};
use crate::table::series::integers::{BITS, scaled};
use crate::table::series::rate::{Rate, negligible};

/// Constants of one expansion, from the values at its point.
struct Values {
    /// Factor of cos²χ in η.
    eta: f64,
    /// Factors of cos²χ and of its square in δ.
    delta: [f64; 2],
    /// Factors of cos²χ in the variations of dψ_A/dx and dψ_B/dx.
    psi: [f64; 2],
    /// Shares of D and of D dχ/dx in the denominators of ψ_A' and ψ_B'.
    shares: [[f64; 2]; 2],
}

impl SlowFactors {
    /// Factors for a rate of `slope`; `delta` and `drive` have their exponents already, the series of the rate get
    /// theirs.
    fn new(
        rate: &mut Rate,
        slope: f64,
        (scale, [constant, smoothing]): (f64, [f64; 2]),
        [square, delta, drive]: [&Block; 3],
        least: f64,
    ) -> Self {
        let Rate { variation, integral: divisor, .. } = rate;
        let of_size = |factor: f64, series: &Block| times_power_of_two(factor, series.exponent + BITS);
        divisor.scale_for(of_size(constant, delta) + of_size(smoothing, drive));
        variation.scale_for(of_size(Float::abs(slope), divisor) + of_size(Float::abs(scale), square));
        rate.scale = 1.0;
        Self {
            from_square: Factor::new(scale, square.exponent, variation.exponent),
            from_divisor: Factor::new(slope, divisor.exponent, variation.exponent),
            shares: [
                Factor::new(constant, delta.exponent, divisor.exponent),
                Factor::new(smoothing, drive.exponent, divisor.exponent),
            ],
            negligible: negligible(least, variation.exponent),
        }
    }
}

impl PhaseEquations<f64> {
    #[inline(never)] // the frame must not remain below those of the recurrence
    fn values(&self, sine: f64, cosine: f64, chi_slope: f64, unit: f64) -> Values {
        let swing = self.e2_minus_e1 * cosine * cosine;
        let one_minus_u = swing + self.one_minus_e2;
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * sine * sine;
        let d = self.a_over_p + self.s * one_minus_u * one_plus_u;
        let per_d = 1.0 / d;
        let s_per_d = self.s * self.e2_minus_e1 * per_d;
        // the denominators of ψ_A' and ψ_B' over D: combinations of 1 and dχ/dx
        let scale = unit * unit * self.e2_minus_e1 * per_d;
        let per = |constant: f64, smoothing: f64| {
            let smoothed = smoothing * chi_slope;
            let per_divisor = 1.0 / (constant + smoothed);
            (scale * per_divisor, [constant * per_divisor, smoothed * per_divisor])
        };
        let (alpha, alpha_shares) = per(unit, self.alpha_smoothing);
        let (beta, beta_shares) = per(unit * self.root_e3, self.beta_smoothing);
        Values {
            eta: self.e2_minus_e1 / (self.e3_minus_e2 + swing),
            delta: [times_power_of_two(s_per_d * (1.0 - one_minus_u), 1), s_per_d * self.e2_minus_e1],
            psi: [self.s * self.alpha_scale * alpha, -self.s_e3 * self.beta_scale * beta],
            shares: [alpha_shares, beta_shares],
        }
    }

    /// Expands the motion around `point`, where the phases have these derivatives and x = 1 stands for a time `unit`. Terms are computed
    /// until two in succession are below `least` at x = 2, y = 1/2.
    #[inline(never)]
    pub(crate) fn expand(
        &self,
        point: &PhasePoint,
        slopes: &Slopes,
        unit: f64,
        least: f64,
        to: &mut Expansion,
        between: &mut dyn FnMut(),
    ) {
        let recurrence = self.recurrence(point, slopes, unit, least, to);
        to.compute(&recurrence, between);
    }

    /// Constants of the recurrence, and the first coefficients.
    #[inline(never)] // the frame must not remain below those of the recurrence
    fn recurrence(
        &self,
        point: &PhasePoint,
        slopes: &Slopes,
        unit: f64,
        least: f64,
        to: &mut Expansion,
    ) -> Recurrence {
        // the series are in y = x/4
        let by_y = |by_x: f64| times_power_of_two(by_x, 2);
        let (unit, chi_slope) = (by_y(unit), by_y(slopes.psi.nutation));
        (to.origin, to.weight) = (*point, slopes.weight);
        let (point_sine, point_cosine) = slopes.sine_cosine;
        let values = self.values(point_sine, point_cosine, chi_slope, unit);
        // sin χ and cos χ, and the variations of cos²χ, of D and of D dχ/dx
        let Expansion { chi, theta: [alpha, beta], scratch: [sine, cosine, square, delta, drive], .. } =
            &mut *to;
        let magnitude = |own: f64, other: f64| larger_or_nan(Float::abs(own), Float::abs(chi_slope * other));
        sine.scale_for(magnitude(point_sine, point_cosine));
        cosine.scale_for(magnitude(point_cosine, point_sine));
        square.exponent = 2 * cosine.exponent + BITS;
        let of_square = |factor: f64| times_power_of_two(factor, square.exponent + BITS);
        let [linear, quadratic] = values.delta;
        let delta_size = of_square(Float::abs(linear) + of_square(quadratic));
        delta.scale_for(delta_size);
        drive.scale_for(delta_size + of_square(values.eta));
        chi.variation.exponent = drive.exponent;
        (chi.slope, chi.scale) = (chi_slope, chi_slope);
        let ([alpha_scale, beta_scale], [alpha_shares, beta_shares]) = (values.psi, values.shares);
        let series = [&*square, &*delta, &*drive];
        let psi = [slopes.psi.alpha, slopes.psi.beta].map(by_y);
        let slow = [
            SlowFactors::new(alpha, psi[0], (alpha_scale, alpha_shares), series, least),
            SlowFactors::new(beta, psi[1], (beta_scale, beta_shares), series, least),
        ];
        let of_chi = least / Float::abs(slopes.weight * chi_slope);
        let of_chi = if of_chi > f64::MAX { f64::MAX } else { of_chi };
        let in_range = sine.put(0, scaled(point_sine, sine.exponent))
            & cosine.put(0, scaled(point_cosine, cosine.exponent));
        Recurrence {
            slow,
            from_square: [
                Factor::new(values.eta, square.exponent, drive.exponent),
                Factor::new(linear, square.exponent, delta.exponent),
                Factor::new(-quadratic, 2 * square.exponent + BITS, delta.exponent),
            ],
            to_drive: Factor::new(1.0, delta.exponent, drive.exponent),
            to_sine: Factor::new(chi_slope, cosine.exponent, sine.exponent),
            to_cosine: Factor::new(-chi_slope, sine.exponent, cosine.exponent),
            negligible: [
                negligible(least, sine.exponent),
                negligible(least, cosine.exponent),
                negligible(of_chi, drive.exponent),
            ],
            theta: slopes.theta.map(by_y),
            psi: larger_or_nan(Float::abs(psi[0]), Float::abs(psi[1])),
            converges: chi_slope <= STEEPEST && in_range,
        }
    }
}

/// Largest dχ/dy at which series may converge fast enough to be used.
const STEEPEST: f64 = 4.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Top, TopParameters};
    use crate::complex::Complex;
    use crate::constants::{BranchPoints, Sign, Signs};
    use crate::phase::Phase;
    use crate::scalar::{Extended, Scalar};
    use crate::table::series::expansion::{TERMS, UNIT};

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
        let e = BranchPoints::<Extended>::exact([e1, e2, e3]).unwrap();
        let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
        PhaseEquations::new(&top, &e, e.integrals_in(&top, signs).l_plus_n, signs)
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
                let size = [beyond.nutation, beyond.alpha, beyond.beta].into_iter().map(f64::abs);
                let unit = 0.02 * spread.sqrt().min(1.0) / size.fold(0.0, f64::max).max(1.0);
                let [chi, alpha, beta] =
                    [rates.nutation, rates.alpha, rates.beta].map(|rate| (rate * unit.into()).to_f64());
                let slopes = Slopes {
                    sine_cosine: (sine, cosine),
                    psi: crate::motion::phase_equations::PhaseRates { nutation: chi, alpha, beta },
                    theta: [alpha, beta],
                    weight: (alpha.abs().max(beta.abs()) / chi).max(1.0),
                };
                let mut expansion = Expansion::EMPTY;
                rounded.expand(&point, &slopes, unit, 1e-18, &mut expansion, &mut || {});
                assert!(expansion.terms > 2, "{spread} {e:?} {turns}");
                for x in [-1.0, 0.5, 1.0] {
                    let (PhasePoint { chi: at, theta }, slope) = expansion.point_and_slope(x);
                    let (sine, cosine) = f64::sine_cosine(at);
                    let rates = exact.rates(sine.into(), cosine.into());
                    let of = |rate: Extended| (rate * unit.into()).to_f64();
                    let [alpha, beta] =
                        expansion.theta.map(|rate| 0.25 * rate.at(0.25 * x, expansion.terms).0);
                    worst[0] = worst[0].max(slopes.weight * (slope - of(rates.nutation)).abs());
                    worst[1] = worst[1].max((alpha - of(rates.alpha)).abs());
                    worst[2] = worst[2].max((beta - of(rates.beta)).abs());
                    let ([p, q], mut re, mut im) = ([0.6, -0.3], [0; TERMS], [0; TERMS]);
                    let mut copy = expansion;
                    copy.turned(0, [p, q], 5, [&mut re, &mut im]).unwrap();
                    let sum =
                        |part: [i64; TERMS]| part.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64 * UNIT);
                    let [up, down] = [at, -at].map(|chi| Complex::cis(chi + theta[0]));
                    let truth = up.scaled(p) + down.scaled(q);
                    worst[3] = worst[3].max((sum(re) - truth.re).abs()).max((sum(im) - truth.im).abs());
                }
            }
        }
        assert!(worst.into_iter().all(|worst| (1e-19..5e-15).contains(&worst)), "{worst:?}");
    }
}
