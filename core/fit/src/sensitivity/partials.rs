//! Partial derivatives of the quantities of a sample, at one time.

use crate::sensitivity::coefficients::Coefficients;
use crate::sensitivity::equations::{Acceleration, Equations};
use crate::sensitivity::state::{AugmentedState, COLUMNS, Tangent};
use crate::vector::{Vector, add_scaled, along, combined, cross, from_axes, scaled};
use toytop::Complex;
use toytop::scalar::Float;
use toytop::su2::Orientation;

/// State at one time with its partial derivatives, in the order of [`Sensitivity::NAMES`](crate::Sensitivity::NAMES).
#[derive(Clone, Copy, Debug)]
pub struct Partials<F = f64> {
    pub(crate) state: AugmentedState<F, COLUMNS>,
    pub(crate) equations: Equations<F>,
}

impl<F: Float> Partials<F> {
    /// Image of each known column, from its tangent and its change of the coefficients; 0 for the others.
    pub(crate) fn each(
        &self,
        mut image: impl FnMut(&Tangent<F>, Option<&Coefficients<F>>) -> Vector<F>,
    ) -> [Vector<F>; COLUMNS] {
        // columns that are built where they are returned need not be cleared and copied
        let mut known = self.state.tangents.iter().take(self.equations.columns).enumerate();
        [(); COLUMNS].map(|()| match known.next() {
            Some((column, tangent)) => image(tangent, self.equations.change(column)),
            None => [F::ZERO; 3],
        })
    }

    /// Symmetry axis r.
    #[must_use]
    pub fn axis(&self) -> Vector<F> {
        self.state.axis
    }

    /// Orientation Φ, of either sign.
    #[must_use]
    pub fn orientation(&self) -> Orientation<F> {
        from_axes(self.state.axis, self.state.first_axis)
    }

    /// Angular velocity ω in the fixed frame, rad per unit time.
    #[must_use]
    pub fn omega(&self) -> Vector<F> {
        self.state.omega()
    }

    /// Body coordinates of a vector given in the fixed frame.
    #[must_use]
    pub fn in_body(&self, fixed: Vector<F>) -> Vector<F> {
        along(&self.state.axes(), fixed)
    }

    /// Fixed coordinates of a vector given in the body frame.
    #[must_use]
    pub fn in_fixed(&self, body: Vector<F>) -> Vector<F> {
        combined(&self.state.axes(), body)
    }

    /// Derivatives of the orientation: rotation vectors θ in the fixed frame, with dΦ = θ Φ.
    #[must_use]
    pub fn d_orientation(&self) -> [Vector<F>; COLUMNS] {
        self.each(|tangent, _| tangent.theta)
    }

    /// Derivatives of ω in the fixed frame.
    #[must_use]
    pub fn d_omega(&self) -> [Vector<F>; COLUMNS] {
        let omega = self.omega();
        self.each(|Tangent { theta, eta }, _| add_scaled(*eta, cross(*theta, omega), F::ONE))
    }

    /// Derivatives of Ω in the body frame.
    #[must_use]
    pub fn d_omega_body(&self) -> [Vector<F>; COLUMNS] {
        let axes = self.state.axes();
        self.each(|tangent, _| along(&axes, tangent.eta))
    }

    /// Derivatives of the axis r.
    #[must_use]
    pub fn d_axis(&self) -> [Vector<F>; COLUMNS] {
        self.each(|tangent, _| cross(tangent.theta, self.state.axis))
    }

    /// Tip c = -s (r₁ + i r₂), m; -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn tip(&self) -> Complex<F> {
        let [x, y, _] = scaled(self.state.axis, -self.tip_scale());
        Complex::new(x, y)
    }

    /// Length s of a sliding top; 1 for a fixed tip.
    fn tip_scale(&self) -> F {
        let [_, _, s, ..] = self.equations.coefficients;
        if s > F::ZERO { s } else { F::ONE }
    }

    /// Derivatives of the tip c = -s (r₁ + i r₂), m; of -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn d_tip(&self) -> [Complex<F>; COLUMNS] {
        let axis = self.state.axis;
        let changes = self.each(|tangent, change| {
            let d_s = change.map_or(F::ZERO, |&[_, _, d_s, ..]| d_s);
            add_scaled(scaled(cross(tangent.theta, axis), -self.tip_scale()), axis, -d_s)
        });
        changes.map(|[x, y, _]| Complex::new(x, y))
    }

    /// Derivatives of the tip angle φ = arg c, rad; `None` where the tip is at the centre.
    #[must_use]
    pub fn d_tip_angle(&self) -> Option<[F; COLUMNS]> {
        let [x, y, _] = self.state.axis;
        let square = x * x + y * y;
        (square > F::ZERO).then(|| self.d_axis().map(|[dx, dy, _]| (x * dy - y * dx) / square))
    }

    /// Specific force in the body frame at a point of the body, as an accelerometer there measures it, and its
    /// derivatives, m/s².
    ///
    /// * `place`: body coordinates of the point, m, from the point to which the moments of inertia belong: the centre of mass, or a
    ///   fixed tip
    #[must_use]
    pub fn specific_force(&self, place: Vector<F>) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        self.force_along(&self.state.axes(), place)
    }

    /// Body coordinates of a fixed direction, as a magnetometer sees the field, and their derivatives.
    #[must_use]
    pub fn direction(&self, fixed: Vector<F>) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        self.direction_along(&self.state.axes(), fixed)
    }

    /// Coordinates of a fixed direction along the axes of an instrument, and their derivatives.
    pub(crate) fn direction_along(
        &self,
        axes: &[Vector<F>; 3],
        fixed: Vector<F>,
    ) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        (along(axes, fixed), self.each(|tangent, _| along(axes, cross(fixed, tangent.theta))))
    }

    /// Specific force along the axes of an instrument, and its derivatives.
    pub(crate) fn force_along(
        &self,
        axes: &[Vector<F>; 3],
        place: Vector<F>,
    ) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        let at = self.equations.acceleration(&self.state);
        let force = axes.map(|[.., up]| up * at.support);
        let changes = self.each(|tangent, change| {
            let support = self.equations.support_change(self.state.spin, &at, tangent, change);
            // in the frame that turns by θ, the vertical turns by -θ: k × θ has no vertical component
            let [x, y, _] = tangent.theta;
            axes.map(|[east, north, up]| up * support + at.support * (north * x - east * y))
        });
        if place == [F::ZERO; 3] {
            (force, changes)
        } else {
            self.with_swing(&at, axes, place, (force, changes))
        }
    }

    /// Specific force with the part that the rotation causes away from the centre.
    #[inline(never)] // stack
    fn with_swing(
        &self,
        at: &Acceleration<F>,
        axes: &[Vector<F>; 3],
        place: Vector<F>,
        (force, changes): (Vector<F>, [Vector<F>; COLUMNS]),
    ) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        let AugmentedState { axis, across, spin, .. } = self.state;
        let (omega, arm) = (self.omega(), self.in_fixed(place));
        let swing = cross(omega, arm);
        let rate = add_scaled(add_scaled(at.across, cross(across, axis), spin), axis, at.spin);
        let by_rotation = add_scaled(cross(rate, arm), cross(omega, swing), F::ONE);
        let mut before = changes.into_iter();
        let changes = self.each(|tangent, change| {
            // in the frame that turns by θ, the arm is constant
            let eta = tangent.eta;
            let rate = self.equations.tangent_rate(&self.state, at, tangent, change).eta;
            let turning = add_scaled(rate, cross(eta, omega), F::ONE);
            let change = add_scaled(cross(turning, arm), cross(eta, swing), F::ONE);
            let change = add_scaled(change, cross(omega, cross(eta, arm)), F::ONE);
            add_scaled(before.next().unwrap_or([F::ZERO; 3]), along(axes, change), F::ONE)
        });
        (add_scaled(force, along(axes, by_rotation), F::ONE), changes)
    }
}
