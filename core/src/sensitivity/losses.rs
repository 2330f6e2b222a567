//! Losses of rotation: torques that make l, n and h drift.
//!
//! With the losses x₁, x₂, x₃ the torques are those that alone would change ω by -x₁ S r, by -x₂ w, and by
//! -x₃ ⟨ω, k⟩ (k - u r): loss of the rotation about the axis, of that across it, and of that about the vertical. The
//! derivation is in `docs/partials.md`.

use crate::phase::Phase;
use crate::scalar::Float;
use crate::sensitivity::coefficients::{Coefficients, LOSSES};
use crate::sensitivity::equations::{Acceleration, Equations, vertical_cross};
use crate::sensitivity::flow::{Flow, Tangent, total};
use crate::su2::{Vector, bracket, dot};

/// Part k - u r of the vertical across the axis.
fn level<F: Float>(axis: Vector<F>) -> Vector<F> {
    let ([.., u], up) = (axis, [F::ZERO, F::ZERO, F::ONE]);
    total(up, axis, -u)
}

impl<F: Float> Equations<F> {
    /// Adds the torques of the losses to the accelerations of the exact motion.
    pub(super) fn lose<const N: usize>(&self, at: &mut Acceleration<F>, flow: &Flow<F, N>) {
        let Coefficients { moment, height, losses: [axial, across, vertical], .. } = self.coefficients;
        let [.., rise] = at.axis_rate;
        let [.., turning] = flow.omega();
        // the torque of the second loss lifts the centre of mass; the others do not
        let lift = -(across * rise) / at.factor;
        at.u = at.u + lift;
        at.support = at.support + height * lift;
        at.by_omega = total(at.by_omega, at.lever, -across);
        at.by_vertical = total(at.by_vertical, at.axis_rate, -across);
        let by_lift = (moment * height * lift).doubled();
        at.by_vertical = total(at.by_vertical, bracket(at.lever, flow.axis), -by_lift);
        at.across = total(at.across, at.lever, -(moment * height * lift));
        at.across = total(at.across, flow.across, -across);
        at.across = total(at.across, level(flow.axis), -(vertical * turning));
        at.spin = -(axial * flow.spin);
    }

    /// Lift that a change of the second loss takes away, times `factor`.
    pub(super) fn lost_lift(by: &Coefficients<F>, at: &Acceleration<F>) -> F {
        let ([_, across, _], [.., rise]) = (by.losses, at.axis_rate);
        across * rise
    }

    /// Reduction of η' by the losses, without the part of the support.
    pub(super) fn lost_change<const N: usize>(
        &self,
        flow: &Flow<F, N>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> Vector<F> {
        let [axial, across, vertical] = self.coefficients.losses;
        let (axis, omega, eta) = (flow.axis, flow.omega(), tangent.eta);
        let [.., turning] = omega;
        let spin_change = dot(eta, axis);
        let up_change = vertical_cross(tangent.theta);
        let level_change = total(up_change, axis, -dot(axis, up_change));
        let [.., turned] = eta;
        let turning_change = turned + dot(omega, up_change);
        let across_change = total(eta, axis, -spin_change);
        let mut lost = axis.map(|x| axial * spin_change * x);
        lost = total(lost, across_change, across);
        lost = total(lost, level(axis), vertical * turning_change);
        lost = total(lost, level_change, vertical * turning);
        if let Some(Coefficients { losses: [axial, across, vertical], .. }) = change {
            lost = total(lost, axis, *axial * flow.spin);
            lost = total(lost, flow.across, *across);
            lost = total(lost, level(axis), *vertical * turning);
        }
        lost
    }
}

impl Equations<f64> {
    /// Equations with these losses of rotation, per unit time.
    pub(crate) fn with_losses(mut self, losses: [f64; LOSSES]) -> Self {
        self.coefficients.losses = losses;
        self.lossy = true;
        self
    }

    /// Derivatives of the rates of l/A, n/A and h/A with respect to each loss.
    pub(crate) fn integral_rates<const N: usize>(&self, flow: &Flow<f64, N>) -> [Vector<f64>; 3] {
        let Coefficients { inertia, .. } = self.coefficients;
        let ([.., u], across, spin) = (flow.axis, flow.across, flow.spin);
        let [.., turning] = flow.omega();
        let [.., vertical] = across;
        let slope = 1.0 - u * u;
        // a torque τ changes l by ⟨τ, k⟩, n by ⟨τ, r⟩ and h by ⟨τ, ω⟩
        let by_axial = [inertia * spin * u, inertia * spin, inertia * spin * spin];
        let by_across = [vertical, 0.0, dot(across, across)];
        let by_vertical = [turning * slope, 0.0, turning * vertical];
        [by_axial, by_across, by_vertical].map(|by| by.map(|x| -x))
    }
}

impl Coefficients<f64> {
    /// Angle by which the body has turned about its axis at a time, from S at the start.
    pub(crate) fn rolled(&self, spin: f64, t: f64) -> Phase {
        let [axial, ..] = self.losses;
        let lost = axial * t;
        // (1 - e⁻ˣ)/x
        let mean = if lost == 0.0 { 1.0 } else { -libm::expm1(-lost) / lost };
        Phase::from_radians(spin * t * mean)
    }
}
