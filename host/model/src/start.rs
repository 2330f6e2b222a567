//! State of a motion at t = 0: its axis, and its angular momentum where no torque acts.

use crate::equations::cross;
use core::array::from_fn;
use toytop::Motion;
use toytop::scalar::{Float, Real, Ring};

/// Tilt and azimuth of the axis at t = 0, rad, and their rates, rad/s. Where the axis is vertical, the azimuth rate is 0, and the tilt rate
/// is the speed at which the axis leaves the vertical.
pub(crate) fn axis_at_start(motion: &Motion) -> [f64; 4] {
    let state = motion.attitude_at_launch();
    let (axis, u) = (state.orientation.axis(), state.orientation.u().clamp(-1.0, 1.0));
    let ([x, y, _], [rx, ry, rz]) = (axis, cross(state.omega(), axis));
    let level = Float::sqrt(x * x + y * y);
    let [precession, nutation] = if level > 0.0 {
        [(x * ry - y * rx) / level.squared(), (x * rx + y * ry) / level * u - rz * level]
    } else {
        [0.0, Float::sqrt(rx * rx + ry * ry)]
    };
    [Real::atan2(level, u), Real::atan2(y, x), precession, nutation]
}

/// Angular momentum m = A r × r' + n r of a body on which no torque acts, kg m²/s; NaN where one does.
pub(crate) fn momentum(motion: &Motion) -> [f64; 3] {
    if !motion.top().is_torque_free() {
        return [f64::NAN; 3];
    }
    let state = motion.attitude_at_launch();
    let (r, n) = (state.orientation.axis(), motion.first_integrals().n);
    let swing = cross(r, cross(state.omega(), r));
    from_fn(|i| motion.top().transverse_inertia() * swing[i] + n * r[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::launch::{Kind, Launch};
    use crate::parameters::{self, top_parameters};
    use toytop::Support;

    /// Motion of a throw: tilt, spin, precession, nutation, azimuth and roll.
    fn thrown(support: Support, numbers: [f64; 7]) -> Motion {
        let top = parameters::top(support, &top_parameters(numbers)).unwrap();
        let launch = Launch::new(Kind::Release, [20.0, 150.0, 4.0, -3.0, 50.0, 70.0, 0.0, 0.0]);
        launch.unwrap().motion(&top).unwrap()
    }

    /// The toy top of the README.
    fn toy_top() -> Motion {
        thrown(Support::Sliding, [3.0e-5, 2.0e-5, 0.03, 0.05, 0.0, 9.81, 0.0])
    }

    /// The sliders of the throw show any motion by these.
    #[test]
    fn angles_and_rates_at_the_start_are_those_of_the_throw() {
        let motion = toy_top();
        let given = [20_f64.to_radians(), 50_f64.to_radians(), 4.0, -3.0];
        for (found, given) in axis_at_start(&motion).into_iter().zip(given) {
            assert!((found / given - 1.0).abs() < 1e-12, "{found} for {given}");
        }
        assert!((motion.first_integrals().spin / 150.0 - 1.0).abs() < 1e-12);
    }

    /// Where no torque acts the angular momentum stands still, Aω + ((C - A)⟨ω, r⟩ + K) r; elsewhere it does not.
    #[test]
    fn a_free_body_has_its_angular_momentum() {
        let motion = thrown(Support::Free, [3.0e-5, 2.0e-5, 0.0, 0.0, 0.0, 0.0, 1.0e-3]);
        let state = motion.attitude_at_launch();
        let (r, omega) = (state.orientation.axis(), state.omega());
        let axial = -1.0e-5 * 150.0 + 1.0e-3;
        for (i, found) in momentum(&motion).into_iter().enumerate() {
            let expected = 3.0e-5 * omega[i] + axial * r[i];
            assert!((found - expected).abs() < 1e-17, "{i}: {found:e} for {expected:e}");
        }
        assert!(momentum(&toy_top()).iter().all(|x| x.is_nan()));
    }
}
