//! The curve that the tip draws on the plane, c = 2 s αβ, and its angle (section 4 of the paper).

use super::Pose;
use crate::complex::Complex;
use crate::launch::Motion;
use crate::real::Float;
use crate::su2::Phi;
use crate::turns::Turns;

/// The tip at one instant, relative to the point of the plane below the centre of mass.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tip<R> {
    /// c = x + i y = 2 s αβ, m; 2 αβ (no unit) for a fixed tip.
    pub c: Complex<R>,
    /// c', the velocity of the tip, m per unit time.
    pub velocity: Complex<R>,
    /// φ = arg c and its rate; `None` where the axis is vertical for ever.
    pub angle: Option<TipAngle<R>>,
}

/// The tip angle, continued along the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TipAngle<R> {
    /// φ, with φ(0) within half a turn of 0. Where the curve passes through the centre (e₁ = -1 or e₂ = 1) φ is smooth there and
    /// the radius changes sign: c = ±ρ e^{iφ}.
    pub phi: Turns,
    /// φ', rad per unit time (eqn:dphi): ((l + n)/(1 + u) + (l - n)/(1 - u))/(2A). Where that is beyond `f32`, as it is for
    /// an instant in a motion that misses the vertical by 1e-30, its greatest number.
    pub rate: R,
}

impl<R: Float> Tip<R> {
    /// ρ = |c| = s √(1 - u²), m.
    #[must_use]
    pub fn rho(&self) -> R {
        self.c.norm_squared().sqrt()
    }

    /// |c'|, m per unit time.
    #[must_use]
    pub fn speed(&self) -> R {
        self.velocity.norm_squared().sqrt()
    }
}

/// The number; of one that has left the range of `f32`, the greatest with its sign.
fn saturated<R: Float>(x: R) -> R {
    if x.to_f64().is_finite() {
        return x;
    }
    let greatest = R::from_f64(f32::MAX.into());
    if x < R::ZERO { -greatest } else { greatest }
}

/// What the tip needs to know of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TipLaw<R> {
    /// 2 s.
    scale: R,
    /// (l ± n)/(4A).
    momenta: [R; 2],
}

impl<R: Float> TipLaw<R> {
    pub(super) fn new(motion: &Motion) -> Self {
        let (top, integrals) = (motion.top(), motion.first_integrals());
        let per_a = 0.25 / top.a();
        let momenta = [integrals.l_plus_n, integrals.l_minus_n];
        Self {
            scale: R::from_f64(2.0 * top.tip_scale()),
            momenta: momenta.map(|momentum| R::from_f64(momentum * per_a)),
        }
    }

    pub(super) fn tip(&self, pose: &Pose<R>, phi: Option<Turns>) -> Tip<R> {
        let Pose { phi: Phi { alpha, beta }, rate } = *pose;
        // φ' = (l+n)/(4A |α|²) + (l-n)/(4A |β|²); where a parameter vanishes so does its momentum
        let part = |momentum: R, z: Complex<R>| {
            let (re, im) = (z.re.abs(), z.im.abs());
            let size = if re > im { re } else { im };
            if momentum == R::ZERO || size == R::ZERO {
                return R::ZERO;
            }
            // |z|² may underflow where the quotient does not, and 1/|z| overflow
            let inverse = R::ONE / size;
            let direction = match inverse.to_f64().is_finite() {
                true => z.scaled(inverse),
                false => Complex::new(z.re / size, z.im / size),
            };
            momentum / size / size / direction.norm_squared()
        };
        let [plus, minus] = self.momenta;
        let rate_of_phi = saturated(part(plus, alpha) + part(minus, beta));
        Tip {
            c: (alpha * beta).scaled(self.scale),
            velocity: (rate.alpha * beta + alpha * rate.beta).scaled(self.scale),
            angle: phi.map(|phi| TipAngle { phi, rate: rate_of_phi }),
        }
    }
}
