//! Instruments on the body: gyroscope, accelerometer and magnetometer.

use crate::sensitivity::Partials;
use crate::sensors::{Hint, Mounting, Noise, Residual, Sensor, Values, first_three};
use crate::vector::{UP, Vector, cast, norm, unit};
use toytop::scalar::Real;

/// Least specific force that tells a direction, in standard deviations.
const HINT_SIGMA: f64 = 5.0;

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

impl<F: Real> Sensor<F> for Gyroscope {
    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        self.mounting.residual(values, (at.omega_body(), at.d_omega_body()), &self.noise, self.range)
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &Values) -> Hint {
        let reading = first_three(values);
        let saturated = reading.map(|x| x.abs() >= self.range);
        // a saturated axis of the sensor says little about the axial rate, unless it is across the top's axis
        let axis = self.mounting.rotation.inverse().axis();
        let axial_is_saturated = saturated.iter().zip(axis).any(|(is, along)| *is && along.abs() > 0.1);
        Hint::Rate { omega: self.mounting.rotation.adjoint(reading), axial_is_saturated }
    }
}

impl<F: Real> Sensor<F> for Accelerometer {
    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        let predicted = at.specific_force(cast(self.mounting.place));
        self.mounting.residual(values, predicted, &self.noise, self.range)
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &Values) -> Hint {
        let reading = first_three(values);
        // that of a free body is noise and bias; away from the centre of mass, or the tip, most of it comes from the rotation
        let least = HINT_SIGMA * (self.noise.deviation + self.noise.bias_deviation);
        if norm(reading) < least || norm(self.mounting.place) > 0.0 {
            return Hint::None;
        }
        Hint::Direction { fixed: UP, body: self.mounting.rotation.adjoint(reading) }
    }
}

impl<F: Real> Sensor<F> for Magnetometer {
    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        self.mounting.residual(values, at.direction(cast(self.field)), &self.noise, f64::INFINITY)
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &Values) -> Hint {
        let body = self.mounting.rotation.adjoint(first_three(values));
        unit(self.field).map_or(Hint::None, |fixed| Hint::Direction { fixed, body })
    }
}
