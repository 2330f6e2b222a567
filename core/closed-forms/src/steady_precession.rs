//! Steady precessions of a top at a given tilt and spin.

use toytop::internal::{check, check_finite};
use toytop::scalar::Float;
use toytop::{ParameterError, Top};

/// Steady precessions of a top at given tilt and spin: the roots of A e φ'² - n φ' + p g = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteadyPrecession {
    /// No steady precession: the spin is too slow for an axis above the horizontal, or 0 for a horizontal axis.
    None {
        /// Least |spin| with a steady precession, √(4 A e p g)/C, rad per unit time; 0 for a horizontal axis, which
        /// needs any spin other than 0. With a rotor: (√(4 A e p g) ∓ K)/C, the least spin in the direction of n;
        /// infinite where C = 0.
        least_spin: f64,
    },
    /// One steady precession: the axis is horizontal, with φ' = p g/n, or the spin is exactly the least one; or torque
    /// and n are 0, so that the axis is at rest, φ' = 0.
    One {
        /// Rate φ', rad per unit time.
        rate: f64,
    },
    /// Two steady precessions. Below the horizontal they have opposite directions.
    Two {
        /// Rate φ' of smaller magnitude, rad per unit time; about p g/n for a fast top.
        slow: f64,
        /// Rate φ' of larger magnitude, rad per unit time; about n/(A e) for a fast top.
        fast: f64,
    },
}

impl SteadyPrecession {
    /// Steady precessions of a top at a tilt (rad from the upward vertical, strictly between 0 and π) and a spin ω·r
    /// = (n - K)/C.
    ///
    /// A top that is released with this tilt, this spin, the rate φ' as `precession` and no nutation keeps its tilt.
    /// Relative error of a rate: a few roundings, except that the difference of the spin from the least spin loses
    /// digits where it is small.
    ///
    /// ```
    /// use toytop::{Top, TopParameters};
    /// use toytop_closed_forms::SteadyPrecession;
    /// let top = Top::sliding(&TopParameters::TOY)?;
    /// let SteadyPrecession::Two { slow, fast } = SteadyPrecession::new(&top, 0.5, 150.0)? else { panic!() };
    /// assert!(slow > 5.0 && slow < 9.0 && fast > 90.0);
    /// let SteadyPrecession::None { least_spin } = SteadyPrecession::new(&top, 0.5, 50.0)? else { panic!() };
    /// assert!(least_spin > 60.0);
    /// # Ok::<(), toytop::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `tilt`: not strictly between 0 and π; `spin`: above 1e11 in magnitude; either not finite.
    pub fn new(top: &Top, tilt: f64, spin: f64) -> Result<Self, ParameterError> {
        check_finite("tilt", tilt)?;
        check_finite("spin", spin)?;
        check(tilt > 0.0 && tilt < core::f64::consts::PI, "tilt", "strictly between 0 and pi")?;
        check(Float::abs(spin) <= 1e11, "spin", "between -1e11 and 1e11 rad/s")?;
        let a = top.transverse_inertia();
        let k = top.rotor_momentum();
        let n = top.axial_inertia() * spin + k;
        let weight = top.mass_moment() * top.gravity();
        // the f64 nearest to π/2 means a horizontal axis
        let e = if tilt == core::f64::consts::FRAC_PI_2 { 0.0 } else { libm::cos(tilt) };
        let least = Float::sqrt(4.0 * a * e * weight);
        let above_least = Float::abs(n) - least;
        if weight == 0.0 && n == 0.0 {
            return Ok(Self::One { rate: 0.0 });
        }
        if e >= 0.0 && (above_least < 0.0 || n == 0.0) {
            let opposite = if n < 0.0 { k } else { -k };
            return Ok(Self::None { least_spin: (least + opposite) / top.axial_inertia() });
        }
        let root = if e > 0.0 {
            Float::sqrt(above_least * (Float::abs(n) + least))
        } else {
            Float::sqrt(n * n - 4.0 * a * e * weight)
        };
        let half_sum = libm::copysign(0.5 * (Float::abs(n) + root), n);
        let slow = weight / half_sum;
        if e == 0.0 || root == 0.0 {
            return Ok(Self::One { rate: slow });
        }
        Ok(Self::Two { slow, fast: half_sum / (a * e) })
    }
}
