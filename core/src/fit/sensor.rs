//! Sensors: the predicted reading of an instrument at a state, and its derivatives with respect to the launch.

use crate::complex::Complex;
use crate::scalar::Real;
use crate::sensitivity::{COLUMNS, Partials};
use crate::su2::{Orientation, Vector};

/// One reading of a sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Time, in the unit of time (s).
    pub time: f64,
    /// Index of the sensor in the list that the fit was given.
    pub sensor: usize,
    /// Values of the reading; a sensor with fewer leaves the rest 0.
    pub values: [f64; 4],
}

/// Difference of a reading from what a state predicts, in up to three components.
#[derive(Clone, Copy, Debug)]
pub struct Prediction<F = f64> {
    /// Measured minus predicted value, without bias.
    pub difference: Vector<F>,
    /// Standard deviation of the noise; infinite for a component without information.
    pub deviation: Vector<F>,
    /// Derivatives of the predicted value, in the order of [`Sensitivity::NAMES`](crate::Sensitivity::NAMES).
    pub columns: [Vector<F>; COLUMNS],
}

/// Information that one reading contains about the state, from which a fit makes its first guess.
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
    /// Direction that is known in the fixed frame, seen in the body frame.
    Direction {
        /// Unit vector in the fixed frame.
        fixed: Vector<f64>,
        /// Vector along the same direction in the body frame, of any length.
        body: Vector<f64>,
    },
    /// Orientation Φ, of either sign.
    Orientation(Orientation<f64>),
    /// Axis r in the fixed frame.
    Axis(Vector<f64>),
}

/// Sensor on the top or beside it. Implement it for an instrument of your own, for the scalar `F` in which your fits
/// compute.
pub trait Sensor<F = f64> {
    /// Difference of a reading from the prediction at a state, with its derivatives.
    fn predict(&self, at: &Partials<F>, values: &[f64; 4]) -> Prediction<F>;

    /// Prior standard deviation of a constant bias of each component; 0 where there is no bias, which then is not an
    /// unknown.
    fn bias_deviation(&self) -> f64 {
        0.0
    }

    /// Information about the state, from which a fit may make its first guess.
    fn hint(&self, values: &[f64; 4]) -> Hint {
        let _ = values;
        Hint::None
    }
}

/// Noise and bias of a sensor with three equal components.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Standard deviation of one reading.
    pub deviation: f64,
    /// Standard deviation of the constant bias; 0 for none.
    pub bias: f64,
}

/// Mounting of a sensor in the body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounting {
    /// Rotation from sensor to body coordinates.
    pub rotation: Orientation<f64>,
    /// Body coordinates of its place, m: from the centre of mass of a sliding top, and from the tip of a top with a
    /// fixed tip.
    pub place: Vector<f64>,
}

impl Mounting {
    /// Axes of the sensor in the fixed frame.
    pub(crate) fn axes<F: Real>(&self, at: &Partials<F>) -> [Vector<F>; 3] {
        if self.is_along_body() { at.body_axes() } else { at.axes(&self.rotation()) }
    }

    /// Axis of the top in the coordinates of the sensor.
    pub(crate) fn axis<F: Real>(&self) -> Vector<F> {
        if self.is_along_body() { [F::ZERO, F::ZERO, F::ONE] } else { self.rotation().inverse().axis() }
    }

    /// Place in the scalar of the measurements. Most are at the origin, whose bits are compared faster than converted.
    pub(crate) fn place<F: Real>(&self) -> Vector<F> {
        if self.place.iter().all(|x| x.to_bits() == 0) { [F::ZERO; 3] } else { self.place.map(F::from_f64) }
    }

    /// Whether the sensor is mounted along the axes of the body. The bits are compared, which is faster on a chip
    /// without a unit for `f64`.
    fn is_along_body(&self) -> bool {
        let Orientation { alpha, beta } = self.rotation;
        alpha.re.to_bits() == 1.0_f64.to_bits()
            && [alpha.im, beta.re, beta.im].iter().all(|x| x.to_bits() == 0)
    }

    fn rotation<F: Real>(&self) -> Orientation<F> {
        let Orientation { alpha, beta } = self.rotation;
        let of = |z: Complex<f64>| Complex::new(F::from_f64(z.re), F::from_f64(z.im));
        Orientation { alpha: of(alpha), beta: of(beta) }
    }

    /// Body coordinates of a vector that is given in sensor coordinates.
    pub(crate) fn in_body(&self, sensor: Vector<f64>) -> Vector<f64> {
        self.rotation.adjoint(sensor)
    }
}
