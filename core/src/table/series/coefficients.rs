//! Coefficients of an expansion, computed one after another.

use crate::table::series::block::{Block, Factor, integrated};
use crate::table::series::expansion::Expansion;
use crate::table::series::integers::{BITS, TERMS, in_range, sum_in_range};
use crate::table::series::rate::{Rate, is_negligible};

/// Constant factors of the recurrence for one slow phase, whose denominator is in the memory of the rate's integral until that is computed.
pub(super) struct SlowFactors {
    pub(super) from_square: Factor,
    pub(super) from_divisor: Factor,
    /// Factors of δ and of the variation of D dχ/dx in that of the denominator.
    pub(super) shares: [Factor; 2],
    pub(super) negligible: i64,
}

/// Constant factors of the recurrence of the coefficients.
pub(super) struct Recurrence {
    pub(super) slow: [SlowFactors; 2],
    /// Factor of cos²χ in η, and factors of cos²χ and of its square in δ.
    pub(super) from_square: [Factor; 3],
    /// Factor from the units of δ to those of ξ.
    pub(super) to_drive: Factor,
    pub(super) to_sine: Factor,
    pub(super) to_cosine: Factor,
    /// Magnitudes below which a term of sin χ, cos χ and ξ is negligible.
    pub(super) negligible: [i64; 3],
    /// Derivatives θ' by y.
    pub(super) theta: [f64; 2],
    /// Larger of the derivatives ψ_A' and ψ_B' by y.
    pub(super) psi: f64,
    /// Whether the series may converge fast enough to be used.
    pub(super) converges: bool,
}

impl SlowFactors {
    /// Computes the k-th coefficients. Returns whether the rate's is negligible, or `None` where one is out of range.
    fn advance(&self, rate: &mut Rate, k: usize, [square, delta, drive]: [i64; 3]) -> Option<bool> {
        let Rate { variation, integral: divisor, .. } = rate;
        let [constant, smoothing] = &self.shares;
        let of_divisor = sum_in_range([constant.times(delta), smoothing.times(drive)])?;
        let known = divisor.product(variation, 1..k, k, -divisor.exponent);
        let of_rate =
            sum_in_range([self.from_square.times(square), -self.from_divisor.times(of_divisor), -known])?;
        let in_range = divisor.put(k, of_divisor) & variation.put(k, of_rate);
        in_range.then_some(is_negligible(of_rate, k, self.negligible))
    }
}

impl Expansion {
    /// Computes the coefficients until two in succession are negligible or all sixteen are known; none where they do not converge.
    #[inline(never)]
    pub(super) fn compute(&mut self, recurrence: &Recurrence, between: &mut dyn FnMut()) {
        let terms = if recurrence.converges { self.recur(recurrence, between) } else { None };
        self.integrate(recurrence, terms.unwrap_or_default());
    }

    /// Number of terms; `None` where a coefficient is out of range.
    fn recur(&mut self, recurrence: &Recurrence, between: &mut dyn FnMut()) -> Option<usize> {
        let mut before = false;
        for k in 0..TERMS {
            if k % 4 == 0 {
                between();
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
        let [eta, linear, quadratic] = &constants.from_square;
        let square = cosine.product(cosine, 0..k + 1, k, BITS);
        let twice = sum_in_range([square_series.product(square_series, 1..k, k, BITS)])?;
        let delta = sum_in_range([linear.times(square), quadratic.times(twice)])?;
        let across = |series: &Block| series.product(xi_series, 1..k, k, -series.exponent);
        // coefficient of (1 + ξ)(1 + δ) without the unknown ξ
        let known = sum_in_range([constants.to_drive.times(delta), across(delta_series)])?;
        let xi = sum_in_range([eta.times(square), -known, -across(drive_series)])? >> 1;
        let drive = known + xi;
        let in_range = square_series.put(k, square)
            & delta_series.put(k, delta)
            & xi_series.put(k, xi)
            & drive_series.put(k, drive);
        in_range.then_some(())?;
        let ([alpha, beta], [alpha_factors, beta_factors]) = (theta, &constants.slow);
        let alpha = alpha_factors.advance(alpha, k, [square, delta, drive])?;
        let beta = beta_factors.advance(beta, k, [square, delta, drive])?;
        let [.., of_xi] = constants.negligible;
        Some(alpha && beta && is_negligible(xi, k, of_xi))
    }

    /// Computes coefficient k + 1 of sin χ and of cos χ. Returns whether both are negligible.
    fn turn(&mut self, recurrence: &Recurrence, k: usize) -> Option<bool> {
        let Self { chi, scratch: [sine_series, cosine_series, ..], .. } = self;
        let xi = &chi.variation;
        let rate = |part: &Block| sum_in_range([part.get(k), xi.product(part, 1..k + 1, k, -xi.exponent)]);
        let sine = integrated(in_range(recurrence.to_sine.times(rate(cosine_series)?))?, k);
        let cosine = integrated(in_range(recurrence.to_cosine.times(rate(sine_series)?))?, k);
        let in_range = sine_series.put(k + 1, sine) & cosine_series.put(k + 1, cosine);
        let [of_sine, of_cosine, _] = recurrence.negligible;
        in_range.then_some(is_negligible(sine, k, of_sine) && is_negligible(cosine, k, of_cosine))
    }

    /// Integrates the rates term by term, after the recurrence has used the integrals' memory.
    #[inline(never)]
    fn integrate(&mut self, recurrence: &Recurrence, terms: usize) {
        self.terms = terms;
        let [.., delta, _] = &self.scratch;
        self.variation_size = recurrence.psi as f32 * (delta.size_at_quarters(3, terms) * delta.short_unit());
        let [alpha, beta] = &mut self.theta;
        [alpha.slope, beta.slope] = recurrence.theta;
        for rate in [&mut self.chi, alpha, beta] {
            rate.integral.exponent = rate.variation.exponent;
            for k in 1..terms {
                // not larger than the coefficient, which is in range
                let _ = rate.integral.put(k, integrated(rate.variation.get(k), k));
            }
        }
        let before = terms.saturating_sub(2);
        self.last_terms = [self.term(before), self.term(before + 1)];
    }
}
