//! Instruments on the body: gyroscope, accelerometer and magnetometer.

use crate::sensitivity::Partials;
use crate::sensors::{Hint, Mounting, Noise, Residual, Sensor, three};
use crate::vector::{UP, Vector, add_scaled, along, cast, dot, unit};
use toytop::scalar::Real;

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

/// Deviation of the noise; infinite where the reading is at the end of the range.
fn deviations<F: Real>(range: f64, reading: Vector<F>, deviation: f64) -> Vector<F> {
    let [range, deviation, unused] = cast([range, deviation, f64::INFINITY]);
    reading.map(|x| if x.abs() < range { deviation } else { unused })
}

impl<F: Real> Sensor<F> for Gyroscope {
    fn residual(&self, at: &Partials<F>, values: &[f64; 4]) -> Residual<F> {
        let reading = cast(three(values));
        let axes = self.mounting.axes(at);
        // the axial part is larger than the rest, and keeps its digits
        let axis = cast(self.mounting.axis());
        let rate = add_scaled(along(&axes, at.state.across), axis, at.state.spin);
        Residual {
            difference: add_scaled(reading, rate, -F::ONE),
            deviation: deviations(self.range, reading, self.noise.deviation),
            columns: at.each(|tangent, _| along(&axes, tangent.eta)),
        }
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let reading = three(values);
        let saturated = reading.map(|x| libm::fabs(x) >= self.range);
        // a saturated axis of the sensor says little about the axial rate, unless it is across the top's axis
        let axis = self.mounting.axis();
        let axial_is_saturated = saturated.iter().zip(axis).any(|(is, along)| *is && libm::fabs(along) > 0.1);
        Hint::Rate { omega: self.mounting.in_body(reading), axial_is_saturated }
    }
}

impl<F: Real> Sensor<F> for Accelerometer {
    fn residual(&self, at: &Partials<F>, values: &[f64; 4]) -> Residual<F> {
        let reading = cast(three(values));
        let (force, columns) = at.force_along(&self.mounting.axes(at), cast(self.mounting.place));
        Residual {
            difference: add_scaled(reading, force, -F::ONE),
            deviation: deviations(self.range, reading, self.noise.deviation),
            columns,
        }
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        // away from the centre of mass, or the tip, most of the specific force is that of the rotation
        if dot(self.mounting.place, self.mounting.place) > 0.0 {
            return Hint::None;
        }
        Hint::Direction { fixed: UP, body: self.mounting.in_body(three(values)) }
    }
}

impl<F: Real> Sensor<F> for Magnetometer {
    fn residual(&self, at: &Partials<F>, values: &[f64; 4]) -> Residual<F> {
        let (field, columns) = at.direction_along(&self.mounting.axes(at), cast(self.field));
        Residual {
            difference: add_scaled(cast(three(values)), field, -F::ONE),
            deviation: [F::from_f64(self.noise.deviation); 3],
            columns,
        }
    }

    fn noise(&self) -> Noise {
        self.noise
    }

    fn hint(&self, values: &[f64; 4]) -> Hint {
        let body = self.mounting.in_body(three(values));
        unit(self.field).map_or(Hint::None, |fixed| Hint::Direction { fixed, body })
    }
}
