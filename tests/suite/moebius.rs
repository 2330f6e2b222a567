//! Section 2.2: statements on SL(2, C) and its subgroup of rotations, acting on the Riemann sphere.

use toytop::exact::moebius::Moebius;
use toytop::su2::{dot, sphere_point, stereographic};
use toytop::{Complex, Orientation};
use toytop_tests::{greater, tolerance};

fn number(i: u32) -> Complex<f64> {
    let x = f64::from(i);
    Complex::new(2.0 * (1.3 * x).sin(), 1.5 * (2.1 * x).cos())
}

/// Elements of SL(2, C), almost none of which is a rotation.
fn transformations() -> Vec<Moebius<f64>> {
    let of = |i: u32| {
        let (alpha, beta, gamma) = (number(3 * i + 1), number(3 * i + 2), number(3 * i + 5));
        // δ = (1 + βγ)/α
        let delta = ((Complex::ONE + beta * gamma) * alpha.conj()).scaled(1.0 / alpha.norm_squared());
        Moebius { alpha, beta, gamma, delta }
    };
    (0..60).map(of).filter(|m| m.alpha.norm_squared() > 0.3).collect()
}

fn rotations() -> Vec<Orientation<f64>> {
    let vector = |i: u32| [number(i).re, number(i + 9).im, number(i + 4).re];
    (0..60).map(|i| Orientation::exp(vector(i))).collect()
}

fn size(z: Complex<f64>) -> f64 {
    z.norm_squared().sqrt()
}

/// Equation (2.4): the image is on the unit sphere, the inverse is (ξ + iη)/(1 - ζ), the unit circle is the equator,
/// 0 the south pole and infinity the north pole.
#[test]
fn eqn_inverse_stereo_proj() {
    let mut worst = 0.0_f64;
    for i in 0..200 {
        let z = number(i);
        let point = sphere_point(Some(z));
        worst = greater(worst, (dot(point, point) - 1.0).abs());
        worst = greater(worst, size(stereographic(point).unwrap() - z) / (1.0 + z.norm_squared()));
    }
    tolerance::GROUP.check("stereographic projection", worst);
    assert_eq!(sphere_point(Some(Complex::<f64>::ZERO)), [0.0, 0.0, -1.0]);
    assert_eq!(sphere_point::<f64>(None), [0.0, 0.0, 1.0]);
    assert_eq!(sphere_point(Some(Complex::new(0.6, 0.8))), [0.6, 0.8, 0.0]);
}

/// The projection is conformal: a step in any direction of the plane is scaled by the same factor 2/(|z|² + 1).
#[test]
fn stereographic_projection_is_conformal() {
    let step = 1e-5;
    for i in 0..50 {
        let (z, mut worst) = (number(i), 0.0_f64);
        for direction in 0..7 {
            let (im, re) = (0.9 * f64::from(direction)).sin_cos();
            let half = Complex::new(re, im).scaled(0.5 * step);
            let stretch = chordal_distance(Some(z + half), Some(z - half)) / step;
            worst = greater(worst, (stretch * (z.norm_squared() + 1.0) / 2.0 - 1.0).abs());
        }
        assert!(worst < 1e-9 && worst > 1e-14, "{worst:e}");
    }
}

/// Equation (2.5): the map of a product is the composition of the maps, and the derivative, a complex number, is
/// 1/(γz + δ)².
#[test]
fn eqn_moeb_is_a_homomorphism_and_conformal() {
    let (mut homomorphism, mut derivative) = (0.0_f64, 0.0_f64);
    let all = transformations();
    for (i, (first, second)) in all.iter().zip(all.iter().skip(1)).enumerate() {
        assert!(size(first.determinant() - Complex::ONE) < 1e-14);
        for z in [Some(number(i as u32 + 70)), Some(Complex::ZERO), None] {
            let (product, successive) = (first.compose(second).at(z), first.at(second.at(z)));
            // scale factors of the two maps, by which the rounding between them grows
            let norm = |m: &Moebius<f64>| {
                [m.alpha, m.beta, m.gamma, m.delta].iter().map(|z| z.norm_squared()).sum::<f64>()
            };
            let scale = (norm(first) * norm(second)).sqrt();
            homomorphism = greater(homomorphism, chordal_distance(product, successive) / scale);
        }
        let (z, step) = (number(i as u32 + 40), 1e-5);
        let slope = |direction: Complex<f64>| {
            let h = direction.scaled(step);
            let (after, before) = (first.at(Some(z + h)).unwrap(), first.at(Some(z - h)).unwrap());
            ((after - before) * direction.conj()).scaled(0.5 / step)
        };
        let exact = first.derivative(z).unwrap();
        for direction in [Complex::ONE, Complex::ONE.times_i()] {
            // the third derivative over the first is 6 (γ/(γz + δ))²
            let scale = 1.0 + size(exact) * first.gamma.norm_squared();
            derivative = greater(derivative, size(slope(direction) - exact) / size(exact) / scale);
        }
    }
    tolerance::GROUP.check("homomorphism", homomorphism);
    assert!(derivative < 1e-8 && derivative > 1e-12, "{derivative:e}");
}

/// The kernel is {1, -1}: Φ and -Φ give the same map; a map that fixes three points is the identity, so its matrix is
/// ±1.
#[test]
fn the_kernel_is_plus_and_minus_one() {
    for phi in rotations() {
        let negative = Orientation { alpha: -phi.alpha, beta: -phi.beta };
        for z in [Some(number(5)), Some(Complex::ZERO), None] {
            assert_eq!(phi.moebius(z), negative.moebius(z));
        }
        // 0 ↦ 0 and ∞ ↦ ∞ make β = γ = 0; then 1 ↦ α/δ = α², which is 1 for α = ±1 only
        let moved = [None, Some(Complex::ZERO), Some(Complex::ONE)]
            .map(|z| chordal_distance(phi.moebius(z), z))
            .into_iter()
            .fold(0.0, greater);
        let from_identity = (phi.alpha.re.abs() - 1.0).abs();
        assert!(moved > from_identity, "{moved} {from_identity}");
    }
    for sign in [1.0, -1.0] {
        let identity = Orientation { alpha: Complex::new(sign, 0.0), beta: Complex::ZERO };
        assert_eq!(identity.moebius(Some(number(8))), Some(number(8)));
        assert_eq!(identity.moebius(None), None);
    }
}

/// Euclidean distance of the points of the unit sphere over z and w, in [0, 2].
fn chordal_distance(z: Option<Complex<f64>>, w: Option<Complex<f64>>) -> f64 {
    let ([x1, x2, x3], [y1, y2, y3]) = (sphere_point(z), sphere_point(w));
    let chord = [x1 - y1, x2 - y2, x3 - y3];
    dot(chord, chord).sqrt()
}

/// Distance √(|δ - ᾱ|² + |γ + β̄|²) from a rotation.
fn distance_from_rotation(m: &Moebius<f64>) -> f64 {
    ((m.delta - m.alpha.conj()).norm_squared() + (m.gamma + m.beta.conj()).norm_squared()).sqrt()
}

/// The rotations are the Möbius transformations with δ = ᾱ, γ = -β̄: these preserve all distances on the sphere,
/// others do not.
#[test]
fn rotations_are_su2() {
    let points: Vec<_> = (100..112).map(|i| Some(number(i))).chain([None]).collect();
    let distortion = |m: &Moebius<f64>| {
        let mut worst = 0.0_f64;
        for &z in &points {
            for &w in &points {
                worst = greater(worst, (chordal_distance(m.at(z), m.at(w)) - chordal_distance(z, w)).abs());
            }
        }
        worst
    };
    let mut worst = 0.0_f64;
    for phi in rotations() {
        let moebius = Moebius::from(phi);
        assert_eq!(distance_from_rotation(&moebius), 0.0);
        worst = greater(worst, distortion(&moebius));
        assert_eq!(moebius.at(Some(number(3))), phi.moebius(Some(number(3))));
    }
    tolerance::GROUP.check("isometry", worst);
    for moebius in transformations() {
        let off = distance_from_rotation(&moebius);
        assert!(distortion(&moebius) > 0.02 * off.min(1.0), "{off} {}", distortion(&moebius));
    }
}
