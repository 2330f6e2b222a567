//! Equations of motion in the fixed frame, and the linear equations of a small change of the motion.

use crate::scalar::Float;
use crate::su2::{Orientation, Vector, bracket, dot};
use crate::top::Top;

/// Coefficients of the equations of motion, or a change of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coefficients<F> {
    /// Ratio C/A.
    pub(crate) inertia: F,
    /// Quotient p/A, 1/m.
    pub(crate) moment: F,
    /// Length s, m; 0 for a fixed tip.
    pub(crate) height: F,
    /// Gravity g, m/s².
    pub(crate) gravity: F,
    /// Rate K/A of a rotor's momentum, rad per unit time.
    pub(crate) rotor: F,
}

/// Coefficients of a top, and the changes of them that belong to the columns from the seventh on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Equations<F> {
    pub(crate) coefficients: Coefficients<F>,
    pub(crate) changes: [Coefficients<F>; 4],
}

/// Small change of a motion: rotation vector θ of the orientation, and its rate η = θ', which is the change of ω seen
/// by an observer who turns by θ. Both are in the fixed frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent<F> {
    pub(crate) theta: Vector<F>,
    pub(crate) eta: Vector<F>,
}

/// State of the motion with N changes of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flow<F, const N: usize> {
    /// Axis r, the third body axis.
    pub(crate) axis: Vector<F>,
    /// First body axis.
    pub(crate) side: Vector<F>,
    /// Angular velocity ω.
    pub(crate) omega: Vector<F>,
    pub(crate) tangents: [Tangent<F>; N],
}

/// Vertical acceleration of the axis, and the rates that lead to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Acceleration<F> {
    /// Rate r' of the axis.
    axis_rate: Vector<F>,
    /// Vector q = r × k.
    lever: Vector<F>,
    /// Axial component S = ω·r.
    spin: F,
    /// Acceleration u''.
    pub(crate) u: F,
    /// Factor 1 + (p/A) s |q|² of u''.
    factor: F,
    /// Acceleration g + s u'' of the support, which is the normal force by the mass.
    pub(crate) support: F,
    /// Rate ω'.
    pub(crate) omega: Vector<F>,
}

/// x + f y.
pub(crate) fn sum<F: Float>([x1, x2, x3]: Vector<F>, [y1, y2, y3]: Vector<F>, f: F) -> Vector<F> {
    [x1 + f * y1, x2 + f * y2, x3 + f * y3]
}

/// k × x of the vertical k.
fn vertical_cross<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [-y, x, F::ZERO]
}

/// x × k of the vertical k.
fn cross_vertical<F: Float>([x, y, _]: Vector<F>) -> Vector<F> {
    [y, -x, F::ZERO]
}

impl Equations<f64> {
    pub(crate) fn of(top: &Top) -> Self {
        let coefficients = Coefficients::of(top);
        Self { coefficients, changes: coefficients.derivatives(top.support()) }
    }
}

impl<F: Float> Equations<F> {
    /// Accelerations at an axis and an angular velocity: the equations of Newton and Euler,
    ///
    /// u'' (1 + (p/A) s |q|²) = ⟨ω, r' × k⟩ - ((C/A - 1) S + K/A) ⟨r', q⟩ - (p/A) g |q|²,
    /// ω' = -(p/A)(g + s u'') q - ((C/A - 1) S + K/A) r'.
    pub(crate) fn acceleration(&self, axis: Vector<F>, omega: Vector<F>) -> Acceleration<F> {
        let Coefficients { inertia, moment, height, gravity, rotor } = self.coefficients;
        let axis_rate = bracket(omega, axis);
        let lever = cross_vertical(axis);
        let spin = dot(omega, axis);
        let gyroscopic = (inertia - F::ONE) * spin + rotor;
        let lever_squared = dot(lever, lever);
        let factor = F::ONE + moment * height * lever_squared;
        let u = (dot(omega, cross_vertical(axis_rate))
            - gyroscopic * dot(axis_rate, lever)
            - moment * gravity * lever_squared)
            / factor;
        let support = gravity + height * u;
        let omega = sum(lever.map(|x| -(moment * support) * x), axis_rate, -gyroscopic);
        Acceleration { axis_rate, lever, spin, u, factor, support, omega }
    }

    /// Rate of a tangent, in which η' is the last entry, and the change of u''. `change` is that of the coefficients.
    ///
    /// A rotation of everything but gravity by θ leaves the equations as they are. So the change is that of the
    /// equations with the vertical turned by -θ and ω changed by η, in the frame that θ turns.
    pub(crate) fn tangent_rate(
        &self,
        axis: Vector<F>,
        omega: Vector<F>,
        at: &Acceleration<F>,
        tangent: &Tangent<F>,
        change: Option<&Coefficients<F>>,
    ) -> (Tangent<F>, F) {
        let Coefficients { inertia, moment, height, gravity, rotor } = self.coefficients;
        let excess = inertia - F::ONE;
        let gyroscopic = excess * at.spin + rotor;
        let eta = tangent.eta;
        let vertical = vertical_cross(tangent.theta); // δk = k × θ
        let axis_rate = bracket(eta, axis);
        let lever = bracket(axis, vertical);
        let spin = dot(eta, axis);
        let lever_squared = dot(at.lever, lever).doubled();
        let gyration = dot(at.axis_rate, at.lever);
        let mut force = dot(eta, cross_vertical(at.axis_rate))
            + dot(omega, cross_vertical(axis_rate))
            + dot(omega, bracket(at.axis_rate, vertical))
            - excess * spin * gyration
            - gyroscopic * (dot(axis_rate, at.lever) + dot(at.axis_rate, lever))
            - moment * gravity * lever_squared;
        let mut factor = moment * height * lever_squared;
        let mut support = F::ZERO;
        let mut torque = [F::ZERO; 3];
        if let Some(by) = change {
            let square = dot(at.lever, at.lever);
            force = force
                - by.inertia * at.spin * gyration
                - (by.moment * gravity + moment * by.gravity) * square;
            factor = factor + (by.moment * height + moment * by.height) * square;
            support = by.gravity + at.u * by.height;
            torque =
                sum(at.lever.map(|x| -(by.moment * at.support) * x), at.axis_rate, -(by.inertia * at.spin));
        }
        let u = (force - at.u * factor) / at.factor;
        support = support + height * u;
        let rate = sum(torque, at.lever, -(moment * support));
        let rate = sum(rate, lever, -(moment * at.support));
        let rate = sum(rate, at.axis_rate, -(excess * spin));
        let rate = sum(rate, axis_rate, -gyroscopic);
        (Tangent { theta: eta, eta: sum(rate, bracket(eta, omega), -F::ONE) }, u)
    }

    /// Rate of a state and its tangents.
    pub(crate) fn rate<const N: usize>(&self, flow: &Flow<F, N>) -> Flow<F, N> {
        let at = self.acceleration(flow.axis, flow.omega);
        let mut tangents = flow.tangents;
        for (index, tangent) in tangents.iter_mut().enumerate() {
            let change = self.changes.get(index.wrapping_sub(6));
            (*tangent, _) = self.tangent_rate(flow.axis, flow.omega, &at, tangent, change);
        }
        Flow { axis: at.axis_rate, side: bracket(flow.omega, flow.side), omega: at.omega, tangents }
    }

    /// Size of θ below which a column needs no relative accuracy: that at which a change of its ratio by the ratio itself
    /// turns the body by a thousandth of a radian. It is 0 for the columns of the launch, which are never small.
    fn least_size(&self, index: usize) -> F {
        let Some(by) = self.changes.get(index.wrapping_sub(6)) else { return F::ZERO };
        let of = &self.coefficients;
        let share = |change: F, value: F| if value > F::ZERO { change.abs() / value } else { F::ZERO };
        let relative = share(by.inertia, of.inertia)
            + share(by.moment, of.moment)
            + share(by.height, of.height)
            + share(by.gravity, of.gravity);
        relative * F::from_f64(1e-3)
    }

    /// Bound on the frequencies of the motion at a state, rad per unit time.
    pub(crate) fn frequency<const N: usize>(&self, flow: &Flow<F, N>) -> F {
        let Coefficients { inertia, moment, gravity, rotor, .. } = self.coefficients;
        let across = bracket(flow.omega, flow.axis);
        let spin = dot(flow.omega, flow.axis);
        dot(across, across).sqrt() + (inertia * spin + rotor).abs() + spin.abs() + (moment * gravity).sqrt()
    }
}

impl<F: Float> Tangent<F> {
    const NONE: Self = Self { theta: [F::ZERO; 3], eta: [F::ZERO; 3] };

    /// Sum of this tangent and f times another.
    pub(crate) fn plus(&self, other: &Self, f: F) -> Self {
        Self { theta: sum(self.theta, other.theta, f), eta: sum(self.eta, other.eta, f) }
    }

    /// Tangent of a change of Φ and of ω in the fixed frame.
    fn of_change(theta: Vector<F>, change: Vector<F>, omega: Vector<F>) -> Self {
        Self { theta, eta: sum(change, bracket(theta, omega), -F::ONE) }
    }
}

impl<F: Float, const N: usize> Flow<F, N> {
    /// Flow at the launch: the first six tangents are the unit changes of Φ and ω, the others are 0.
    pub(crate) fn launched(phi: &Orientation<F>, omega: Vector<F>) -> Self {
        let [zero, one] = [F::ZERO, F::ONE];
        let mut tangents = [Tangent::NONE; N];
        for (index, tangent) in tangents.iter_mut().enumerate() {
            let unit = |first: usize| {
                let is = |k: usize| if index == first + k { one } else { zero };
                [is(0), is(1), is(2)]
            };
            *tangent = Tangent::of_change(unit(0), unit(3), omega);
        }
        let [axis, side] = [[zero, zero, one], [one, zero, zero]].map(|body| phi.adjoint(body));
        Self { axis, side, omega, tangents }
    }

    /// Flow with another number of tangents: the first ones, or with 0 for those that are missing.
    pub(crate) fn resized<const M: usize>(&self) -> Flow<F, M> {
        let mut tangents = [Tangent::NONE; M];
        for (slot, tangent) in tangents.iter_mut().zip(&self.tangents) {
            *slot = *tangent;
        }
        Flow { axis: self.axis, side: self.side, omega: self.omega, tangents }
    }

    /// Body coordinates of a vector of the fixed frame.
    pub(crate) fn in_body(&self, x: Vector<F>) -> Vector<F> {
        [dot(self.side, x), dot(bracket(self.axis, self.side), x), dot(self.axis, x)]
    }

    /// Fixed coordinates of a vector of the body frame.
    pub(crate) fn in_fixed(&self, [x, y, z]: Vector<F>) -> Vector<F> {
        let across = bracket(self.axis, self.side);
        sum(sum(self.side.map(|c| c * x), across, y), self.axis, z)
    }

    /// Sum of this flow and f times another.
    pub(crate) fn plus(&self, other: &Self, f: F) -> Self {
        let mut tangents = self.tangents;
        for (tangent, rate) in tangents.iter_mut().zip(&other.tangents) {
            *tangent = tangent.plus(rate, f);
        }
        Self {
            axis: sum(self.axis, other.axis, f),
            side: sum(self.side, other.side, f),
            omega: sum(self.omega, other.omega, f),
            tangents,
        }
    }

    /// Largest difference from another flow, each part relative to its size. Rates are compared in units of
    /// `frequency`.
    pub(crate) fn difference(&self, other: &Self, equations: &Equations<F>, frequency: F) -> F {
        let size = |x: Vector<F>| dot(x, x).sqrt();
        let apart = |x: Vector<F>, y: Vector<F>| size(sum(x, y, -F::ONE));
        let mut worst = apart(self.axis, other.axis)
            + apart(self.side, other.side)
            + apart(self.omega, other.omega) / frequency;
        for (index, (a, b)) in self.tangents.iter().zip(&other.tangents).enumerate() {
            let scale = equations.least_size(index) + size(a.theta) + size(a.eta) / frequency;
            let error = apart(a.theta, b.theta) + apart(a.eta, b.eta) / frequency;
            if error > worst * scale {
                worst = error / scale;
            }
        }
        worst
    }
}
