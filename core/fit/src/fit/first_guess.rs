//! First guesses of a launch from the first measurements, without iteration:
//!
//! 1. Measurements of the same time make a reading. The first 16 readings that tell something of the orientation are used.
//! 2. The first of them gives the orientation, and leaves a part of it open:
//!
//!    | measured | open |
//!    |---|---|
//!    | orientation, or two directions | nothing |
//!    | one direction | rotation about it |
//!    | axis | rate about it |
//!    | rates alone | orientation |
//!
//! 3. The angular velocity is read. The mean rate of the orientations replaces a missing rate, and an axial rate beyond the range.
//!    A single direction gives an orientation too, whose changes show how the body turns about its axis.
//! 4. The orientation is turned back to the first measurement. Several guesses are made of what is still open.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::limits::{FIRST_READINGS, GUESSES, MAX_READINGS, TILTS};
use crate::sensors::{Hint, Measurements};
use crate::vector::{UP, Vector, add_scaled, cross, dot, norm, rotation_vector, scaled, unit};
use core::f64::consts::PI;
use toytop::su2::Orientation;

/// Quantities that the measurements of one time determine.
#[derive(Clone, Copy, Default)]
struct Reading {
    time: f64,
    /// Unit vectors in the fixed frame and in the body frame.
    directions: [Option<[Vector<f64>; 2]>; 2],
    /// Angular velocity in the body frame, and whether its axial component is only a bound.
    rate: Option<(Vector<f64>, bool)>,
    orientation: Option<Orientation<f64>>,
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

impl Undetermined {
    /// Guess with this number, counted from 0, by an orientation and an angular velocity in the body frame; `None` after the last one.
    fn guess(
        self,
        number: u32,
        mut orientation: Orientation<f64>,
        mut omega: Vector<f64>,
    ) -> Option<Estimate> {
        let angle = 2.0 * PI * f64::from(number) / f64::from(GUESSES);
        let count = match self {
            Self::Nothing => 1,
            Self::Rotation(axis) => {
                orientation = Orientation::exp(scaled(axis, angle)).compose(&orientation);
                GUESSES
            }
            Self::Spin(fastest) => {
                let [.., axial] = &mut omega;
                let rate = fastest * libm::exp2(-0.75 * f64::from(number / 2));
                *axial = if number.is_multiple_of(2) { rate } else { -rate };
                2 * GUESSES
            }
            Self::Orientation => {
                let tilt = *TILTS.get((number / GUESSES) as usize)?;
                let roll = Orientation::exp([0.0, 0.0, angle]);
                orientation = Orientation::exp([0.0, tilt, 0.0]).compose(&roll);
                u32::MAX
            }
        };
        (number < count).then(|| Estimate::new(orientation.normalised(), orientation.adjoint(omega)))
    }
}

impl Reading {
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
            Hint::Tip(tip) => {
                let level = tip.scaled(-1.0 / tip_scale);
                let up = libm::sqrt((1.0 - level.norm_squared()).max(0.0));
                self.add(Hint::Direction { fixed: [level.re, level.im, up], body: UP }, tip_scale);
            }
        }
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

    /// Orientation in which the first direction is right, and the rotation about it is arbitrary.
    fn partial_orientation(&self) -> Option<Orientation<f64>> {
        let [direction, _] = self.directions;
        direction.map(aligned)
    }

    fn is_oriented(&self) -> bool {
        self.orientation.is_some() || self.directions != [None; 2]
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

/// Orientation that takes the second of two unit vectors to the first. It turns the body about its axis by the azimuth of that vector, and
/// then tilts it.
fn aligned([fixed, [x, y, z]]: [Vector<f64>; 2]) -> Orientation<f64> {
    let azimuth = Orientation::exp([0.0, 0.0, -libm::atan2(y, x)]);
    let tilt = Orientation::exp([0.0, -libm::atan2(norm([x, y, 0.0]), z), 0.0]);
    rotation_from_vertical(fixed).compose(&tilt).compose(&azimuth)
}

/// Guesses at the time of the first measurement, if there are any.
#[inline(never)] // stack
pub(super) fn guesses<F>(
    block: &Block<F, impl Measurements>,
    tip_scale: f64,
) -> Option<impl Iterator<Item = Estimate>> {
    let all = readings(block, tip_scale).take(MAX_READINGS);
    let end = all.clone().filter(Reading::is_oriented).nth(FIRST_READINGS);
    let end = end.map_or(f64::INFINITY, |reading| reading.time);
    let readings = all.take_while(|reading| reading.time < end);
    let rate = readings.clone().find_map(|reading| reading.rate);
    let known_rate = rate.filter(|(_, axial_is_saturated)| !axial_is_saturated);
    let oriented = readings.clone().filter(Reading::is_oriented);
    let (orientation, omega, undetermined) = if let Some(first) = oriented.clone().next() {
        let undetermined = match first.directions {
            _ if first.full_orientation().is_some() => Undetermined::Nothing,
            [Some([_, UP]), _] if known_rate.is_none() => {
                Undetermined::Spin(4.0 / (oriented.clone().nth(3)?.time - first.time))
            }
            // a rotation about the vertical changes nothing that such measurements tell
            [Some([fixed, _]), _] if fixed != UP => Undetermined::Rotation(fixed),
            _ => Undetermined::Nothing,
        };
        let orientation = first.full_orientation().or_else(|| first.partial_orientation())?;
        let mean = mean_rate(oriented.clone(), Reading::full_orientation);
        let mean = mean.or_else(|| mean_rate(oriented, Reading::partial_orientation));
        let omega = match (rate, mean) {
            (Some((omega, false)), _) => omega,
            (Some(([x, y, _], true)), Some([.., axial])) => [x, y, axial],
            (_, mean) => mean?,
        };
        // from the first reading with an orientation back to the first measurement
        let [epoch, _] = block.times;
        let turn = Orientation::exp(scaled(omega, epoch - first.time));
        (orientation.compose(&turn), omega, undetermined)
    } else {
        let (omega, _) = known_rate?;
        (Orientation::IDENTITY, omega, Undetermined::Orientation)
    };
    Some((0..).map_while(move |number| undetermined.guess(number, orientation, omega)))
}

/// Readings of the measurements, one at a time: all would be too many for the stack.
fn readings<F>(block: &Block<F, impl Measurements>, tip_scale: f64) -> impl Iterator<Item = Reading> + Clone {
    let mut ahead = block.measurements().peekable();
    core::iter::from_fn(move || {
        let time = ahead.peek()?.time;
        let mut reading = Reading { time, ..Reading::default() };
        while let Some(measurement) = ahead.next_if(|measurement| measurement.time == time) {
            reading.add(block.hint(&measurement), tip_scale);
        }
        Some(reading)
    })
}

/// Angular velocity in the body frame from the orientations: the mean rate along the axis, and the first rate across it.
#[inline(never)] // stack
fn mean_rate(
    readings: impl Iterator<Item = Reading>,
    orientation: fn(&Reading) -> Option<Orientation<f64>>,
) -> Option<Vector<f64>> {
    let mut known = readings.filter_map(|reading| Some((reading.time, orientation(&reading)?)));
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
