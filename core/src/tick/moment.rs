//! One moment of an ephemeris: three phases, and on demand what follows from them.

use super::table::Spot;
use super::tabular::{Place, Tabular};
use super::{Ephemeris, Pose};
use crate::complex::Complex;
use crate::real::{Float, Ring};
use crate::su2::{Phi, PhiRate};
use crate::turns::Turns;

/// A moment. Nothing is computed before it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a, R: Tabular, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) ephemeris: &'a Ephemeris<R, SEGMENTS, TERMS>,
    /// The 64 leading bits of nutation phase, A and B.
    pub(super) phases: [u64; 3],
}

impl<R: Tabular, const SEGMENTS: usize, const TERMS: usize> Moment<'_, R, SEGMENTS, TERMS> {
    /// The nutation phase: one turn a period, 0 at u = e₁, half a turn at u = e₂ (where an aperiodic motion stops).
    #[must_use]
    pub fn nutation_phase(&self) -> Turns {
        let [nutation, ..] = self.phases;
        turns(nutation)
    }

    /// The orientation Φ; γ, δ and u follow from it.
    #[inline(always)]
    #[must_use]
    pub fn phi(&self) -> Phi<R> {
        let (spot, place) = self.place();
        let [alpha, beta] = R::alpha_beta(spot.terms, place);
        Phi { alpha, beta }
    }

    /// The tip, c = 2 s αβ in m (2αβ for a fixed tip); in fixed point in units of s, as 2αβ: for metres [`Moment::wide_tip`].
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R> {
        let (_, tip) = self.phi_and_tip();
        tip
    }

    /// Φ and the tip of [`Moment::tip`] in one evaluation.
    #[inline(always)]
    #[must_use]
    pub fn phi_and_tip(&self) -> (Phi<R>, Complex<R>) {
        let phi = self.phi();
        (phi, R::tip(phi.alpha * phi.beta, self.ephemeris.clock.tip_scale))
    }

    /// Where in the table, and where on the segment.
    #[inline(always)]
    fn place(&self) -> (Spot<'_, R::Coefficient>, Place) {
        let [nutation, a, b] = self.phases;
        let mirrored = (nutation as i64) < 0;
        let share = (nutation ^ ((nutation as i64) >> 63) as u64) << 1;
        let spot = self.ephemeris.table.find(share);
        let (x, short_x) = (spot.x, spot.short_x);
        (spot, Place { x, short_x, mirrored, slow: [a, b] })
    }

    /// The tip in units of length whatever the scalar: in `f32` where that is fixed point.
    #[must_use]
    pub fn wide_tip(&self) -> Complex<R::Wide> {
        let Phi { alpha, beta } = self.wide_phi();
        (alpha * beta).scaled(self.ephemeris.clock.tip_scale)
    }

    /// Φ, in `f32` where the scalar is fixed point.
    #[must_use]
    pub fn wide_phi(&self) -> Phi<R::Wide> {
        let wide = |number: Complex<R>| Complex::new(number.re.widened(), number.im.widened());
        let phi = self.phi();
        Phi { alpha: wide(phi.alpha), beta: wide(phi.beta) }
    }

    /// Φ and Φ', from which u' and ω follow; in `f32` where the scalar is fixed point. Some three times the work of Φ alone.
    #[must_use]
    pub fn pose(&self) -> Pose<R::Wide> {
        let (Spot { terms, level, .. }, place) = self.place();
        let [x_rate, alpha_rate, beta_rate] = self.ephemeris.clock.rates;
        let x_rate = x_rate * R::Wide::from_f64(f64::from(1_u16 << level));
        // on the falling half x runs backwards
        let x_rate = if place.mirrored { -x_rate } else { x_rate };
        let x = R::Wide::from_f64(place.x as f64 / (1_u64 << 63) as f64);
        let (value, slope) = value_and_slope::<R>(terms, x);
        let [alpha, beta] = conjugate_if(place.mirrored, value);
        let [alpha_slope, beta_slope] = conjugate_if(place.mirrored, slope);
        let rate = |value: Complex<R::Wide>, slope: Complex<R::Wide>, turning: R::Wide| {
            slope.scaled(x_rate) + value.times_i().scaled(turning)
        };
        let [a, b] = place.slow.map(|phase| Complex::cis(turns(phase)));
        Pose {
            phi: self.wide_phi(),
            rate: PhiRate {
                alpha: rate(alpha, alpha_slope, alpha_rate) * a,
                beta: rate(beta, beta_slope, beta_rate) * b,
            },
        }
    }
}

/// The four polynomials at x, and their derivatives.
fn value_and_slope<R: Tabular>(terms: &[[R::Coefficient; 4]], x: R::Wide) -> ([R::Wide; 4], [R::Wide; 4]) {
    let (mut four, mut slope) = ([R::Wide::ZERO; 4], [R::Wide::ZERO; 4]);
    for (power, coefficients) in terms.iter().enumerate().rev() {
        for ((sum, slope), &c) in four.iter_mut().zip(&mut slope).zip(coefficients) {
            *slope = *slope * x + *sum;
            *sum = *sum * x + R::number(c, power);
        }
    }
    (four, slope)
}

/// Re α, Im α, Re β, Im β as complex numbers.
fn conjugate_if<R: Ring>(mirrored: bool, [re_alpha, im_alpha, re_beta, im_beta]: [R; 4]) -> [Complex<R>; 2] {
    let sign = |y: R| if mirrored { -y } else { y };
    [Complex::new(re_alpha, sign(im_alpha)), Complex::new(re_beta, sign(im_beta))]
}

/// From the 64 leading bits of a share of a turn.
fn turns(leading: u64) -> Turns {
    Turns::from_bits(i128::from(leading) << 32)
}
