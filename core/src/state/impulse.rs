//! Impulse: a force so short that the top does not move while it acts. It changes ω and leaves Φ as it is.
//!
//! The impulse J acts at a point with the position d from the centre of mass, and the support reacts with an impulse R
//! at the tip, whose position from there is -s r. With the moments of inertia about the centre of mass and M s = p,
//!
//! ```text
//! M Δv = J + R        A Δω + (C - A) ⟨Δω, r⟩ r = d × J - s r × R
//! ```
//!
//! *Sliding tip.* The plane has no friction, R = R k, and the tip stays on it: ⟨Δv - s Δω × r, k⟩ = 0. With q = r × k
//! and |q|² = 1 - u², which is orthogonal to r, that is (J₃ + R)/M = s ⟨Δω, q⟩ = s (⟨d × J, q⟩ - s R |q|²)/A, so that
//!
//! ```text
//! R = (p ⟨d × J, q⟩ - A J₃) / (A + p s |q|²)
//! ```
//!
//! *Fixed tip.* A and C are about the tip, where R has no moment: the right-hand side is d × J with d from the tip.
//! This is the case s = 0 of the same formulas.
//!
//! *Free body.* A and C are about the centre of mass, R = 0, and d is from there: again the case s = 0. The momentum K of
//! a rotor inside does not change. Where C = 0 the whole body lies on its axis, and J has no moment about it.

use super::{FASTEST, State};
use crate::error::{ParameterError, finite, require};
use crate::scalar::Float;
use crate::su2::{Vector, bracket, dot};
use crate::top::{Support, Top};

impl State {
    /// State after an impulse J, N s in the fixed frame, at a point X of the body, m in the body frame *from the tip*.
    ///
    /// The point is relative to the tip, because the distance of the centre of mass, which is at [0, 0, s], need not be given for a top
    /// with a fixed tip. For a free body it is relative to the centre of mass. It may lie outside the body, as the end of a lever does.
    /// The orientation does not change. The reaction of the support is [`State::reaction_impulse`]: a fixed tip does not move, and a
    /// sliding tip keeps its height, without friction. A horizontal impulse on a sliding top also changes the horizontal velocity of the
    /// centre of mass by J/M, which is not part of a state: the motion of this crate is relative to the centre of mass, whose horizontal
    /// velocity stays constant between impulses.
    ///
    /// An angular impulse, N m s, is a pair of opposite impulses: J at X + D and -J at X give D × J for any X, with D in
    /// the fixed frame.
    ///
    /// ```
    /// use toytop::{Release, State, Top, TopParameters};
    /// let top = Top::sliding(&TopParameters {
    ///     transverse_inertia: 3.0e-5,
    ///     axial_inertia: 2.0e-5,
    ///     com_height: 0.03,
    ///     mass: 0.05,
    ///     ..TopParameters::default()
    /// })?;
    /// let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
    /// // a tangential stroke of 2 mN s on the rim, 25 mm from the axis, at the height of the centre of mass
    /// let struck = state.with_impulse(&top, [0.0, 2.0e-3, 0.0], [0.025, 0.0, 0.03])?;
    /// assert!(struck.omega() != state.omega() && struck.orientation() == state.orientation());
    /// # Ok::<(), toytop::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `impulse`: a component is not finite, is above 1e12 N s, or makes a component of ω exceed 1e12 rad/s; `point`: a
    /// component is not finite or is above 1e12 m.
    pub fn with_impulse(
        &self,
        top: &Top,
        impulse: Vector<f64>,
        point: Vector<f64>,
    ) -> Result<Self, ParameterError> {
        let mut omega = self.omega_change(top, impulse, point)?;
        for (component, before) in omega.iter_mut().zip(self.omega) {
            *component += before;
            require(
                Float::abs(*component) <= FASTEST,
                "impulse",
                "such that no component of omega exceeds 1e12 rad/s",
            )?;
        }
        Ok(Self { omega, ..*self })
    }

    /// Reaction impulse of the support, N s in the fixed frame: p Δω × r - J. The plane under a sliding tip gives the vertical
    /// part only.
    ///
    /// Where the third component is negative the plane would have to pull: a real top then leaves it, and does not follow
    /// the motion from [`State::with_impulse`]. The weight does not count, because the force of an impulse has no bound.
    ///
    /// * `impulse`, `point`: the arguments of [`State::with_impulse`]
    ///
    /// # Errors
    /// `impulse`, `point`: a component is not finite or is above 1e12.
    pub fn reaction_impulse(
        &self,
        top: &Top,
        impulse: Vector<f64>,
        point: Vector<f64>,
    ) -> Result<Vector<f64>, ParameterError> {
        let change = self.omega_change(top, impulse, point)?;
        let mut reaction = bracket(change, self.orientation.normalised().axis());
        for (component, given) in reaction.iter_mut().zip(impulse) {
            *component = top.mass_moment() * *component - given;
        }
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
        impulse: Vector<f64>,
        point: Vector<f64>,
    ) -> Result<Vector<f64>, ParameterError> {
        for (name, vector) in [("impulse", impulse), ("point", point)] {
            for component in vector {
                finite(name, component)?;
                require(Float::abs(component) <= 1e12, name, "between -1e12 and 1e12 in every component")?;
            }
        }
        let (a, c, s) = (top.transverse_inertia(), top.axial_inertia(), top.com_height());
        let phi = self.orientation.normalised();
        let (r, [x, y, z], [.., lift]) = (phi.axis(), point, impulse);
        let given = bracket(phi.adjoint([x, y, z - s]), impulse);
        let q = bracket(r, [0.0, 0.0, 1.0]);
        let p = top.mass_moment();
        let reaction = (p * dot(given, q) - a * lift) / (a + p * s * dot(q, q));
        let axial = dot(given, r);
        let spin_up = if c > 0.0 { axial / c } else { 0.0 };
        let mut change = given;
        for ((component, r), q) in change.iter_mut().zip(r).zip(q) {
            *component = (*component - s * reaction * q - axial * r) / a + spin_up * r;
        }
        Ok(change)
    }
}
