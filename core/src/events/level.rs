//! Values of u at which events occur.

use crate::body::{ParameterError, Support, Top, check, check_finite, check_range, half_tilt_sine_cosine};
use crate::complex::Complex;
use crate::events::rising_half::{LAST_RISING, at_phase, bisect};
use crate::motion::{Motion, normal_force};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Real, Ring};
use crate::su2::Orientation;
use crate::table::{Table, TableScalar};

/// Value of u, the cosine of the tilt, stored as 1 - u and 1 + u.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Level {
    one_minus_u: f64,
    one_plus_u: f64,
}

impl Level {
    /// Level of a value of u.
    ///
    /// # Errors
    /// `u`: not finite or not in [-1, 1].
    pub fn from_u(u: f64) -> Result<Self, ParameterError> {
        check_range(-1.0..=1.0, "u", u, "in [-1, 1]")?;
        Ok(Self { one_minus_u: 1.0 - u, one_plus_u: 1.0 + u })
    }

    /// Level of a tilt, the angle between the axis and the upward vertical, rad.
    ///
    /// # Errors
    /// `tilt`: not finite or not in [0, π].
    pub fn from_tilt(tilt: f64) -> Result<Self, ParameterError> {
        let (sine, cosine) = half_tilt_sine_cosine(tilt)?;
        Ok(Self { one_minus_u: 2.0 * sine * sine, one_plus_u: 2.0 * cosine * cosine })
    }

    /// Levels at which the tip is on the circle |c| = `radius`, in m: with the centre of mass above the tip, and below it. For a fixed tip
    /// the radius is the sine of the tilt.
    ///
    /// # Errors
    /// `radius`: not finite, or not in (0, s) (for another support in (0, 1)).
    pub fn from_circle(top: &Top, radius: f64) -> Result<[Self; 2], ParameterError> {
        check_finite("radius", radius)?;
        let scale = top.tip_scale();
        check(radius > 0.0 && radius < scale, "radius", "above 0 and below the greatest |c|")?;
        let radius = Extended::from(radius);
        let scale = Extended::from(scale);
        // 1 - √(1 - x²) = x²/(1 + √(1 - x²)) with x = radius/s
        let root = ((scale - radius) * (scale + radius)).sqrt() / scale;
        let large = Extended::ONE + root;
        let small = (radius / scale).squared() / large;
        let [small, large] = [small, large].map(Float::to_f64);
        let upper = Self { one_minus_u: small, one_plus_u: large };
        Ok([upper, Self { one_minus_u: large, one_plus_u: small }])
    }

    /// Level above which the normal force is negative, so that a real top lifts off. `None` if the tip does not slide, or the force never changes
    /// its sign: see [`Motion::min_normal_force`].
    #[must_use]
    pub fn lift_off(motion: &Motion) -> Option<Self> {
        if motion.top().support() != Support::Sliding || motion.is_steady() {
            return None;
        }
        let e = &motion.branch_points;
        let [one_plus_u, one_minus_u] = normal_force::sign_change(e, motion.top().a_over_ps())?;
        let reached = one_minus_u > e.one_minus_e2 && one_plus_u > e.one_plus_e1;
        reached.then_some(Self { one_minus_u: one_minus_u.to_f64(), one_plus_u: one_plus_u.to_f64() })
    }

    /// Cosine of the tilt u.
    #[must_use]
    pub fn u(&self) -> f64 {
        if self.one_minus_u < 1.0 { 1.0 - self.one_minus_u } else { self.one_plus_u - 1.0 }
    }

    /// Tilt, rad.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        2.0 * Real::atan2(self.one_minus_u.sqrt(), self.one_plus_u.sqrt())
    }

    /// Nutation phase in (0, 1/2) turn at which u rises to the level; `None` where the motion does not reach it.
    pub(super) fn phase<R: TableScalar>(&self, table: &Table<R>) -> Option<Phase> {
        let reached = |nutation| self.is_reached(&at_phase(table, nutation).orientation());
        (reached(LAST_RISING) && !reached(0)).then(|| Phase::from_leading_bits(bisect(reached)))
    }

    /// Whether u is at the level or above it, by tan²(tilt/2) = |β|²/|α|².
    fn is_reached<R: TableScalar>(&self, orientation: &Orientation<R>) -> bool {
        let square = |z: Complex<R>| {
            let [re, im] = [z.re, z.im].map(Into::<f64>::into);
            re * re + im * im
        };
        square(orientation.beta) * self.one_plus_u <= square(orientation.alpha) * self.one_minus_u
    }
}
