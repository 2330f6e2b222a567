//! Impulse: a force so short that it changes ω only.
//!
//! J acts at d from the centre of mass, and the support's reaction R at -s r:
//!
//! ```text
//! M Δv = J + R        A Δω + (C - A) ⟨Δω, r⟩ r = d × J - s r × R
//! ```
//!
//! *Sliding tip.* R = R k, and the tip stays on the plane: ⟨Δv - s Δω × r, k⟩ = 0. With q = r × k
//!
//! ```text
//! R = (p ⟨d × J, q⟩ - A J₃) / (A + p s |q|²)
//! ```
//!
//! *Fixed tip, free body.* s = 0, and d is from the point of A and C.
//!
//! K is kept. A rod (C = 0) gets no axial rate.

use super::state::MAX_RATE;
use super::{ParameterError, State, Support, Top, check, check_range};
use crate::scalar::Float;
use crate::su2::{Vector, add_scaled, cross, dot, scaled};

/// Impulse at a point of a body. A couple is two impulses, J at X + D and -J at X; its angular impulse is D × J.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointImpulse {
    /// Impulse J in the fixed frame, N s.
    pub impulse: Vector<f64>,
    /// Point X in the body frame, m from the tip, or from the centre of mass of a free body. The centre of mass of a top is at [0, 0, s].
    pub point: Vector<f64>,
}

impl State {
    /// State after an impulse.
    ///
    /// ```
    /// use toytop::{PointImpulse, Release, State, Top, TopParameters};
    /// let top = Top::sliding(&TopParameters::TOY)?;
    /// let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    /// // tangential, 25 mm from the axis, at the height of the centre of mass
    /// let stroke = PointImpulse { impulse: [0.0, 2.0e-3, 0.0], point: [0.025, 0.0, 0.03] };
    /// let struck = state.with_impulse(&top, &stroke)?;
    /// assert!(struck.omega() != state.omega() && struck.orientation() == state.orientation());
    /// # Ok::<(), toytop::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `impulse`: a component is not finite, is above 1e12 N s, or makes a component of ω exceed 1e12 rad/s; `point`: a
    /// component is not finite or is above 1e12 m.
    pub fn with_impulse(&self, top: &Top, impulse: &PointImpulse) -> Result<Self, ParameterError> {
        let omega = add_scaled(self.omega, self.omega_change(top, impulse)?, 1.0);
        for component in omega {
            check(
                component.abs() <= MAX_RATE,
                "impulse",
                "such that no component of omega exceeds 1e12 rad/s",
            )?;
        }
        Ok(Self { omega, ..*self })
    }

    /// Reaction of the support, N s in the fixed frame: p Δω × r - J; for a sliding tip its vertical part. Where that is negative, a real top
    /// leaves the plane.
    ///
    /// # Errors
    /// `impulse`, `point`: a component is not finite or is above 1e12.
    pub fn reaction_impulse(&self, top: &Top, impulse: &PointImpulse) -> Result<Vector<f64>, ParameterError> {
        let change = self.omega_change(top, impulse)?;
        let momentum = scaled(cross(change, self.orientation.normalised().axis()), top.mass_moment());
        let reaction = add_scaled(momentum, impulse.impulse, -1.0);
        let [.., vertical] = reaction;
        Ok(match top.support() {
            Support::Sliding => [0.0, 0.0, vertical],
            Support::Fixed => reaction,
            Support::Free => [0.0; 3],
        })
    }

    /// Change Δω of the angular velocity by an impulse, rad/s.
    fn omega_change(
        &self,
        top: &Top,
        &PointImpulse { impulse, point }: &PointImpulse,
    ) -> Result<Vector<f64>, ParameterError> {
        for (name, vector) in [("impulse", impulse), ("point", point)] {
            for component in vector {
                check_range(-1e12..=1e12, name, component, "between -1e12 and 1e12 in every component")?;
            }
        }
        let [a, c, s, p] = [top.a, top.c, top.s, top.p].map(Float::to_f64);
        let phi = self.orientation.normalised();
        let r = phi.axis();
        let [x, y, z] = point;
        let [.., vertical] = impulse;
        let torque_impulse = cross(phi.adjoint([x, y, z - s]), impulse);
        let q = cross(r, [0.0, 0.0, 1.0]);
        let reaction = (p * dot(torque_impulse, q) - a * vertical) / (a + p * s * dot(q, q));
        let axial = dot(torque_impulse, r);
        let spin_up = if c > 0.0 { axial / c } else { 0.0 };
        let transverse = add_scaled(add_scaled(torque_impulse, q, -s * reaction), r, -axial);
        Ok(add_scaled(transverse.map(|component| component / a), r, spin_up))
    }
}
