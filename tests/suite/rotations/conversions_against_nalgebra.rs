//! Conversions to quaternions and matrices are compared with nalgebra: component order, sign, both directions.

use super::exponential::{rotations, vector};
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use toytop::Orientation;
use toytop_tests::widened;

#[test]
fn the_quaternion_is_the_same_rotation_with_the_same_sign() {
    for (i, phi) in (1..).zip(rotations()) {
        let q = UnitQuaternion::from(phi);
        let [w, x, y, z] = phi.quaternion();
        assert_eq!([q.w, q.i, q.j, q.k], [w, x, y, z]);
        assert_eq!([Orientation::from(q), Orientation::from_quaternion([w, x, y, z])], [phi; 2]);
        let minus = Orientation { alpha: -phi.alpha, beta: -phi.beta };
        assert_eq!(UnitQuaternion::from(minus).coords, -q.coords);
        // nalgebra's own exponential, whose sign is lost beyond a turn
        let theirs = UnitQuaternion::new(Vector3::from(vector(i)) * 4.0);
        assert!((q.coords - theirs.coords).norm() < 1e-14 || (q.coords + theirs.coords).norm() < 1e-14);
        let body = vector(i + 11);
        let turned = theirs * Vector3::from(body);
        assert!((turned - Vector3::from(phi.adjoint(body))).norm() < 3e-14);
        let rows = phi.matrix().map(|row| Vector3::from(row).dot(&Vector3::from(body)));
        assert!((turned - Vector3::from(rows)).norm() < 3e-14);
    }
}

#[test]
fn the_matrix_loses_only_the_sign() {
    for i in 1..60 {
        let phi = Orientation::<f32>::exp([0.4, 0.5, -0.3].map(|component| component * i as f32));
        let matrix = Rotation3::from(phi);
        let axis = matrix * Vector3::z();
        assert!((axis - Vector3::from(phi.axis())).norm() < 1e-6);
        let back = Orientation::from(matrix);
        let minus = Orientation { alpha: -back.alpha, beta: -back.beta };
        let error = |candidate| widened(candidate).distance(&widened(phi));
        assert!(error(back).min(error(minus)) < 2e-6);
    }
}
