//! Coefficients of an expansion, one after another, by the equations of [`Expansion`]. With S = sin χ and C = cos χ, for k = 1, 2, ...:
//!
//! ```text
//! v_k   = Σ C_i C_(k-i)                    i = 0, ..., k
//! δ_k   = 2 c u₀ v_k - c e Σ v_i v_(k-i)   here and below i = 1, ..., k - 1
//! η_k   = e/(e₃ - u₀) v_k
//! known = δ_k + Σ δ_i ξ_(k-i)
//! ξ_k   = (η_k - known - Σ μ_i ξ_(k-i))/2
//! μ_k   = known + ξ_k
//! κ_k   = g δ_k + h μ_k                    for ψ_α and for ψ_β
//! σ_k   = f v_k - (dψ/dy)₀ κ_k - Σ κ_i σ_(k-i)
//! S_(k+1) =  (dχ/dy)₀ (C_k + Σ ξ_i C_(k-i))/(k + 1)    i = 1, ..., k; also for k = 0
//! C_(k+1) = -(dχ/dy)₀ (S_k + Σ ξ_i S_(k-i))/(k + 1)
//! ```
//!
//! `prepare` chooses the unit of each series, and computes the constant factors between these units.

use super::{Expansion, ExpansionPoint, MAX_TERMS, NOISE, PowerSeries, RateSeries};
use crate::integer::to_units;
use crate::motion::phase_equations::{PhaseEquations, TiltDistances};
use crate::scalar::Ring;
use crate::table::build::path::series::{BITS, UnitFactor, in_range, integrated, sum_in_range};

/// Whether a coefficient is a rounding error, or its term of degree k at x = 1 is below `least` units.
fn is_negligible(coefficient: i64, k: usize, least: i64) -> bool {
    let size = coefficient.abs();
    size <= NOISE || size >> (2 * k) < least
}

/// Constant factors of the recurrence for ψ_α or ψ_β.
struct PsiFactors {
    v_to_sigma: UnitFactor,
    kappa_to_sigma: UnitFactor,
    delta_to_kappa: UnitFactor,
    mu_to_kappa: UnitFactor,
    negligible_below: i64,
}

impl PsiFactors {
    /// Factors from dψ/dy and from f, g and h. Sets the exponents of σ and κ.
    fn new(
        rate: &mut RateSeries,
        kappa: &mut PowerSeries,
        psi_rate: f64,
        [f, g, h]: [f64; 3],
        [v, delta, mu]: [&PowerSeries; 3],
        negligible: f64,
    ) -> Self {
        let RateSeries { variation, scale, .. } = rate;
        kappa.set_exponent(delta.magnitude_times(g) + mu.magnitude_times(h));
        variation.set_exponent(kappa.magnitude_times(psi_rate.abs()) + v.magnitude_times(f.abs()));
        *scale = 1.0;
        Self {
            v_to_sigma: UnitFactor::new(f, v, variation),
            kappa_to_sigma: UnitFactor::new(psi_rate, kappa, variation),
            delta_to_kappa: UnitFactor::new(g, delta, kappa),
            mu_to_kappa: UnitFactor::new(h, mu, kappa),
            negligible_below: to_units(negligible, variation.exponent),
        }
    }

    /// Computes the k-th coefficients of κ and σ. Returns whether the coefficient of σ is negligible.
    fn next_coefficients(
        &self,
        rate: &mut RateSeries,
        kappa_series: &mut PowerSeries,
        k: usize,
        [v, delta, mu]: [i64; 3],
    ) -> Option<bool> {
        let sigma_series = &mut rate.variation;
        let kappa = sum_in_range([self.delta_to_kappa.times(delta), self.mu_to_kappa.times(mu)])?;
        let known = kappa_series.product(sigma_series, 1..k, k, -kappa_series.exponent);
        let sigma = sum_in_range([self.v_to_sigma.times(v), -self.kappa_to_sigma.times(kappa), -known])?;
        kappa_series.set(k, kappa)?;
        sigma_series.set(k, sigma)?;
        Some(is_negligible(sigma, k, self.negligible_below))
    }
}

/// Constant factors of the recurrence.
struct Recurrence {
    psi: [PsiFactors; 2],
    v_to_eta: UnitFactor,
    v_to_delta: UnitFactor,
    v_squared_to_delta: UnitFactor,
    delta_to_mu: UnitFactor,
    cosine_to_sine: UnitFactor,
    sine_to_cosine: UnitFactor,
    negligible_xi: i64,
}

impl Expansion {
    /// Expands the motion around a point.
    pub(crate) fn expand(
        &mut self,
        equations: &PhaseEquations<f64>,
        origin: &ExpansionPoint,
        pause: &mut dyn FnMut(),
    ) {
        let recurrence = self.prepare(equations, origin);
        self.terms = self.compute_series(&recurrence, pause).unwrap_or_default();
    }

    /// Constants of the recurrence. Sets the exponents and first coefficients of the series.
    fn prepare(&mut self, equations: &PhaseEquations<f64>, origin: &ExpansionPoint) -> Recurrence {
        let ExpansionPoint { time_per_y, chi_rate, psi_rates: [alpha_psi, beta_psi], negligible, .. } =
            *origin;
        let TiltDistances { one_minus_u, e3_minus_u, inverse_d, .. } =
            equations.tilt_distances(origin.sine, origin.cosine);
        // factors in η = eta_per_v v and δ = linear v - quadratic v²
        let eta_per_v = equations.e2_minus_e1 / e3_minus_u;
        let c = equations.s * equations.e2_minus_e1 * inverse_d;
        let linear = 2.0 * (c * (1.0 - one_minus_u));
        let quadratic = c * equations.e2_minus_e1;

        let Self { chi, residual: [alpha, beta], sine, cosine, v, delta, mu, .. } = self;
        let magnitude = |value: f64, other: f64| value.abs().larger_or_nan((chi_rate * other).abs());
        sine.set_exponent(magnitude(origin.sine, origin.cosine));
        cosine.set_exponent(magnitude(origin.cosine, origin.sine));
        v.exponent = 2 * cosine.exponent + BITS;
        let delta_size = v.magnitude_times(linear.abs() + v.magnitude_times(quadratic));
        delta.set_exponent(delta_size);
        mu.set_exponent(delta_size + v.magnitude_times(eta_per_v));
        chi.variation.exponent = mu.exponent;
        (chi.at_origin, chi.scale) = (chi_rate, chi_rate);
        // in range by their exponents
        let _ = sine.set(0, to_units(origin.sine, sine.exponent));
        let _ = cosine.set(0, to_units(origin.cosine, cosine.exponent));

        let scale = time_per_y * time_per_y * equations.e2_minus_e1 * inverse_d;
        // f, g and h of a ψ
        let factors = |numerator: f64, constant: f64, chi_time: f64| {
            let chi = chi_time * chi_rate;
            let inverse_divisor = 1.0 / (constant + chi);
            [numerator * (scale * inverse_divisor), constant * inverse_divisor, chi * inverse_divisor]
        };
        let of_alpha =
            factors(equations.s * equations.alpha_rate_factor, time_per_y, equations.alpha_chi_time);
        let of_beta = factors(
            -equations.s_times_e3_minus_one * equations.beta_rate_factor,
            time_per_y * equations.root_e3_minus_one,
            equations.beta_chi_time,
        );
        let series = [&*v, &*delta, &*mu];
        let [alpha_kappa, beta_kappa] = &mut self.kappa;
        let psi = [
            PsiFactors::new(alpha, alpha_kappa, alpha_psi, of_alpha, series, negligible),
            PsiFactors::new(beta, beta_kappa, beta_psi, of_beta, series, negligible),
        ];
        [alpha.at_origin, beta.at_origin] = origin.residual_rates;
        (self.origin, self.rotation_per_chi_error) = (origin.phases, origin.rotation_per_chi_error as f32);
        let negligible_xi = (negligible / (origin.rotation_per_chi_error * chi_rate).abs()).min(f64::MAX);
        Recurrence {
            psi,
            v_to_eta: UnitFactor::new(eta_per_v, v, mu),
            v_to_delta: UnitFactor::new(linear, v, delta),
            v_squared_to_delta: UnitFactor::new(-v.magnitude_times(quadratic), v, delta),
            delta_to_mu: UnitFactor::new(1.0, delta, mu),
            cosine_to_sine: UnitFactor::new(chi_rate, cosine, sine),
            sine_to_cosine: UnitFactor::new(-chi_rate, sine, cosine),
            negligible_xi: to_units(negligible_xi, mu.exponent),
        }
    }

    /// Computes coefficients until two in succession are negligible. Returns their number.
    fn compute_series(&mut self, recurrence: &Recurrence, pause: &mut dyn FnMut()) -> Option<usize> {
        let mut before = false;
        for k in 0..MAX_TERMS {
            if k % 4 == 0 {
                pause();
            }
            let negligible = k > 0 && self.next_rates(recurrence, k)?;
            self.next_sine_cosine(recurrence, k)?;
            if negligible && before {
                return Some(k + 1);
            }
            before = negligible;
        }
        Some(MAX_TERMS)
    }

    /// Computes the k-th coefficients of the rates. Returns whether they are negligible.
    fn next_rates(&mut self, recurrence: &Recurrence, k: usize) -> Option<bool> {
        let xi_series = &mut self.chi.variation;
        let v = self.cosine.product(&self.cosine, 0..k + 1, k, BITS);
        let v_squared = sum_in_range([self.v.product(&self.v, 1..k, k, BITS)])?;
        let delta =
            sum_in_range([recurrence.v_to_delta.times(v), recurrence.v_squared_to_delta.times(v_squared)])?;
        let mixed = |series: &PowerSeries| series.product(xi_series, 1..k, k, -series.exponent);
        // μ = known + ξ, and (1 + ξ) (1 + μ) = 1 + η
        let known = sum_in_range([recurrence.delta_to_mu.times(delta), mixed(&self.delta)])?;
        let eta = recurrence.v_to_eta.times(v);
        let xi = sum_in_range([eta, -known, -mixed(&self.mu)])? >> 1;
        let mu = known + xi;
        self.v.set(k, v)?;
        self.delta.set(k, delta)?;
        xi_series.set(k, xi)?;
        self.mu.set(k, mu)?;
        let mut negligible = is_negligible(xi, k, recurrence.negligible_xi);
        let series = self.residual.iter_mut().zip(&mut self.kappa);
        for ((rate, kappa), factors) in series.zip(&recurrence.psi) {
            negligible &= factors.next_coefficients(rate, kappa, k, [v, delta, mu])?;
        }
        Some(negligible)
    }

    /// Computes coefficient k + 1 of sin χ and of cos χ.
    fn next_sine_cosine(&mut self, recurrence: &Recurrence, k: usize) -> Option<()> {
        let xi = &self.chi.variation;
        let next = |factor: &UnitFactor, part: &PowerSeries| {
            let rate = sum_in_range([part.coefficient(k), xi.product(part, 1..k + 1, k, -xi.exponent)])?;
            Some(integrated(in_range(factor.times(rate))?, k))
        };
        let sine = next(&recurrence.cosine_to_sine, &self.cosine)?;
        let cosine = next(&recurrence.sine_to_cosine, &self.sine)?;
        self.sine.set(k + 1, sine)?;
        self.cosine.set(k + 1, cosine)
    }
}
