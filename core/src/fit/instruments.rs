//! Instruments: gyroscope, accelerometer, magnetometer, and optical ones.

use crate::fit::sensor::{Hint, Mounting, Noise, Prediction, Sensor};
use crate::phase::Phase;
use crate::scalar::Real;
use crate::sensitivity::{Partials, along, total};
use crate::su2::{Orientation, Vector, bracket, dot};

/// Rate gyroscope with three axes. It reads Ω, in rad per unit time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyroscope {
    /// Noise and bias, rad per unit time.
    pub noise: Noise,
    /// Mounting; the place has no effect.
    pub mounting: Mounting,
    /// Largest magnitude that a component can read. A component that reaches it is not used.
    pub range: f64,
}

/// Accelerometer with three axes. It reads the specific force at its place, in m/s².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerometer {
    /// Noise and bias, m/s².
    pub noise: Noise,
    /// Mounting.
    pub mounting: Mounting,
    /// Largest magnitude that a component can read. A component that reaches it is not used.
    pub range: f64,
}

/// Magnetometer, or any instrument that measures a fixed vector in the body frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnetometer {
    /// Noise and bias, in the unit of the field.
    pub noise: Noise,
    /// Mounting; the place has no effect.
    pub mounting: Mounting,
    /// Field in the fixed frame.
    pub field: Vector<f64>,
}

/// Camera that measures the orientation. It reads a unit quaternion [w, x, y, z] from body to fixed coordinates, of
/// either sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientationCamera {
    /// Standard deviation of each component of the rotation vector, rad.
    pub deviation: f64,
}

/// Camera that measures the axis. It reads the unit vector r in the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisCamera {
    /// Standard deviation of each component.
    pub deviation: f64,
}

/// Camera that measures the tip c on the plane. It reads its two coordinates, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipCamera {
    /// Standard deviation of each coordinate, m.
    pub deviation: f64,
    /// Length s of the top that maps the axis to the tip, m ([`Top::tip_scale`](crate::Top::tip_scale)).
    pub tip_scale: f64,
}

/// Mark on the body that passes a fixed azimuth, as a photo diode sees it once a turn. The time of the measurement is
/// that of the passage; it reads the azimuth, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Standard deviation of the time.
    pub deviation: f64,
    /// Body coordinates of the mark.
    pub place: Vector<f64>,
}

fn minus<F: Real>(x: Vector<F>, y: Vector<F>) -> Vector<F> {
    total(x, y, -F::ONE)
}

/// First three values of a reading.
fn three([x, y, z, _]: &[f64; 4]) -> Vector<f64> {
    [*x, *y, *z]
}

fn cast<F: Real>(x: Vector<f64>) -> Vector<F> {
    x.map(F::from_f64)
}

/// Deviation of a component without information.
fn unused<F: Real>() -> F {
    F::from_f64(f64::INFINITY)
}

/// Standard deviations: infinite where the reading is at the end of the range.
fn within<F: Real>(range: f64, reading: Vector<F>, deviation: f64) -> Vector<F> {
    let [range, deviation] = [range, deviation].map(F::from_f64);
    reading.map(|x| if x.abs() < range { deviation } else { unused() })
}

impl<F: Real> Sensor<F> for Gyroscope {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let reading = cast(three(values));
        let axes = self.mounting.axes(at);
        Prediction {
            difference: minus(reading, at.omega_in(&axes, self.mounting.axis())),
            deviation: within(self.range, reading, self.noise.deviation),
            columns: at.each(|tangent| along(&axes, tangent.eta)),
        }
    }

    fn bias_deviation(&self) -> f64 {
        self.noise.bias
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let reading = three(values);
        let saturated = reading.map(|x| libm::fabs(x) >= self.range);
        // a saturated axis of the sensor says little about the axial rate, unless it is across the top's axis
        let axis: Vector<f64> = self.mounting.axis();
        let axial_is_saturated = saturated.iter().zip(axis).any(|(is, along)| *is && libm::fabs(along) > 0.1);
        Hint::Rate { omega: self.mounting.in_body(reading), axial_is_saturated }
    }
}

impl<F: Real> Sensor<F> for Accelerometer {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let reading = cast(three(values));
        let (force, columns) = at.force_in(&self.mounting.axes(at), self.mounting.place());
        Prediction {
            difference: minus(reading, force),
            deviation: within(self.range, reading, self.noise.deviation),
            columns,
        }
    }

    fn bias_deviation(&self) -> f64 {
        self.noise.bias
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        // away from the centre of mass, or the tip, most of the specific force is that of the rotation
        if dot(self.mounting.place, self.mounting.place) > 0.0 {
            return Hint::None;
        }
        Hint::Direction { fixed: [0.0, 0.0, 1.0], body: self.mounting.in_body(three(values)) }
    }
}

impl<F: Real> Sensor<F> for Magnetometer {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let (field, columns) = at.direction_in(&self.mounting.axes(at), cast(self.field));
        Prediction {
            difference: minus(cast(three(values)), field),
            deviation: [F::from_f64(self.noise.deviation); 3],
            columns,
        }
    }

    fn bias_deviation(&self) -> f64 {
        self.noise.bias
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let length = libm::sqrt(dot(self.field, self.field));
        Hint::Direction { fixed: self.field.map(|x| x / length), body: self.mounting.in_body(three(values)) }
    }
}

impl<F: Real> Sensor<F> for OrientationCamera {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let measured = Orientation::from_quaternion(values.map(F::from_f64)).normalised();
        Prediction {
            difference: rotation_vector(&measured.compose(&at.orientation_now().inverse())),
            deviation: [F::from_f64(self.deviation); 3],
            columns: at.orientation(),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        Hint::Orientation(Orientation::from_quaternion(*values).normalised())
    }
}

impl<F: Real> Sensor<F> for AxisCamera {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        Prediction {
            difference: minus(cast(three(values)), at.axis()),
            deviation: [F::from_f64(self.deviation); 3],
            columns: at.axis_change(),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let [x, y, z] = three(values);
        let length = libm::sqrt(x * x + y * y + z * z);
        Hint::Axis([x / length, y / length, z / length])
    }
}

impl<F: Real> Sensor<F> for TipCamera {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let [x, y, _]: Vector<F> = cast(three(values));
        let [r1, r2, _] = at.axis();
        let [scale, deviation] = [self.tip_scale, self.deviation].map(F::from_f64);
        Prediction {
            difference: [x + scale * r1, y + scale * r2, F::ZERO],
            deviation: [deviation, deviation, unused()],
            columns: at.tip().map(|c| [c.re, c.im, F::ZERO]),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        // the top is assumed to stand above the plane
        let [x, y, ..] = values.map(|x| -x / self.tip_scale);
        let square = x * x + y * y;
        Hint::Axis([x, y, libm::sqrt(if square < 1.0 { 1.0 - square } else { 0.0 })])
    }
}

impl<F: Real> Sensor<F> for Mark {
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F> {
        let [azimuth, ..] = *values;
        let place = at.in_fixed(cast(self.place));
        let [x, y, _] = place;
        let square = x * x + y * y;
        let turned = |[dx, dy, _]: Vector<F>| (x * dy - y * dx) / square;
        let (sine, cosine) = F::sine_cosine(Phase::from_radians(azimuth));
        let rate = turned(bracket(at.angular_velocity(), place));
        Prediction {
            difference: [F::atan2(sine * x - cosine * y, cosine * x + sine * y), F::ZERO, F::ZERO],
            deviation: [F::from_f64(self.deviation) * rate.abs(), unused(), unused()],
            columns: at.each(|tangent| [turned(bracket(tangent.theta, place)), F::ZERO, F::ZERO]),
        }
    }
}

/// Rotation vector of an orientation of either sign, of magnitude up to π.
pub(crate) fn rotation_vector<F: Real>(phi: &Orientation<F>) -> Vector<F> {
    let [w, x, y, z] = phi.quaternion();
    let sign = if w < F::ZERO { -F::ONE } else { F::ONE };
    let sine = (x * x + y * y + z * z).sqrt();
    let angle = F::atan2(sine, sign * w).doubled();
    let scale = if sine > F::from_f64(1e-12) { sign * angle / sine } else { sign.doubled() };
    [x, y, z].map(|component| scale * component)
}
