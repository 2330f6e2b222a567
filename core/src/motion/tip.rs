//! Curve c = 2 s αβ that the tip draws on the plane, and its angle (section 4 of the paper).

use crate::complex::Complex;
use crate::motion::Motion;
use crate::motion::attitude_state::AttitudeState;
use crate::scalar::Float;
use crate::su2::Orientation;

/// Constants of the tip curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TipConstants<R> {
    /// Length 2 s, m; 2 for a fixed tip.
    scale: R,
    /// Rates (l + n)/(4A) and (l - n)/(4A), rad per unit time.
    momenta: [R; 2],
}

impl<R: Float> TipConstants<R> {
    pub(crate) fn new(motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let per_a = 0.25 / top.transverse_inertia();
        let momenta = [integrals.l_plus_n, integrals.l_minus_n];
        Self {
            scale: R::from_f64(2.0 * top.tip_scale()),
            momenta: momenta.map(|momentum| R::from_f64(momentum * per_a)),
        }
    }

    /// Tip position c = 2 s αβ, m.
    pub(crate) fn tip(&self, orientation: &Orientation<R>) -> Complex<R> {
        (orientation.alpha * orientation.beta).scaled(self.scale)
    }

    /// Velocity c' of the tip, m per unit time.
    pub(crate) fn velocity(&self, AttitudeState { orientation, rate }: &AttitudeState<R>) -> Complex<R> {
        (rate.alpha * orientation.beta + orientation.alpha * rate.beta).scaled(self.scale)
    }

    /// Rate φ' = (l+n)/(4A |α|²) + (l-n)/(4A |β|²) of the tip angle, at most the largest finite `f32`; without a term whose
    /// Cayley-Klein parameter is 0.
    pub(crate) fn angle_rate(&self, orientation: &Orientation<R>) -> R {
        let part = |momentum: R, z: Complex<R>| {
            let (re, im) = (z.re.abs(), z.im.abs());
            let size = if re > im { re } else { im };
            if momentum == R::ZERO || size == R::ZERO {
                return R::ZERO;
            }
            // |z|² may underflow and 1/|z| overflow where the quotient does neither
            let inverse = R::ONE / size;
            let direction = if inverse.to_f64().is_finite() {
                z.scaled(inverse)
            } else {
                Complex::new(z.re / size, z.im / size)
            };
            momentum / size / size / direction.norm_squared()
        };
        let [plus, minus] = self.momenta;
        let rate = part(plus, orientation.alpha) + part(minus, orientation.beta);
        if rate.to_f64().is_finite() {
            return rate;
        }
        let greatest = R::from_f64(f32::MAX.into());
        if rate < R::ZERO { -greatest } else { greatest }
    }
}
