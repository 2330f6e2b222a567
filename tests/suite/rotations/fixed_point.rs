//! Fixed point: sines, products, and the adjoint action.

use super::group::{distance, rotations};
use toytop::fixed::traits::Fixed;
use toytop::fixed::types::{I2F14, I2F30};
use toytop::scalar::{Ring, Scalar};
use toytop::{Complex, Orientation, Phase};
use toytop_tests::{check_all, greater, keep, tolerance};

/// Sine and cosine of a phase: errors within three units of the last place in 32 bits, and the nearest numbers in 16 bits.
#[test]
fn sines_and_cosines_have_the_digits_of_their_type() {
    let mut worst = [0.0_f64; 2];
    for i in 0..4096 {
        let phase = Phase::from_turns(f64::from(i) * 0.618_033_988_75);
        let (sine, cosine) = f64::sine_cosine(phase);
        let ((s, c), (short_s, short_c)) = (I2F30::sine_cosine(phase), I2F14::sine_cosine(phase));
        let off = |a: f64, b: f64| greater((a - sine).abs(), (b - cosine).abs());
        let [long, short] = [off(s.into(), c.into()), off(short_s.into(), short_c.into())];
        keep(&mut worst, [long * (1_u64 << 30) as f64, short * (1_u64 << 14) as f64]);
    }
    assert!((0.4..3.0).contains(&worst[0]) && (0.4..0.51).contains(&worst[1]), "{worst:?} units");
}

/// Products of both types are rounded down.
#[test]
fn products_are_rounded_down() {
    fn of<F: Fixed + Ring + PartialEq + std::fmt::Debug>() {
        let [a, b, c, half] = [0.75, -0.25, 0.25, 0.5].map(F::from_num::<f64>);
        assert_eq!(a.product(-half), F::from_num(-0.375));
        assert_eq!(F::DELTA.product(a), <F as Ring>::ZERO);
        assert_eq!(F::inner([a, b], [half, half]), c);
        assert_eq!(F::determinant([half, c], [a, half]), F::from_num(0.0625));
        assert_eq!(F::determinant([a, b], [half, half]), half);
    }
    of::<I2F14>();
    of::<I2F30>();
}

fn narrowed<F: Fixed>(phi: Orientation<f64>) -> Orientation<F> {
    let narrow = |z: Complex<f64>| Complex::new(F::from_num(z.re), F::from_num(z.im));
    Orientation { alpha: narrow(phi.alpha), beta: narrow(phi.beta) }
}

/// In a number type with the range ±2, the adjoint action of the third unit vector is the axis.
#[test]
fn the_adjoint_action_in_fixed_point() {
    let mut errors = [0.0_f64; 2];
    for phi in rotations() {
        let (wide, narrow): (Orientation<I2F30>, Orientation<I2F14>) = (narrowed(phi), narrowed(phi));
        let turned = wide.adjoint([I2F30::ZERO, I2F30::ZERO, I2F30::ONE]).map(f64::from);
        let turned_narrow = narrow.adjoint([I2F14::ZERO, I2F14::ZERO, I2F14::ONE]).map(f64::from);
        keep(&mut errors, [turned, turned_narrow].map(|turned| distance(turned, phi.axis())));
    }
    check_all(["I2F30", "I2F14"], errors, tolerance::FIXED_POINT_ADJOINT);
}
