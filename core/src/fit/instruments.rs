//! Instruments: gyroscope, accelerometer, magnetometer, and optical ones.

use crate::fit::sensor::{Hint, Mounting, Noise, Prediction, Sensor};
use crate::sensitivity::{COLUMNS, Partials, total};
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

/// Magnetometer, or any instrument that sees a fixed vector in the body frame.
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

/// Camera that measures the tip c on the plate. It reads its two coordinates, m.
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

fn minus([x1, x2, x3]: Vector<f64>, [y1, y2, y3]: Vector<f64>) -> Vector<f64> {
    [x1 - y1, x2 - y2, x3 - y3]
}

/// First three values of a reading.
fn three([x, y, z, _]: &[f64; 4]) -> Vector<f64> {
    [*x, *y, *z]
}

/// Standard deviations: infinite where the reading is at the end of the range.
fn within(range: f64, reading: Vector<f64>, deviation: f64) -> Vector<f64> {
    reading.map(|x| if libm::fabs(x) < range { deviation } else { f64::INFINITY })
}

impl Sensor for Gyroscope {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let reading = three(values);
        let omega = self.mounting.in_sensor(at.in_body(at.angular_velocity()));
        Prediction {
            difference: minus(reading, omega),
            deviation: within(self.range, reading, self.noise.deviation),
            columns: at.omega_body().map(|column| self.mounting.in_sensor(column)),
        }
    }

    fn bias_deviation(&self) -> f64 {
        self.noise.bias
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let reading = three(values);
        let saturated = reading.map(|x| libm::fabs(x) >= self.range);
        // an axis of the sensor that is neither along nor across the top's is of no use when it is saturated
        let [.., along] = self.mounting.in_body(saturated.map(|is| if is { 1.0 } else { 0.0 }));
        let axial_is_saturated = saturated.contains(&true) && libm::fabs(along) > 0.1;
        Hint::Rate { omega: self.mounting.in_body(reading), axial_is_saturated }
    }
}

impl Sensor for Accelerometer {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let reading = three(values);
        let (force, columns) = at.specific_force(self.mounting.place);
        Prediction {
            difference: minus(reading, self.mounting.in_sensor(force)),
            deviation: within(self.range, reading, self.noise.deviation),
            columns: columns.map(|column| self.mounting.in_sensor(column)),
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

impl Sensor for Magnetometer {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let (field, columns) = at.direction(self.field);
        Prediction {
            difference: minus(three(values), self.mounting.in_sensor(field)),
            deviation: [self.noise.deviation; 3],
            columns: columns.map(|column| self.mounting.in_sensor(column)),
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

impl Sensor for OrientationCamera {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let measured = Orientation::from_quaternion(*values).normalised();
        Prediction {
            difference: rotation_vector(&measured.compose(&at.orientation_now().inverse())),
            deviation: [self.deviation; 3],
            columns: at.orientation(),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        Hint::Orientation(Orientation::from_quaternion(*values).normalised())
    }
}

impl Sensor for AxisCamera {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        Prediction {
            difference: minus(three(values), at.axis()),
            deviation: [self.deviation; 3],
            columns: at.axis_change(),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let [x, y, z] = three(values);
        let length = libm::sqrt(x * x + y * y + z * z);
        Hint::Axis([x / length, y / length, z / length])
    }
}

impl Sensor for TipCamera {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let [x, y, ..] = *values;
        let [r1, r2, _] = at.axis();
        Prediction {
            difference: [x + self.tip_scale * r1, y + self.tip_scale * r2, 0.0],
            deviation: [self.deviation, self.deviation, f64::INFINITY],
            columns: at.tip().map(|c| [c.re, c.im, 0.0]),
        }
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        // the top is taken to stand above the plate
        let [x, y, ..] = values.map(|x| -x / self.tip_scale);
        let square = x * x + y * y;
        Hint::Axis([x, y, libm::sqrt(if square < 1.0 { 1.0 - square } else { 0.0 })])
    }
}

impl Sensor for Mark {
    fn predict(&self, at: &Partials, values: &[f64; 4]) -> Prediction {
        let [azimuth, ..] = *values;
        let place = at.in_fixed(self.place);
        let [x, y, _] = place;
        let square = x * x + y * y;
        let turned = |[dx, dy, _]: Vector<f64>| (x * dy - y * dx) / square;
        let (sine, cosine) = libm::sincos(azimuth);
        let rate = turned(bracket(at.angular_velocity(), place));
        let mut columns = [[0.0; 3]; COLUMNS];
        for (column, theta) in columns.iter_mut().zip(at.orientation()) {
            *column = [turned(bracket(theta, place)), 0.0, 0.0];
        }
        Prediction {
            difference: [libm::atan2(sine * x - cosine * y, cosine * x + sine * y), 0.0, 0.0],
            deviation: [self.deviation * libm::fabs(rate), f64::INFINITY, f64::INFINITY],
            columns,
        }
    }
}

/// Rotation vector of an orientation of either sign, of magnitude up to π.
pub(crate) fn rotation_vector(phi: &Orientation<f64>) -> Vector<f64> {
    let [w, x, y, z] = phi.quaternion();
    let sign = if w < 0.0 { -1.0 } else { 1.0 };
    let sine = libm::sqrt(x * x + y * y + z * z);
    let angle = 2.0 * libm::atan2(sine, sign * w);
    let scale = if sine > 1e-12 { sign * angle / sine } else { 2.0 * sign };
    total([0.0; 3], [x, y, z], scale)
}
