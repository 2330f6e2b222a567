//! Sensors: the predicted reading of an instrument at a state, and its derivatives with respect to the launch.

mod inertial;

mod optical;

use crate::sensitivity::{COLUMNS, Partials};
use crate::vector::{Vector, add_scaled, cast, coordinates};
pub use inertial::{Accelerometer, Gyroscope, Magnetometer};
pub use optical::{AxisCamera, Mark, OrientationCamera, TipCamera};
use toytop::Complex;
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Values of one reading; a sensor with fewer leaves the rest 0.
pub type Values = [f64; 4];

/// One reading of a sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Time, in the unit of time (s).
    pub time: f64,
    /// Index of the sensor in the list that the fit was given.
    pub sensor: usize,
    /// Values, in the unit of the sensor.
    pub values: Values,
}

/// Measurements in the order of time, which are read several times.
pub(crate) trait Measurements: Iterator<Item = Measurement> + Clone {}

impl<I: Iterator<Item = Measurement> + Clone> Measurements for I {}

/// Residual of a reading: its difference from what a state predicts, in up to three components.
#[derive(Clone, Copy, Debug)]
pub struct Residual<F = f64> {
    /// Measured minus predicted value, without bias.
    pub difference: Vector<F>,
    /// Standard deviation of the noise; infinite for a component without information.
    pub deviation: Vector<F>,
    /// Derivatives of the predicted value, in the order of the columns of the state's [`Partials`].
    pub columns: [Vector<F>; COLUMNS],
}

/// Information of a reading for the first guess of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Hint {
    /// No information that a first guess can use.
    None,
    /// Angular velocity in the body frame; a component may be only a lower bound of the magnitude.
    Rate {
        /// Angular velocity Ω, rad per unit time.
        omega: Vector<f64>,
        /// Whether the component along the axis is beyond the range of the sensor.
        axial_is_saturated: bool,
    },
    /// Direction that is known in both frames. For the symmetry axis, `body` is [0, 0, 1].
    Direction {
        /// Vector along the direction in the fixed frame, of any length.
        fixed: Vector<f64>,
        /// Vector along the same direction in the body frame, of any length.
        body: Vector<f64>,
    },
    /// Orientation Φ, of either sign.
    Orientation(Orientation<f64>),
    /// Tip c on the plane, m. The top is assumed to stand above the plane.
    Tip(Complex<f64>),
}

/// Sensor on the top or beside it, for fits in the scalar `F`. Implement it for an instrument of your own.
pub trait Sensor<F = f64> {
    /// Difference of a reading from the prediction at a state, with its derivatives.
    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F>;

    /// Noise and bias of each component.
    fn noise(&self) -> Noise;

    /// Information about the state, for the first guess of a fit.
    fn hint(&self, values: &Values) -> Hint {
        let _ = values;
        Hint::None
    }
}

/// Noise and bias of a sensor, equal in all components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Standard deviation of one reading, > 0.
    pub deviation: f64,
    /// Prior standard deviation of the constant bias; 0 for none.
    pub bias_deviation: f64,
}

impl Noise {
    /// Noise without a bias.
    const fn unbiased(deviation: f64) -> Self {
        Self { deviation, bias_deviation: 0.0 }
    }

    /// Whether the deviation of the noise is positive, that of the bias not negative, and both finite.
    pub(crate) fn is_valid(&self) -> bool {
        let Self { deviation, bias_deviation } = *self;
        deviation > 0.0 && bias_deviation >= 0.0 && (deviation + bias_deviation).is_finite()
    }
}

/// Mounting of a sensor in the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounting {
    /// Rotation from sensor to body coordinates.
    pub rotation: Orientation<f64>,
    /// Body coordinates of its place, m, from the point that the moments of inertia belong to: the centre of mass, or a fixed tip.
    pub place: Vector<f64>,
}

impl Mounting {
    /// Residual of a reading, from the predicted vector in body coordinates and its derivatives. A component at the end of the range has
    /// no information.
    fn residual<F: Real>(
        &self,
        values: &Values,
        (predicted, columns): (Vector<F>, [Vector<F>; COLUMNS]),
        noise: &Noise,
        range: f64,
    ) -> Residual<F> {
        let in_sensor = coordinates(self.rotation.map(F::from_f64));
        let reading = cast(first_three(values));
        let [range, deviation, unused] = cast([range, noise.deviation, f64::INFINITY]);
        Residual {
            difference: add_scaled(reading, in_sensor(predicted), -F::ONE),
            deviation: reading.map(|x| if x.abs() < range { deviation } else { unused }),
            columns: columns.map(in_sensor),
        }
    }
}

/// First three values of a reading.
pub(crate) fn first_three([x, y, z, _]: &Values) -> Vector<f64> {
    [*x, *y, *z]
}
