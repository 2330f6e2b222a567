//! Partial derivatives of the quantities of a sample, at one time.

use crate::sensitivity::coefficients::Coefficients;
use crate::sensitivity::equations::{Acceleration, Equations, vertical_cross};
use crate::sensitivity::state::{BodyState, COLUMNS, Tangent};
use crate::vector::{Vector, about_third_axis, add_all, add_scaled, coordinates, cross, scaled};
use toytop::scalar::{Float, Real};
use toytop::su2::Orientation;
use toytop::{Complex, Phase};

/// State at one time with its partial derivatives, in the order of [`Sensitivity::NAMES`](crate::Sensitivity::NAMES).
#[derive(Clone, Copy, Debug)]
pub struct Partials<F = f64> {
    pub(crate) state: BodyState<F>,
    pub(crate) tangents: [Tangent<F>; COLUMNS],
    pub(crate) equations: Equations<F>,
}

impl<F: Float> Partials<F> {
    /// Image of each known column, from its tangent and its change of the coefficients; 0 for the others.
    pub(crate) fn map_columns(
        &self,
        mut image: impl FnMut(&Tangent<F>, Option<&Coefficients<F>>) -> Vector<F>,
    ) -> [Vector<F>; COLUMNS] {
        core::array::from_fn(|column| match self.tangents.get(column) {
            Some(tangent) if column < self.equations.column_count => {
                image(tangent, self.equations.change(column))
            }
            _ => [F::ZERO; 3],
        })
    }

    /// Symmetry axis r.
    #[must_use]
    pub fn axis(&self) -> Vector<F> {
        self.state.orientation.axis()
    }

    /// Orientation Φ, of either sign.
    #[must_use]
    pub fn orientation(&self) -> Orientation<F> {
        self.state.orientation.normalised()
    }

    /// Angular velocity ω in the fixed frame, rad per unit time.
    #[must_use]
    pub fn omega(&self) -> Vector<F> {
        self.state.omega()
    }

    /// Angular velocity Ω in the body frame, rad per unit time.
    #[must_use]
    pub fn omega_body(&self) -> Vector<F> {
        // the axial part is larger than the rest, and keeps its digits
        let [x, y, _] = self.in_body(self.state.transverse);
        [x, y, self.state.spin]
    }

    /// Body coordinates of a vector given in the fixed frame.
    #[must_use]
    pub fn in_body(&self, fixed: Vector<F>) -> Vector<F> {
        self.state.orientation.inverse().adjoint(fixed)
    }

    /// Fixed coordinates of a vector given in the body frame.
    #[must_use]
    pub fn in_fixed(&self, body: Vector<F>) -> Vector<F> {
        self.state.orientation.adjoint(body)
    }

    /// Derivatives of the orientation: rotation vectors θ in the fixed frame, with dΦ = θ Φ.
    #[must_use]
    pub fn d_orientation(&self) -> [Vector<F>; COLUMNS] {
        self.map_columns(|tangent, _| tangent.theta)
    }

    /// Derivatives of ω in the fixed frame.
    #[must_use]
    pub fn d_omega(&self) -> [Vector<F>; COLUMNS] {
        let omega = self.omega();
        self.map_columns(|Tangent { theta, eta }, _| add_scaled(*eta, cross(*theta, omega), F::ONE))
    }

    /// Derivatives of Ω in the body frame.
    #[must_use]
    pub fn d_omega_body(&self) -> [Vector<F>; COLUMNS] {
        let in_body = coordinates(self.state.orientation);
        self.map_columns(|tangent, _| in_body(tangent.eta))
    }

    /// Derivatives of the axis r.
    #[must_use]
    pub fn d_axis(&self) -> [Vector<F>; COLUMNS] {
        let axis = self.axis();
        self.map_columns(|tangent, _| cross(tangent.theta, axis))
    }

    /// Tip c = -s (r₁ + i r₂), m; -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn tip(&self) -> Complex<F> {
        self.state.orientation.tip_over_s().scaled(self.tip_scale())
    }

    /// Length s of a sliding top; 1 for a fixed tip.
    fn tip_scale(&self) -> F {
        let s = self.equations.coefficients.s;
        if s > F::ZERO { s } else { F::ONE }
    }

    /// Derivatives of the tip c = -s (r₁ + i r₂), m; of -(r₁ + i r₂) for a fixed tip.
    #[must_use]
    pub fn d_tip(&self) -> [Complex<F>; COLUMNS] {
        let axis = self.axis();
        let scale = self.tip_scale();
        let changes = self.map_columns(|tangent, change| {
            let d_s = change.map_or(F::ZERO, |change| change.s);
            add_scaled(scaled(axis, -d_s), cross(tangent.theta, axis), -scale)
        });
        changes.map(|[x, y, _]| Complex::new(x, y))
    }

    /// Derivatives of the tip angle φ = arg c, rad; `None` where the tip is at the centre.
    #[must_use]
    pub fn d_tip_angle(&self) -> Option<[F; COLUMNS]> {
        let [x, y, _] = self.axis();
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
        let at = Acceleration::new(&self.equations.coefficients, &self.state);
        let is_central = place == [F::ZERO; 3];
        let axis = self.axis();
        let omega = self.omega();
        let arm = self.in_fixed(place);
        let in_body = coordinates(self.state.orientation);
        let velocity = cross(omega, arm);
        let one = F::ONE;
        let mut force = [F::ZERO, F::ZERO, at.support];
        if !is_central {
            let BodyState { transverse, spin, .. } = at.rate;
            let axial = [(cross(self.state.transverse, axis), self.state.spin), (axis, spin)];
            let omega_rate = add_all(transverse, axial);
            force = add_all(force, [(cross(omega_rate, arm), one), (cross(omega, velocity), one)]);
        }
        let changes = self.map_columns(|tangent, change| {
            let Tangent { theta, eta } = *tangent;
            // in the frame that turns by θ, the arm is constant, and the vertical turns by -θ
            let [x, y, _] = vertical_cross(theta);
            let support = self.equations.support_change(&at, tangent, change);
            let mut d_force = [x * at.support, y * at.support, support];
            if !is_central {
                let rate = self.equations.tangent_rate(&at, tangent, change).eta;
                let d_omega_rate = add_scaled(rate, cross(eta, omega), one);
                let terms = [cross(d_omega_rate, arm), cross(eta, velocity), cross(omega, cross(eta, arm))];
                d_force = add_all(d_force, terms.map(|term| (term, one)));
            }
            in_body(d_force)
        });
        (in_body(force), changes)
    }

    /// Body coordinates of a fixed direction, as a magnetometer sees the field, and their derivatives.
    #[must_use]
    pub fn direction(&self, fixed: Vector<F>) -> (Vector<F>, [Vector<F>; COLUMNS]) {
        let in_body = coordinates(self.state.orientation);
        (in_body(fixed), self.map_columns(|tangent, _| in_body(cross(fixed, tangent.theta))))
    }
}

impl<F: Real> Partials<F> {
    /// Turns the motion about the vertical.
    pub(crate) fn turn(&mut self, angle: Phase) {
        let turn = about_third_axis(angle);
        self.state.orientation = turn.compose(&self.state.orientation);
        self.state.transverse = turn.adjoint(self.state.transverse);
        for Tangent { theta, eta } in &mut self.tangents {
            (*theta, *eta) = (turn.adjoint(*theta), turn.adjoint(*eta));
        }
    }
}
