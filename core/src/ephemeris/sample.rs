//! Sample of a motion: three phases, and the quantities computed from them on demand.

use crate::attitude_state::AttitudeState;
use crate::complex::Complex;
use crate::ephemeris::evaluation::{EphemerisScalar, SegmentPoint};
use crate::ephemeris::storage::EphemerisView;
use crate::ephemeris::table::{LocatedSegment, locate};
use crate::phase::{Phase, PhaseFraction};
use crate::scalar::Float;
use crate::su2::{Orientation, OrientationRate, Vector};

/// Sample of a motion at one time. Each method computes its result anew, on demand. If several of orientation, u,
/// axis and quaternion are needed, call [`Sample::orientation`] once and use its methods.
///
/// Orientation, u, axis and quaternion are in the scalar R; lengths and rates are in [`EphemerisScalar::Wide`], which
/// is R itself in floating point and `f32` in fixed point.
#[derive(Debug)]
pub struct Sample<'a, R: EphemerisScalar> {
    pub(crate) ephemeris: &'a EphemerisView<R>,
    /// Leading 64 bits of nutation phase, A and B.
    pub(crate) phases: [u64; 3],
    /// Mean tip angle.
    pub(crate) mean_tip: Phase,
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Sample of the motion t units of time after t = 0, with t taken as exact (to 2^-64 ticks). A t that is not finite counts as 0.
    ///
    /// It equals [`EphemerisView::at_tick`] to the bit where t is a whole number of ticks (and the tick rate is a
    /// multiple of 1/2). Beyond the 2^63 ticks of [`EphemerisView::at_tick`] the motion continues without a jump. The error
    /// bound keeps growing with the ticks, and exceeds a turn before the 96 bits of an increment are insufficient. Where an
    /// aperiodic motion rises within less than one tick, times within that tick are not resolved.
    #[inline(always)] // so that the mean tip angle is computed only where the caller uses it
    #[must_use]
    pub fn at(&self, t: f64) -> Sample<'_, R> {
        match self.clock.instant(t) {
            Some(instant) => Sample {
                ephemeris: self,
                phases: self.clock.at_instant(instant),
                mean_tip: self.clock.tip.at_instant(instant),
            },
            None => self.far(t),
        }
    }

    /// [`EphemerisView::at`] for a time whose ticks do not fit an integer of 64 bits.
    #[cold]
    #[inline(never)]
    fn far(&self, t: f64) -> Sample<'_, R> {
        let (whole, share) = self.clock.ticks(t);
        let tip = self.clock.tip.between(whole, share);
        Sample::new(self, self.clock.between(whole, share), tip)
    }

    /// Sample of the motion at tick n, of either sign.
    #[inline(always)]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Sample<'_, R> {
        Sample::new(self, self.clock.at(n), self.clock.tip.at(n))
    }
}

impl<R: EphemerisScalar> Clone for Sample<'_, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: EphemerisScalar> Copy for Sample<'_, R> {}

impl<'a, R: EphemerisScalar> Sample<'a, R> {
    #[inline(always)]
    pub(crate) fn new(ephemeris: &'a EphemerisView<R>, phases: [PhaseFraction; 3], mean_tip: Phase) -> Self {
        Self { ephemeris, phases: phases.map(PhaseFraction::leading), mean_tip }
    }

    /// Nutation phase: one turn a period, 0 at u = e₁, half a turn at u = e₂ (where the phase of an aperiodic motion stops).
    #[must_use]
    pub fn nutation_phase(&self) -> Phase {
        let [nutation, ..] = self.phases;
        Phase::from_fraction(nutation)
    }

    /// Orientation Φ, from which γ, δ and u follow.
    #[inline(always)]
    #[must_use]
    pub fn orientation(&self) -> Orientation<R> {
        let (found, point) = self.locate();
        let [alpha, beta] = R::alpha_beta(found.terms, point);
        Orientation { alpha, beta }
    }

    /// Cosine u of the tilt, in [-1, 1].
    #[must_use]
    pub fn u(&self) -> R {
        self.orientation().clamped_u()
    }

    /// Unit vector r from the tip to the centre of mass, in the fixed frame.
    #[must_use]
    pub fn axis(&self) -> Vector<R> {
        self.orientation().axis()
    }

    /// Unit quaternion [w, x, y, z] from body to fixed coordinates. Φ and -Φ give quaternions of opposite sign.
    #[must_use]
    pub fn quaternion(&self) -> [R; 4] {
        self.orientation().quaternion()
    }

    /// Tip position c = 2 s αβ, in m, relative to the point of the plane below the centre of mass; for a fixed tip
    /// 2αβ, the horizontal part of the axis with the opposite sign. In fixed point [`Orientation::tip_over_s`] costs
    /// less.
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R::Wide> {
        let (_, tip) = self.orientation_and_tip();
        tip
    }

    /// Orientation and tip position from a single evaluation.
    #[inline(always)]
    #[must_use]
    pub fn orientation_and_tip(&self) -> (Orientation<R>, Complex<R::Wide>) {
        let orientation = self.orientation();
        let Orientation { alpha, beta } = widened(&orientation);
        (orientation, (alpha * beta).scaled(self.ephemeris.clock.tip_scale))
    }

    /// Angular velocity ω in the fixed frame, rad per unit time. Error: [`EphemerisView::rate_error_bound`].
    #[inline(always)]
    #[must_use]
    pub fn omega(&self) -> Vector<R::Wide> {
        let (orientation, omega_body, exponent) = self.rates_with_orientation();
        orientation.adjoint(omega_body).map(|rate| R::rate_in(rate, exponent))
    }

    /// Angular velocity Ω in the body frame, rad per unit time. Error: [`EphemerisView::rate_error_bound`].
    #[inline(always)]
    #[must_use]
    pub fn omega_body(&self) -> Vector<R::Wide> {
        let (_, omega_body) = self.orientation_and_omega_body();
        omega_body
    }

    /// Orientation and angular velocity Ω in the body frame from a single evaluation.
    #[inline(always)]
    #[must_use]
    pub fn orientation_and_omega_body(&self) -> (Orientation<R>, Vector<R::Wide>) {
        let (orientation, [x1, x2, _], exponent) = self.rates();
        let [.., axial] = self.ephemeris.clock.rates;
        (orientation, [R::rate_in(x1, exponent), R::rate_in(x2, exponent), axial])
    }

    /// Rate u' of the cosine of the tilt, per unit time. Error: [`EphemerisView::rate_error_bound`].
    #[inline(always)]
    #[must_use]
    pub fn udot(&self) -> R::Wide {
        let (orientation, omega_body, exponent) = self.rates_with_orientation();
        let [.., udot] = orientation.axis_rate(omega_body);
        R::rate_in(udot, exponent)
    }

    /// Velocity c' of the tip, m per unit time; per unit time for a fixed tip. Error: s times
    /// [`EphemerisView::rate_error_bound`], where s is 1 for a fixed tip.
    #[inline(always)]
    #[must_use]
    pub fn tip_velocity(&self) -> Complex<R::Wide> {
        let (orientation, omega_body, exponent) = self.rates_with_orientation();
        let [x, y, _] = orientation.axis_rate(omega_body);
        // c = -s (r₁ + i r₂), and the scale of the tip is 2 s
        let half_scale = -self.ephemeris.clock.tip_scale.halved();
        Complex::new(R::rate_in(x, exponent), R::rate_in(y, exponent)).scaled(half_scale)
    }

    /// Tip angle φ = arg c, continuous in time from φ(0) in (-1/2, 1/2] turn, whole turns included (modulo 2^32
    /// turns); `None` where the axis is vertical at all times.
    ///
    /// Where the curve passes through the centre (e₁ = -1 or e₂ = 1), φ is smooth there and the radius changes sign:
    /// c = ±ρ e^{iφ}. Cost: an arctangent, and a complex product for every segment between u = e₁ and the sample.
    #[must_use]
    pub fn tip_angle(&self) -> Option<Phase> {
        let [nutation, ..] = self.phases;
        let exists = self.ephemeris.clock.tip.exists;
        exists.then(|| self.mean_tip + self.ephemeris.periodic_tip_angle(nutation))
    }

    /// Orientation and its rate, from which ω, u' and a [`State`](crate::State) follow. Cost: that of the orientation
    /// and of some forty operations of [`EphemerisScalar::Wide`].
    #[must_use]
    pub fn attitude_state(&self) -> AttitudeState<R::Wide> {
        let (orientation, omega_body) = self.orientation_and_omega_body();
        let orientation = widened(&orientation);
        AttitudeState { orientation, rate: OrientationRate::from_body(&orientation, omega_body) }
    }

    /// Orientation, angular velocity Ω in the body frame as multiples of a power of two, and the exponent of that power.
    #[inline(always)]
    fn rates(&self) -> (Orientation<R>, Vector<R::Rate>, i32) {
        let (found, point) = self.locate();
        let ([alpha, beta], omega_body, exponent) =
            R::alpha_beta_and_rates(found.terms, point, found.level, self.ephemeris.clock.rates);
        (Orientation { alpha, beta }, omega_body, exponent)
    }

    /// [`Sample::rates`], with the orientation in the number type of the rates.
    #[inline(always)]
    fn rates_with_orientation(&self) -> (Orientation<R::Rate>, Vector<R::Rate>, i32) {
        let (Orientation { alpha, beta }, omega_body, exponent) = self.rates();
        let [alpha, beta] = [alpha, beta].map(|z| Complex::new(z.re.rate_number(), z.im.rate_number()));
        (Orientation { alpha, beta }, omega_body, exponent)
    }

    /// Segment, and the local coordinate on it.
    #[inline(always)]
    fn locate(&self) -> (LocatedSegment<'a, R>, SegmentPoint) {
        let [nutation, a, b] = self.phases;
        let mirrored = (nutation as i64) < 0;
        let share = (nutation ^ ((nutation as i64) >> 63) as u64) << 1;
        let found = locate::<R>(&self.ephemeris.cells, &self.ephemeris.segments, share);
        let (x, short_x) = (found.x, found.short_x);
        (found, SegmentPoint { x, short_x, mirrored, slow: [a, b] })
    }
}

/// Orientation in the wide type of its scalar.
fn widened<R: EphemerisScalar>(orientation: &Orientation<R>) -> Orientation<R::Wide> {
    let wide = |number: Complex<R>| Complex::new(number.re.widened(), number.im.widened());
    Orientation { alpha: wide(orientation.alpha), beta: wide(orientation.beta) }
}
