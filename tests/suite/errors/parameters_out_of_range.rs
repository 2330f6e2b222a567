//! Values out of range are refused by the name of the parameter, and values just inside are accepted.

use toytop::{
    BranchPoints, Complex, InitialAngles, Motion, Orientation, ParameterError, PointImpulse, Release,
    SetUpError, Signs, SizedTable, State, TableSettings, Tick, Top, TopParameters,
};
use toytop_tests::{kilohertz, top_of, toy, vectors};

fn parameter<T>(result: Result<T, ParameterError>) -> Option<&'static str> {
    result.err().map(|error| error.parameter())
}

fn top() -> Top {
    top_of([1.0, 1.0, 1.0, 1.0], 1.0)
}

/// Branch points determine neither the rate of a body without torque nor the axial rate of a rod.
#[test]
fn branch_points_that_do_not_determine_the_motion_are_refused() {
    let body = TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 0.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    };
    let motion = |top: Top, e| {
        parameter(Motion::from_branch_points(&top, e, Signs::default(), &InitialAngles::default()))
    };
    let (rod, free) = (Top::fixed(&body).unwrap(), Top::free(&body).unwrap());
    assert_eq!(motion(rod, [-0.5, 0.5, 2.0]), Some("e3"));
    assert_eq!(motion(rod, [-1.0, 0.5, 1.0]), None);
    assert_eq!(motion(rod, [-1.0, 1.0, 1.5]), None);
    assert_eq!(motion(free, [-0.5, 0.5, 2.0]), Some("top"));
    let thin = Top::fixed(&TopParameters { axial_inertia: 1e-50, ..body }).unwrap();
    assert_eq!(motion(thin, [-0.5, 0.5, 2.0]), Some("e3"));
}

#[test]
fn states_out_of_range_are_refused() {
    let (nan, infinity) = (f64::NAN, f64::INFINITY);
    for ([alpha, beta, omega], refused) in [
        ([0.6, 0.8, 0.0], None),
        ([0.6, 0.8000006, 0.0], None),
        ([0.6, 0.8000007, 0.0], Some("alpha")),
        ([0.0, 0.0, 0.0], Some("alpha")),
        ([nan, 0.8, 0.0], Some("alpha")),
        ([0.6, infinity, 0.0], Some("beta")),
        ([0.6, 0.8, nan], Some("omega")),
        ([0.6, 0.8, 1e13], Some("omega")),
    ] {
        let phi = Orientation { alpha: Complex::new(alpha, 0.0), beta: Complex::new(0.0, beta) };
        assert_eq!(parameter(State::new(phi, [0.0, omega, 0.0])), refused, "{alpha} {beta} {omega}");
    }
}

#[test]
fn impulses_out_of_range_are_refused() {
    let state = State::from_release(&Release { tilt: 0.3, spin: 10.0, ..Release::default() }).unwrap();
    let (impulse, point) = ([1e-3, 2e-3, -1e-3], [0.01, 0.0, 0.02]);
    for (impulse, point, refused) in [
        (impulse, point, [None; 2]),
        ([0.0, f64::NAN, 0.0], point, [Some("impulse"); 2]),
        ([0.0, 0.0, 2e12], point, [Some("impulse"); 2]),
        (impulse, [f64::INFINITY, 0.0, 0.0], [Some("point"); 2]),
        (impulse, [0.0, -2e12, 0.0], [Some("point"); 2]),
        // more than 1e12 rad/s, from numbers in range
        ([1e10, 0.0, 0.0], [0.0, 1.0, 0.0], [Some("impulse"), None]),
    ] {
        let after = parameter(state.with_impulse(&toy(), &PointImpulse { impulse, point }));
        let reaction = parameter(state.reaction_impulse(&toy(), &PointImpulse { impulse, point }));
        assert_eq!([after, reaction], refused, "{impulse:?} {point:?}");
    }
}

#[test]
fn quaternions_and_gyroscopes_out_of_range_are_refused() {
    for (quaternion, gyro, refused) in [
        ([0.6, 0.0, 0.8000006, 0.0], [0.0, 0.0, 1e12], None),
        ([0.6, 0.0, 0.8000007, 0.0], [0.0; 3], Some("quaternion")),
        ([0.0; 4], [0.0; 3], Some("quaternion")),
        ([f64::NAN, 0.0, 0.8, 0.0], [0.0; 3], Some("quaternion")),
        ([1e200, 0.0, 0.0, 0.0], [0.0; 3], Some("quaternion")),
        ([1.0, 0.0, 0.0, 0.0], [0.0, f64::INFINITY, 0.0], Some("gyro")),
        ([1.0, 0.0, 0.0, 0.0], [8e11, 0.0, 8e11], Some("gyro")),
        ([1.0, 0.0, 0.0, 0.0], [1e300, 0.0, 0.0], Some("gyro")),
    ] {
        let state = State::from_quaternion_and_gyro(quaternion, gyro);
        assert_eq!(parameter(state), refused, "{quaternion:?} {gyro:?}");
    }
}

#[test]
fn releases_out_of_range_are_refused() {
    let good = Release { tilt: 0.3, spin: 10.0, ..Release::default() };
    for (release, refused) in [
        (good, None),
        (Release { tilt: -1e-9, ..good }, Some("tilt")),
        (Release { tilt: 3.15, ..good }, Some("tilt")),
        (Release { azimuth: f64::NAN, ..good }, Some("azimuth")),
        (Release { roll: f64::NEG_INFINITY, ..good }, Some("roll")),
        (Release { spin: 1e12, ..good }, Some("spin")),
        (Release { precession: f64::NAN, ..good }, Some("precession")),
        (Release { nutation: 1e300, ..good }, Some("nutation")),
    ] {
        assert_eq!(parameter(State::from_release(&release)), refused, "{release:?}");
    }
}

#[test]
fn branch_points_out_of_range_are_refused() {
    let start = InitialAngles::default();
    for ([e1, e2, e3], refused) in [
        ([-1.0, 1.0, 1.0], None),
        ([-1.0000001, 0.5, 2.0], Some("e1")),
        ([0.6, 0.5, 2.0], Some("e2")),
        ([0.6, 1.1, 2.0], Some("e2")),
        ([0.6, 0.9, 0.99], Some("e3")),
        ([0.6, 0.9, 1e15], Some("e3")),
        ([f64::NAN, 0.9, 2.0], Some("e1")),
    ] {
        let motion = Motion::from_branch_points(&top(), [e1, e2, e3], Signs::default(), &start);
        assert_eq!(parameter(motion), refused, "{e1} {e2} {e3}");
    }
    for (start, refused) in [
        (InitialAngles { theta: f64::NAN, ..start }, "theta"),
        (InitialAngles { arg_alpha: 1e7, ..start }, "arg_alpha"),
        (InitialAngles { arg_beta: f64::INFINITY, ..start }, "arg_beta"),
    ] {
        let motion = Motion::from_branch_points(&top(), [0.7, 0.9, 2.0], Signs::default(), &start);
        assert_eq!(parameter(motion), Some(refused));
    }
}

#[test]
fn motions_too_fast_and_energies_too_low_are_refused() {
    let spinning = |spin| State::from_release(&Release { tilt: 0.3, spin, ..Release::default() }).unwrap();
    assert_eq!(parameter(Motion::launch(&top(), &spinning(1e7))), None);
    // at so high a rate the torque has no effect: the refusal names the constructor to use
    let refusal = Motion::launch(&top(), &spinning(1e8)).unwrap_err();
    assert!(refusal.parameter() == "omega" && refusal.allowed().contains("free"), "{refusal}");
    let body = TopParameters { transverse_inertia: 1.0, axial_inertia: 1.0, ..TopParameters::default() };
    assert!(Motion::launch(&Top::free(&body).unwrap(), &spinning(1e8)).is_ok());
    for ([l, n, h], refused) in [
        ([2.0, 2.0, 1.0], Some("h")),
        // enough energy for some heights, but not for this l at any height
        ([1.5, 0.0, 0.5], Some("h")),
        ([1.0, 0.0, 0.5], None),
        // a top at rest: only hanging is possible
        ([0.0, 0.0, -1.0], None),
        ([0.0, 0.0, -1.0 - 1e-6], Some("h")),
        ([f64::NAN, 2.0, 1.0], Some("l")),
    ] {
        assert_eq!(parameter(BranchPoints::from_integrals(&top(), l, n, h)), refused, "{l} {n} {h}");
    }
}

#[test]
fn ticks_without_a_length_are_refused() {
    assert_eq!([Tick::hertz(0), Tick::ratio(0, 1), Tick::ratio(1, 0)].map(parameter), [Some("tick"); 3]);
    assert_eq!(parameter(Tick::ratio(u32::MAX, 1)), None);
}

#[test]
fn a_tick_of_too_many_turns_is_refused() {
    let motion = vectors::motion("si_toytop_150");
    let table = |seconds| SizedTable::<f64, 48>::new(&motion, Tick::ratio(1, seconds).unwrap());
    let Err(SetUpError::Parameter(error)) = table(u32::MAX) else { panic!("a tick of 136 years") };
    assert_eq!(error.to_string(), "tick: must be shorter than 2^31 turns of each phase");
    assert!(table(86_400).is_ok());
}

#[test]
fn a_truncation_error_is_finite_and_positive() {
    let motion = vectors::motion("exact_generic_pp");
    let tick = kilohertz();
    for truncation in [f64::INFINITY, f64::NAN, 0.0, -0.0, -1e-9, f64::NEG_INFINITY] {
        let refused = SizedTable::<f64, 48>::new(
            &motion,
            TableSettings { truncation: Some(truncation), ..tick.into() },
        );
        let Err(SetUpError::Parameter(error)) = refused else { panic!("{truncation}") };
        assert_eq!(error.to_string(), "truncation: must be positive and finite", "{truncation}");
    }
    for truncation in [f64::MAX, 1e-15] {
        let bound = SizedTable::<f64, 48>::new(
            &motion,
            TableSettings { truncation: Some(truncation), ..tick.into() },
        )
        .unwrap()
        .error_bound();
        assert!(bound.after(1.0).is_finite(), "{truncation:e}: {bound:?}");
    }
}
