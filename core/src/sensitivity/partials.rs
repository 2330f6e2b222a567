//! Partial derivatives of the quantities of a sample, at one time.

use crate::complex::Complex;
use crate::scalar::Float;
use crate::sensitivity::equations::{Acceleration, Equations};
use crate::sensitivity::flow::{Flow, total};
use crate::sensitivity::{COLUMNS, LAUNCH, Tangent};
use crate::su2::{Orientation, Vector, bracket, dot};

/// State at one time with its partial derivatives, in the order of [`Sensitivity::NAMES`](crate::Sensitivity::NAMES).
#[derive(Clone, Copy, Debug)]
pub struct Partials<F = f64> {
    pub(crate) flow: Flow<F, COLUMNS>,
    pub(crate) equations: Equations<F>,
    tip_scale: F,
    /// Number of columns that are known; the others are 0.
    known: usize,
}

impl<F: Float> Partials<F> {
    pub(crate) fn new(
        equations: &Equations<F>,
        flow: Flow<F, COLUMNS>,
        tip_scale: f64,
        known: usize,
    ) -> Self {
        Self { flow, equations: *equations, tip_scale: F::from_f64(tip_scale), known }
    }

    /// Image of each known column; 0 for the others.
    pub(crate) fn each(&self, mut of: impl FnMut(&Tangent<F>) -> Vector<F>) -> [Vector<F>; COLUMNS] {
        // columns that are built where they are returned need not be cleared and copied
        let mut known = self.flow.tangents.iter().take(self.known);
        [(); COLUMNS].map(|()| known.next().map_or([F::ZERO; 3], &mut of))
    }

    /// Symmetry axis r.
    #[must_use]
    pub fn axis(&self) -> Vector<F> {
        self.flow.axis
    }

    /// Orientation Φ, of either sign.
    #[must_use]
    pub fn orientation_now(&self) -> Orientation<F> {
        let Flow { axis: [x3, y3, z3], side: [x1, y1, z1], .. } = self.flow;
        let [x2, y2, z2] = bracket(self.flow.axis, self.flow.side);
        // four times a component of the quaternion times the others: the row with the largest component is used
        let one = F::ONE;
        let rows = [
            [one + x1 + y2 + z3, z2 - y3, x3 - z1, y1 - x2],
            [z2 - y3, one + x1 - y2 - z3, y1 + x2, x3 + z1],
            [x3 - z1, y1 + x2, one - x1 + y2 - z3, z2 + y3],
            [y1 - x2, x3 + z1, z2 + y3, one - x1 - y2 + z3],
        ];
        let size = |row: &[F; 4]| row.iter().fold(F::ZERO, |sum, x| sum + *x * *x);
        let first = [one, F::ZERO, F::ZERO, F::ZERO];
        let largest =
            rows.into_iter().fold(first, |best, row| if size(&row) > size(&best) { row } else { best });
        Orientation::from_quaternion(largest).normalised()
    }

    /// Angular velocity ω in the fixed frame, rad per unit time.
    #[must_use]
    pub fn angular_velocity(&self) -> Vector<F> {
        self.flow.omega()
    }

    /// Body coordinates of a vector given in the fixed frame.
    #[must_use]
    pub fn in_body(&self, fixed: Vector<F>) -> Vector<F> {
        self.flow.in_body(fixed)
    }

    /// Fixed coordinates of a vector given in the body frame.
    #[must_use]
    pub fn in_fixed(&self, body: Vector<F>) -> Vector<F> {
        self.flow.in_fixed(body)
    }

    /// Derivatives of the orientation: rotation vectors θ in the fixed frame, with dΦ = θ Φ.
    #[must_use]
    pub fn orientation(&self) -> [Vector<F>; COLUMNS] {
        self.each(|tangent| tangent.theta)
    }

    /// Derivatives of ω in the fixed frame.
    #[must_use]
    pub fn omega(&self) -> [Vector<F>; COLUMNS] {
        let omega = self.angular_velocity();
        self.each(|Tangent { theta, eta }| total(*eta, bracket(*theta, omega), F::ONE))
    }

    /// Derivatives of Ω in the body frame.
    #[must_use]
    pub fn omega_body(&self) -> [Vector<F>; COLUMNS] {
        self.each(|tangent| self.flow.in_body(tangent.eta))
    }

    /// Derivatives of the axis r.
    #[must_use]
    pub fn axis_change(&self) -> [Vector<F>; COLUMNS] {
        self.each(|tangent| bracket(tangent.theta, self.flow.axis))
    }

    /// Derivatives of the tip c = -s (r₁ + i r₂), m; of -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn tip(&self) -> [Complex<F>; COLUMNS] {
        let mut changes = self.axis_change().map(|[x, y, _]| Complex::new(x, y).scaled(-self.tip_scale));
        let [x, y, _] = self.flow.axis;
        for (change, by) in changes.iter_mut().skip(LAUNCH).zip(&self.equations.changes) {
            *change = *change - Complex::new(x, y).scaled(by.height);
        }
        changes
    }

    /// Derivatives of the tip angle φ = arg c, rad; `None` where the tip is at the centre.
    #[must_use]
    pub fn tip_angle(&self) -> Option<[F; COLUMNS]> {
        let [x, y, _] = self.flow.axis;
        let square = x * x + y * y;
        (square > F::ZERO).then(|| self.axis_change().map(|[dx, dy, _]| (x * dy - y * dx) / square))
    }

    /// Specific force in the body frame at a point of the body, as an accelerometer there measures it, and its
    /// derivatives, m/s².
    ///
    /// * `place`: body coordinates of the point, m, from the centre of mass of a sliding top, and from the tip of a top
    ///   with a fixed tip: the point to which the moments of inertia belong
    #[must_use]
    pub fn specific_force(&self, place: Vector<F>) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        self.force_in(&self.body_axes(), place)
    }

    /// Body coordinates of a fixed direction, as a magnetometer sees the field, and their derivatives.
    #[must_use]
    pub fn direction(&self, fixed: Vector<F>) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        self.direction_in(&self.body_axes(), fixed)
    }

    /// Axes of the body in the fixed frame.
    pub(crate) fn body_axes(&self) -> [Vector<F>; 3] {
        let Flow { axis, side, .. } = self.flow;
        [side, bracket(axis, side), axis]
    }

    /// Axes of an instrument in the fixed frame, from its rotation in the body.
    pub(crate) fn axes(&self, rotation: &Orientation<F>) -> [Vector<F>; 3] {
        let [zero, one] = [F::ZERO, F::ONE];
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
            .map(|direction| self.in_fixed(rotation.adjoint(direction)))
    }

    /// ω in the coordinates of an instrument, from the coordinates of the axis there.
    pub(crate) fn omega_in(&self, axes: &[Vector<F>; 3], axis: Vector<F>) -> Vector<F> {
        total(along(axes, self.flow.across), axis, self.flow.spin)
    }

    /// [`Self::direction`] in the coordinates of an instrument.
    pub(crate) fn direction_in(
        &self,
        axes: &[Vector<F>; 3],
        fixed: Vector<F>,
    ) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        (along(axes, fixed), self.each(|tangent| along(axes, bracket(fixed, tangent.theta))))
    }

    /// [`Self::specific_force`] in the coordinates of an instrument.
    pub(crate) fn force_in(
        &self,
        axes: &[Vector<F>; 3],
        place: Vector<F>,
    ) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        let at = self.equations.acceleration(&self.flow);
        // coordinates of the vertical
        let vertical = axes.map(|[.., z]| z);
        let mut force = vertical.map(|x| x * at.support);
        let mut index = 0_usize;
        let mut changes = self.each(|tangent| {
            let by = self.equations.changes.get(index.wrapping_sub(LAUNCH));
            index += 1;
            let support = self.equations.support_change(self.flow.spin, &at, tangent, by);
            // in the frame that turns by θ, the vertical turns by -θ: k × θ has no vertical component
            let [x, y, _] = tangent.theta;
            axes.map(|[east, north, up]| up * support + at.support * (north * x - east * y))
        });
        if place != [F::ZERO; 3] {
            self.add_swing(&at, axes, place, &mut force, &mut changes);
        }
        (force, changes)
    }

    /// Adds the part of the specific force that the rotation causes away from the centre.
    #[inline(never)] // most accelerometers do not need it
    fn add_swing(
        &self,
        at: &Acceleration<F>,
        axes: &[Vector<F>; 3],
        place: Vector<F>,
        force: &mut Vector<F>,
        changes: &mut [Vector<F>; COLUMNS],
    ) {
        let Flow { axis, across, spin, .. } = self.flow;
        let omega = self.angular_velocity();
        let arm = self.in_fixed(place);
        let swing = bracket(omega, arm);
        let rate = total(total(at.across, bracket(across, axis), spin), axis, at.spin);
        let of_rotation = total(bracket(rate, arm), bracket(omega, swing), F::ONE);
        *force = total(*force, along(axes, of_rotation), F::ONE);
        let tangents = self.flow.tangents.iter().take(self.known).enumerate();
        for (slot, (index, tangent)) in changes.iter_mut().zip(tangents) {
            let by = self.equations.changes.get(index.wrapping_sub(LAUNCH));
            // in the frame that turns by θ, the arm is constant
            let rate = self.equations.tangent_rate(&self.flow, at, tangent, by).eta;
            let turning = total(rate, bracket(tangent.eta, omega), F::ONE);
            let change = total(bracket(turning, arm), bracket(tangent.eta, swing), F::ONE);
            let change = total(change, bracket(omega, bracket(tangent.eta, arm)), F::ONE);
            *slot = total(*slot, along(axes, change), F::ONE);
        }
    }
}

/// Coordinates of a vector along three axes.
pub(crate) fn along<F: Float>(axes: &[Vector<F>; 3], x: Vector<F>) -> Vector<F> {
    axes.map(|axis| dot(axis, x))
}
