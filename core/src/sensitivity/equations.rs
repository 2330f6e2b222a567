//! Equations of motion in the fixed frame, and the linear equations of a small change of the motion.

use crate::scalar::Float;
use crate::sensitivity::LAUNCH;
use crate::sensitivity::coefficients::Coefficients;
use crate::sensitivity::flow::{Flow, Tangent, total};
use crate::su2::{Vector, bracket, dot};
use crate::top::Top;

/// Coefficients of a top, and their changes, one for each column from the seventh on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Equations<F> {
    pub(crate) coefficients: Coefficients<F>,
    pub(crate) changes: [Coefficients<F>; 4],
    /// Whether there are losses, or columns that are derivatives with respect to losses.
    pub(crate) lossy: bool,
}

/// Vertical acceleration of the axis, its derivatives, and the rates that lead to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acceleration<F> {
    /// Rate r' of the axis.
    pub(crate) axis_rate: Vector<F>,
    /// Vector q = r × k.
    pub(super) lever: Vector<F>,
    /// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
    gyroscopic: F,
    /// Acceleration u''.
    pub(crate) u: F,
    /// Factor 1 + (p/A) s |q|² of u''.
    pub(super) factor: F,
    /// Derivatives of `factor` · u'' with respect to ω and to the vertical k, in the frame that rotates with the change.
    pub(super) by_omega: Vector<F>,
    pub(super) by_vertical: Vector<F>,
    /// Acceleration g + s u'' of the support, which is the normal force over the mass.
    pub(crate) support: F,
    /// Rate w'.
    pub(crate) across: Vector<F>,
    /// Rate S'; 0 without losses.
    pub(crate) spin: F,
}

/// Cross product k × x with the vertical k.
pub(super) fn vertical_cross<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [-y, x, F::ZERO]
}

/// Cross product x × k with the vertical k.
fn cross_vertical<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [y, -x, F::ZERO]
}

impl<F: Float> Flow<F, 0> {
    /// Rate of a state with these accelerations.
    pub(crate) fn rate(&self, at: &Acceleration<F>) -> Self {
        Self {
            axis: at.axis_rate,
            side: bracket(self.across, self.side),
            across: at.across,
            spin: at.spin,
            tangents: [],
        }
    }
}

impl Equations<f64> {
    pub(crate) fn of(top: &Top) -> Self {
        let coefficients = Coefficients::of(top);
        Self { coefficients, changes: coefficients.derivatives(top.support()), lossy: false }
    }

    /// Equations of the state alone.
    pub(crate) fn of_state(coefficients: &Coefficients<f64>) -> Self {
        let lossy = coefficients.losses.iter().any(|loss| *loss != 0.0);
        Self { coefficients: *coefficients, changes: [Coefficients::NONE; 4], lossy }
    }

    /// Upper bound on the frequencies of the motion after a state, rad per unit time: the frequency of the gyroscopic
    /// torque, plus twice the greatest rate of the axis. Gravity accelerates the axis until it points down, or until
    /// the gyroscopic torque has turned it. The term √(ps/A) allows for the axis of a sliding top, which is faster
    /// near the vertical. It is 1 for a body at rest without torque.
    pub(crate) fn fastest<const N: usize>(&self, flow: &Flow<f64, N>) -> f64 {
        let Coefficients { moment, height, gravity, .. } = self.coefficients;
        let rate = bracket(flow.across, flow.axis);
        let ([.., rise], [.., u], gyroscopic) = (rate, flow.axis, Float::abs(self.gyroscopic(flow.spin)));
        let square = dot(rate, rate) + moment * height * rise * rise;
        let hanging = libm::sqrt(square + 2.0 * moment * gravity * (1.0 + u));
        let driven = libm::sqrt(square) + 2.0 * moment * gravity / gyroscopic;
        let sum = libm::sqrt(gyroscopic * gyroscopic + moment * gravity)
            + hanging.min(driven) * (2.0 + libm::sqrt(moment * height));
        if sum > 0.0 { sum } else { 1.0 }
    }

    /// Equations in another scalar.
    pub(crate) fn cast<F: Float>(&self) -> Equations<F> {
        Equations {
            coefficients: self.coefficients.cast(),
            changes: self.changes.map(|change| change.cast()),
            lossy: self.lossy,
        }
    }
}

impl<F: Float> Acceleration<F> {
    /// Placeholder for accelerations that are not computed yet.
    pub(crate) const ZERO: Self = Self {
        axis_rate: [F::ZERO; 3],
        lever: [F::ZERO; 3],
        gyroscopic: F::ZERO,
        u: F::ZERO,
        factor: F::ZERO,
        by_omega: [F::ZERO; 3],
        by_vertical: [F::ZERO; 3],
        support: F::ZERO,
        across: [F::ZERO; 3],
        spin: F::ZERO,
    };
}

impl<F: Float> Equations<F> {
    /// Rate n/A = (C/A) S + K/A.
    fn gyroscopic(&self, spin: F) -> F {
        self.coefficients.inertia * spin + self.coefficients.rotor
    }

    /// Accelerations at an axis r, a part w of ω, and an S: the equations of Newton and Euler,
    ///
    /// u'' (1 + (p/A) s |q|²) = ⟨w, r' × k⟩ - (n/A) ⟨r', q⟩ - (p/A) g |q|²,
    /// w' = -(p/A)(g + s u'') q - (n/A) r',
    ///
    /// with the torques of the losses.
    pub(crate) fn acceleration<const N: usize>(&self, flow: &Flow<F, N>) -> Acceleration<F> {
        let Coefficients { inertia, moment, height, gravity, .. } = self.coefficients;
        let Flow { axis, across, spin, .. } = *flow;
        let axis_rate = bracket(across, axis);
        let lever = cross_vertical(axis);
        let gyroscopic = self.gyroscopic(spin);
        let lever_squared = dot(lever, lever);
        let gyration = dot(axis_rate, lever);
        let factor = F::ONE + moment * height * lever_squared;
        let inward = cross_vertical(axis_rate);
        let u = (dot(across, inward) - gyroscopic * gyration - moment * gravity * lever_squared) / factor;
        let support = gravity + height * u;
        // with dr' = dω × r, dq = r × dk, and d(n/A) = (C/A) ⟨dω, r⟩; the term ⟨S r, r' × k⟩ is -S ⟨r', q⟩
        let by_omega = total(inward, bracket(axis, vertical_cross(across)), F::ONE);
        let by_omega = total(by_omega, axis, (F::ONE - inertia) * gyration);
        let by_omega = total(by_omega, bracket(axis, lever), -gyroscopic);
        let by_vertical = total(bracket(across, axis_rate), bracket(axis, axis_rate), gyroscopic);
        let by_vertical = total(by_vertical, bracket(lever, axis), -(moment * support).doubled());
        let rate = total(lever.map(|x| -(moment * support) * x), axis_rate, -gyroscopic);
        let mut at = Acceleration {
            axis_rate,
            lever,
            gyroscopic,
            u,
            factor,
            by_omega,
            by_vertical,
            support,
            across: rate,
            spin: F::ZERO,
        };
        if self.lossy {
            self.lose(&mut at, flow);
        }
        at
    }

    /// Change of the support's acceleration g + s u'' caused by a tangent and by `change`, the change of the coefficients.
    ///
    /// A rotation of everything, gravity included, by θ leaves the equations as they are. Therefore the change is that of the
    /// equations with the vertical turned by -θ and ω changed by η, in the frame that θ turns.
    pub(crate) fn support_change(
        &self,
        spin: F,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> F {
        let Coefficients { moment, height, .. } = self.coefficients;
        let vertical = vertical_cross(tangent.theta); // δk = k × θ
        let mut force = dot(tangent.eta, at.by_omega) + dot(vertical, at.by_vertical);
        let mut direct = F::ZERO;
        if let Some(by) = change {
            let square = dot(at.lever, at.lever);
            direct = by.gravity + at.u * by.height;
            force = force
                - by.inertia * spin * dot(at.axis_rate, at.lever)
                - (by.moment * at.support + moment * direct) * square;
            if self.lossy {
                force = force - Self::lost_lift(by, at);
            }
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
        let Coefficients { inertia, moment, .. } = self.coefficients;
        let (axis, eta) = (flow.axis, tangent.eta);
        let lever = bracket(axis, vertical_cross(tangent.theta));
        let spin = dot(eta, axis);
        let mut push = moment * self.support_change(flow.spin, at, tangent, change);
        let mut gyroscopic = (inertia - F::ONE) * spin;
        if let Some(by) = change {
            push = push + by.moment * at.support;
            gyroscopic = gyroscopic + by.inertia * flow.spin;
        }
        let rate = total(lever.map(|x| -(moment * at.support) * x), at.lever, -push);
        let rate = total(rate, at.axis_rate, -gyroscopic);
        let rate = total(rate, bracket(eta, axis), -at.gyroscopic);
        let rate = total(rate, bracket(eta, flow.across), -F::ONE);
        if self.lossy {
            return Tangent {
                theta: eta,
                eta: total(rate, self.lost_change(flow, tangent, change), -F::ONE),
            };
        }
        Tangent { theta: eta, eta: rate }
    }

    /// Rate of a state and its tangents.
    pub(crate) fn rate<const N: usize>(&self, flow: &Flow<F, N>) -> Flow<F, N> {
        let at = self.acceleration(flow);
        let mut tangents = flow.tangents;
        for (index, tangent) in tangents.iter_mut().enumerate() {
            let change = self.changes.get(index.wrapping_sub(LAUNCH));
            *tangent = self.tangent_rate(flow, &at, tangent, change);
        }
        let Flow { axis, side, across, spin, .. } = flow.state().rate(&at);
        Flow { axis, side, across, spin, tangents }
    }

    /// Size of θ below which a column needs no relative accuracy: the size at which a change of its ratio by 100 %
    /// rotates the body by a thousandth of a radian. It is 0 for the columns of the launch, which are never small.
    fn least_size(&self, index: usize) -> F {
        let Some(by) = self.changes.get(index.wrapping_sub(LAUNCH)) else { return F::ZERO };
        let of = &self.coefficients;
        let share = |change: F, value: F| if value > F::ZERO { change.abs() / value } else { F::ZERO };
        let relative = share(by.inertia, of.inertia)
            + share(by.moment, of.moment)
            + share(by.height, of.height)
            + share(by.gravity, of.gravity);
        relative * F::from_f64(1e-3)
    }

    /// Upper bound on the frequencies of the motion at a state, rad per unit time; 1 for a body at rest without torque, because rates are
    /// compared in this unit.
    pub(crate) fn frequency<const N: usize>(&self, flow: &Flow<F, N>) -> F {
        let Coefficients { moment, gravity, .. } = self.coefficients;
        let sum = dot(flow.across, flow.across).sqrt()
            + self.gyroscopic(flow.spin).abs()
            + (moment * gravity).sqrt();
        if sum > F::ZERO { sum } else { F::ONE }
    }

    /// Largest difference of two flows, each part relative to its size. Rates are compared in units of `frequency`.
    pub(crate) fn difference<const N: usize>(&self, one: &Flow<F, N>, other: &Flow<F, N>, frequency: F) -> F {
        let size = |x: Vector<F>| dot(x, x).sqrt();
        let apart = |x: Vector<F>, y: Vector<F>| size(total(x, y, -F::ONE));
        let mut worst = apart(one.axis, other.axis)
            + apart(one.side, other.side)
            + apart(one.across, other.across) / frequency;
        for (index, (a, b)) in one.tangents.iter().zip(&other.tangents).enumerate() {
            let scale = self.least_size(index) + size(a.theta) + size(a.eta) / frequency;
            let error = apart(a.theta, b.theta) + apart(a.eta, b.eta) / frequency;
            if error > worst * scale {
                worst = error / scale;
            }
        }
        worst
    }
}
