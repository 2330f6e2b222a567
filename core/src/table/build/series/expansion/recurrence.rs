//! Coefficients of the rates of an expansion, one after another.

use super::{Expansion, NOISE, Rate, Slopes, larger_or_nan};
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::{Extended, Float};
use crate::table::build::series::{BITS, Block, Factor, TERMS, in_range, integrated, scaled, sum_in_range};

/// Whether the k-th coefficient is a rounding error, or its term at y = 1/2 is below `least` units.
fn is_negligible(coefficient: i64, k: usize, least: i64) -> bool {
    let size = coefficient.abs();
    size <= NOISE || size >> k < least
}

/// Constant factors of the recurrence for one slow phase.
struct SlowFactors {
    /// Factor of cos²χ in the rate.
    square: Factor,
    /// Factor of the denominator in the rate.
    divisor: Factor,
    /// Factors of D and of D dχ/dx in the denominator.
    delta: Factor,
    drive: Factor,
    negligible: i64,
}

impl SlowFactors {
    /// Factors for a rate, from the values of those of cos²χ, D and D dχ/dx. It sets the exponents of the series.
    fn new(
        rate: &mut Rate,
        slope: f64,
        [of_square, of_delta, of_drive]: [f64; 3],
        [square, delta, drive]: [&Block; 3],
        least: f64,
    ) -> Self {
        let Rate { variation, divisor, scale, .. } = rate;
        divisor.scale_for(delta.magnitude_times(of_delta) + drive.magnitude_times(of_drive));
        variation.scale_for(
            divisor.magnitude_times(Float::abs(slope)) + square.magnitude_times(Float::abs(of_square)),
        );
        *scale = 1.0;
        Self {
            square: Factor::new(of_square, square, variation),
            divisor: Factor::new(slope, divisor, variation),
            delta: Factor::new(of_delta, delta, divisor),
            drive: Factor::new(of_drive, drive, divisor),
            negligible: scaled(least, variation.exponent),
        }
    }

    /// Computes the k-th coefficients. Returns whether that of the rate is negligible; `None` where one is out of range.
    fn advance(&self, rate: &mut Rate, k: usize, [square, delta, drive]: [i64; 3]) -> Option<bool> {
        let Rate { variation, divisor, .. } = rate;
        let of_divisor = sum_in_range([self.delta.times(delta), self.drive.times(drive)])?;
        let known = divisor.product(variation, 1..k, k, -divisor.exponent);
        let of_rate = sum_in_range([self.square.times(square), -self.divisor.times(of_divisor), -known])?;
        divisor.put(k, of_divisor)?;
        variation.put(k, of_rate)?;
        Some(is_negligible(of_rate, k, self.negligible))
    }
}

/// Constant factors of the recurrence of the coefficients.
struct Recurrence {
    slow: [SlowFactors; 2],
    /// Factor of cos²χ in η.
    eta: Factor,
    /// Factors of cos²χ and of its square in δ.
    linear: Factor,
    quadratic: Factor,
    /// Factor from the units of δ to those of ξ.
    to_drive: Factor,
    to_sine: Factor,
    to_cosine: Factor,
    /// Magnitudes below which a term of sin χ, cos χ and ξ is negligible.
    negligible_sine: i64,
    negligible_cosine: i64,
    negligible_xi: i64,
}

/// Largest dχ/dy at which series may converge fast enough to be used.
const STEEPEST: f64 = 4.0;

impl Expansion {
    /// Expands the motion around a point.
    #[inline(never)]
    pub(crate) fn expand(
        &mut self,
        equations: &PhaseEquations<Extended>,
        slopes: &Slopes,
        pause: &mut dyn FnMut(),
    ) {
        let recurrence = self.begin(equations, slopes);
        self.terms = self.recur(&recurrence, pause).unwrap_or_default();
        let [.., delta, _] = &self.scratch;
        self.variation_size *= delta.size(3, self.terms, 0.0);
    }

    /// Constants of the recurrence, and the first coefficients.
    #[inline(never)] // the frame must not remain below those of the recurrence
    fn begin(&mut self, equations: &PhaseEquations<Extended>, slopes: &Slopes) -> Recurrence {
        let equations: PhaseEquations<f64> = equations.cast();
        let Slopes { sine: point_sine, cosine: point_cosine, unit, chi: chi_slope, least, .. } = *slopes;
        let swing = equations.e2_minus_e1 * point_cosine * point_cosine;
        let one_minus_u = swing + equations.one_minus_e2;
        let one_plus_u = equations.one_plus_e1 + equations.e2_minus_e1 * point_sine * point_sine;
        let per_d = 1.0 / (equations.a_over_p + equations.s * one_minus_u * one_plus_u);
        let eta = equations.e2_minus_e1 / (equations.e3_minus_e2 + swing);
        let s_per_d = equations.s * equations.e2_minus_e1 * per_d;
        let (linear, quadratic) = (2.0 * (s_per_d * (1.0 - one_minus_u)), s_per_d * equations.e2_minus_e1);

        // sin χ and cos χ, and the variations of cos²χ, of D and of D dχ/dx
        let Self { chi, theta: [alpha, beta], scratch: [sine, cosine, square, delta, drive], .. } = self;
        let magnitude = |own: f64, other: f64| larger_or_nan(Float::abs(own), Float::abs(chi_slope * other));
        sine.scale_for(magnitude(point_sine, point_cosine));
        cosine.scale_for(magnitude(point_cosine, point_sine));
        square.exponent = 2 * cosine.exponent + BITS;
        let delta_size = square.magnitude_times(Float::abs(linear) + square.magnitude_times(quadratic));
        delta.scale_for(delta_size);
        drive.scale_for(delta_size + square.magnitude_times(eta));
        chi.variation.exponent = drive.exponent;
        (chi.slope, chi.scale) = (chi_slope, chi_slope);
        // in range by their exponents
        let _ = sine.put(0, scaled(point_sine, sine.exponent));
        let _ = cosine.put(0, scaled(point_cosine, cosine.exponent));

        // the denominators of ψ_A' and ψ_B' over D are combinations of 1 and dχ/dx
        let scale = unit * unit * equations.e2_minus_e1 * per_d;
        let factors = |numerator: f64, constant: f64, smoothing: f64| {
            let smoothed = smoothing * chi_slope;
            let per_divisor = 1.0 / (constant + smoothed);
            [numerator * (scale * per_divisor), constant * per_divisor, smoothed * per_divisor]
        };
        let of_alpha = factors(equations.s * equations.alpha_scale, unit, equations.alpha_smoothing);
        let of_beta = factors(
            -equations.s_times_e3_minus_one * equations.beta_scale,
            unit * equations.root_e3_minus_one,
            equations.beta_smoothing,
        );
        let series = [&*square, &*delta, &*drive];
        let [alpha_psi, beta_psi] = slopes.psi;
        let slow = [
            SlowFactors::new(alpha, alpha_psi, of_alpha, series, least),
            SlowFactors::new(beta, beta_psi, of_beta, series, least),
        ];
        [alpha.slope, beta.slope] = slopes.theta;
        (self.origin, self.weight) = (slopes.point, slopes.weight as f32);
        self.variation_size = larger_or_nan(Float::abs(alpha_psi), Float::abs(beta_psi)) as f32;
        let least_xi = (least / Float::abs(slopes.weight * chi_slope)).min(f64::MAX);
        Recurrence {
            slow,
            eta: Factor::new(eta, square, drive),
            linear: Factor::new(linear, square, delta),
            quadratic: Factor::new(-square.magnitude_times(quadratic), square, delta),
            to_drive: Factor::new(1.0, delta, drive),
            to_sine: Factor::new(chi_slope, cosine, sine),
            to_cosine: Factor::new(-chi_slope, sine, cosine),
            negligible_sine: scaled(least, sine.exponent),
            negligible_cosine: scaled(least, cosine.exponent),
            negligible_xi: scaled(least_xi, drive.exponent),
        }
    }

    /// Computes the coefficients until two in succession are negligible. Returns their number; `None` where one is out of range.
    #[inline(never)]
    fn recur(&mut self, recurrence: &Recurrence, pause: &mut dyn FnMut()) -> Option<usize> {
        (self.chi.slope <= STEEPEST).then_some(())?;
        let mut before = false;
        for k in 0..TERMS {
            if k % 4 == 0 {
                pause();
            }
            let rates = k > 0 && self.advance(recurrence, k)?;
            let negligible = self.turn(recurrence, k)? && rates;
            if negligible && before {
                return Some(k + 1);
            }
            before = negligible;
        }
        Some(TERMS)
    }

    /// Computes the k-th coefficients of the rates: (1 + ξ)² (1 + δ) = 1 + η.
    fn advance(&mut self, constants: &Recurrence, k: usize) -> Option<bool> {
        let Self { chi, theta, scratch: [_, cosine, square_series, delta_series, drive_series], .. } = self;
        let xi_series = &mut chi.variation;
        let square = cosine.product(cosine, 0..k + 1, k, BITS);
        let twice = sum_in_range([square_series.product(square_series, 1..k, k, BITS)])?;
        let delta = sum_in_range([constants.linear.times(square), constants.quadratic.times(twice)])?;
        let across = |series: &Block| series.product(xi_series, 1..k, k, -series.exponent);
        // coefficient of (1 + ξ)(1 + δ) without the unknown ξ
        let known = sum_in_range([constants.to_drive.times(delta), across(delta_series)])?;
        let xi = sum_in_range([constants.eta.times(square), -known, -across(drive_series)])? >> 1;
        let drive = known + xi;
        square_series.put(k, square)?;
        delta_series.put(k, delta)?;
        xi_series.put(k, xi)?;
        drive_series.put(k, drive)?;
        let mut negligible = is_negligible(xi, k, constants.negligible_xi);
        for (rate, factors) in theta.iter_mut().zip(&constants.slow) {
            negligible &= factors.advance(rate, k, [square, delta, drive])?;
        }
        Some(negligible)
    }

    /// Computes coefficient k + 1 of sin χ and of cos χ. Returns whether both are negligible.
    fn turn(&mut self, recurrence: &Recurrence, k: usize) -> Option<bool> {
        let Self { chi, scratch: [sine_series, cosine_series, ..], .. } = self;
        let xi = &chi.variation;
        let next = |factor: &Factor, part: &Block| {
            let rate = sum_in_range([part.get(k), xi.product(part, 1..k + 1, k, -xi.exponent)])?;
            Some(integrated(in_range(factor.times(rate))?, k))
        };
        let sine = next(&recurrence.to_sine, cosine_series)?;
        let cosine = next(&recurrence.to_cosine, sine_series)?;
        sine_series.put(k + 1, sine)?;
        cosine_series.put(k + 1, cosine)?;
        Some(
            is_negligible(sine, k, recurrence.negligible_sine)
                && is_negligible(cosine, k, recurrence.negligible_cosine),
        )
    }
}
