//! Measurements of one fit, checked, with their sensors.

use crate::sensors::{Hint, Measurement, Measurements, Sensor};
use crate::vector::Vector;
use toytop::ParameterError;
use toytop::internal::check_item;

/// Measurements of one fit, checked, with their sensors.
pub(super) struct Block<'a, F, M> {
    pub(super) sensors: &'a [&'a dyn Sensor<F>],
    measurements: M,
    /// Number of measurements.
    pub(super) total: usize,
    /// Times of the first and the last measurement.
    pub(super) times: [f64; 2],
    /// Factor from the rates read to rad per unit time.
    rate_unit: f64,
}

impl<'a, F, M: Measurements> Block<'a, F, M> {
    /// Block whose rates are in rad per unit time. Each measurement is checked.
    #[inline(never)] // stack
    pub(super) fn new(sensors: &'a [&'a dyn Sensor<F>], measurements: M) -> Result<Self, ParameterError> {
        const NAME: &str = "measurements";
        let mut total = 0;
        let mut times = None;
        for Measurement { time, sensor, values } in measurements.clone() {
            let [first, last] = times.unwrap_or([time; 2]);
            let is_finite = time.is_finite() && values.iter().all(|x| x.is_finite());
            check_item(is_finite, NAME, total, "finite")?;
            check_item(time >= last, NAME, total, "as late as the one before, or later")?;
            check_item(sensor < sensors.len(), NAME, total, "of a sensor in the list")?;
            times = Some([first, time]);
            total += 1;
        }
        let times = times.ok_or(ParameterError::new(NAME, "at least one"))?;
        Ok(Self { sensors, total, times, rate_unit: 1.0, measurements })
    }

    /// Block whose rates are in degrees per unit time.
    pub(super) fn in_degrees(&self) -> Self {
        let rate_unit = core::f64::consts::PI / 180.0;
        Self { rate_unit, measurements: self.measurements.clone(), ..*self }
    }

    /// Measurements, with rates in rad per unit time.
    pub(super) fn measurements(&self) -> impl Measurements {
        self.measurements.clone().map(|mut measurement| {
            if self.rate_unit != 1.0 && matches!(self.hint(&measurement), Hint::Rate { .. }) {
                measurement.values = measurement.values.map(|x| x * self.rate_unit);
            }
            measurement
        })
    }

    /// Hint of a measurement.
    pub(super) fn hint(&self, Measurement { sensor, values, .. }: &Measurement) -> Hint {
        self.sensors.get(*sensor).map_or(Hint::None, |sensor| sensor.hint(values))
    }

    /// Rates in the body frame, and whether their axial component is beyond the range.
    pub(super) fn rates(&self) -> impl Iterator<Item = (Vector<f64>, bool)> {
        self.measurements().filter_map(|measurement| match self.hint(&measurement) {
            Hint::Rate { omega, axial_is_saturated } => Some((omega, axial_is_saturated)),
            _ => None,
        })
    }
}
