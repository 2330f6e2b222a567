//! Optical instruments beside the top: cameras, and a mark that passes a photo diode.

use crate::sensitivity::Partials;
use crate::sensors::{Hint, Noise, Residual, Sensor, Values, first_three};
use crate::vector::{UP, Vector, add_scaled, cast, cross, rotation_vector, unit};
use toytop::scalar::Real;
use toytop::su2::Orientation;
use toytop::{Complex, Phase};

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

impl<F: Real> Sensor<F> for OrientationCamera {
    fn noise(&self) -> Noise {
        Noise::unbiased(self.deviation)
    }

    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        let measured = Orientation::from_quaternion(values.map(F::from_f64)).normalised();
        Residual {
            difference: rotation_vector(&measured.compose(&at.orientation().inverse())),
            deviation: [F::from_f64(self.deviation); 3],
            columns: at.d_orientation(),
        }
    }

    fn hint(&self, values: &Values) -> Hint {
        Hint::Orientation(Orientation::from_quaternion(*values).normalised())
    }
}

impl<F: Real> Sensor<F> for AxisCamera {
    fn noise(&self) -> Noise {
        Noise::unbiased(self.deviation)
    }

    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        Residual {
            difference: add_scaled(cast(first_three(values)), at.axis(), -F::ONE),
            deviation: [F::from_f64(self.deviation); 3],
            columns: at.d_axis(),
        }
    }

    fn hint(&self, values: &Values) -> Hint {
        unit(first_three(values)).map_or(Hint::None, |fixed| Hint::Direction { fixed, body: UP })
    }
}

impl<F: Real> Sensor<F> for TipCamera {
    fn noise(&self) -> Noise {
        Noise::unbiased(self.deviation)
    }

    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        let ([x, y, _], tip): (Vector<F>, _) = (cast(first_three(values)), at.tip());
        let [deviation, unused] = [self.deviation, f64::INFINITY].map(F::from_f64);
        Residual {
            difference: [x - tip.re, y - tip.im, F::ZERO],
            deviation: [deviation, deviation, unused],
            columns: at.d_tip().map(|c| [c.re, c.im, F::ZERO]),
        }
    }

    fn hint(&self, &[x, y, ..]: &Values) -> Hint {
        Hint::Tip(Complex::new(x, y))
    }
}

impl<F: Real> Sensor<F> for Mark {
    fn noise(&self) -> Noise {
        Noise::unbiased(self.deviation)
    }

    fn residual(&self, at: &Partials<F>, values: &Values) -> Residual<F> {
        let [azimuth, ..] = *values;
        let place = at.in_fixed(cast(self.place));
        let [x, y, _] = place;
        let square = x * x + y * y;
        let azimuth_rate = |[dx, dy, _]: Vector<F>| (x * dy - y * dx) / square;
        let (sine, cosine) = F::sine_cosine(Phase::from_radians(azimuth));
        let rate = azimuth_rate(cross(at.omega(), place));
        let unused = F::from_f64(f64::INFINITY);
        let deviation = if square > F::ZERO { F::from_f64(self.deviation) * rate.abs() } else { unused };
        Residual {
            difference: [F::atan2(sine * x - cosine * y, cosine * x + sine * y), F::ZERO, F::ZERO],
            deviation: [deviation, unused, unused],
            columns: at
                .map_columns(|tangent, _| [azimuth_rate(cross(tangent.theta, place)), F::ZERO, F::ZERO]),
        }
    }
}
