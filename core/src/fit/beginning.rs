//! First guesses of a launch from the first measurements, without iteration.
//!
//! Two directions, or a camera, give the orientation at each instant; a single direction leaves the yaw open, and the
//! axis alone the roll. The rate about the axis is beyond the range of most gyroscopes. It then follows from two
//! orientations or from the circle that a direction draws in the body; otherwise several rates are tried.

use crate::fit::Fit;
use crate::fit::instruments::rotation_vector;
use crate::fit::launch::Launch;
use crate::fit::sensor::{Hint, Measurement};
use crate::phase::Phase;
use crate::scalar::Real;
use crate::sensitivity::total;
use crate::su2::{Orientation, Vector, bracket, dot};

/// Number of instants in the first window; the others are each four times as long.
pub(super) const FIRST_WINDOW: usize = 16;
/// Number of rates about the axis that are tried on each side of 0, where the measurements do not determine the rate.
const TRIED: u32 = 12;

/// State of the motion at one instant.
#[derive(Clone, Copy, Debug)]
struct Instant {
    time: f64,
    /// Directions in the fixed frame and in the body frame, unit vectors.
    directions: [Option<[Vector<f64>; 2]>; 2],
    rate: Option<(Vector<f64>, bool)>,
    orientation: Option<Orientation<f64>>,
    axis: Option<Vector<f64>>,
}

/// First instants. They are read again whenever they are needed, because together they would take too much of the stack.
#[derive(Clone)]
struct Instants<'a, 's, F, I> {
    fit: &'a Fit<'s, F>,
    measurements: I,
    /// First measurement of the next instant.
    ahead: Option<Measurement>,
    left: usize,
}

impl<F: Real, I: Iterator<Item = Measurement>> Iterator for Instants<'_, '_, F, I> {
    type Item = Instant;

    #[inline(never)] // it is called in many places
    fn next(&mut self) -> Option<Instant> {
        self.left = self.left.checked_sub(1)?;
        let mut measurement = self.ahead.take()?;
        let mut instant = Instant::at(measurement.time);
        loop {
            instant.learn(self.fit.hint(&measurement));
            measurement = match self.measurements.next() {
                Some(next) if next.time == instant.time => next,
                ahead => {
                    self.ahead = ahead;
                    return Some(instant);
                }
            };
        }
    }
}

/// First guesses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginning {
    orientation: Orientation<f64>,
    omega: Vector<f64>,
    /// Fastest rate about the axis that is tried, and the axis; `omega` is then only the part across the axis.
    tried: Option<(f64, Vector<f64>)>,
}

impl Beginning {
    /// Guesses from the first instants, at the time of the first measurement.
    #[inline(never)] // an instant is on the stack only during the call
    pub(super) fn of<F: Real, I>(fit: &Fit<'_, F>, measurements: &I, epoch: f64) -> Option<Self>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut measurements = measurements.clone();
        let ahead = measurements.next();
        let instants = Instants { fit, measurements, ahead, left: FIRST_WINDOW };
        let (time, orientation) = instants
            .clone()
            .filter(Instant::is_oriented)
            .map(|first| (first.time, first.attitude()))
            .next()?;
        let Some(orientation) = orientation else { return Self::from_axis(instants) };
        let rate = instants.clone().find_map(|instant| instant.rate);
        let omega = match (rate, mean_rate(instants.clone())) {
            (Some(([x, y, _], true)), Some([.., axial])) => [x, y, axial],
            (Some(([x, y, low], true)), None) => [x, y, circling::<F>(instants, low)?],
            (Some((omega, false)), _) => omega,
            (None, Some(omega)) => omega,
            (None, None) => return None,
        };
        // from the first instant with an orientation back to the first measurement
        let lead = epoch - time;
        let orientation = orientation.compose(&Orientation::exp(omega.map(|x| x * lead)));
        Some(Self { orientation, omega: orientation.adjoint(omega), tried: None })
    }

    /// Guesses from the axis alone: its rate from the first and a later instant, and several rates about it.
    #[inline(never)]
    fn from_axis(instants: impl Iterator<Item = Instant>) -> Option<Self> {
        let mut seen = instants.filter_map(|instant| Some((instant.time, instant.axis?)));
        let ((start, axis), (end, later)) = (seen.next()?, seen.nth(2)?);
        let per_time = 1.0 / (end - start);
        let across = bracket(axis, later).map(|x| x * per_time);
        Some(Self { orientation: upright_to(axis), omega: across, tried: Some((4.0 * per_time, axis)) })
    }

    pub(super) fn is_ambiguous(&self) -> bool {
        self.tried.is_some()
    }

    /// Number of the guesses.
    pub(super) fn count(&self) -> u32 {
        if self.is_ambiguous() { 2 * TRIED } else { 1 }
    }

    /// Guess with this number, counted from 0.
    pub(super) fn guess(&self, number: u32) -> Launch {
        let mut omega = self.omega;
        if let Some((fastest, axis)) = self.tried {
            let magnitude = fastest * libm::exp2(-0.75 * f64::from(number / 2));
            omega = total(omega, axis, if number.is_multiple_of(2) { magnitude } else { -magnitude });
        }
        Launch::new(self.orientation.normalised(), omega)
    }
}

impl Instant {
    fn at(time: f64) -> Self {
        Self { time, directions: [None; 2], rate: None, orientation: None, axis: None }
    }

    fn learn(&mut self, hint: Hint) {
        let unit = |x: Vector<f64>| {
            let length = libm::sqrt(dot(x, x));
            (length > 0.0).then(|| x.map(|component| component / length))
        };
        match hint {
            Hint::None => {}
            Hint::Rate { omega, axial_is_saturated } => self.rate = Some((omega, axial_is_saturated)),
            Hint::Direction { fixed, body } => {
                if let Some(free) = self.directions.iter_mut().find(|slot| slot.is_none())
                    && let (Some(fixed), Some(body)) = (unit(fixed), unit(body))
                {
                    *free = Some([fixed, body]);
                }
            }
            Hint::Orientation(orientation) => self.orientation = Some(orientation),
            Hint::Axis(axis) => self.axis = Some(axis),
        }
    }

    fn is_oriented(&self) -> bool {
        self.attitude().is_some() || self.axis.is_some()
    }

    /// Orientation, if it is fully determined.
    #[inline(never)] // its trigonometric functions need much of the stack
    fn full_attitude(&self) -> Option<Orientation<f64>> {
        if self.orientation.is_some() {
            return self.orientation;
        }
        let [Some([fixed, body]), Some([second_fixed, second_body])] = self.directions else { return None };
        let frame = |x: Vector<f64>, y: Vector<f64>| {
            let across = bracket(x, y);
            let length = libm::sqrt(dot(across, across));
            (length > 1e-3).then(|| from_frame(x, across.map(|c| c / length)))
        };
        let (in_fixed, in_body) = (frame(fixed, second_fixed)?, frame(body, second_body)?);
        Some(in_fixed.compose(&in_body.inverse()))
    }

    /// Orientation; where only one direction is known, with an arbitrary rotation about it.
    fn attitude(&self) -> Option<Orientation<f64>> {
        self.full_attitude().or_else(|| {
            let [Some([fixed, body]), _] = self.directions else { return None };
            Some(upright_to(fixed).compose(&upright_to(body).inverse()))
        })
    }
}

/// Orientation whose third and first axes are these unit vectors.
fn from_frame(third: Vector<f64>, first: Vector<f64>) -> Orientation<f64> {
    let tilt = upright_to(third);
    // rotation about the third axis that aligns the first axis
    let [x, y, _] = tilt.inverse().adjoint(first);
    // x and y are the components of a unit vector, so that the half angle needs no trigonometric functions
    let half = if x > 0.0 { [1.0 + x, 0.0, 0.0, y] } else { [y, 0.0, 0.0, 1.0 - x] };
    tilt.compose(&Orientation::from_quaternion(half).normalised())
}

/// Smallest rotation that takes the vertical to this unit vector.
pub(super) fn upright_to([x, y, z]: Vector<f64>) -> Orientation<f64> {
    // below -1 + 1e-12 the rotation may be about any horizontal axis
    if z < -1.0 + 1e-12 {
        return Orientation::from_quaternion([0.0, 1.0, 0.0, 0.0]);
    }
    Orientation::from_quaternion([1.0 + z, -y, x, 0.0]).normalised()
}

/// Angular velocity in the body frame from the orientations. The component along the axis is the mean over all; the
/// others are those of the first instants.
#[inline(never)] // an instant is on the stack only during the call
fn mean_rate(instants: impl Iterator<Item = Instant>) -> Option<Vector<f64>> {
    let mut known = instants.filter_map(|instant| Some((instant.time, instant.full_attitude()?)));
    let (mut time, mut orientation) = known.next()?;
    let start = time;
    let mut along = 0.0;
    let mut across: Option<(f64, f64)> = None;
    for (next_time, next) in known {
        let [x, y, z] = rotation_vector(&orientation.inverse().compose(&next));
        let per_time = 1.0 / (next_time - time);
        along += z;
        across = across.or(Some((x * per_time, y * per_time)));
        (time, orientation) = (next_time, next);
    }
    let (x, y) = across?;
    Some([x, y, along / (time - start)])
}

/// Rate about the axis from the circle that a direction draws in the body, with the sign of `bound`.
///
/// For K = Φ⁻¹ k and z = K₁ + i K₂ the motion gives z' = -iΩ₃ z + i K₃ (Ω₁ + i Ω₂).
#[inline(never)] // its steps are on the stack only during the call
fn circling<F: Real>(instants: impl Iterator<Item = Instant>, bound: f64) -> Option<f64> {
    const PLACES: u32 = 720;
    let mut steps = [[F::ZERO; 7]; FIRST_WINDOW];
    let mut last: Option<(f64, Vector<f64>, Vector<f64>)> = None;
    let mut count = 0;
    for instant in instants {
        let Instant { time, directions: [Some([_, k]), _], rate: Some((w, _)), .. } = instant else {
            last = None;
            continue;
        };
        if let Some((before, [k1, k2, k3], [x, y, _])) = last.replace((time, k, w))
            && let Some(slot) = steps.get_mut(count)
        {
            let ([n1, n2, n3], [x2, y2, _], duration) = (k, w, time - before);
            let half = 0.25 * (k3 + n3) * duration;
            *slot = [duration, k1, k2, n1, n2, -half * (y + y2), half * (x + x2)].map(F::from_f64);
            count += 1;
        }
    }
    let steps = steps.get(..count)?;
    let mismatch = |rate: f64| {
        let half_turns = F::from_f64(rate * 0.25 * core::f64::consts::FRAC_1_PI);
        let mut sum = F::ZERO;
        for [duration, k1, k2, n1, n2, p, q] in steps.iter().copied() {
            let (sine, cosine) = F::sine_cosine(Phase::new((half_turns * duration).to_f64()));
            // e^{iφ/2} z_next - e^{-iφ/2} z - forcing
            let re = (cosine * n1 - sine * n2) - (cosine * k1 + sine * k2) - p;
            let im = (cosine * n2 + sine * n1) - (cosine * k2 - sine * k1) - q;
            sum = sum + re * re + im * im;
        }
        sum
    };
    let [duration, ..] = steps.first()?;
    let fastest = core::f64::consts::PI / libm::fabs(duration.to_f64());
    let mut best = (F::from_f64(f64::INFINITY), 0.0);
    for place in 1..PLACES {
        let magnitude = fastest * f64::from(place) / f64::from(PLACES);
        let rate = if bound < 0.0 { -magnitude } else { magnitude };
        if magnitude < 0.9 * libm::fabs(bound) {
            continue;
        }
        let value = mismatch(rate);
        if value < best.0 {
            best = (value, rate);
        }
    }
    let (_, rate) = best;
    (rate != 0.0).then_some(rate)
}
