//! Conversions to and from nalgebra: component order, sign, both directions.

use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use toytop::Orientation;
use toytop_tests::widened;

#[test]
fn the_quaternion_is_the_same_rotation_with_the_same_sign() {
    for i in 1..60 {
        let x = [0.31, -0.22, 0.17].map(|component| component * f64::from(i));
        let phi = Orientation::exp(x);
        let q = UnitQuaternion::from(phi);
        // nalgebra's own exponential of the same vector, sign included (angles up to several turns)
        let theirs = UnitQuaternion::new(Vector3::from(x));
        assert!((q.coords - theirs.coords).norm() < 1e-14 || (q.coords + theirs.coords).norm() < 1e-14);
        let body = Vector3::new(0.3, -1.2, 0.8);
        let turned = q * body;
        let ours = phi.adjoint([0.3, -1.2, 0.8]);
        assert!((turned - Vector3::from(ours)).norm() < 1e-14);
        assert_eq!(Orientation::from(q), phi);
        let minus = Orientation { alpha: -phi.alpha, beta: -phi.beta };
        assert_eq!(UnitQuaternion::from(minus).coords, -q.coords);
    }
}

#[test]
fn component_order() {
    let phi = Orientation::<f64>::exp([0.2, 0.0, 0.0]);
    let q = UnitQuaternion::from(phi);
    assert_eq!((q.w, q.i, q.j, q.k), (phi.alpha.re, phi.beta.im, -phi.beta.re, phi.alpha.im));
    assert!((q.i - 0.1_f64.sin()).abs() < 1e-16);
    assert!((UnitQuaternion::from(Orientation::<f64>::exp([0.0, 0.2, 0.0])).j - 0.1_f64.sin()).abs() < 1e-16);
    assert!((UnitQuaternion::from(Orientation::<f64>::exp([0.0, 0.0, 0.2])).k - 0.1_f64.sin()).abs() < 1e-16);
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
