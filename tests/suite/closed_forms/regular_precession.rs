//! Section 5.2: motions at constant tilt, their stability and the search for one are compared with their equations.

use toytop::{FirstIntegrals, Motion, Regime, Release, Signs, Top};
use toytop_closed_forms::{RegularPrecession, Stability, SteadyPrecession};
use toytop_tests::{DIFFERENT, SAME, apart, by_branch_points, released, released_from_rest, top_of, vectors};

fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 2.0)
}

fn at(e1: f64, e2: f64, e3: f64, signs: Signs) -> Motion {
    by_branch_points(&top(), [e1, e2, e3], signs)
}

/// φ' solves A e φ'² - n φ' + p g = 0 and equals the general formula, and the product of fast and slow φ' is pg/A.
#[test]
fn regular_precessions_solve_their_equation() {
    let top = top();
    let (a, pg) = (top.transverse_inertia(), top.mass_moment() * top.gravity());
    for (e, e3) in [(0.4, 1.3), (-0.7, 5.0), (0.999, 1.0), (0.0, 2.0), (-0.999_999, 1.000_001)] {
        let mut product = 1.0;
        for (signs, regime) in [(SAME, Regime::FastPrecession), (DIFFERENT, Regime::SlowPrecession)] {
            let motion = at(e, e, e3, signs);
            let form = RegularPrecession::new(&motion).unwrap();
            assert!(e3 == 1.0 || form.regime() == regime);
            let [precession, spin] = form.rates().unwrap();
            let FirstIntegrals { l, n, .. } = motion.first_integrals();
            let terms = [a * e * precession * precession, -n * precession, pg];
            let size = terms.iter().fold(0.0, |size, term| size + term.abs());
            assert!(terms.iter().sum::<f64>().abs() < 1e-15 * size);
            let general = (l - n * e) / (a * (1.0 - e * e));
            assert!((precession - general).abs() < 1e-9 * general.abs());
            let axial = spin + e * precession - n / top.axial_inertia();
            assert!(axial.abs() < 1e-15 * spin.abs().max(1.0));
            product *= precession;
            // ω = ψ' r + φ' k at any time
            let attitude = form.at(0.7);
            let [r1, r2, r3] = attitude.orientation.axis();
            let off = apart(attitude.omega(), [spin * r1, spin * r2, spin * r3 + precession]);
            assert!(off < 1e-14 * (spin.abs() + precession.abs()));
        }
        assert!((product * a / pg - 1.0).abs() < 1e-14, "{e} {e3}: {product}");
    }
}

/// The frequency is that of small nutations in the vectors.
#[test]
fn the_frequency_is_that_of_small_nutations() {
    for name in
        ["regular_precession", "regular_precession_fast", "sleeping_stable", "exact_regular_precession_pm"]
    {
        let vector = vectors::named(name);
        let form = RegularPrecession::new(&vector.motion().unwrap()).unwrap();
        let Stability::Stable { frequency } = form.stability() else { panic!("{name}") };
        let period = vector.period().unwrap().period;
        assert!((frequency * period / std::f64::consts::TAU - 1.0).abs() < 1e-14, "{name}");
    }
}

/// Below the border n² = 4Apg a sleeping top falls at its growth rate, which another program has measured for the vector; above the border
/// it is stable.
#[test]
fn the_sleeping_top_falls_at_its_growth_rate() {
    let top = top();
    let (a, c) = (top.transverse_inertia(), top.axial_inertia());
    let border = (4.0 * a * top.mass_moment() * top.gravity()).sqrt() / c;
    let stability = |motion: &Motion| RegularPrecession::new(motion).unwrap().stability();
    for share in [0.0, 0.5, 0.9] {
        let found = stability(&released_from_rest(&top, 0.0, share * border));
        let Stability::Unstable { growth_rate } = found else { panic!("too slow to sleep") };
        let formula = (1.0 - share * share).sqrt() * c * border / (2.0 * a);
        assert!((growth_rate / formula - 1.0).abs() < 1e-14);
    }
    assert!(matches!(stability(&released_from_rest(&top, 0.0, 1.1 * border)), Stability::Stable { .. }));
    let marginal = at(1.0, 1.0, 1.0, SAME);
    assert_eq!(stability(&marginal), Stability::Marginal);
    assert_eq!(RegularPrecession::new(&marginal).unwrap().rates(), None);
    let vector = vectors::named("sleeping_unstable");
    let found = stability(&vector.motion().unwrap());
    let Stability::Unstable { growth_rate } = found else { panic!("unstable") };
    assert!((growth_rate / vector.number("growth_rate") - 1.0).abs() < 1e-13, "{growth_rate}");
}

fn steady(tilt: f64, spin: f64, precession: f64) -> Motion {
    released(&top(), &Release { tilt, spin, precession, ..Release::default() })
}

/// A release with the computed rate keeps its tilt, for every tilt and spin with a steady precession.
#[test]
fn a_steady_precession_is_steady() {
    let mut found = 0;
    for tilt in [1e-3, 0.3, 1.2, std::f64::consts::FRAC_PI_2, 1.8, 3.0] {
        for spin in [-40.0, -4.0, -0.3, 0.0, 0.7, 5.0, 200.0] {
            let rates = match SteadyPrecession::new(&top(), tilt, spin).unwrap() {
                SteadyPrecession::None { least_spin } => {
                    assert!(spin.abs() <= least_spin && tilt <= std::f64::consts::FRAC_PI_2);
                    vec![]
                }
                SteadyPrecession::One { rate } => vec![rate],
                SteadyPrecession::Two { slow, fast } => {
                    assert!(slow.abs() <= fast.abs() * (1.0 + 1e-15));
                    assert_eq!(slow * fast < 0.0, tilt > std::f64::consts::FRAC_PI_2);
                    vec![slow, fast]
                }
            };
            for rate in rates {
                let e = steady(tilt, spin, rate).branch_points();
                // effect of a rounding of the release on the tilt, over the stiffness of the tilt
                let allowed = 1e-13 / (e.e3_minus_e2 / e.e3).min(1.0);
                assert!(e.e2_minus_e1 < allowed, "{tilt} {spin} {rate}: {e:?}");
                found += 1;
            }
        }
    }
    assert_eq!(found, 58);
}

/// Where there is no steady precession, no rate keeps the tilt; at the least spin the two rates are equal.
#[test]
fn below_the_least_spin_no_precession_is_steady() {
    let tilt = 0.5;
    let SteadyPrecession::None { least_spin } = SteadyPrecession::new(&top(), tilt, 1.0).unwrap() else {
        panic!("1 rad/s is too slow")
    };
    for i in -400..=400 {
        let motion = steady(tilt, 0.999 * least_spin, 0.05 * f64::from(i));
        assert!(motion.branch_points().e2_minus_e1 > 1e-4);
    }
    let two = |spin: f64| match SteadyPrecession::new(&top(), tilt, spin).unwrap() {
        SteadyPrecession::Two { slow, fast } => fast / slow - 1.0,
        other => panic!("{other:?}"),
    };
    // the difference of the rates grows like the square root
    let ratio = two(least_spin * (1.0 + 1e-6)) / two(least_spin * (1.0 + 1e-8));
    assert!((ratio - 10.0).abs() < 0.1, "{ratio}");
    let error = |tilt, spin| SteadyPrecession::new(&top(), tilt, spin).unwrap_err().parameter();
    assert_eq!([error(0.0, 1.0), error(std::f64::consts::PI, 1.0), error(f64::NAN, 1.0)], ["tilt"; 3]);
    assert_eq!([error(0.5, 1e12), error(0.5, f64::INFINITY)], ["spin"; 2]);
}
