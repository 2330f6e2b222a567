//! SU(2), its Lie algebra, and its two actions on the sphere (section 2 of the paper).

use toytop::fixed::traits::Fixed;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::su2::{Vector, cross, dot};
use toytop::{Complex, Orientation};
use toytop_tests::complex::{C, from};
use toytop_tests::{greater, tolerance};

/// Fixed pseudo-random rotations: exponentials of elements of su(2).
fn rotations() -> Vec<Orientation<f64>> {
    (1..200).map(|i| Orientation::exp(vector(i).map(|x| 4.0 * x))).collect()
}

fn narrowed<F: Fixed>(phi: Orientation<f64>) -> Orientation<F> {
    let narrow = |z: Complex<f64>| Complex::new(F::from_num(z.re), F::from_num(z.im));
    Orientation { alpha: narrow(phi.alpha), beta: narrow(phi.beta) }
}

fn vector(i: u32) -> Vector<f64> {
    [1.0, 2.0, 3.0].map(|k| (f64::from(i) * k * 1.618).sin() * (1.0 + k))
}

fn distance(x: Vector<f64>, y: Vector<f64>) -> f64 {
    let difference: Vector<f64> = std::array::from_fn(|i| x[i] - y[i]);
    dot(difference, difference).sqrt() / dot(x, x).sqrt().max(1.0)
}

#[test]
fn group_facts() {
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        let (x, y) = (vector(i as u32 + 7), vector(i as u32 + 50));
        let psi = Orientation::exp(y);
        worst = greater(worst, (phi.norm_squared() - 1.0).abs());
        worst = greater(worst, phi.compose(&phi.inverse()).distance(&Orientation::IDENTITY));
        // Ad is a homomorphism, orthogonal, and respects the bracket
        worst = greater(worst, distance(phi.compose(&psi).adjoint(x), phi.adjoint(psi.adjoint(x))));
        worst =
            greater(worst, distance(phi.adjoint(cross(x, y)), cross(phi.adjoint(x), phi.adjoint(y))) / 4.0);
        worst = greater(worst, distance(phi.axis(), phi.adjoint([0.0, 0.0, 1.0])));
        // the matrix product: upper row of Φ Φ⁻¹
        let off = phi.alpha * phi.delta() - phi.beta * phi.gamma() - Complex::ONE;
        worst = greater(worst, off.norm_squared().sqrt());
    }
    tolerance::GROUP.check("group facts", worst);
}

#[test]
fn the_exponential_turns_about_its_axis() {
    let phi = Orientation::<f64>::exp([0.0, 0.0, 0.7]);
    assert!(distance(phi.adjoint([1.0, 0.0, 0.0]), [0.7_f64.cos(), 0.7_f64.sin(), 0.0]) < 1e-15);
    let quarter = Orientation::<f64>::exp([std::f64::consts::FRAC_PI_2, 0.0, 0.0]);
    assert!(distance(quarter.adjoint([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]) < 1e-15);
    assert_eq!(Orientation::<f64>::exp([0.0; 3]), Orientation::IDENTITY);
    assert!(Orientation::<f64>::exp([0.0, 1e-200, 0.0]).norm_squared() == 1.0);
}

/// The exponential of an element of any size is a rotation about its axis; the rounding of the angle may exceed a
/// turn. The exponential of a vector that is not finite is the identity.
#[test]
fn the_exponential_is_a_rotation_whatever_its_size() {
    for size in [1e8, 1e17, 1e100, 1e153, 1e160, 1e200, f64::MAX] {
        for x in [[size, 0.0, 0.0], [0.0, -size, 0.0], [0.6 * size, 0.0, 0.8 * size], [size; 3]] {
            let phi = Orientation::<f64>::exp(x);
            assert!((phi.norm_squared() - 1.0).abs() < 1e-15, "{x:?}: {phi:?}");
            let axis = x.map(|component| component / size);
            assert!(distance(axis, phi.adjoint(axis)) < 2e-15, "{x:?}");
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

/// Equations (2.4) and (2.5): the Möbius transformation is Ad in the plane of the stereographic projection from the north pole.
#[test]
fn moebius_is_the_adjoint_action() {
    let stereographic = |[x, y, z]: Vector<f64>| C::new(x, y) / (1.0 - z);
    let sphere_point =
        |z: C| [2.0 * z.re, 2.0 * z.im, z.norm_sqr() - 1.0].map(|component| component / (z.norm_sqr() + 1.0));
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        let x = vector(i as u32 + 3);
        let point = x.map(|component| component / dot(x, x).sqrt());
        let [alpha, beta, gamma, delta] = [phi.alpha, phi.beta, phi.gamma(), phi.delta()].map(from);
        let z = stereographic(point);
        let turned = sphere_point((alpha * z + beta) / (gamma * z + delta));
        worst = greater(worst, distance(turned, phi.adjoint(point)) * (1.0 - point[2]).min(1.0));
    }
    tolerance::GROUP.check("Moebius", worst);
}

/// In a number type with the range ±2, the adjoint action of the third unit vector is the axis.
#[test]
fn the_adjoint_action_in_fixed_point() {
    let mut error = [0.0_f64; 2];
    for phi in rotations() {
        let (wide, narrow): (Orientation<I2F30>, Orientation<I2F14>) = (narrowed(phi), narrowed(phi));
        let turned = wide.adjoint([I2F30::ZERO, I2F30::ZERO, I2F30::ONE]).map(f64::from);
        let turned_narrow = narrow.adjoint([I2F14::ZERO, I2F14::ZERO, I2F14::ONE]).map(f64::from);
        for (error, turned) in error.iter_mut().zip([turned, turned_narrow]) {
            *error = error.max(distance(turned, phi.axis()));
        }
    }
    assert!(error[0] < 3e-8 && error[1] < 1e-3, "{error:?}");
}

/// In `f32` a small rotation has full relative precision, and a large one the precision of its angle.
#[test]
fn the_exponential_of_small_rotations() {
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

/// Quaternion, matrix and adjoint action give the same rotation.
#[test]
fn quaternion_and_matrix() {
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        assert_eq!(Orientation::from_quaternion(phi.quaternion()), phi);
        let x = vector(i as u32 + 11);
        let turned = phi.adjoint(x);
        worst = worst.max(distance(phi.matrix().map(|row| dot(row, x)), turned));
        // v + 2 w (q × v) + 2 q × (q × v)
        let [w, q @ ..] = phi.quaternion();
        let (once, twice) = (cross(q, x), cross(q, cross(q, x)));
        let by_quaternion = std::array::from_fn(|k| x[k] + 2.0 * (w * once[k] + twice[k]));
        worst = worst.max(distance(by_quaternion, turned));
    }
    tolerance::GROUP.check("quaternion and matrix", worst);
    assert_eq!(Orientation::<f64>::default().matrix(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
}
