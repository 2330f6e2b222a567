//! Output of an integrator, compared with the exact motion.
//!
//! | module | contents |
//! |---|---|
//! | [`trajectory`] | times and orientations from a file |
//! | `phases` | phase errors of nutation, precession and spin |
//! | [`scorer`] | errors of a trajectory, and drifts of l, n and h |
//! | [`order`] | order of convergence of several step sizes |

pub mod trajectory;

mod phases;

pub mod order;
pub mod scorer;

use toytop::Orientation;

/// Rotation vector x of the shorter rotation exp(x) that takes `from` to `to`, in the fixed frame, rad: `to` = exp(x) `from`, whatever
/// the signs of both.
pub fn rotation_between(from: &Orientation<f64>, to: &Orientation<f64>) -> [f64; 3] {
    let [w, x, y, z] = to.compose(&from.inverse()).quaternion();
    let sine = (x * x + y * y + z * z).sqrt();
    if sine == 0.0 {
        return [0.0; 3];
    }
    // the quaternion with w >= 0 belongs to the shorter rotation
    let scale = 2.0 * sine.atan2(w.abs()).copysign(w) / sine;
    [scale * x, scale * y, scale * z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rotation_between_two_orientations_does_not_see_signs() {
        let from = Orientation::from_quaternion([0.5, -0.5, 0.1, 0.7]).normalised();
        for x in [[1e-9, -2e-9, 3e-10], [0.3, -0.2, 1.1], [0.0; 3]] {
            let to = Orientation::exp(x).compose(&from);
            let negative = Orientation { alpha: -to.alpha, beta: -to.beta };
            for to in [to, negative] {
                let found = rotation_between(&from, &to);
                assert!(found.iter().zip(x).all(|(found, x)| (found - x).abs() < 1e-15), "{found:?}");
            }
        }
    }
}
