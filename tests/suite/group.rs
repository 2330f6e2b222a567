//! SU(2), its algebra, and the two ways it turns the sphere (section 2 of the paper).

use toytop::fixed::traits::Fixed;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::real::Float;
use toytop::su2::{PhiRate, Vector, bracket, dot, sphere_point, stereographic};
use toytop::{Complex, Phi, Stepper};
use toytop_tests::{greater, orientation_error, tolerance, vectors};

/// Fixed pseudo-random rotations: exponentials of a walk through su(2).
fn rotations() -> Vec<Phi<f64>> {
    (1..200).map(|i| Phi::exp(vector(i).map(|x| 4.0 * x))).collect()
}

fn narrowed<F: Fixed>(phi: Phi<f64>) -> Phi<F> {
    let narrow = |z: Complex<f64>| Complex::new(F::from_num(z.re), F::from_num(z.im));
    Phi { alpha: narrow(phi.alpha), beta: narrow(phi.beta) }
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
        let psi = Phi::exp(y);
        worst = greater(worst, (phi.norm_squared() - 1.0).abs());
        worst = greater(worst, orientation_error(phi.compose(&phi.inverse()), Phi::IDENTITY));
        // Ad is a homomorphism, orthogonal, and respects the bracket
        worst = greater(worst, distance(phi.compose(&psi).adjoint(x), phi.adjoint(psi.adjoint(x))));
        worst = greater(
            worst,
            distance(phi.adjoint(bracket(x, y)), bracket(phi.adjoint(x), phi.adjoint(y))) / 4.0,
        );
        worst = greater(worst, distance(phi.axis(), phi.adjoint([0.0, 0.0, 1.0])));
        // the matrix product itself: upper row of Φ Φ⁻¹
        let off = phi.alpha * phi.delta() - phi.beta * phi.gamma() - Complex::ONE;
        worst = greater(worst, off.norm_squared().sqrt());
    }
    tolerance::GROUP.check("group facts", worst);
}

#[test]
fn the_exponential_turns_about_its_axis() {
    let phi = Phi::<f64>::exp([0.0, 0.0, 0.7]);
    assert!(distance(phi.adjoint([1.0, 0.0, 0.0]), [0.7_f64.cos(), 0.7_f64.sin(), 0.0]) < 1e-15);
    let quarter = Phi::<f64>::exp([std::f64::consts::FRAC_PI_2, 0.0, 0.0]);
    assert!(distance(quarter.adjoint([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]) < 1e-15);
    assert_eq!(Phi::<f64>::exp([0.0; 3]), Phi::IDENTITY);
    assert!(Phi::<f64>::exp([0.0, 1e-200, 0.0]).norm_squared() == 1.0);
}

/// eqn:Moeb: the Möbius transformation is Ad seen in the stereographic plane.
#[test]
fn moebius_is_the_adjoint_action() {
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        let x = vector(i as u32 + 3);
        let point = x.map(|component| component / dot(x, x).sqrt());
        let turned = sphere_point(phi.moebius(stereographic(point)));
        worst = greater(worst, distance(turned, phi.adjoint(point)) * (1.0 - point[2]).min(1.0));
    }
    tolerance::GROUP.check("Moebius", worst);
    // infinity is the north pole, and comes back
    let upset = Phi::<f64>::exp([std::f64::consts::PI, 0.0, 0.0]);
    assert_eq!(stereographic([0.0, 0.0, 1.0]), None);
    assert_eq!(sphere_point::<f64>(None), [0.0, 0.0, 1.0]);
    assert!(upset.moebius(None).unwrap().norm_squared() < 1e-30);
}

/// eqn:omega and eqn:Omega, against a central difference of Φ, and ω = Φ Ω Φ⁻¹.
#[test]
fn angular_velocities() {
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let at = |time: f64| {
        let mut stepper = Stepper::<f64>::new(&motion);
        (0..1000).for_each(|_| stepper.step(time / 1000.0));
        stepper.pose()
    };
    let (time, step) = (1.3, 1e-4);
    let (pose, before, after) = (at(time), at(time - step), at(time + step));
    let difference = |a: Complex<f64>, b: Complex<f64>| (b - a).scaled(0.5 / step);
    let rate = PhiRate {
        alpha: difference(before.phi.alpha, after.phi.alpha),
        beta: difference(before.phi.beta, after.phi.beta),
    };
    assert!(distance(pose.omega(), rate.omega_fixed(&pose.phi)) < 1e-7);
    assert!(distance(pose.omega_body(), rate.omega_body(&pose.phi)) < 1e-7);
    assert!(distance(pose.omega(), pose.phi.adjoint(pose.omega_body())) < 1e-14);
    let again = PhiRate::from_fixed(&pose.phi, pose.omega());
    assert!((again.alpha - pose.rate.alpha).norm_squared().sqrt() < 1e-14);
    assert!((again.beta - pose.rate.beta).norm_squared().sqrt() < 1e-14);
    assert!(Float::abs(pose.udot() - (after.u() - before.u()) * 0.5 / step) < 1e-7);
}

/// Of what has no room beyond 2: an axis turned by the adjoint action is the axis.
#[test]
fn the_adjoint_action_in_fixed_point() {
    let mut error = [0.0_f64; 2];
    for phi in rotations() {
        let (wide, narrow): (Phi<I2F30>, Phi<I2F14>) = (narrowed(phi), narrowed(phi));
        let turned = wide.adjoint([I2F30::ZERO, I2F30::ZERO, I2F30::ONE]).map(f64::from);
        let turned_narrow = narrow.adjoint([I2F14::ZERO, I2F14::ZERO, I2F14::ONE]).map(f64::from);
        for (error, turned) in error.iter_mut().zip([turned, turned_narrow]) {
            *error = error.max(distance(turned, phi.axis()));
        }
    }
    assert!(error[0] < 3e-8 && error[1] < 1e-3, "{error:?}");
}

/// In `f32` a small rotation has all its digits, and a large one as many as its angle.
#[test]
fn the_exponential_of_small_rotations() {
    for exponent in -30..2 {
        let angle = 1.37 * 10_f64.powi(exponent);
        let phi = Phi::<f32>::exp([0.0, angle as f32, 0.0]);
        let half = 0.5 * f64::from(angle as f32);
        let [sine, cosine] = [-f64::from(phi.beta.re), f64::from(phi.alpha.re)];
        assert!((sine / half.sin() - 1.0).abs() < 2e-7, "{angle}: {sine:e}");
        assert!((cosine - half.cos()).abs() < 2e-7, "{angle}: {cosine:e}");
        let double = Phi::<f64>::exp([0.0, angle, 0.0]);
        let half = 0.5 * angle;
        assert!((-double.beta.re / half.sin() - 1.0).abs() < 4e-16, "{angle}: {:e}", double.beta.re);
        assert!((double.alpha.re - half.cos()).abs() < 4e-16, "{angle}");
    }
}

/// One rotation by quaternion, by matrix and by the adjoint action.
#[test]
fn quaternion_and_matrix() {
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        assert_eq!(Phi::from_quaternion(phi.quaternion()), phi);
        let x = vector(i as u32 + 11);
        let turned = phi.adjoint(x);
        worst = worst.max(distance(phi.matrix().map(|row| dot(row, x)), turned));
        // v + 2 w (q × v) + 2 q × (q × v)
        let [w, q @ ..] = phi.quaternion();
        let (once, twice) = (bracket(q, x), bracket(q, bracket(q, x)));
        let by_quaternion = std::array::from_fn(|k| x[k] + 2.0 * (w * once[k] + twice[k]));
        worst = worst.max(distance(by_quaternion, turned));
    }
    tolerance::GROUP.check("quaternion and matrix", worst);
    assert_eq!(Phi::<f64>::default().matrix(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
}
