//! Sample of a motion: its orientation at one time, and the phases from which its rates are computed when they are asked for.

use crate::body::{ParameterError, State};
use crate::complex::Complex;
use crate::phase::Phase;
use crate::scalar::Float;
use crate::su2::{AttitudeState, Orientation, Vector};
use crate::table::data::Table;
use crate::table::evaluation::{ComponentOf, TableScalar, orientation, orientation_and_omega_body};
use crate::table::read::located_segment::LocatedSegment;
use crate::table::time::{Instant, Phases};

/// Sample of a motion at one time. It has the orientation; each rate, and the tip angle, takes another evaluation of the table.
///
/// Lengths and rates are in [`TableScalar::Quantity`]: R itself in floating point, `f32` in fixed point.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a, R: TableScalar> {
    pub(in crate::table) table: &'a Table<R>,
    /// 64 leading bits of the phases.
    pub(in crate::table) phases: Phases<u64>,
    pub(in crate::table) instant: Instant,
    /// Orientation in the number type of a tick.
    components: Orientation<ComponentOf<R>>,
}

impl<'a, R: TableScalar> Sample<'a, R> {
    /// Sample from the 64 leading bits of the phases.
    #[inline(always)]
    pub(crate) fn new(table: &'a Table<R>, phases: Phases<u64>, instant: Instant) -> Self {
        let LocatedSegment { rows, point, .. } = table.segment_at(phases.nutation);
        let components = orientation::<R>(rows, point, [phases.alpha, phases.beta]);
        Self { table, phases, instant, components }
    }
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
        self.components.map(R::from_component)
    }

    /// Cosine u of the tilt, not limited: a rounding may take it past ±1.
    #[inline(always)]
    #[must_use]
    pub fn u(&self) -> R {
        R::from_component(self.components.u())
    }

    /// Unit vector r from the tip to the centre of mass, in the fixed frame.
    #[inline(always)]
    #[must_use]
    pub fn axis(&self) -> Vector<R> {
        self.components.axis().map(R::from_component)
    }

    /// Unit quaternion [w, x, y, z] from body to fixed coordinates.
    #[inline(always)]
    #[must_use]
    pub fn quaternion(&self) -> [R; 4] {
        self.orientation().quaternion()
    }

    /// Position c = 2 s αβ of the tip, m, from the point below the centre of mass; 2αβ for another support.
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R::Quantity> {
        let Orientation { alpha, beta } = self.components;
        (alpha * beta).map(R::to_quantity).scaled(self.table.clock.twice_tip_scale)
    }

    /// Position 2αβ of the tip in units of s: see [`Sample::tip`].
    #[inline(always)]
    #[must_use]
    pub fn tip_over_s(&self) -> Complex<R> {
        self.components.tip_over_s().map(R::from_component)
    }

    /// Angular velocity ω in the fixed frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn omega(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body) = self.orientation_and_omega_body();
        orientation.adjoint(omega_body)
    }

    /// Angular velocity Ω in the body frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn omega_body(&self) -> Vector<R::Quantity> {
        let (_, omega_body) = self.orientation_and_omega_body();
        omega_body
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
        let (orientation, omega_body) = self.orientation_and_omega_body();
        AttitudeState::from_body(orientation, omega_body)
    }

    /// State, with the error of the sample, from which another motion can be launched.
    ///
    /// # Errors
    /// The errors of [`State::from_attitude`]: the sample of a baked table can have any numbers.
    pub fn state(&self) -> Result<State, ParameterError> {
        State::from_attitude(&self.attitude_state())
    }

    /// Φ and Ω by one evaluation.
    #[inline(always)]
    fn orientation_and_omega_body(&self) -> (Orientation<R::Quantity>, Vector<R::Quantity>) {
        let Phases { nutation, alpha, beta } = self.phases;
        let LocatedSegment { rows, point, .. } = self.table.segment_at(nutation);
        let (components, omega_body) =
            orientation_and_omega_body::<R>(rows, point, [alpha, beta], self.table.clock.rates());
        (components.map(R::to_quantity), omega_body)
    }

    /// Rate r' of the axis in the fixed frame.
    #[inline(always)]
    fn axis_rate(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body) = self.orientation_and_omega_body();
        orientation.axis_rate(omega_body)
    }
}

#[cfg(feature = "defmt")]
impl<R: TableScalar + defmt::Format> defmt::Format for Sample<'_, R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{} (nutation {})", self.orientation(), self.nutation_phase());
    }
}
