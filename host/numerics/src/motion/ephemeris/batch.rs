//! One quantity of an ephemeris at many times.

use super::{Boxed, BoxedScalar, unwrapped};
use toytop::scalar::Float;

/// Quantity of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Unit quaternion w, x, y, z from body to fixed coordinates.
    Quaternion,
    /// Unit vector from the tip to the centre of mass, in the fixed frame.
    Axis,
    /// Cosine of the tilt.
    U,
    /// Rate of u, per unit time.
    Udot,
    /// Angular velocity in the fixed frame, rad per unit time.
    Omega,
    /// Angular velocity in the body frame, rad per unit time.
    OmegaBody,
    /// Position of the tip, 2 s αβ; 2 αβ for a fixed tip.
    Tip,
    /// Tip angle, continued from t = 0, rad; NaN where the axis is vertical at all times.
    TipAngle,
}

impl Quantity {
    /// Number of quantities.
    pub const COUNT: usize = 8;

    /// Number of components.
    #[must_use]
    pub const fn width(self) -> usize {
        match self {
            Self::Quaternion => 4,
            Self::Axis | Self::Omega | Self::OmegaBody => 3,
            Self::Tip => 2,
            Self::U | Self::Udot | Self::TipAngle => 1,
        }
    }
}

impl<R: BoxedScalar> Boxed<R> {
    /// Writes the components of a quantity at each of these times to `out`.
    pub(super) fn fill_with(&self, quantity: Quantity, times: &[f64], out: &mut [f64]) {
        let table = &*self.0;
        let wide = <R::Wide as Float>::to_f64;
        match quantity {
            Quantity::Quaternion => rows(times, out, |t| table.at(t).quaternion().map(Into::into)),
            Quantity::Axis => rows(times, out, |t| table.at(t).axis().map(Into::into)),
            Quantity::U => rows(times, out, |t| [table.at(t).u().into()]),
            Quantity::Udot => rows(times, out, |t| [wide(table.at(t).udot())]),
            Quantity::Omega => rows(times, out, |t| table.at(t).omega().map(wide)),
            Quantity::OmegaBody => rows(times, out, |t| table.at(t).omega_body().map(wide)),
            Quantity::Tip => rows(times, out, |t| {
                let tip = table.at(t).tip();
                [tip.re, tip.im].map(wide)
            }),
            Quantity::TipAngle => rows(times, out, |t| {
                let angle = table.at(t).tip_angle();
                [angle.map_or(f64::NAN, |angle| unwrapped(angle, table.mean_tip_angle_rate() * t))]
            }),
        }
    }
}

/// Writes a row of N numbers for each time.
fn rows<const N: usize>(times: &[f64], out: &mut [f64], row: impl Fn(f64) -> [f64; N]) {
    for (t, out) in times.iter().zip(out.as_chunks_mut().0) {
        *out = row(*t);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Scalar;
    use crate::motion::ephemeris::smallest;
    use crate::motion::ephemeris::tests::motion;

    #[test]
    fn a_quantity_is_that_of_the_sample() {
        let (times, motion) = ([0.0, 0.7, -3.1, 1e6], motion(1.0, [0.2, 0.8, 1.5]));
        for scalar in Scalar::ALL {
            let table = smallest(scalar, &motion).unwrap();
            let filled = |quantity: Quantity| {
                let mut out = vec![0.0; quantity.width() * times.len()];
                table.fill(quantity, &times, &mut out);
                out
            };
            let samples = times.map(|t| table.at(t).sample);
            let exact = |quantity, of: &dyn Fn(&crate::motion::propagate::Sample) -> Vec<f64>| {
                assert_eq!(filled(quantity), samples.iter().flat_map(of).collect::<Vec<_>>(), "{quantity:?}");
            };
            exact(Quantity::Quaternion, &|now| now.orientation().quaternion().to_vec());
            exact(Quantity::U, &|now| vec![now.u]);
            exact(Quantity::Tip, &|now| vec![now.tip.re, now.tip.im]);
            exact(Quantity::TipAngle, &|now| now.phi.into_iter().collect());
            // the others are computed in another way, and differ by rounding errors
            let close = |quantity, of: &dyn Fn(&crate::motion::propagate::Sample) -> Vec<f64>| {
                let expected: Vec<f64> = samples.iter().flat_map(of).collect();
                let off =
                    filled(quantity).iter().zip(&expected).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                // the sines of micromath and of 16 bits have errors of about a thousandth
                let allowed = match scalar {
                    Scalar::Q15 => 2e-3,
                    Scalar::Micromath => 1e-2,
                    _ => 2e-6,
                };
                assert!(off < allowed, "{quantity:?} {scalar:?} {off:e}");
                assert_eq!(expected.len(), quantity.width() * times.len());
            };
            close(Quantity::Axis, &|now| now.orientation().axis().to_vec());
            close(Quantity::Udot, &|now| vec![now.udot]);
            close(Quantity::Omega, &|now| now.omega.to_vec());
            close(Quantity::OmegaBody, &|now| now.orientation().inverse().adjoint(now.omega).to_vec());
        }
    }
}
