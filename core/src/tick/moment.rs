//! One moment of an ephemeris: three phases, and on demand what follows from them.

use super::{Ephemeris, Pose};
use crate::complex::Complex;
use crate::cycle::Cycle;
use crate::real::Scalar;
use crate::su2::{Phi, PhiRate};
use crate::turns::Turns;

/// A moment. Nothing is computed before it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a, R, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) ephemeris: &'a Ephemeris<R, SEGMENTS, TERMS>,
    /// The 64 leading bits of nutation phase, A and B.
    pub(super) phases: [u64; 3],
}

impl<R: Scalar, const SEGMENTS: usize, const TERMS: usize> Moment<'_, R, SEGMENTS, TERMS> {
    /// The nutation phase: one turn a period, 0 at u = e₁, half a turn at u = e₂ (where an aperiodic motion stops).
    #[must_use]
    pub fn nutation_phase(&self) -> Turns {
        let [nutation, ..] = self.phases;
        Cycle::new((nutation >> 32) as u32, nutation << 32).to_turns()
    }

    /// The orientation Φ; γ, δ and u follow from it.
    #[inline(always)]
    #[must_use]
    pub fn phi(&self) -> Phi<R> {
        let (share, mirrored) = self.share();
        let [alpha, beta] = mirror(self.ephemeris.table.value(share), mirrored);
        let [a, b] = rotations(self.phases);
        Phi { alpha: alpha * a, beta: beta * b }
    }

    /// Φ and Φ', from which u' and ω follow.
    #[must_use]
    pub fn pose(&self) -> Pose<R> {
        let (share, mirrored) = self.share();
        let (value, slope) = self.ephemeris.table.value_and_slope(share);
        let [x_rate, alpha_rate, beta_rate] = self.ephemeris.clock.rates;
        // on the falling half x runs backwards
        let x_rate = if mirrored { -x_rate } else { x_rate };
        let [a, b] = rotations(self.phases);
        let [alpha, beta] = mirror(value, mirrored);
        let [alpha_slope, beta_slope] = mirror(slope, mirrored);
        let rate = |value: Complex<R>, slope: Complex<R>, turning: R| {
            slope.scaled(x_rate) + value.times_i().scaled(turning)
        };
        Pose {
            phi: Phi { alpha: alpha * a, beta: beta * b },
            rate: PhiRate {
                alpha: rate(alpha, alpha_slope, alpha_rate) * a,
                beta: rate(beta, beta_slope, beta_rate) * b,
            },
        }
    }

    /// The tip, c = 2 s αβ in m (2 αβ for a fixed tip).
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R> {
        let phi = self.phi();
        (phi.alpha * phi.beta).scaled(self.ephemeris.clock.tip_scale)
    }

    /// Φ and the tip in one evaluation.
    #[inline(always)]
    #[must_use]
    pub fn phi_and_tip(&self) -> (Phi<R>, Complex<R>) {
        let phi = self.phi();
        (phi, (phi.alpha * phi.beta).scaled(self.ephemeris.clock.tip_scale))
    }

    /// The share of the half period as 64 bits, and whether it is the falling half.
    #[inline(always)]
    fn share(&self) -> (u64, bool) {
        let [bits, ..] = self.phases;
        let mirrored = (bits as i64) < 0;
        ((if mirrored { !bits } else { bits }) << 1, mirrored)
    }
}

/// Re α, Im α, Re β, Im β as complex numbers, conjugate on the falling half.
#[inline(always)]
fn mirror<R: Scalar>(four: [R; 4], mirrored: bool) -> [Complex<R>; 2] {
    let [re_alpha, im_alpha, re_beta, im_beta] = four;
    let sign = |y: R| if mirrored { -y } else { y };
    [Complex::new(re_alpha, sign(im_alpha)), Complex::new(re_beta, sign(im_beta))]
}

/// e^{iA} and e^{iB}.
#[inline(always)]
fn rotations<R: Scalar>(phases: [u64; 3]) -> [Complex<R>; 2] {
    let [_, a, b] = phases;
    R::sine_cosine_pair([a, b]).map(|(im, re)| Complex::new(re, im))
}
