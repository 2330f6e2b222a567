//! Upright tops whose spin the measurements do not determine.
//!
//! While a top stands upright, the readings of an accelerometer and of a gyroscope do not depend on its spin and roll, if
//! the spin is beyond the gyroscope's range. A fit still finds a tilt as small as the noise, and a spin at which this tilt
//! explains the noise best; by the derivatives at that launch, the spin would be determined. Therefore a launch that cannot be distinguished from an
//! upright one is evaluated with the derivatives of the upright one.

use crate::fit::Fit;
use crate::fit::beginning::upright_to;
use crate::fit::launch::Launch;
use crate::fit::pass::{Progress, SETTLED};
use crate::fit::sensor::{Hint, Measurement};
use crate::fit::triangle::MOST_UNKNOWNS;
use crate::fit::window::Part;
use crate::scalar::Real;
use crate::su2::{bracket, dot};

/// Least quotient of an angular velocity beyond the range and a reading at the end of the range: bias, noise and the
/// mounting may shift the reading.
const WITHIN: f64 = 0.9;
/// Sine of the tilt, and share of ω across the axis, beyond which a launch is not compared with an upright one.
const NEAR: f64 = 0.1;
/// Increase of the sum of squares up to which the upright launch explains the measurements equally well. It is
/// compared with the best of many spins: the largest of a hundred sums of four squares is about 20.
const CHANCE: f64 = 40.0;

impl<F: Real> Fit<'_, F> {
    /// Passes over the measurements until the launch does not change any more, and then checks whether the spin is
    /// determined.
    pub(super) fn settle_finally<I>(&mut self, measurements: &I) -> Progress
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let progress = self.settle(measurements, Part::ALL, SETTLED);
        let Launch { orientation, omega, .. } = self.best.launch;
        let found = dot(omega, orientation.axis());
        let least = measurements.clone().find_map(|measurement| self.least_spin(&measurement));
        // the axial component of ω is constant, so that one reading at the end of the range bounds it
        let spin = least.filter(|least| found / least < WITHIN).unwrap_or(found);
        let unknown = self.explains_upright(spin, measurements)
            && self.model.unobservable(&self.current.launch, &self.current.information).spin;
        if unknown {
            Progress::SpinUnknown
        } else if spin == found {
            progress
        } else {
            Progress::Stuck
        }
    }

    /// Lower bound of the magnitude of the angular velocity about the axis, with its sign, that a reading at the end of
    /// the range gives.
    fn least_spin(&self, measurement: &Measurement) -> Option<f64> {
        match self.hint(measurement) {
            Hint::Rate { omega: [.., low], axial_is_saturated: true } if low != 0.0 => Some(low),
            _ => None,
        }
    }

    /// Whether the upright launch with this angular velocity about the axis explains the measurements as well as the best
    /// launch; the current pass is then that of the upright launch.
    #[inline(never)] // its launches are on the stack only during the call
    fn explains_upright<I>(&mut self, spin: f64, measurements: &I) -> bool
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let found = self.best.launch;
        let axis = found.orientation.axis();
        let across = bracket(found.omega, axis);
        let [x, y, z] = axis;
        let near = NEAR * NEAR;
        if x * x + y * y > near || dot(across, across) > near * dot(found.omega, found.omega) {
            return false;
        }
        let sign = if z < 0.0 { -1.0 } else { 1.0 };
        let tilt = upright_to(axis.map(|component| sign * component));
        let orientation = tilt.inverse().compose(&found.orientation);
        let omega = [0.0, 0.0, sign * spin];
        self.pass(&Launch { orientation, omega, ..found }, measurements, Part::ALL);
        // only the biases are corrected; the launch is held fixed
        let mut deviations = [F::from_f64(1e6); MOST_UNKNOWNS];
        for slot in deviations.iter_mut().take(self.model.common()) {
            *slot = F::from_f64(1e-9);
        }
        self.current.information.damp(&deviations);
        let change = self.current.information.solution();
        let launch = self.model.moved(&self.current.launch, &change);
        self.pass(&launch, measurements, Part::ALL);
        self.current.cost <= self.best.cost + CHANCE
    }
}
