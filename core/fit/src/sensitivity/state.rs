//! State of a motion, and small changes of it.

use crate::vector::{UNITS, Vector, add_scaled, cast, cross, dot, scaled};
use toytop::Phase;
use toytop::scalar::{Float, Real};
use toytop::su2::Orientation;

/// Number of columns of the launch.
pub(crate) const LAUNCH_COLUMNS: usize = 6;
/// Number of columns: six of the launch, and those of four ratios or losses.
pub(crate) const COLUMNS: usize = 10;

/// Small change of a motion in the fixed frame: rotation vector θ of the orientation, and its rate η, the change of ω in a frame
/// that θ turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent<F> {
    pub(crate) theta: Vector<F>,
    pub(crate) eta: Vector<F>,
}

/// State of the motion, and N changes of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AugmentedState<F, const N: usize> {
    /// Axis r, the third body axis.
    pub(crate) axis: Vector<F>,
    /// First body axis, turned back by the angle that the body has turned about r.
    pub(crate) first_axis: Vector<F>,
    /// Part w = ω - S r of the angular velocity across the axis, which keeps its digits where S is much larger.
    pub(crate) across: Vector<F>,
    /// Axial component S = ⟨ω, r⟩ of the angular velocity, constant without losses.
    pub(crate) spin: F,
    pub(crate) tangents: [Tangent<F>; N],
}

impl<F: Float> Tangent<F> {
    pub(crate) const ZERO: Self = Self { theta: [F::ZERO; 3], eta: [F::ZERO; 3] };

    /// Changes of θ, then of η, along three axes; the others are 0.
    pub(crate) fn along_axes<const N: usize>(axes: &[Vector<f64>; 3]) -> [Self; N] {
        let mut tangents = [Self::ZERO; N];
        let (turns, rates) = tangents.split_at_mut(axes.len().min(N));
        turns.iter_mut().zip(axes).for_each(|(tangent, axis)| tangent.theta = cast(*axis));
        rates.iter_mut().zip(axes).for_each(|(tangent, axis)| tangent.eta = cast(*axis));
        tangents
    }

    /// Inner product of all six numbers.
    pub(crate) fn inner(&self, other: &Self) -> F {
        dot(self.theta, other.theta) + dot(self.eta, other.eta)
    }

    /// Sum of this tangent and f times another.
    pub(crate) fn plus(&self, other: &Self, f: F) -> Self {
        Self { theta: add_scaled(self.theta, other.theta, f), eta: add_scaled(self.eta, other.eta, f) }
    }
}

impl<F: Float, const N: usize> AugmentedState<F, N> {
    pub(crate) const ZERO: Self = Self {
        axis: [F::ZERO; 3],
        first_axis: [F::ZERO; 3],
        across: [F::ZERO; 3],
        spin: F::ZERO,
        tangents: [Tangent::ZERO; N],
    };

    /// Angular velocity ω = w + S r.
    pub(crate) fn omega(&self) -> Vector<F> {
        add_scaled(self.across, self.axis, self.spin)
    }

    /// Body axes in the fixed frame.
    pub(crate) fn axes(&self) -> [Vector<F>; 3] {
        [self.first_axis, cross(self.axis, self.first_axis), self.axis]
    }

    /// Adds f times another state, of which only the first `columns` tangents are not 0.
    pub(crate) fn add(&mut self, other: &Self, f: F, columns: usize) {
        self.axis = add_scaled(self.axis, other.axis, f);
        self.first_axis = add_scaled(self.first_axis, other.first_axis, f);
        self.across = add_scaled(self.across, other.across, f);
        // 0 without losses; a comparison is faster than the arithmetic of `f64` by software
        if other.spin != F::ZERO {
            self.spin = self.spin + f * other.spin;
        }
        for (tangent, rate) in self.tangents.iter_mut().zip(&other.tangents).take(columns) {
            *tangent = tangent.plus(rate, f);
        }
    }
}

impl AugmentedState<f64, 0> {
    /// State of a launch.
    pub(crate) fn launched(phi: &Orientation<f64>, omega: Vector<f64>) -> Self {
        let [first_axis, _, axis] = UNITS.map(|body| phi.adjoint(body));
        let spin = dot(omega, axis);
        Self { axis, first_axis, across: add_scaled(omega, axis, -spin), spin, tangents: [] }
    }

    /// State with tangents, in their scalar.
    pub(crate) fn with_tangents<F: Float, const N: usize>(
        &self,
        tangents: [Tangent<F>; N],
    ) -> AugmentedState<F, N> {
        let Self { axis, first_axis, across, spin, .. } = *self;
        AugmentedState {
            axis: cast(axis),
            first_axis: cast(first_axis),
            across: cast(across),
            spin: F::from_f64(spin),
            tangents,
        }
    }
}

impl<F: Real, const N: usize> AugmentedState<F, N> {
    /// Turns the motion about the vertical by an angle of this sine and cosine.
    pub(crate) fn turn(&mut self, (sine, cosine): (F, F)) {
        let turned = |[x, y, z]: Vector<F>| [x * cosine - y * sine, x * sine + y * cosine, z];
        self.axis = turned(self.axis);
        self.first_axis = turned(self.first_axis);
        self.across = turned(self.across);
        for Tangent { theta, eta } in &mut self.tangents {
            (*theta, *eta) = (turned(*theta), turned(*eta));
        }
    }

    /// Turns the body about its axis.
    pub(crate) fn roll(&mut self, phase: Phase) {
        let (sine, cosine) = F::sine_cosine(phase);
        self.first_axis =
            add_scaled(scaled(self.first_axis, cosine), cross(self.axis, self.first_axis), sine);
    }
}
