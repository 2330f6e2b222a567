//! The exponential of su(2) (section 2 of the paper) is compared with rotations about its axis by its angle.

use toytop::Orientation;
use toytop::su2::Vector;
use toytop_tests::{apart, length};

/// Fixed pseudo-random rotations: exponentials of elements of su(2).
pub(super) fn rotations() -> Vec<Orientation<f64>> {
    (1..200).map(|i| Orientation::exp(vector(i).map(|x| 4.0 * x))).collect()
}

pub(super) fn vector(i: u32) -> Vector<f64> {
    [1.0, 2.0, 3.0].map(|k| (f64::from(i) * k * 1.618).sin() * (1.0 + k))
}

/// The exponential of an element of any size is a rotation about its axis; the rounding of the angle may exceed a
/// turn. The exponential of a vector that is not finite is the identity.
#[test]
fn the_exponential_is_a_rotation_whatever_its_size() {
    assert_eq!(Orientation::<f64>::exp([0.0; 3]), Orientation::IDENTITY);
    for size in [1e-200, 1e8, 1e17, 1e100, 1e153, 1e160, 1e200, f64::MAX] {
        for x in [[size, 0.0, 0.0], [0.0, -size, 0.0], [0.6 * size, 0.0, 0.8 * size], [size; 3]] {
            let phi = Orientation::<f64>::exp(x);
            assert!((phi.norm_squared() - 1.0).abs() < 1e-15, "{x:?}: {phi:?}");
            let axis = x.map(|component| component / size);
            assert!(apart(axis, phi.adjoint(axis)) < 2e-15 * length(axis), "{x:?}");
            // |x| is exact for a vector along a coordinate axis
            let aligned = axis.iter().filter(|component| **component != 0.0).count() == 1;
            let miss = (phi.alpha.re - (0.5 * size).cos()).abs();
            assert!(!aligned || size < 1e16 || miss < 1e-15, "{x:?}: {phi:?}");
            let single = Orientation::<f32>::exp(axis.map(|component| component as f32 * f32::MAX));
            assert!(
                (single.norm_squared() - 1.0).abs() < 1e-6 && single != Orientation::IDENTITY,
                "{single:?}"
            );
        }
    }
    for wild in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        for x in [[wild, 0.0, 0.0], [0.0, 1.0, wild], [1e300, wild, 1e300]] {
            assert_eq!(Orientation::exp(x), Orientation::<f64>::IDENTITY, "{x:?}");
            assert_eq!(
                Orientation::exp(x.map(|component| component as f32)),
                Orientation::<f32>::IDENTITY,
                "{x:?}"
            );
        }
    }
}

/// In `f32` a small rotation has full relative precision, and a large one the precision of its angle.
#[test]
fn small_rotations_keep_their_digits() {
    for exponent in -30..2 {
        let angle = 1.37 * 10_f64.powi(exponent);
        let phi = Orientation::<f32>::exp([0.0, angle as f32, 0.0]);
        let half = 0.5 * f64::from(angle as f32);
        let [sine, cosine] = [-f64::from(phi.beta.re), f64::from(phi.alpha.re)];
        assert!((sine / half.sin() - 1.0).abs() < 2e-7, "{angle}: {sine:e}");
        assert!((cosine - half.cos()).abs() < 2e-7, "{angle}: {cosine:e}");
        let double = Orientation::<f64>::exp([0.0, angle, 0.0]);
        let half = 0.5 * angle;
        assert!((-double.beta.re / half.sin() - 1.0).abs() < 4e-16, "{angle}: {:e}", double.beta.re);
        assert!((double.alpha.re - half.cos()).abs() < 4e-16, "{angle}");
    }
}
