//! Sample of a motion: three phases, from which every quantity is computed when it is asked for.

use crate::body::{ParameterError, State};
use crate::complex::Complex;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::su2::{AttitudeState, Orientation, Vector};
use crate::table::data::Table;
use crate::table::evaluation::{ComponentOf, TableScalar, orientation, orientation_and_omega_body};
use crate::table::read::located_segment::LocatedSegment;
use crate::table::time::{Instant, Phases};

/// Sample of a motion at one time. Each method evaluates the table; [`Sample::pose`], [`Sample::orientation_and_omega_body`] and
/// [`Sample::attitude_state`] do so once for several quantities.
///
/// Lengths and rates are in [`TableScalar::Quantity`]: R itself in floating point, `f32` in fixed point.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a, R: TableScalar> {
    pub(crate) table: &'a Table<R>,
    /// 64 leading bits of the phases.
    pub(crate) phases: Phases<u64>,
    pub(crate) instant: Instant,
}

/// Orientation, u and tip of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<R> {
    /// Orientation Φ.
    pub orientation: Orientation<R>,
    /// Cosine u of the tilt: see [`Sample::u`].
    pub u: R,
    /// Position 2αβ of the tip in units of s: see [`Sample::tip`].
    pub tip_over_s: Complex<R>,
}

impl<R: TableScalar> Sample<'_, R> {
    /// Nutation phase: one turn a period, 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self) -> Phase {
        Phase::from_leading_bits(self.phases.nutation)
    }

    /// Orientation Φ.
    #[inline(always)]
    #[must_use]
    pub fn orientation(&self) -> Orientation<R> {
        self.unrounded().map(R::from_number)
    }

    /// Orientation, u and tip.
    #[inline(always)]
    #[must_use]
    pub fn pose(&self) -> Pose<R> {
        let numbers = self.unrounded();
        Pose {
            orientation: numbers.map(R::from_number),
            u: R::from_number(numbers.u()),
            tip_over_s: numbers.tip_over_s().map(R::from_number),
        }
    }

    /// Cosine u of the tilt, not limited: a rounding may take it past ±1.
    #[must_use]
    pub fn u(&self) -> R {
        R::from_number(self.unrounded().u())
    }

    /// Unit vector r from the tip to the centre of mass, in the fixed frame.
    #[must_use]
    pub fn axis(&self) -> Vector<R> {
        self.unrounded().axis().map(R::from_number)
    }

    /// Unit quaternion [w, x, y, z] from body to fixed coordinates.
    #[must_use]
    pub fn quaternion(&self) -> [R; 4] {
        self.orientation().quaternion()
    }

    /// Position c = 2 s αβ of the tip, m, from the point below the centre of mass; 2αβ for another support.
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R::Quantity> {
        let Orientation { alpha, beta } = self.unrounded();
        (alpha * beta).map(R::to_quantity).scaled(self.table.clock.twice_tip_scale)
    }

    /// Angular velocity ω in the fixed frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn omega(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body) = self.unrounded_and_omega_body();
        orientation.map(R::to_quantity).adjoint(omega_body)
    }

    /// Angular velocity Ω in the body frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn omega_body(&self) -> Vector<R::Quantity> {
        let (_, omega_body) = self.orientation_and_omega_body();
        omega_body
    }

    /// Orientation, and angular velocity Ω in the body frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn orientation_and_omega_body(&self) -> (Orientation<R>, Vector<R::Quantity>) {
        let (numbers, omega_body) = self.unrounded_and_omega_body();
        (numbers.map(R::from_number), omega_body)
    }

    /// Rate u' of the cosine of the tilt, per unit time.
    #[inline(always)]
    #[must_use]
    pub fn udot(&self) -> R::Quantity {
        let [.., udot] = self.axis_rate();
        udot
    }

    /// Velocity c' of the tip, m/s.
    #[inline(always)]
    #[must_use]
    pub fn tip_velocity(&self) -> Complex<R::Quantity> {
        let [x, y, _] = self.axis_rate();
        // c = 2 s αβ = -s (r₁ + i r₂)
        Complex::new(x, y).scaled(-self.table.clock.twice_tip_scale.halved())
    }

    /// Orientation and its rate, from which ω and u' follow.
    #[must_use]
    pub fn attitude_state(&self) -> AttitudeState<R::Quantity> {
        let (numbers, omega_body) = self.unrounded_and_omega_body();
        AttitudeState::from_body(numbers.map(R::to_quantity), omega_body)
    }

    /// State, with the error of the sample, from which another motion can be launched.
    ///
    /// # Errors
    /// The errors of [`State::from_attitude`]: the sample of a baked table can have any numbers.
    pub fn state(&self) -> Result<State, ParameterError> {
        State::from_attitude(&self.attitude_state())
    }

    #[inline(always)]
    fn unrounded(&self) -> Orientation<ComponentOf<R>> {
        let Phases { nutation, alpha, beta } = self.phases;
        let LocatedSegment { rows, point, .. } = self.table.segment_at(nutation);
        orientation::<R>(rows, point, [alpha, beta])
    }

    /// Unrounded orientation, and Ω.
    #[inline(always)]
    fn unrounded_and_omega_body(&self) -> (Orientation<ComponentOf<R>>, Vector<R::Quantity>) {
        let Phases { nutation, alpha, beta } = self.phases;
        let LocatedSegment { rows, point, .. } = self.table.segment_at(nutation);
        orientation_and_omega_body::<R>(rows, point, [alpha, beta], self.table.clock.rates())
    }

    /// Rate r' of the axis in the fixed frame.
    #[inline(always)]
    fn axis_rate(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body) = self.unrounded_and_omega_body();
        orientation.map(R::to_quantity).axis_rate(omega_body)
    }
}

#[cfg(feature = "defmt")]
impl<R: TableScalar + defmt::Format> defmt::Format for Sample<'_, R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{} (nutation {})", self.orientation(), self.nutation_phase());
    }
}
