//! State of a motion, and small changes of it.

use crate::vector::{UNITS, Vector, add_scaled, cast, dot, scaled};
use toytop::scalar::Float;
use toytop::su2::Orientation;

/// Number of columns of the launch.
pub(crate) const LAUNCH_COLUMNS: usize = 6;
/// Number of columns: six of the launch, and four of ratios or losses.
pub(crate) const COLUMNS: usize = 10;

/// Orientation and angular velocity of a body. Their rates of change have the same type.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyState<F> {
    pub(crate) orientation: Orientation<F>,
    /// Transverse part w = ω - S r of the angular velocity, which keeps its digits where S is much larger.
    pub(crate) transverse: Vector<F>,
    /// Axial component S = ⟨ω, r⟩ of the angular velocity, constant without losses.
    pub(crate) spin: F,
}

/// Small change of a motion in the fixed frame: rotation vector θ of the orientation, and its rate η, the change of ω in a frame
/// that θ turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent<F> {
    pub(crate) theta: Vector<F>,
    pub(crate) eta: Vector<F>,
}

impl BodyState<f64> {
    /// State in the scalar of a computation.
    pub(crate) fn cast<F: Float>(&self) -> BodyState<F> {
        BodyState {
            orientation: self.orientation.map(F::from_f64),
            transverse: cast(self.transverse),
            spin: F::from_f64(self.spin),
        }
    }
}

impl<F: Float> BodyState<F> {
    /// State of an orientation and an angular velocity ω in the fixed frame.
    pub(crate) fn new(orientation: Orientation<F>, omega: Vector<F>) -> Self {
        let axis = orientation.axis();
        let spin = dot(omega, axis);
        Self { orientation, transverse: add_scaled(omega, axis, -spin), spin }
    }

    /// Angular velocity ω = w + S r.
    pub(crate) fn omega(&self) -> Vector<F> {
        add_scaled(self.transverse, self.orientation.axis(), self.spin)
    }

    /// Adds f times a rate.
    pub(crate) fn add(&mut self, rate: &Self, f: F) {
        let Orientation { alpha, beta } = &mut self.orientation;
        *alpha = *alpha + rate.orientation.alpha.scaled(f);
        *beta = *beta + rate.orientation.beta.scaled(f);
        self.transverse = add_scaled(self.transverse, rate.transverse, f);
        // 0 without losses; a comparison is faster than the arithmetic of `f64` by software
        if rate.spin != F::ZERO {
            self.spin = self.spin + f * rate.spin;
        }
    }
}

impl<F: Float> Tangent<F> {
    pub(crate) const ZERO: Self = Self { theta: [F::ZERO; 3], eta: [F::ZERO; 3] };

    /// Columns at the launch: changes of θ, then of η, along the fixed axes. The columns of the ratios are 0.
    pub(crate) fn launch_columns() -> [Self; COLUMNS] {
        let mut tangents = [Self::ZERO; COLUMNS];
        let (turns, rates) = tangents.split_at_mut(UNITS.len());
        for ((turn, rate), unit) in turns.iter_mut().zip(rates).zip(UNITS) {
            (turn.theta, rate.eta) = (cast(unit), cast(unit));
        }
        tangents
    }

    /// Components of θ and of η.
    pub(crate) fn components(&self) -> [F; LAUNCH_COLUMNS] {
        let [x, y, z] = self.theta;
        let [u, v, w] = self.eta;
        [x, y, z, u, v, w]
    }

    /// Tangent whose η is multiplied by a factor.
    pub(crate) fn with_eta_times(&self, f: F) -> Self {
        Self { theta: self.theta, eta: scaled(self.eta, f) }
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
