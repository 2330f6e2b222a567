//! State of a motion, and small changes of it.

use crate::phase::Phase;
use crate::scalar::{Float, Real};
use crate::su2::{Orientation, Vector, bracket, dot};

/// Small change of a motion: rotation vector θ of the orientation, and its rate η = θ', which is the change of ω in a
/// frame that turns by θ. Both are in the fixed frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent<F> {
    pub(crate) theta: Vector<F>,
    pub(crate) eta: Vector<F>,
}

/// State of the motion, and N changes of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flow<F, const N: usize> {
    /// Axis r, the third body axis.
    pub(crate) axis: Vector<F>,
    /// First body axis, turned back by the angle that the body has turned about r. Therefore it does not rotate about r.
    pub(crate) side: Vector<F>,
    /// Part w = ω - S r of the angular velocity across the axis. It keeps its digits where S is much larger.
    pub(crate) across: Vector<F>,
    /// Axial component S = ⟨ω, r⟩ of the angular velocity. It is constant without losses.
    pub(crate) spin: F,
    pub(crate) tangents: [Tangent<F>; N],
}

/// x + f y.
pub(crate) fn total<F: Float>([x1, x2, x3]: Vector<F>, [y1, y2, y3]: Vector<F>, f: F) -> Vector<F> {
    [x1 + f * y1, x2 + f * y2, x3 + f * y3]
}

impl<F: Float> Tangent<F> {
    /// Zero tangent.
    pub(crate) const NONE: Self = Self { theta: [F::ZERO; 3], eta: [F::ZERO; 3] };

    /// Sum of this tangent and f times another.
    pub(crate) fn plus(&self, other: &Self, f: F) -> Self {
        Self { theta: total(self.theta, other.theta, f), eta: total(self.eta, other.eta, f) }
    }

    /// Tangent at the launch: a unit change of a component of Φ or of ω in the fixed frame, or none from the seventh on.
    pub(crate) fn of_launch(index: usize, omega: Vector<F>) -> Self {
        let unit = |first: usize| [0, 1, 2].map(|k| if index == first + k { F::ONE } else { F::ZERO });
        let (theta, change) = (unit(0), unit(3));
        Self { theta, eta: total(change, bracket(theta, omega), -F::ONE) }
    }
}

impl<const N: usize> Flow<f64, N> {
    /// Flow in another scalar.
    pub(crate) fn cast<F: Float>(&self) -> Flow<F, N> {
        let of = |x: Vector<f64>| x.map(F::from_f64);
        Flow {
            axis: of(self.axis),
            side: of(self.side),
            across: of(self.across),
            spin: F::from_f64(self.spin),
            tangents: self.tangents.map(|Tangent { theta, eta }| Tangent { theta: of(theta), eta: of(eta) }),
        }
    }
}

impl<F: Float, const N: usize> Flow<F, N> {
    /// Flow of zeros.
    pub(crate) const ZERO: Self = Self {
        axis: [F::ZERO; 3],
        side: [F::ZERO; 3],
        across: [F::ZERO; 3],
        spin: F::ZERO,
        tangents: [Tangent::NONE; N],
    };

    /// Flow at the launch: the first six tangents are the unit changes of Φ and ω, the others are 0.
    pub(crate) fn launched(phi: &Orientation<F>, omega: Vector<F>) -> Self {
        let [zero, one] = [F::ZERO, F::ONE];
        let mut tangents = [Tangent::NONE; N];
        for (index, tangent) in tangents.iter_mut().enumerate() {
            *tangent = Tangent::of_launch(index, omega);
        }
        let [axis, side] = [[zero, zero, one], [one, zero, zero]].map(|body| phi.adjoint(body));
        let spin = dot(omega, axis);
        Self { axis, side, across: total(omega, axis, -spin), spin, tangents }
    }

    /// Angular velocity ω = w + S r.
    pub(crate) fn omega(&self) -> Vector<F> {
        total(self.across, self.axis, self.spin)
    }

    /// State without tangents.
    pub(crate) fn state(&self) -> Flow<F, 0> {
        let Self { axis, side, across, spin, .. } = *self;
        Flow { axis, side, across, spin, tangents: [] }
    }

    /// Sets the state; the tangents are not changed.
    pub(crate) fn set_state(&mut self, state: &Flow<F, 0>) {
        (self.axis, self.side) = (state.axis, state.side);
        (self.across, self.spin) = (state.across, state.spin);
    }

    /// Body coordinates of a vector of the fixed frame.
    pub(crate) fn in_body(&self, x: Vector<F>) -> Vector<F> {
        [dot(self.side, x), dot(bracket(self.axis, self.side), x), dot(self.axis, x)]
    }

    /// Fixed coordinates of a vector of the body frame.
    pub(crate) fn in_fixed(&self, [x, y, z]: Vector<F>) -> Vector<F> {
        let across = bracket(self.axis, self.side);
        total(total(self.side.map(|c| c * x), across, y), self.axis, z)
    }

    /// Adds f times another flow to the state and to the first `known` tangents.
    pub(crate) fn add(&mut self, other: &Self, f: F, known: usize) {
        self.axis = total(self.axis, other.axis, f);
        self.side = total(self.side, other.side, f);
        self.across = total(self.across, other.across, f);
        self.spin = self.spin + f * other.spin;
        for (tangent, rate) in self.tangents.iter_mut().zip(&other.tangents).take(known) {
            *tangent = tangent.plus(rate, f);
        }
    }

    /// Sum of this flow and f times another.
    pub(crate) fn plus(&self, other: &Self, f: F) -> Self {
        let mut flow = *self;
        flow.add(other, f, N);
        flow
    }
}

/// Vector turned about the vertical.
fn about_vertical<F: Float>([x, y, z]: Vector<F>, (sine, cosine): (F, F)) -> Vector<F> {
    [x * cosine - y * sine, x * sine + y * cosine, z]
}

impl<F: Real, const N: usize> Flow<F, N> {
    /// Turns the motion and its tangents about the vertical.
    pub(crate) fn turn(&mut self, phase: Phase) {
        self.turn_by(F::sine_cosine(phase), N);
    }

    /// Turns the motion and its first `known` tangents about the vertical by an angle of this sine and cosine.
    pub(crate) fn turn_by(&mut self, turn: (F, F), known: usize) {
        for vector in [&mut self.axis, &mut self.side, &mut self.across] {
            *vector = about_vertical(*vector, turn);
        }
        for tangent in self.tangents.iter_mut().take(known) {
            tangent.theta = about_vertical(tangent.theta, turn);
            tangent.eta = about_vertical(tangent.eta, turn);
        }
    }

    /// Turns the body about its axis.
    pub(crate) fn roll(&mut self, phase: Phase) {
        let (sine, cosine) = F::sine_cosine(phase);
        let across = bracket(self.axis, self.side);
        self.side = total(self.side.map(|x| x * cosine), across, sine);
    }
}
