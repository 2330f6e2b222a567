//! Section 5.2: motions at constant tilt, their stability, and how to find one.

use toytop::{Complex, Motion, Orientation, Regime, Release, Sign, Signs, State, Stepper, Top};
use toytop_closed_forms::{RegularPrecession, Stability, SteadyPrecession};
use toytop_tests::{by_branch_points, top_of, vectors};

fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 2.0)
}

fn at(e1: f64, e2: f64, e3: f64, l_minus_n: Sign) -> Motion {
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n };
    by_branch_points(&top(), [e1, e2, e3], signs)
}

/// φ' solves A e φ'² - n φ' + p g = 0 and equals the general formula, and the product of fast and slow φ' is pg/A.
#[test]
fn both_kinds_of_regular_precession() {
    let top = top();
    for (e, e3) in [(0.4, 1.3), (-0.7, 5.0), (0.999, 1.0), (0.0, 2.0), (-0.999_999, 1.000_001)] {
        let mut product = 1.0;
        for (sign, regime) in [(Sign::Plus, Regime::FastPrecession), (Sign::Minus, Regime::SlowPrecession)] {
            let motion = at(e, e, e3, sign);
            let form = RegularPrecession::new(&motion).unwrap();
            assert!(e3 == 1.0 || form.regime() == regime);
            let [precession, spin] = form.rates().unwrap();
            let integrals = motion.first_integrals();
            let terms = [
                top.transverse_inertia() * e * precession * precession,
                -integrals.n * precession,
                top.mass_moment() * top.gravity(),
            ];
            let size = terms.iter().fold(0.0, |size, term| size + term.abs());
            assert!(terms.iter().sum::<f64>().abs() < 1e-15 * size);
            let general = (integrals.l - integrals.n * e) / (top.transverse_inertia() * (1.0 - e * e));
            assert!((precession - general).abs() < 1e-9 * general.abs());
            assert!(
                (spin + e * precession - integrals.n / top.axial_inertia()).abs()
                    < 1e-15 * spin.abs().max(1.0)
            );
            product *= precession;
            // ω = ψ' r + φ' k at any time
            let attitude = form.at(0.7);
            let [r1, r2, r3] = attitude.orientation.axis();
            let expected = [spin * r1, spin * r2, spin * r3 + precession];
            for (ours, expected) in attitude.omega().iter().zip(expected) {
                assert!((ours - expected).abs() < 1e-14 * (spin.abs() + precession.abs()));
            }
        }
        assert!(
            (product * top.transverse_inertia() / (top.mass_moment() * top.gravity()) - 1.0).abs() < 1e-14,
            "{e} {e3}: {product}"
        );
    }
}

/// The frequency is that of the nutation after a small push: the difference is of second order in the push.
#[test]
fn small_nutations() {
    for (e, e3) in [(0.4, 1.3), (-0.7, 5.0), (0.9, 1.05)] {
        let form = RegularPrecession::new(&at(e, e, e3, Sign::Minus)).unwrap();
        let Stability::Stable { frequency } = form.stability() else { panic!("e1 = e2 is stable") };
        let off = |push: f64| {
            let period = at(e - push, e + push, e3, Sign::Minus).period_advance().unwrap().period;
            frequency * period / std::f64::consts::TAU - 1.0
        };
        let (coarse, fine) = (off(1e-3), off(1e-4));
        assert!((coarse / fine - 100.0).abs() < 5.0, "{coarse:e} {fine:e}");
        assert!(fine.abs() < 1e-5);
    }
    // the vectors contain the period of small nutations
    for name in ["regular_precession", "regular_precession_fast", "sleeping_stable"] {
        let vector = vectors::named(name);
        let form = RegularPrecession::new(&vector.motion().unwrap()).unwrap();
        let Stability::Stable { frequency } = form.stability() else { panic!("{name}") };
        let period = vector.period().unwrap().period;
        assert!((frequency * period / std::f64::consts::TAU - 1.0).abs() < 1e-14, "{name}");
    }
}

fn upright(spin: f64, push: f64) -> Motion {
    Motion::launch(&top(), &State::new(Orientation::IDENTITY, [push, 0.0, spin]).unwrap()).unwrap()
}

/// Sleeping top after a push: below the border it falls at the growth rate, above the border it stays near the
/// vertical.
#[test]
fn the_sleeping_top_falls_at_its_growth_rate() {
    let top = top();
    let border =
        (4.0 * top.transverse_inertia() * top.mass_moment() * top.gravity()).sqrt() / top.axial_inertia();
    for share in [0.0, 0.5, 0.9] {
        let n = top.axial_inertia() * share * border;
        let form = RegularPrecession::new(&upright(share * border, 0.0)).unwrap();
        let Stability::Unstable { growth_rate } = form.stability() else { panic!("too slow to sleep") };
        let formula = (4.0 * top.transverse_inertia() * top.mass_moment() * top.gravity() - n * n).sqrt()
            / (2.0 * top.transverse_inertia());
        assert!((growth_rate / formula - 1.0).abs() < 1e-14);
        // between two times at which the tilt is far above its initial value and still small
        let pushed = upright(share * border, 1e-9);
        let mut stepper = Stepper::<f64>::new(&pushed);
        let mut sizes = [0.0; 2];
        for size in &mut sizes {
            (0..4096).for_each(|_| stepper.step(6.0 / growth_rate / 4096.0));
            *size = stepper.orientation().beta.norm_squared().sqrt();
        }
        assert!(((sizes[1] / sizes[0]).ln() / 6.0 - 1.0).abs() < 1e-4, "{share}: {sizes:?}");
    }
    let form = RegularPrecession::new(&upright(1.1 * border, 0.0)).unwrap();
    assert!(matches!(form.stability(), Stability::Stable { .. }));
    let form = RegularPrecession::new(&at(1.0, 1.0, 1.0, Sign::Plus)).unwrap();
    assert_eq!(form.stability(), Stability::Marginal);
    assert_eq!(form.rates(), None);
    // growth rate of the vector, measured there by another program
    let vector = vectors::named("sleeping_unstable");
    let form = RegularPrecession::new(&vector.motion().unwrap()).unwrap();
    let Stability::Unstable { growth_rate } = form.stability() else { panic!("unstable") };
    if let Some(truth) = vector.number("growth_rate") {
        assert!((growth_rate / truth - 1.0).abs() < 1e-13, "{growth_rate} {truth}");
    }
}

fn released(tilt: f64, spin: f64, precession: f64) -> Motion {
    let release = Release { tilt, spin, precession, ..Release::default() };
    Motion::launch(&top(), &State::release(&release).unwrap()).unwrap()
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
                let e = released(tilt, spin, rate).branch_points();
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
fn below_the_least_spin_there_is_none() {
    let tilt = 0.5;
    let SteadyPrecession::None { least_spin } = SteadyPrecession::new(&top(), tilt, 1.0).unwrap() else {
        panic!("1 rad/s is too slow")
    };
    for i in -400..=400 {
        let motion = released(tilt, 0.999 * least_spin, 0.05 * f64::from(i));
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

/// A state that is a regular precession up to rounding has the closed form.
#[test]
fn a_rounded_state_has_the_form_too() {
    let SteadyPrecession::Two { slow, .. } = SteadyPrecession::new(&top(), 0.4, 9.0).unwrap() else {
        panic!()
    };
    let motion = released(0.4, 9.0, slow);
    assert_eq!(motion.regime(), Regime::SlowPrecession);
    let form = RegularPrecession::new(&motion).unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    for second in 1..20 {
        (0..1024).for_each(|_| stepper.step(1.0 / 1024.0));
        let apart = stepper.orientation().alpha - form.at(f64::from(second)).orientation.alpha;
        let beta = stepper.orientation().beta - form.at(f64::from(second)).orientation.beta;
        assert!(apart.norm_squared().sqrt() + beta.norm_squared().sqrt() < 1e-13);
    }
    assert!(form.at(1e9).orientation.alpha != Complex::ZERO);
}
