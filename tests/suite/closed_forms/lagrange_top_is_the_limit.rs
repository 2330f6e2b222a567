//! Section 5.4: toy tops with ever larger e₄ are compared with the Lagrange top, their limit.

use toytop::{InitialAngles, Motion, Signs, SizedTable};
use toytop_closed_forms::EllipticNutation;
use toytop_tests::{DIFFERENT, SAME, kilohertz, top_of};

const A_OVER_P: f64 = 1.1 / 0.9;
const E: [f64; 3] = [-0.4, 0.5, 1.8];

/// Motion of a top with the height s of its centre of mass; s = 0 is the Lagrange top.
fn motion(s: f64, signs: Signs) -> Motion {
    let start = InitialAngles { theta: 0.8, arg_alpha: 0.3, arg_beta: -1.1 };
    Motion::from_branch_points(&top_of([1.1, 0.7, s, 0.9], 1.0), E, signs, &start).unwrap()
}

/// Period and orientation of toy tops converge to those of the Lagrange top at the rate e₄⁻²: the difference times
/// e₄² is constant up to a relative term of order e₄⁻².
#[test]
fn toy_tops_tend_to_it_like_the_inverse_square_of_e4() {
    for signs in [SAME, DIFFERENT] {
        let exact = EllipticNutation::new(&motion(0.0, signs)).unwrap();
        let at = 5.3;
        let scaled = [1e2, 1e3, 1e4].map(|e4| {
            // e₄² = 1 + A/(ps)
            let motion = motion(A_OVER_P / (e4 * e4 - 1.0), signs);
            let period = motion.period_advance().unwrap().period;
            let table = SizedTable::<f64, 64>::new(&motion, kilohertz()).unwrap();
            let apart = table.at(at).orientation().distance(&exact.at(at).orientation);
            [(period - exact.period()) * e4 * e4, apart * e4 * e4]
        });
        for (coarse, (middle, fine)) in scaled[0].into_iter().zip(scaled[1].into_iter().zip(scaled[2])) {
            assert!(fine > 0.1 && fine < 10.0, "a constant, not 0: {fine}");
            // the tolerance contains 1e-4 from the next order at e₄ = 100, and the rounding of a difference of 1e-8
            // at e₄ = 10⁴
            assert!((coarse / fine - 1.0).abs() < 3e-4, "{coarse} {fine}");
            assert!((middle / fine - 1.0).abs() < 1e-5, "{middle} {fine}");
            assert!(coarse != middle);
        }
    }
}
