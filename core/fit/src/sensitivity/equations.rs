//! Equations of motion in the fixed frame, and the linear equations of a small change of the motion (`docs/partials.md`).

use crate::sensitivity::coefficients::{Coefficients, RATIOS, by_ratios, coefficients};
use crate::sensitivity::flow::{COLUMNS, Flow, LAUNCH_COLUMNS, Tangent};
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
    /// Vector q = r × k.
    lever: Vector<F>,
    /// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
    gyroscopic: F,
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
    pub(crate) fn frequency<const N: usize>(&self, flow: &Flow<f64, N>) -> f64 {
        let [_, moment, height, gravity, ..] = self.coefficients;
        let rate = cross(flow.across, flow.axis);
        let ([.., rise], [.., u], gyroscopic) = (rate, flow.axis, libm::fabs(self.gyroscopic(flow.spin)));
        let square = dot(rate, rate) + moment * height * rise * rise;
        let hanging = libm::sqrt(square + 2.0 * moment * gravity * (1.0 + u));
        let driven = libm::sqrt(square) + 2.0 * moment * gravity / gyroscopic;
        let sum = libm::sqrt(gyroscopic * gyroscopic + moment * gravity)
            + hanging.min(driven) * (2.0 + libm::sqrt(moment * height));
        if sum > 0.0 { sum } else { 1.0 }
    }
}

impl<F: Float> Equations<F> {
    /// Rate n/A = (C/A) S + K/A.
    pub(crate) fn gyroscopic(&self, spin: F) -> F {
        let [inertia, _, _, _, rotor, ..] = self.coefficients;
        inertia * spin + rotor
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
    pub(crate) fn acceleration<const N: usize>(&self, flow: &Flow<F, N>) -> Acceleration<F> {
        let [inertia, moment, height, gravity, _, axial, loss, vertical] = self.coefficients;
        let Flow { axis, across, spin, .. } = *flow;
        let (axis_rate, lever, gyroscopic) =
            (cross(across, axis), cross_vertical(axis), self.gyroscopic(spin));
        let (lift, gyration) = (moment * dot_level(lever, lever), dot_level(axis_rate, lever));
        let (inward, [.., rise]) = (cross_vertical(axis_rate), axis_rate);
        let factor = F::ONE + height * lift;
        let mut force = dot_level(across, inward) - gyroscopic * gyration - gravity * lift;
        if self.lossy {
            force = force - loss * rise;
        }
        let u = force / factor;
        let support = gravity + height * u;
        let push = moment * support;
        // with dr' = dω × r, dq = r × dk, and d(n/A) = (C/A) ⟨dω, r⟩; the term ⟨S r, r' × k⟩ is -S ⟨r', q⟩
        let by_omega = add_scaled(inward, cross(axis, vertical_cross(across)), F::ONE);
        let by_omega = add_scaled(by_omega, axis, (F::ONE - inertia) * gyration);
        let mut by_omega = add_scaled(by_omega, cross(axis, lever), -gyroscopic);
        let by_vertical = add_scaled(cross(across, axis_rate), cross(axis, axis_rate), gyroscopic);
        let mut by_vertical = add_scaled(by_vertical, cross(lever, axis), -push.doubled());
        let (mut rate, mut spin_rate) = (add_scaled(scaled(lever, -push), axis_rate, -gyroscopic), F::ZERO);
        if self.lossy {
            let [.., turning] = flow.omega();
            by_omega = add_scaled(by_omega, lever, -loss);
            by_vertical = add_scaled(by_vertical, axis_rate, -loss);
            rate = add_scaled(add_scaled(rate, across, -loss), vertical_across(axis), -(vertical * turning));
            spin_rate = -(axial * spin);
        }
        Acceleration {
            axis_rate,
            lever,
            gyroscopic,
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
        let [_, moment, height, ..] = self.coefficients;
        let vertical = vertical_cross(tangent.theta); // dk = k × θ
        let mut force = dot(tangent.eta, at.by_omega) + dot_level(vertical, at.by_vertical);
        let mut direct = F::ZERO;
        if let Some(&[by_inertia, by_moment, by_height, by_gravity, _, _, by_loss, _]) = change {
            let ([.., rise], square) = (at.axis_rate, dot_level(at.lever, at.lever));
            direct = by_gravity + at.u * by_height;
            force = force
                - by_inertia * spin * dot_level(at.axis_rate, at.lever)
                - (by_moment * at.support + moment * direct) * square
                - by_loss * rise;
        }
        direct + height * (force / at.factor)
    }

    /// Rate of a tangent: η and η'.
    pub(crate) fn tangent_rate<const N: usize>(
        &self,
        flow: &Flow<F, N>,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Tangent<F> {
        let [inertia, moment, ..] = self.coefficients;
        let (axis, eta) = (flow.axis, tangent.eta);
        let mut push = moment * self.support_change(flow.spin, at, tangent, change);
        let mut gyroscopic = (inertia - F::ONE) * dot(eta, axis);
        if let Some(&[by_inertia, by_moment, ..]) = change {
            push = push + by_moment * at.support;
            gyroscopic = gyroscopic + by_inertia * flow.spin;
        }
        let lever_change = cross(axis, vertical_cross(tangent.theta));
        let rate = add_scaled(scaled(lever_change, -(moment * at.support)), at.lever, -push);
        let rate = add_scaled(rate, at.axis_rate, -gyroscopic);
        let rate = add_scaled(rate, cross(eta, axis), -at.gyroscopic);
        let mut rate = add_scaled(rate, cross(eta, flow.across), -F::ONE);
        if self.lossy {
            rate = add_scaled(rate, self.loss_change(flow, tangent, change), -F::ONE);
        }
        Tangent { theta: eta, eta: rate }
    }

    /// Reduction of η' by the losses, without the part of the support.
    fn loss_change<const N: usize>(
        &self,
        flow: &Flow<F, N>,
        &Tangent { theta, eta }: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Vector<F> {
        let [.., axial, across, vertical] = self.coefficients;
        let (axis, omega, up_change) = (flow.axis, flow.omega(), vertical_cross(theta));
        let ([.., turning], [.., turned], spin_change) = (omega, eta, dot(eta, axis));
        let level_change = add_scaled(up_change, axis, -dot(axis, up_change));
        let lost = scaled(axis, (axial - across) * spin_change);
        let lost = add_scaled(lost, eta, across);
        let lost = add_scaled(lost, vertical_across(axis), vertical * (turned + dot(omega, up_change)));
        let lost = add_scaled(lost, level_change, vertical * turning);
        let Some(&[.., axial, across, vertical]) = change else { return lost };
        let lost = add_scaled(lost, axis, axial * flow.spin);
        add_scaled(add_scaled(lost, flow.across, across), vertical_across(axis), vertical * turning)
    }

    /// Sets `rate` to the rate of a state and its tangents.
    pub(crate) fn set_rate<const N: usize>(&self, flow: &Flow<F, N>, rate: &mut Flow<F, N>) {
        let at = self.acceleration(flow);
        (rate.axis, rate.side) = (at.axis_rate, cross(flow.across, flow.side));
        (rate.across, rate.spin) = (at.across, at.spin);
        let tangents = rate.tangents.iter_mut().zip(&flow.tangents).take(self.columns);
        for (column, (slot, tangent)) in tangents.enumerate() {
            *slot = self.tangent_rate(flow, &at, tangent, self.change(column));
        }
    }
}
