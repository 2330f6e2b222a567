//! Section 5.4: the Lagrange top, exactly and as the limit of toy tops.

use toytop::{Ephemeris, InitialPhases, Motion, Sign, Signs};
use toytop_closed_forms::elliptic::Jacobi;
use toytop_closed_forms::{E3EqualsE4, Lagrange};
use toytop_tests::{kilohertz, top_of};

const A_OVER_P: f64 = 1.1 / 0.9;
const SIGNS: [Signs; 2] = [
    Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus },
    Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus },
];
const START: InitialPhases = InitialPhases { theta: 0.8, arg_alpha: 0.3, arg_beta: -1.1 };

fn lagrange(e: [f64; 3], signs: Signs) -> Motion {
    let top = top_of([1.1, 0.7, 0.0, 0.9], 1.0);
    Motion::from_branch_points(&top, e, signs, &START).unwrap()
}

/// Toy top with this e₄ and the same A, C, p: s = A/(p (e₄² - 1)).
fn toy(e: [f64; 3], signs: Signs, e4: f64) -> Motion {
    let s = A_OVER_P / (e4 * e4 - 1.0);
    let top = top_of([1.1, 0.7, s, 0.9], 1.0);
    Motion::from_branch_points(&top, e, signs, &START).unwrap()
}

/// u = e₁ + (e₂ - e₁) sn²(√(pg (e₃ - e₁)/2A) t + const.), with Jacobi's functions.
#[test]
fn the_height_is_jacobis_sine() {
    let e @ [e1, e2, e3] = [-0.4, 0.5, 1.8];
    let motion = lagrange(e, SIGNS[1]);
    let form = Lagrange::new(&motion).unwrap();
    let jacobi = Jacobi::new((e2 - e1) / (e3 - e1), (e3 - e2) / (e3 - e1)).unwrap();
    let pace = (0.5 / A_OVER_P * (e3 - e1)).sqrt();
    assert!((form.period() * pace / (2.0 * jacobi.quarter_period()) - 1.0).abs() < 1e-15);
    // time since u = e₁, from the phase
    let origin = form.nutation_phase(0.0).to_f64() * form.period();
    for t in [-7.0, -0.3, 0.0, 1.1, 4.0, 29.0] {
        let sn = jacobi.at(pace * (t + origin)).sn;
        assert!((form.at(t).u() - (e1 + (e2 - e1) * sn * sn)).abs() < 1e-14, "{t}");
    }
}

/// Klein's integrals for A = C: α'/α = (u' + i (l + n)/A)/(2 (u + 1)), β'/β = (u' - i (l - n)/A)/(2 (u - 1)).
#[test]
fn the_logarithmic_integrals() {
    let top = top_of([1.1, 1.1, 0.0, 0.9], 1.0);
    for signs in SIGNS {
        let motion = Motion::from_branch_points(&top, [-0.4, 0.5, 1.8], signs, &START).unwrap();
        let form = Lagrange::new(&motion).unwrap();
        let integrals = motion.first_integrals();
        let h = 1e-5;
        for t in [-3.0, 0.0, 0.4, 2.2] {
            let [before, attitude, after] = [-h, 0.0, h].map(|step| form.at(t + step));
            let (u, udot) = (attitude.u(), attitude.udot());
            // z'/z = z' z̄/|z|², with z' from central differences
            let difference = (after.orientation.alpha - before.orientation.alpha).scaled(0.5 / h)
                * attitude.orientation.alpha.conj();
            let alpha = difference.scaled(1.0 / attitude.orientation.alpha.norm_squared());
            let expected = [udot, integrals.l_plus_n / 1.1].map(|part| part / (2.0 * (1.0 + u)));
            assert!((alpha.re - expected[0]).abs() < 1e-8 && (alpha.im - expected[1]).abs() < 1e-8);
            let difference = (after.orientation.beta - before.orientation.beta).scaled(0.5 / h)
                * attitude.orientation.beta.conj();
            let beta = difference.scaled(1.0 / attitude.orientation.beta.norm_squared());
            let expected = [-udot, integrals.l_minus_n / 1.1].map(|part| part / (2.0 * (1.0 - u)));
            assert!((beta.re - expected[0]).abs() < 1e-8 && (beta.im - expected[1]).abs() < 1e-8);
        }
    }
}

/// Period and orientation of toy tops converge to those of the Lagrange top at the rate e₄⁻²: the difference times
/// e₄² is constant up to a relative term of order e₄⁻².
#[test]
fn toy_tops_tend_to_it_like_the_inverse_square_of_e4() {
    let e = [-0.4, 0.5, 1.8];
    for signs in SIGNS {
        let exact = Lagrange::new(&lagrange(e, signs)).unwrap();
        let at = 5.3;
        let scaled = [1e2, 1e3, 1e4].map(|e4| {
            let motion = toy(e, signs, e4);
            let period = motion.period_advance().unwrap().period;
            let table = Ephemeris::<f64, 64>::new(&motion, kilohertz()).unwrap();
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

/// For e₃ = e₄ → ∞ both closed forms apply: the fast top, whose nutation becomes faster and smaller.
#[test]
fn the_closed_forms_meet_where_e3_equals_e4_is_large() {
    let scaled = [16.0, 64.0, 256.0].map(|e4: f64| {
        let e = [0.3, 0.31, e4];
        let (slides, held) = (toy(e, SIGNS[1], e4), lagrange(e, SIGNS[1]));
        let (slides, held) = (E3EqualsE4::new(&slides).unwrap(), Lagrange::new(&held).unwrap());
        (slides.period() / held.period() - 1.0) * e4 * e4
    });
    assert!((scaled[0] / scaled[2] - 1.0).abs() < 1e-2, "{scaled:?}");
    assert!((scaled[1] / scaled[2] - 1.0).abs() < 1e-3 && scaled[2].abs() > 1e-2, "{scaled:?}");
}
