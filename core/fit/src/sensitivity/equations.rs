//! Equations of motion in the fixed frame, and the linear equations of a small change of the motion (`docs/partials.md`).

use crate::sensitivity::coefficients::{Coefficients, RATIOS, by_ratios, coefficients};
use crate::sensitivity::state::{AugmentedState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use crate::vector::{Vector, add_scaled, cross, dot, scaled};
use toytop::Top;
use toytop::scalar::Float;

/// Coefficients of a top, and their changes, one for each column from the seventh on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Equations<F> {
    pub(crate) coefficients: Coefficients<F>,
    pub(crate) changes: [Coefficients<F>; RATIOS],
    /// Number of columns that are computed; the others are 0.
    pub(crate) columns: usize,
    /// Whether there are losses, or columns that are derivatives with respect to losses.
    pub(crate) lossy: bool,
}

/// Accelerations of a state, and what the equations of its changes share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acceleration<F> {
    /// Rate r' of the axis.
    axis_rate: Vector<F>,
    /// Vector r × k.
    q: Vector<F>,
    /// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
    n_over_a: F,
    /// Acceleration u''.
    u: F,
    /// Factor 1 + (p/A) s |q|² of u''.
    factor: F,
    /// Derivatives of `factor` · u'' with respect to ω and to the vertical k.
    by_omega: Vector<F>,
    by_vertical: Vector<F>,
    /// Acceleration g + s u'' of the support, which is the normal force over the mass.
    pub(crate) support: F,
    /// Rates w' and S'.
    pub(crate) across: Vector<F>,
    pub(crate) spin: F,
}

/// Cross product k × x.
fn vertical_cross<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [-y, x, F::ZERO]
}

/// Cross product x × k.
pub(super) fn cross_vertical<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [y, -x, F::ZERO]
}

/// Inner product of two vectors, one of which is horizontal.
fn dot_level<F: Float>([x1, y1, _]: Vector<F>, [x2, y2, _]: Vector<F>) -> F {
    x1 * x2 + y1 * y2
}

/// Part k - u r of the vertical across the axis.
fn vertical_across<F: Float>(axis: Vector<F>) -> Vector<F> {
    let [.., u] = axis;
    add_scaled([F::ZERO, F::ZERO, F::ONE], axis, -u)
}

impl Equations<f64> {
    /// Equations of a top, whose last four columns are those of the ratios.
    pub(crate) fn new(top: &Top) -> Self {
        let coefficients = coefficients(top);
        Self {
            coefficients,
            changes: by_ratios(&coefficients, top.support()),
            columns: COLUMNS,
            lossy: false,
        }
    }

    /// Equations in another scalar.
    pub(crate) fn cast<F: Float>(&self) -> Equations<F> {
        let Self { coefficients, changes, columns, lossy } = *self;
        let cast = |numbers: Coefficients| numbers.map(F::from_f64);
        Equations { coefficients: cast(coefficients), changes: changes.map(cast), columns, lossy }
    }

    /// Upper bound on the frequencies of the motion, rad per unit time: that of the gyroscopic torque, plus twice the greatest rate of
    /// the axis. Gravity accelerates the axis until it points down, or until the gyroscopic torque has turned it; the axis of a
    /// sliding top is faster near the vertical by √(ps/A). It is 1 for a body at rest without torque.
    pub(crate) fn frequency<const N: usize>(&self, state: &AugmentedState<f64, N>) -> f64 {
        let [_, p_over_a, s, g, ..] = self.coefficients;
        let rate = cross(state.across, state.axis);
        let ([.., u_rate], [.., u], n_over_a) = (rate, state.axis, libm::fabs(self.n_over_a(state.spin)));
        let square = dot(rate, rate) + p_over_a * s * u_rate * u_rate;
        let hanging = libm::sqrt(square + 2.0 * p_over_a * g * (1.0 + u));
        let driven = libm::sqrt(square) + 2.0 * p_over_a * g / n_over_a;
        let sum = libm::sqrt(n_over_a * n_over_a + p_over_a * g)
            + hanging.min(driven) * (2.0 + libm::sqrt(p_over_a * s));
        if sum > 0.0 { sum } else { 1.0 }
    }
}

impl<F: Float> Equations<F> {
    /// Rate n/A = (C/A) S + K/A.
    pub(crate) fn n_over_a(&self, spin: F) -> F {
        let [c_over_a, _, _, _, k_over_a, ..] = self.coefficients;
        c_over_a * spin + k_over_a
    }

    /// Change of the coefficients in a column; none in those of the launch.
    pub(crate) fn change(&self, column: usize) -> Option<&Coefficients<F>> {
        self.changes.get(column.wrapping_sub(LAUNCH_COLUMNS))
    }

    /// Accelerations of a state: the equations of Newton and Euler,
    ///
    /// u'' (1 + (p/A) s |q|²) = ⟨w, r' × k⟩ - (n/A) ⟨r', q⟩ - (p/A) g |q|² - x₂ u',
    /// w' = -(p/A)(g + s u'') q - (n/A) r' - x₂ w - x₃ ⟨ω, k⟩ (k - u r),    S' = -x₁ S.
    #[inline(always)] // without tangents, what they share is not computed
    pub(crate) fn acceleration<const N: usize>(&self, state: &AugmentedState<F, N>) -> Acceleration<F> {
        let [c_over_a, p_over_a, s, g, _, x1, x2, x3] = self.coefficients;
        let AugmentedState { axis, across, spin, .. } = *state;
        let (axis_rate, q, n_over_a) = (cross(across, axis), cross_vertical(axis), self.n_over_a(spin));
        let (q_squared, axis_rate_q) = (dot_level(q, q), dot_level(axis_rate, q));
        let (axis_rate_cross_k, [.., u_rate]) = (cross_vertical(axis_rate), axis_rate);
        let factor = F::ONE + p_over_a * s * q_squared;
        let mut force =
            dot_level(across, axis_rate_cross_k) - n_over_a * axis_rate_q - p_over_a * g * q_squared;
        if self.lossy {
            force = force - x2 * u_rate;
        }
        let u = force / factor;
        let support = g + s * u;
        let support_torque = p_over_a * support;
        // with dr' = dω × r, dq = r × dk, and d(n/A) = (C/A) ⟨dω, r⟩; the term ⟨S r, r' × k⟩ is -S ⟨r', q⟩
        let by_omega = add_scaled(axis_rate_cross_k, cross(axis, vertical_cross(across)), F::ONE);
        let by_omega = add_scaled(by_omega, axis, (F::ONE - c_over_a) * axis_rate_q);
        let mut by_omega = add_scaled(by_omega, cross(axis, q), -n_over_a);
        let by_vertical = add_scaled(cross(across, axis_rate), cross(axis, axis_rate), n_over_a);
        let mut by_vertical = add_scaled(by_vertical, cross(q, axis), -support_torque.doubled());
        let (mut rate, mut spin_rate) =
            (add_scaled(scaled(q, -support_torque), axis_rate, -n_over_a), F::ZERO);
        if self.lossy {
            let [.., omega_k] = state.omega();
            by_omega = add_scaled(by_omega, q, -x2);
            by_vertical = add_scaled(by_vertical, axis_rate, -x2);
            rate = add_scaled(add_scaled(rate, across, -x2), vertical_across(axis), -(x3 * omega_k));
            spin_rate = -(x1 * spin);
        }
        Acceleration {
            axis_rate,
            q,
            n_over_a,
            u,
            factor,
            by_omega,
            by_vertical,
            support,
            across: rate,
            spin: spin_rate,
        }
    }

    /// Change of the support's acceleration g + s u'' caused by a tangent and by a change of the coefficients.
    ///
    /// In the frame that θ turns, it is that of the equations with the vertical turned by -θ and ω changed by η.
    pub(crate) fn support_change(
        &self,
        spin: F,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> F {
        let [_, p_over_a, s, ..] = self.coefficients;
        let d_k = vertical_cross(tangent.theta);
        let mut force = dot(tangent.eta, at.by_omega) + dot_level(d_k, at.by_vertical);
        let mut direct = F::ZERO;
        if let Some(&[d_c_over_a, d_p_over_a, d_s, d_g, _, _, d_x2, _]) = change {
            let ([.., u_rate], square) = (at.axis_rate, dot_level(at.q, at.q));
            direct = d_g + at.u * d_s;
            force = force
                - d_c_over_a * spin * dot_level(at.axis_rate, at.q)
                - (d_p_over_a * at.support + p_over_a * direct) * square
                - d_x2 * u_rate;
        }
        direct + s * (force / at.factor)
    }

    /// Rate of a tangent: η and η'.
    pub(crate) fn tangent_rate<const N: usize>(
        &self,
        state: &AugmentedState<F, N>,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Tangent<F> {
        let [c_over_a, p_over_a, ..] = self.coefficients;
        let (axis, eta) = (state.axis, tangent.eta);
        let mut d_support_torque = p_over_a * self.support_change(state.spin, at, tangent, change);
        let mut d_n_over_a = (c_over_a - F::ONE) * dot(eta, axis);
        if let Some(&[d_c_over_a, d_p_over_a, ..]) = change {
            d_support_torque = d_support_torque + d_p_over_a * at.support;
            d_n_over_a = d_n_over_a + d_c_over_a * state.spin;
        }
        let d_q = cross(axis, vertical_cross(tangent.theta));
        let rate = add_scaled(scaled(d_q, -(p_over_a * at.support)), at.q, -d_support_torque);
        let rate = add_scaled(rate, at.axis_rate, -d_n_over_a);
        let rate = add_scaled(rate, cross(eta, axis), -at.n_over_a);
        let mut rate = add_scaled(rate, cross(eta, state.across), -F::ONE);
        if self.lossy {
            rate = add_scaled(rate, self.loss_change(state, tangent, change), -F::ONE);
        }
        Tangent { theta: eta, eta: rate }
    }

    /// Reduction of η' by the losses, without the part of the support.
    fn loss_change<const N: usize>(
        &self,
        state: &AugmentedState<F, N>,
        &Tangent { theta, eta }: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Vector<F> {
        let [.., x1, x2, x3] = self.coefficients;
        let (axis, omega, d_k) = (state.axis, state.omega(), vertical_cross(theta));
        let ([.., omega_k], [.., eta_k], d_spin) = (omega, eta, dot(eta, axis));
        let d_k_across = add_scaled(d_k, axis, -dot(axis, d_k));
        let lost = scaled(axis, (x1 - x2) * d_spin);
        let lost = add_scaled(lost, eta, x2);
        let lost = add_scaled(lost, vertical_across(axis), x3 * (eta_k + dot(omega, d_k)));
        let lost = add_scaled(lost, d_k_across, x3 * omega_k);
        let Some(&[.., d_x1, d_x2, d_x3]) = change else { return lost };
        let lost = add_scaled(lost, axis, d_x1 * state.spin);
        add_scaled(add_scaled(lost, state.across, d_x2), vertical_across(axis), d_x3 * omega_k)
    }

    /// Sets `rate` to the rate of a state and its tangents.
    pub(crate) fn set_rate<const N: usize>(
        &self,
        state: &AugmentedState<F, N>,
        rate: &mut AugmentedState<F, N>,
    ) {
        let at = self.acceleration(state);
        (rate.axis, rate.first_axis) = (at.axis_rate, cross(state.across, state.first_axis));
        (rate.across, rate.spin) = (at.across, at.spin);
        let tangents = rate.tangents.iter_mut().zip(&state.tangents).take(self.columns);
        for (column, (slot, tangent)) in tangents.enumerate() {
            *slot = self.tangent_rate(state, &at, tangent, self.change(column));
        }
    }
}
