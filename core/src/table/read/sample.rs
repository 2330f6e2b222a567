//! Sample of a motion: three phases, from which every quantity is computed when it is asked for.

use crate::complex::Complex;
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float};
use crate::su2::{AttitudeState, Orientation, Vector};
use crate::table::data::EphemerisView;
use crate::table::data::cell::Cell;
use crate::table::evaluation::{
    EphemerisScalar, LEAST_DEPTH, Number, NumberOf, SegmentPoint, orientation, orientation_and_omega_body,
};

/// Sample of a motion at one time. Each method evaluates the table; [`Sample::pose`], [`Sample::orientation_and_omega_body`] and
/// [`Sample::attitude_state`] do so once for several quantities.
///
/// Lengths and rates are in [`EphemerisScalar::Quantity`]: R itself in floating point, `f32` in fixed point.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a, R: EphemerisScalar> {
    pub(crate) ephemeris: &'a EphemerisView<R>,
    /// Leading 64 bits of nutation phase and slow phases.
    pub(crate) phases: [u64; 3],
    pub(crate) mean_tip: Phase,
}

/// Orientation, u and tip of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<R, W> {
    /// Orientation Φ.
    pub orientation: Orientation<R>,
    /// Cosine u of the tilt: see [`Sample::u`].
    pub u: R,
    /// Position c of the tip: see [`Sample::tip`].
    pub tip: Complex<W>,
}

impl<'a, R: EphemerisScalar> Sample<'a, R> {
    #[inline(always)]
    pub(crate) fn new(ephemeris: &'a EphemerisView<R>, phases: [WrappedPhase; 3], mean_tip: Phase) -> Self {
        Self { ephemeris, phases: phases.map(WrappedPhase::leading_bits), mean_tip }
    }

    /// Nutation phase: one turn a period, 0 at u = e₁, half a turn at u = e₂.
    #[must_use]
    pub fn nutation_phase(&self) -> Phase {
        let [nutation, ..] = self.phases;
        Phase::from_leading_bits(nutation)
    }

    /// Orientation Φ, from which γ, δ and u follow.
    #[inline(always)]
    #[must_use]
    pub fn orientation(&self) -> Orientation<R> {
        self.unrounded().map(R::from_number)
    }

    /// Orientation, u and tip.
    #[inline(always)]
    #[must_use]
    pub fn pose(&self) -> Pose<R, R::Quantity> {
        let numbers = self.unrounded();
        let product = numbers.alpha * numbers.beta;
        let [re, im] = [product.re, product.im].map(Into::into);
        Pose {
            orientation: numbers.map(R::from_number),
            u: R::from_number(numbers.u()),
            tip: Complex::new(re, im).scaled(self.ephemeris.clock.twice_tip_scale),
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

    /// Position c = 2 s αβ of the tip, m, from the point below the centre of mass; 2αβ for a fixed tip.
    #[inline(always)]
    #[must_use]
    pub fn tip(&self) -> Complex<R::Quantity> {
        self.pose().tip
    }

    /// Angular velocity ω in the fixed frame, rad/s.
    #[inline(always)]
    #[must_use]
    pub fn omega(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body, exponent) = self.unrounded_with_omega_body();
        orientation.adjoint(omega_body).map(|rate| rate.ldexp(exponent))
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
        let (numbers, omega_body) = self.numbers_and_omega_body();
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
        // c = -s (r₁ + i r₂), and the scale of the tip is 2 s
        Complex::new(x, y).scaled(-self.ephemeris.clock.twice_tip_scale.halved())
    }

    /// Orientation and its rate, from which ω, u' and a [`State`](crate::State) follow.
    #[must_use]
    pub fn attitude_state(&self) -> AttitudeState<R::Quantity> {
        let (numbers, omega_body) = self.numbers_and_omega_body();
        let orientation = numbers.map(Into::into);
        AttitudeState::from_body(orientation, omega_body)
    }

    #[inline(always)]
    fn unrounded(&self) -> Orientation<NumberOf<R>> {
        let [nutation, a, b] = self.phases;
        let LocatedSegment { rows, point, .. } = self.ephemeris.segment_at(nutation);
        orientation::<R>(rows, point, [a, b])
    }

    /// Unrounded orientation, and Ω over a power of two with its exponent.
    #[inline(always)]
    fn unrounded_with_omega_body(&self) -> (Orientation<NumberOf<R>>, Vector<NumberOf<R>>, i32) {
        let [nutation, a, b] = self.phases;
        let LocatedSegment { rows, point, .. } = self.ephemeris.segment_at(nutation);
        orientation_and_omega_body::<R>(rows, point, [a, b], self.ephemeris.clock.rates())
    }

    /// Unrounded orientation, and Ω.
    #[inline(always)]
    fn numbers_and_omega_body(&self) -> (Orientation<NumberOf<R>>, Vector<R::Quantity>) {
        let (orientation, [x1, x2, _], exponent) = self.unrounded_with_omega_body();
        let transverse = |x: NumberOf<R>| x.ldexp(exponent);
        (orientation, [transverse(x1), transverse(x2), self.ephemeris.clock.axial_rate])
    }

    /// Rate r' of the axis in the fixed frame.
    #[inline(always)]
    fn axis_rate(&self) -> Vector<R::Quantity> {
        let (orientation, omega_body, exponent) = self.unrounded_with_omega_body();
        orientation.axis_rate(omega_body).map(|rate| rate.ldexp(exponent))
    }
}

/// Segment of a nutation phase, and the point of it.
pub(super) struct LocatedSegment<'a, R: EphemerisScalar> {
    pub(super) rows: &'a [[R::Coefficient; 4]],
    pub(super) index: usize,
    pub(super) point: SegmentPoint,
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Sample of the motion at tick n, of either sign.
    #[inline(always)]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Sample<'_, R> {
        Sample::new(self, self.clock.at(n), self.clock.mean_tip(n))
    }

    /// Sample of the motion t (s) after tick 0, taken as exact; 0 if it is not finite.
    ///
    /// Same bits as [`EphemerisView::at_tick`] at whole ticks, if the tick rate is a multiple of 1/2. It is slow beyond 2^62 ticks, and for
    /// ticks of half a turn or more of a phase.
    #[inline(always)] // so that the mean tip angle is computed only where the caller uses it
    #[must_use]
    pub fn at(&self, t: f64) -> Sample<'_, R> {
        match self.clock.at_time(t) {
            Some((phases, mean_tip)) => Sample { ephemeris: self, phases, mean_tip },
            None => self.at_ticks(self.clock.ticks(t)),
        }
    }

    /// Sample at any number of ticks, with a fraction.
    #[cold]
    #[inline(never)]
    pub(crate) fn at_ticks(&self, ticks: Extended) -> Sample<'_, R> {
        let (phases, mean_tip) = self.clock.at_ticks(ticks);
        Sample::new(self, phases, mean_tip)
    }

    /// Time of the last tick, 2^63, in s.
    #[must_use]
    pub fn last_time(&self) -> f64 {
        let [ticks_per_time, _] = self.clock.ticks_per_time;
        (1_u64 << 63) as f64 / ticks_per_time
    }

    /// Segment of a nutation phase, given by its 64 leading bits.
    #[inline(always)]
    pub(super) fn segment_at(&self, nutation: u64) -> LocatedSegment<'_, R> {
        let falling = (nutation as i64) >> 63;
        // the fraction of half a period, and its 32 leading bits
        let half = (nutation ^ falling as u64) << 1;
        let leading = (half >> 32) as u32;
        let cell = Cell(self.cells.get((leading >> 28) as usize).copied().unwrap_or_default());
        let (depth, index) = (cell.depth(), cell.segment(leading));
        // a cell refers to a segment of the table, which has one: the fallbacks only avoid a panic
        let segment = self.segments.get(index).or(self.segments.first());
        // 32 leading bits of the fraction of an eighth
        let eighth = (half >> (32 - LEAST_DEPTH)) as u32;
        // the range [0, 1) becomes [-1, 1) by flipping the upper bit
        let (x_q63, x_q31) = ((half << depth) ^ (1 << 63), (eighth << (depth - LEAST_DEPTH)) ^ (1 << 31));
        LocatedSegment {
            rows: segment.map_or(&[], |segment| segment.as_ref()),
            index,
            point: SegmentPoint { x_q63: x_q63 as i64, x_q31: x_q31 as i32, depth, is_falling: falling < 0 },
        }
    }
}

#[cfg(feature = "defmt")]
impl<R: EphemerisScalar + defmt::Format> defmt::Format for Sample<'_, R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{} (nutation {})", self.orientation(), self.nutation_phase());
    }
}
