//! Equations of motion in the fixed frame, and the variational equations: the linear equations of a small change of the motion
//! ([partials](crate::partials)).

use crate::sensitivity::coefficients::{Coefficients, RATIOS};
use crate::sensitivity::state::{BodyState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use crate::vector::{Vector, add_all, add_scaled, cross, dot, scaled};
use toytop::Top;
use toytop::scalar::Float;
use toytop::su2::{AttitudeState, Orientation, OrientationRate};

/// Coefficients of a top, and their changes, one for each column from the seventh on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Equations<F> {
    pub(crate) coefficients: Coefficients<F>,
    pub(crate) changes: [Coefficients<F>; RATIOS],
    /// Number of columns that are computed; the others are 0.
    pub(crate) column_count: usize,
}

/// Accelerations of a state, and the quantities that the equations of its changes share.
pub(crate) struct Acceleration<F> {
    state: BodyState<F>,
    axis: Vector<F>,
    /// Rate r' of the axis.
    axis_rate: Vector<F>,
    /// Vector r × k.
    q: Vector<F>,
    /// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
    n_over_a: F,
    /// Acceleration u''.
    u_acceleration: F,
    /// Factor 1 + (p/A) s |q|² of u''.
    factor: F,
    /// Derivatives of `factor` · u'' with respect to ω and to the vertical k.
    by_omega: Vector<F>,
    by_vertical: Vector<F>,
    /// Acceleration g + s u'' of the support, which is the normal force over the mass.
    pub(crate) support: F,
    /// Rates Φ', w' and S', without the rotation about the axis.
    pub(crate) rate: BodyState<F>,
}

/// Cross product k × x.
pub(super) fn vertical_cross<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [-y, x, F::ZERO]
}

/// Cross product x × k.
pub(super) fn cross_vertical<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [y, -x, F::ZERO]
}

/// Transverse part k - u r of the vertical.
fn transverse_vertical<F: Float>(axis: Vector<F>) -> Vector<F> {
    let [.., u] = axis;
    add_scaled([F::ZERO, F::ZERO, F::ONE], axis, -u)
}

impl<F: Float> Acceleration<F> {
    /// Accelerations of a state: the equations of Newton and Euler,
    ///
    /// u'' (1 + (p/A) s |q|²) = ⟨w, r' × k⟩ - (n/A) ⟨r', q⟩ - (p/A) g |q|² - x₂ u',
    /// w' = -(p/A)(g + s u'') q - (n/A) r' - x₂ w - x₃ ⟨ω, k⟩ (k - u r),    S' = -x₁ S.
    #[inline(always)] // where only the rate is used, the rest is not computed
    pub(crate) fn new(coefficients: &Coefficients<F>, state: &BodyState<F>) -> Self {
        let Coefficients { c_over_a, p_over_a, s, g, losses: [x1, x2, x3], .. } = *coefficients;
        let BodyState { orientation, transverse, spin } = *state;
        let axis = orientation.axis();
        let n_over_a = coefficients.n_over_a(spin);
        let one = F::ONE;
        let axis_rate = cross(transverse, axis);
        let q = cross_vertical(axis);
        let q_squared = dot(q, q);
        let axis_rate_q = dot(axis_rate, q);
        let axis_rate_cross_k = cross_vertical(axis_rate);
        let [.., u_rate] = axis_rate;
        let factor = one + p_over_a * s * q_squared;
        let mut force =
            dot(transverse, axis_rate_cross_k) - n_over_a * axis_rate_q - p_over_a * g * q_squared;
        if coefficients.has_losses() {
            force = force - x2 * u_rate;
        }
        let u_acceleration = force / factor;
        let support = g + s * u_acceleration;
        let support_torque = p_over_a * support;
        let mut transverse_rate = add_scaled(scaled(q, -support_torque), axis_rate, -n_over_a);
        let mut spin_rate = F::ZERO;
        if coefficients.has_losses() {
            let [.., omega_k] = state.omega();
            let lost = [(transverse, -x2), (transverse_vertical(axis), -(x3 * omega_k))];
            (transverse_rate, spin_rate) = (add_all(transverse_rate, lost), -(x1 * spin));
        }
        let OrientationRate { alpha, beta } = AttitudeState::from_fixed(orientation, transverse).rate;
        let rate = BodyState {
            orientation: Orientation { alpha, beta },
            transverse: transverse_rate,
            spin: spin_rate,
        };
        // with dr' = dω × r, dq = r × dk, and d(n/A) = (C/A) ⟨dω, r⟩; the term ⟨S r, r' × k⟩ is -S ⟨r', q⟩
        let by_omega = [
            (cross(axis, vertical_cross(transverse)), one),
            (axis, (one - c_over_a) * axis_rate_q),
            (cross(axis, q), -n_over_a),
            (q, -x2),
        ];
        let by_vertical = [
            (cross(axis, axis_rate), n_over_a),
            (cross(q, axis), -support_torque.doubled()),
            (axis_rate, -x2),
        ];
        let by_omega = add_all(axis_rate_cross_k, by_omega);
        let by_vertical = add_all(cross(transverse, axis_rate), by_vertical);
        let state = *state;
        Self {
            state,
            axis,
            axis_rate,
            q,
            n_over_a,
            u_acceleration,
            factor,
            by_omega,
            by_vertical,
            support,
            rate,
        }
    }
}

impl Equations<f64> {
    /// Equations of a top. The last four columns belong to the ratios.
    pub(crate) fn new(top: &Top) -> Self {
        let coefficients = Coefficients::new(top);
        Self { coefficients, changes: coefficients.by_ratios(top.support()), column_count: COLUMNS }
    }

    /// Equations in the scalar of a computation.
    pub(crate) fn cast<F: Float>(&self) -> Equations<F> {
        Equations {
            coefficients: self.coefficients.cast(),
            changes: self.changes.map(|by| by.cast()),
            column_count: self.column_count,
        }
    }

    /// Upper bound on the frequencies of the motion, rad per unit time:
    ///
    /// √((n/A)² + pg/A) + (2 + √(ps/A)) · (greatest rate of the axis)
    ///
    /// Gravity accelerates the axis until it points down, or until the gyroscopic torque has turned it. The smaller of the two rates is
    /// the bound.
    pub(crate) fn frequency(&self, state: &BodyState<f64>) -> f64 {
        let Coefficients { p_over_a, s, g, .. } = self.coefficients;
        let axis = state.orientation.axis();
        let rate = cross(state.transverse, axis);
        let [.., u_rate] = rate;
        let [.., u] = axis;
        let n_over_a = self.coefficients.n_over_a(state.spin).abs();
        let square = dot(rate, rate) + p_over_a * s * u_rate * u_rate;
        let hanging = libm::sqrt(square + 2.0 * p_over_a * g * (1.0 + u));
        let driven = libm::sqrt(square) + 2.0 * p_over_a * g / n_over_a;
        let sum = libm::sqrt(n_over_a * n_over_a + p_over_a * g)
            + hanging.min(driven) * (2.0 + libm::sqrt(p_over_a * s));
        // a body at rest without torque has no frequency
        if sum > 0.0 { sum } else { 1.0 }
    }
}

impl<F: Float> Equations<F> {
    /// Change of the coefficients in a column; `None` for a column of the launch.
    pub(crate) fn change(&self, column: usize) -> Option<&Coefficients<F>> {
        self.changes.get(column.wrapping_sub(LAUNCH_COLUMNS))
    }

    /// Change of the support's acceleration g + s u'' caused by a tangent and by a change of the coefficients.
    ///
    /// In the frame that θ turns, the vertical turns by -θ and ω changes by η.
    pub(crate) fn support_change(
        &self,
        at: &Acceleration<F>,
        &Tangent { theta, eta }: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> F {
        let Coefficients { p_over_a, s, .. } = self.coefficients;
        let force = dot(eta, at.by_omega) + dot(vertical_cross(theta), at.by_vertical);
        let Some(change) = change else { return s * (force / at.factor) };
        let [.., u_rate] = at.axis_rate;
        let [_, d_x2, _] = change.losses;
        let direct = change.g + at.u_acceleration * change.s;
        let force = force
            - change.c_over_a * at.state.spin * dot(at.axis_rate, at.q)
            - (change.p_over_a * at.support + p_over_a * direct) * dot(at.q, at.q)
            - d_x2 * u_rate;
        direct + s * (force / at.factor)
    }

    /// Rate of a tangent: η and η'.
    pub(crate) fn tangent_rate(
        &self,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Tangent<F> {
        let Coefficients { c_over_a, p_over_a, .. } = self.coefficients;
        let Tangent { theta, eta } = *tangent;
        let mut d_support_torque = p_over_a * self.support_change(at, tangent, change);
        let mut d_n_over_a = (c_over_a - F::ONE) * dot(eta, at.axis);
        if let Some(change) = change {
            d_support_torque = d_support_torque + change.p_over_a * at.support;
            d_n_over_a = d_n_over_a + change.c_over_a * at.state.spin;
        }
        let terms = [
            (cross(at.axis, vertical_cross(theta)), -(p_over_a * at.support)),
            (at.q, -d_support_torque),
            (at.axis_rate, -d_n_over_a),
            (cross(eta, at.axis), -at.n_over_a),
        ];
        let mut rate = add_all(cross(at.state.transverse, eta), terms);
        if self.coefficients.has_losses() || change.is_some_and(Coefficients::has_losses) {
            rate = add_scaled(rate, self.loss_change(at, tangent, change), -F::ONE);
        }
        Tangent { theta: eta, eta: rate }
    }

    /// Reduction of η' by the losses, without the part of the support.
    fn loss_change(
        &self,
        at: &Acceleration<F>,
        &Tangent { theta, eta }: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Vector<F> {
        let [x1, x2, x3] = self.coefficients.losses;
        let [d_x1, d_x2, d_x3] = change.map_or([F::ZERO; 3], |change| change.losses);
        let axis = at.axis;
        let omega = at.state.omega();
        let d_k = vertical_cross(theta);
        let [.., omega_k] = omega;
        let [.., eta_k] = eta;
        let d_spin = dot(eta, axis);
        let d_omega_k = eta_k + dot(omega, d_k);
        let terms = [
            (axis, (x1 - x2) * d_spin + d_x1 * at.state.spin),
            (at.state.transverse, d_x2),
            (transverse_vertical(axis), x3 * d_omega_k + d_x3 * omega_k),
            (add_scaled(d_k, axis, -dot(axis, d_k)), x3 * omega_k),
        ];
        add_all(scaled(eta, x2), terms)
    }
}
