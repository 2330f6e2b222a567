//! First guesses of a launch from the first measurements, without iteration:
//!
//! 1. Measurements of the same time make an instant. The first 16 instants that tell something of the orientation are used.
//! 2. The first of them gives the orientation, and leaves a part of it open:
//!
//!    | measured | open |
//!    |---|---|
//!    | orientation, or two directions | nothing |
//!    | one direction | rotation about it |
//!    | axis | rate about it |
//!    | rates alone | orientation |
//!
//! 3. The angular velocity is read. Where it was not, it is the mean of the orientations' changes; a rate about the axis beyond the range may
//!    also follow from the circle that a direction draws in the body.
//! 4. The orientation is turned back to the first measurement. Several guesses replace what is still open.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::limits::{FIRST_INSTANTS, GUESSES, MAX_INSTANTS, RANGE_FRACTION, TILTS};
use crate::sensors::{Hint, Measurements};
use crate::vector::{UP, Vector, add_scaled, cross, dot, norm, rotation_vector, scaled, unit};
use core::f64::consts::PI;
use toytop::Complex;
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Quantities that the measurements of one instant determine.
#[derive(Clone, Copy, Default)]
struct Instant {
    time: f64,
    /// Unit vectors in the fixed frame and in the body frame.
    directions: [Option<[Vector<f64>; 2]>; 2],
    /// Angular velocity in the body frame, and whether its axial component is only a bound.
    rate: Option<(Vector<f64>, bool)>,
    orientation: Option<Orientation<f64>>,
    axis: Option<Vector<f64>>,
}

/// First guesses: the rotations of an orientation about a fixed axis, or the rates about an axis.
#[derive(Clone, Copy)]
pub(super) struct Guesses {
    orientation: Orientation<f64>,
    /// Angular velocity in the body frame.
    omega: Vector<f64>,
    undetermined: Undetermined,
}

/// Quantities that the first measurements do not determine.
#[derive(Clone, Copy)]
enum Undetermined {
    Nothing,
    /// Rotation about this direction of the fixed frame.
    Rotation(Vector<f64>),
    /// Rate about the axis up to this magnitude.
    Spin(f64),
    /// Orientation.
    Orientation,
}

impl Guesses {
    /// Guess with this number, counted from 0; `None` after the last one.
    pub(super) fn get(&self, number: u32) -> Option<Estimate> {
        let Self { mut orientation, mut omega, undetermined } = *self;
        let angle = 2.0 * PI * f64::from(number) / f64::from(GUESSES);
        let count = match undetermined {
            Undetermined::Nothing => 1,
            Undetermined::Rotation(axis) => {
                orientation = Orientation::exp(scaled(axis, angle)).compose(&orientation);
                GUESSES
            }
            Undetermined::Spin(fastest) => {
                let [.., axial] = &mut omega;
                let rate = fastest * libm::exp2(-0.75 * f64::from(number / 2));
                *axial = if number.is_multiple_of(2) { rate } else { -rate };
                2 * GUESSES
            }
            Undetermined::Orientation => {
                let tilt = *TILTS.get((number / GUESSES) as usize)?;
                let roll = Orientation::exp([0.0, 0.0, angle]);
                orientation = Orientation::exp([0.0, tilt, 0.0]).compose(&roll);
                u32::MAX
            }
        };
        (number < count).then(|| Estimate::new(orientation.normalised(), orientation.adjoint(omega)))
    }
}

impl Instant {
    fn add(&mut self, hint: Hint, tip_scale: f64) {
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
            Hint::Tip(tip) => {
                let level = tip.scaled(-1.0 / tip_scale);
                let up = libm::sqrt((1.0 - level.norm_squared()).max(0.0));
                self.axis = Some([level.re, level.im, up]);
            }
        }
    }

    fn is_oriented(&self) -> bool {
        self.orientation.is_some() || self.axis.is_some() || self.directions != [None; 2]
    }

    /// Orientation, if it is fully determined.
    #[inline(never)] // stack
    fn full_orientation(&self) -> Option<Orientation<f64>> {
        if self.orientation.is_some() {
            return self.orientation;
        }
        let [Some([fixed, body]), Some([second_fixed, second_body])] = self.directions else { return None };
        // the second direction fixes the rotation about the first
        let phi = aligned([fixed, body]);
        let [expected, found] =
            [second_fixed, phi.adjoint(second_body)].map(|x| add_scaled(x, fixed, -dot(x, fixed)));
        let is_parallel = [expected, found].map(norm).into_iter().any(|length| length < 1e-3);
        let angle = libm::atan2(dot(fixed, cross(found, expected)), dot(found, expected));
        (!is_parallel).then(|| Orientation::exp(scaled(fixed, angle)).compose(&phi))
    }
}

/// Smallest rotation that takes the vertical to this unit vector.
pub(super) fn rotation_from_vertical([x, y, z]: Vector<f64>) -> Orientation<f64> {
    // below -1 + 1e-12 the rotation may be about any horizontal axis
    if z < -1.0 + 1e-12 {
        return Orientation::from_quaternion([0.0, 1.0, 0.0, 0.0]);
    }
    Orientation::from_quaternion([1.0 + z, -y, x, 0.0]).normalised()
}

/// Orientation that takes the second of two unit vectors to the first.
fn aligned([fixed, body]: [Vector<f64>; 2]) -> Orientation<f64> {
    rotation_from_vertical(fixed).compose(&rotation_from_vertical(body).inverse())
}

/// Guesses at the time of the first measurement, if there are any.
#[inline(never)] // stack
pub(super) fn guesses<F: Real>(block: &Block<F, impl Measurements>, tip_scale: f64) -> Option<Guesses> {
    let all = instants(block, tip_scale).take(MAX_INSTANTS);
    let end = all.clone().filter(Instant::is_oriented).nth(FIRST_INSTANTS);
    let end = end.map_or(f64::INFINITY, |instant| instant.time);
    let instants = all.take_while(|instant| instant.time < end);
    let rate = instants.clone().find_map(|instant| instant.rate);
    let Some(first) = instants.clone().find(Instant::is_oriented) else {
        let (omega, _) = rate.filter(|(_, axial_is_saturated)| !axial_is_saturated)?;
        let orientation = Orientation::IDENTITY;
        let undetermined = Undetermined::Orientation;
        return Some(Guesses { orientation, omega, undetermined });
    };
    let (orientation, undetermined) = match (first.full_orientation(), first.directions, first.axis) {
        (Some(orientation), ..) => (orientation, Undetermined::Nothing),
        // a rotation about the vertical changes nothing that such measurements tell
        (None, [Some([UP, body]), _], _) => (aligned([UP, body]), Undetermined::Nothing),
        (None, [Some([fixed, body]), _], _) => (aligned([fixed, body]), Undetermined::Rotation(fixed)),
        (None, _, Some(axis)) => return guesses_from_axis(instants, axis),
        _ => return None,
    };
    let mean = mean_rate(instants.clone());
    let omega = match (rate, mean) {
        (Some(([x, y, _], true)), Some([.., axial])) => [x, y, axial],
        (Some(([x, y, low], true)), None) => [x, y, axial_rate_from_circle(instants, low)?],
        (Some((omega, false)), _) => omega,
        (None, mean) => mean?,
    };
    // from the first instant with an orientation back to the first measurement
    let [epoch, _] = block.times;
    let orientation = orientation.compose(&Orientation::exp(scaled(omega, epoch - first.time)));
    Some(Guesses { orientation, omega, undetermined })
}

/// Guesses from the axis alone: its rate from the first and a later instant, and several rates about it.
fn guesses_from_axis(instants: impl Iterator<Item = Instant>, axis: Vector<f64>) -> Option<Guesses> {
    let mut seen = instants.filter_map(|instant| Some((instant.time, instant.axis?)));
    let (start, _) = seen.next()?;
    let (end, later) = seen.nth(2)?;
    let per_time = 1.0 / (end - start);
    let orientation = rotation_from_vertical(axis);
    let omega = orientation.inverse().adjoint(scaled(cross(axis, later), per_time));
    Some(Guesses { orientation, omega, undetermined: Undetermined::Spin(4.0 * per_time) })
}

/// Instants of the measurements, one at a time: all would be too many for the stack.
fn instants<F>(block: &Block<F, impl Measurements>, tip_scale: f64) -> impl Iterator<Item = Instant> + Clone {
    let mut ahead = block.measurements().peekable();
    core::iter::from_fn(move || {
        let time = ahead.peek()?.time;
        let mut instant = Instant { time, ..Instant::default() };
        while let Some(measurement) = ahead.next_if(|measurement| measurement.time == time) {
            instant.add(block.hint(&measurement), tip_scale);
        }
        Some(instant)
    })
}

/// Angular velocity in the body frame from the orientations: the mean rate along the axis, and the first rate across it.
#[inline(never)] // stack
fn mean_rate(instants: impl Iterator<Item = Instant>) -> Option<Vector<f64>> {
    let mut known = instants.filter_map(|instant| Some((instant.time, instant.full_orientation()?)));
    let (start, mut orientation) = known.next()?;
    let mut time = start;
    let mut axial_angle = 0.0;
    let mut first = None;
    for (next_time, next) in known {
        let turn = rotation_vector(&orientation.inverse().compose(&next));
        let [.., axial] = turn;
        axial_angle += axial;
        first = first.or(Some(scaled(turn, 1.0 / (next_time - time))));
        (time, orientation) = (next_time, next);
    }
    first.map(|[x, y, _]| [x, y, axial_angle / (time - start)])
}

/// Rate about the axis from the circle that a direction draws in the body, with the sign of `bound`: the mean turn between two readings
/// that follow each other. The rates across the axis are neglected; a larger turn than 3/4 of the circle is not recognised.
#[inline(never)] // stack
fn axial_rate_from_circle(instants: impl Iterator<Item = Instant>, bound: f64) -> Option<f64> {
    let mut known = instants.filter_map(|instant| {
        let [fixed, [x, y, _]] = instant.directions.into_iter().flatten().next()?;
        Some((instant.time, fixed, Complex::new(x, y)))
    });
    let (start, direction, mut last) = known.next()?;
    let (mut end, mut count, mut turns) = (start, 0.0, Complex::ZERO);
    for (time, _, next) in known.filter(|(_, fixed, _)| *fixed == direction) {
        turns = turns + last * next.conj();
        (end, count, last) = (time, count + 1.0, next);
    }
    let sign = 1_f64.copysign(bound);
    // a small turn may seem negative because of noise
    let turn = 0.5 * PI + libm::atan2(-turns.re, sign * turns.im);
    (end > start).then(|| sign * (count * turn / (end - start)).max(RANGE_FRACTION * bound.abs()))
}
