//! Euler angles of an orientation, in rad.

use std::f64::consts::PI;
use toytop::{Complex, Orientation};

/// Tilt in [0, π], azimuth and roll in (-π, π] of a scenario's release: Rz(azimuth) Ry(tilt) Rz(roll). Where the axis is vertical, one of
/// the two is 0.
pub fn tilt_azimuth_roll(orientation: &Orientation<f64>) -> [f64; 3] {
    let Orientation { alpha, beta } = *orientation;
    let tilt = 2.0 * modulus(beta).atan2(modulus(alpha));
    // alpha = cos(tilt/2) exp(i (azimuth + roll)/2), beta = -sin(tilt/2) exp(i (azimuth - roll)/2)
    let argument = |z: Complex<f64>| z.im.atan2(z.re);
    let (azimuth, roll) = match [modulus(alpha), modulus(beta)] {
        [_, 0.0] => (0.0, 2.0 * argument(alpha)),
        [0.0, _] => (2.0 * argument(-beta), 0.0),
        _ => (argument(alpha) + argument(-beta), argument(alpha) - argument(-beta)),
    };
    [tilt, wrapped(azimuth), wrapped(roll)]
}

/// Euler's angles φ in (-π, π], θ in [0, π], ψ in (-π, π] of the sequence z-x-z: Rz(φ) Rx(θ) Rz(ψ).
pub fn zxz(orientation: &Orientation<f64>) -> [f64; 3] {
    let [tilt, azimuth, roll] = tilt_azimuth_roll(orientation);
    [wrapped(azimuth + 0.5 * PI), tilt, wrapped(roll - 0.5 * PI)]
}

/// Modulus also of a number whose square underflows, unlike [`Complex::modulus`].
fn modulus(z: Complex<f64>) -> f64 {
    z.re.hypot(z.im)
}

/// Angle in (-π, π] that differs by whole turns.
fn wrapped(angle: f64) -> f64 {
    let turns = (angle / (2.0 * PI) - 0.5).ceil();
    (angle - 2.0 * PI * turns).clamp(-PI, PI)
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Release, State};

    fn about(axis: usize, angle: f64) -> Orientation<f64> {
        let mut x = [0.0; 3];
        x[axis] = angle;
        Orientation::exp(x)
    }

    #[test]
    fn the_angles_make_the_orientation_again() {
        for (tilt, azimuth, roll) in [
            (0.3, 2.9, -3.0),
            (1.0, -0.4, 0.1),
            (3.1, 3.1, 3.1),
            (0.0, 0.0, 1.2),
            (PI, 0.7, 0.0),
            (1e-9, 1.0, 2.0),
        ] {
            let release = Release { tilt, azimuth, roll, spin: 1.0, ..Release::default() };
            let orientation = State::from_release(&release).unwrap().orientation();
            let [a, b, c] = tilt_azimuth_roll(&orientation);
            assert!(
                (a - tilt).abs() < 1e-15 && (b - azimuth).abs() < 1e-14 && (c - roll).abs() < 1e-14,
                "{tilt} {azimuth} {roll}: {a} {b} {c}"
            );
            let [p, t, s] = zxz(&orientation);
            let again = about(2, p).compose(&about(0, t)).compose(&about(2, s));
            let opposite = Orientation { alpha: -again.alpha, beta: -again.beta };
            let off = orientation.distance(&again).min(orientation.distance(&opposite));
            assert!(off < 2e-15, "{tilt} {azimuth} {roll}: {off:e}");
            assert!([p, t, s].iter().all(|x| x.abs() <= PI));
        }
    }
}
