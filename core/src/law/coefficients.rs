//! Coefficients of an expansion, computed one after another.

use crate::law::block::{BITS, Block, TERMS, in_range, integrated, sum_in_range};
use crate::law::rate::{Rate, is_negligible};
use crate::law::recurrence::SlowFactors;
use crate::law::series::Expansion;

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

/// Largest number of coefficients that one call of [`Expansion::proceed`] computes.
const COEFFICIENTS_PER_CALL: usize = 9;

impl Expansion {
    /// Computes more coefficients, until two in succession are negligible or all sixteen are known. Returns whether the
    /// expansion is complete; it has no terms where the series do not converge.
    #[inline(never)]
    pub(crate) fn proceed(&mut self) -> bool {
        let first = self.recurrence.next;
        for k in first..TERMS.min(first + COEFFICIENTS_PER_CALL) {
            self.recurrence.next = k + 1;
            let rates = if k == 0 { Some(false) } else { self.advance(k) };
            let negligible = rates.and_then(|rates| Some(self.turn(k)? && rates));
            let terms = match negligible {
                Some(true) if self.recurrence.before => k + 1,
                Some(_) if k + 1 == TERMS => TERMS,
                Some(negligible) => {
                    self.recurrence.before = negligible;
                    continue;
                }
                None => 0,
            };
            self.recurrence.next = TERMS;
            self.complete(terms);
            return true;
        }
        self.recurrence.next >= TERMS
    }

    /// Computes the k-th coefficients of the rates: (1 + ξ)² (1 + δ) = 1 + η.
    fn advance(&mut self, k: usize) -> Option<bool> {
        let Self { chi, theta, scratch: [_, cosine, square_series, delta_series, drive_series], .. } = self;
        let (constants, xi_series) = (&self.recurrence, &mut chi.variation);
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
    fn turn(&mut self, k: usize) -> Option<bool> {
        let Self { chi, scratch: [sine_series, cosine_series, ..], recurrence, .. } = self;
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
    fn complete(&mut self, terms: usize) {
        self.terms = terms;
        let [.., delta, _] = &self.scratch;
        self.variation_size =
            self.recurrence.psi as f32 * (delta.size_at_quarters(3, terms) * delta.short_unit());
        let [alpha, beta] = &mut self.theta;
        [alpha.slope, beta.slope] = self.recurrence.theta;
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
