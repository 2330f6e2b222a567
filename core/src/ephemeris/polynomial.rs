//! Polynomials of α and β in integers, and their restriction to half of an interval.

use crate::law::series::{TERMS, over_power};

/// Power series of α or of β in x ∈ [-1, 1], on a span of the half period or on a part of it, lowest power first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polynomial {
    /// Coefficients of the real and of the imaginary part, in units of 2^-62.
    pub(crate) parts: [[i64; TERMS]; 2],
    /// Number of terms; coefficients beyond them are 0.
    pub(crate) terms: usize,
    /// Sum of the magnitudes of the terms removed.
    pub(crate) removed: i64,
}

impl Polynomial {
    /// Polynomial with all terms.
    pub(crate) const fn of(parts: [[i64; TERMS]; 2]) -> Self {
        Self { parts, terms: TERMS, removed: 0 }
    }

    /// Replaces the series on [-1, 1] by that on the lower or the upper half of the interval, whose own coordinate is in [-1, 1]. Last
    /// terms of at most `least` are removed. Rounding error: about two units of the coefficients.
    pub(crate) fn halve(&mut self, lower: bool, least: i64) {
        while let Some(last) = self.terms.checked_sub(1) {
            let size = |series: &[i64; TERMS]| series.get(last).map_or(0, |c| c.abs());
            let [re, im] = self.parts.each_ref().map(size);
            if re.max(im) > least {
                break;
            }
            self.removed += re + im;
            self.terms = last;
            self.parts.iter_mut().filter_map(|series| series.get_mut(last)).for_each(|c| *c = 0);
        }
        for series in &mut self.parts {
            halve(series.get_mut(..self.terms).unwrap_or_default(), lower);
        }
    }
}

/// Replaces a series in x by that in x', where x = (x' + 1)/2, or x = (x' - 1)/2 for the lower half.
#[inline(never)] // a call for the real and for the imaginary part
fn halve(coefficients: &mut [i64], lower: bool) {
    // the lower half of a series is the mirror image of the upper half of the mirrored series
    if lower {
        coefficients.iter_mut().skip(1).step_by(2).for_each(|c| *c = -*c);
    }
    // in x - 1/2: one sum completes a coefficient, and the next one, which adds up the sums before, completes its successor
    for first in (0..coefficients.len()).step_by(2) {
        let rest = coefficients.get_mut(first..).unwrap_or_default();
        let (mut first_sum, mut second_sum) = (0_i64, 0_i64);
        // where the second sum belongs, which is one coefficient behind
        let mut behind = &mut 0;
        for c in rest.iter_mut().rev() {
            second_sum = first_sum + (second_sum >> 1);
            first_sum = *c + (first_sum >> 1);
            *behind = second_sum;
            behind = c;
        }
        *behind = first_sum;
    }
    for (c, power) in coefficients.iter_mut().zip(0..).skip(1) {
        let twice = if power == 1 { *c } else { over_power(*c, power - 1) };
        let halved = (twice + 1) >> 1;
        *c = if lower && power & 1 == 1 { -halved } else { halved };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::series::UNIT;

    /// The series of every part has the values of the whole, also where it fills the range of the integers.
    #[test]
    fn a_part_has_the_values_of_the_whole() {
        for (ratio, sense) in [(0.3_f64, 1.0), (0.24, -1.0), (0.05, 1.0)] {
            let mut whole = [0; TERMS];
            for (power, c) in whole.iter_mut().enumerate() {
                let sign = if power % 2 == 1 { sense } else { 1.0 };
                *c = (sign * (1.0 - ratio) * ratio.powi(power as i32) / UNIT) as i64;
            }
            let value = |series: &[i64; TERMS], x: f64| {
                UNIT * series.iter().rev().fold(0.0, |sum, c| sum * x + *c as f64)
            };
            for halvings in 0..5 {
                let parts = 1 << halvings;
                for part in 0..parts {
                    let mut polynomial = Polynomial::of([whole, [0; TERMS]]);
                    for halving in (0..halvings).rev() {
                        polynomial.halve(part >> halving & 1 == 0, 0);
                    }
                    let [own, nothing] = polynomial.parts;
                    assert_eq!((polynomial.removed, nothing), (0, [0; TERMS]));
                    for x in [-1.0, -0.3, 0.0, 0.7, 1.0] {
                        let place = (x + (2 * part + 1) as f64) / parts as f64 - 1.0;
                        let error = value(&own, x) - value(&whole, place);
                        assert!(error.abs() < 4e-16, "{ratio} {part}/{parts} {x}: {error:e}");
                    }
                    // the last bits, which f64 does not show
                    let centre = whole.iter().rev().fold(0_i128, |sum, c| {
                        sum * (2 * part as i128 + 1 - parts as i128) / parts as i128 + i128::from(*c)
                    });
                    let error = i128::from(own[0]) - centre;
                    assert!(error.abs() <= 3 * halvings as i128 + 3, "{part}/{parts}: {error}");
                }
            }
        }
    }
}
