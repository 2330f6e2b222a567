//! Refusals, by the name of the parameter. Values just inside the allowed range are accepted.

use toytop::{
    BranchPoints, Complex, Ephemeris, Motion, Orientation, ParameterError, Release, Sign, Signs, Start,
    State, TableTooSmall, Tick, Top, TopParameters,
};
use toytop_tests::vectors;

fn parameter<T>(result: Result<T, ParameterError>) -> Option<&'static str> {
    result.err().map(|error| error.parameter())
}

fn top() -> Top {
    Top::sliding(&TopParameters {
        transverse_inertia: 1.0,
        axial_inertia: 1.0,
        com_height: 1.0,
        mass_moment: 1.0,
        gravity: 1.0,
        ..TopParameters::default()
    })
    .unwrap()
}

#[test]
fn tops() {
    let top = |a, c, s, p, g| {
        parameter(Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: c,
            com_height: s,
            mass_moment: p,
            gravity: g,
            ..TopParameters::default()
        }))
    };
    assert_eq!(top(1.0, 2.0, 1.0, 1.0, 1.0), None);
    assert_eq!(top(1.0, 2.0000001, 1.0, 1.0, 1.0), Some("axial_inertia"));
    assert_eq!(top(-1.0, 1.0, 1.0, 1.0, 1.0), Some("transverse_inertia"));
    assert_eq!(top(1.0, -1e-9, 1.0, 1.0, 1.0), Some("axial_inertia"));
    assert_eq!(top(1.0, 0.0, 1.0, 1.0, 1.0), None);
    assert_eq!(top(1.0, 1.0, 1.0, 1.0, 0.0), Some("gravity"));
    assert_eq!(top(1.0, 1.0, f64::NAN, 1.0, 1.0), Some("com_height"));
    assert_eq!(top(1.0, 1.0, 1.0, f64::INFINITY, 1.0), Some("mass_moment"));
    assert_eq!(top(1.0, 1.0, 1.0, 1.0, -9.81), Some("gravity"));
    assert_eq!(top(1e-7, 1e-7, 1.0, 1.0, 1.0), Some("transverse_inertia"));
    assert_eq!(top(1.1e-6, 1e-6, 1.0, 1.0, 1.0), None);
}

/// Branch points determine neither the rate of a body without torque nor the axial rate of a rod.
#[test]
fn branch_points_that_do_not_determine_the_motion() {
    let body =
        TopParameters { transverse_inertia: 1.0, mass_moment: 1.0, gravity: 1.0, ..TopParameters::default() };
    let motion =
        |top: Top, e| parameter(Motion::from_branch_points(&top, e, Signs::default(), &Start::default()));
    let (rod, free) = (Top::fixed(&body).unwrap(), Top::free(&body).unwrap());
    assert_eq!(motion(rod, [-0.5, 0.5, 2.0]), Some("e3"));
    assert_eq!(motion(rod, [-1.0, 0.5, 1.0]), None);
    assert_eq!(motion(rod, [-1.0, 1.0, 1.5]), None);
    assert_eq!(motion(free, [-0.5, 0.5, 2.0]), Some("e3"));
    let thin = Top::fixed(&TopParameters { axial_inertia: 1e-50, ..body }).unwrap();
    assert_eq!(motion(thin, [-0.5, 0.5, 2.0]), Some("e3"));
    // at so high a rate the torque has no effect: the refusal names the constructor to use
    let state = State::release(&Release { tilt: 0.5, spin: 1e8, ..Release::default() }).unwrap();
    let heavy = TopParameters { axial_inertia: 1.0, ..body };
    let refusal = Motion::launch(&Top::fixed(&heavy).unwrap(), &state).unwrap_err();
    assert!(refusal.parameter() == "omega" && refusal.allowed().contains("free"), "{refusal}");
    assert!(Motion::launch(&Top::free(&heavy).unwrap(), &state).is_ok());
}

#[test]
fn states() {
    let z = Complex::new;
    let state = |alpha, beta, omega| parameter(State::new(Orientation { alpha, beta }, omega));
    assert_eq!(state(z(0.6, 0.0), z(0.0, 0.8), [0.0; 3]), None);
    assert_eq!(state(z(0.6, 0.0), z(0.0, 0.8000006), [0.0; 3]), None);
    assert_eq!(state(z(0.6, 0.0), z(0.0, 0.8000007), [0.0; 3]), Some("alpha"));
    assert_eq!(state(z(0.0, 0.0), z(0.0, 0.0), [0.0; 3]), Some("alpha"));
    assert_eq!(state(z(f64::NAN, 0.0), z(0.0, 0.8), [0.0; 3]), Some("alpha"));
    assert_eq!(state(z(0.6, 0.0), z(f64::INFINITY, 0.8), [0.0; 3]), Some("beta"));
    assert_eq!(state(z(0.6, 0.0), z(0.0, 0.8), [0.0, f64::NAN, 0.0]), Some("omega"));
    assert_eq!(state(z(0.6, 0.0), z(0.0, 0.8), [1e13, 0.0, 0.0]), Some("omega"));
}

#[test]
fn releases() {
    let release = |change: fn(&mut Release)| {
        let mut release = Release { tilt: 0.3, spin: 10.0, ..Release::default() };
        change(&mut release);
        parameter(State::release(&release))
    };
    assert_eq!(release(|_| ()), None);
    assert_eq!(release(|r| r.tilt = -1e-9), Some("tilt"));
    assert_eq!(release(|r| r.tilt = 3.15), Some("tilt"));
    assert_eq!(release(|r| r.azimuth = f64::NAN), Some("azimuth"));
    assert_eq!(release(|r| r.roll = f64::NEG_INFINITY), Some("roll"));
    assert_eq!(release(|r| r.spin = 1e12), Some("spin"));
    assert_eq!(release(|r| r.precession = f64::NAN), Some("precession"));
    assert_eq!(release(|r| r.nutation = 1e300), Some("nutation"));
}

#[test]
fn branch_points() {
    let e = |e1, e2, e3| parameter(BranchPoints::new(e1, e2, e3));
    assert_eq!(e(-1.0, 1.0, 1.0), None);
    assert_eq!(e(-1.0000001, 0.5, 2.0), Some("e1"));
    assert_eq!(e(0.6, 0.5, 2.0), Some("e2"));
    assert_eq!(e(0.6, 1.1, 2.0), Some("e2"));
    assert_eq!(e(0.6, 0.9, 0.99), Some("e3"));
    assert_eq!(e(0.6, 0.9, 1e15), Some("e3"));
    assert_eq!(e(f64::NAN, 0.9, 2.0), Some("e1"));
    let motion =
        |start| parameter(Motion::from_branch_points(&top(), [0.7, 0.9, 2.0], Signs::default(), &start));
    assert_eq!(motion(Start { theta: f64::NAN, ..Start::default() }), Some("theta"));
    assert_eq!(motion(Start { arg_alpha: 1e7, ..Start::default() }), Some("arg_alpha"));
    assert_eq!(motion(Start { arg_beta: f64::INFINITY, ..Start::default() }), Some("arg_beta"));
}

#[test]
fn motions_too_fast_and_energies_too_low() {
    let spinning = |spin| State::release(&Release { tilt: 0.3, spin, ..Release::default() }).unwrap();
    assert_eq!(parameter(Motion::launch(&top(), &spinning(1e7))), None);
    assert_eq!(parameter(Motion::launch(&top(), &spinning(1e8))), Some("omega"));
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), 2.0, 2.0, 1.0)), Some("h"));
    // enough energy for some heights, but not for this l at any height
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), 1.5, 0.0, 0.5)), Some("h"));
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), 1.0, 0.0, 0.5)), None);
    // a top at rest: only hanging is possible
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), 0.0, 0.0, -1.0)), None);
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), 0.0, 0.0, -1.0 - 1e-6)), Some("h"));
    assert_eq!(parameter(BranchPoints::from_integrals(&top(), f64::NAN, 2.0, 1.0)), Some("l"));
}

#[test]
fn ticks() {
    assert_eq!([Tick::hertz(0), Tick::ratio(0, 1), Tick::ratio(1, 0)].map(parameter), [Some("tick"); 3]);
    assert_eq!(parameter(Tick::ratio(u32::MAX, 1)), None);
}

#[test]
fn messages_name_the_parameter_and_what_is_allowed() {
    let error = BranchPoints::new(0.6, 0.5, 2.0).unwrap_err();
    assert_eq!(error.to_string(), "e2: must be in [e1, 1]");
    assert_eq!(BranchPoints::new(0.6, f64::NAN, 2.0).unwrap_err().to_string(), "e2: must be a finite number");
}

#[test]
fn a_small_table_states_the_needed_size() {
    let refusal = TableTooSmall { truncation: 0.0025, segments: 64 };
    assert_eq!(refusal.to_string(), "a table of 64 segments cannot follow the motion to within 2.5e-3 rad");
}

#[test]
fn signs_are_factors() {
    assert_eq!([Sign::Plus.factor(), Sign::Minus.factor()], [1, -1]);
    assert_eq!([Sign::of(0.0), Sign::of(-1e-300)].map(Sign::factor), [1, -1]);
}

/// A table that refused a motion in set-up has an infinite error bound.
#[test]
fn a_refused_set_up_states_no_bound() {
    let [easy, hard] =
        ["exact_generic_pp", "near_separatrix_straddle"].map(|name| vectors::named(name).motion().unwrap());
    let tick = Tick::hertz(1000).unwrap();
    let mut ephemeris = Ephemeris::<f64, 48>::new(&easy, tick).unwrap();
    assert!(ephemeris.error_bound().after(1e9) < 1e-12);
    assert!(ephemeris.set_up(&hard, tick, 1e-19).is_err());
    assert_eq!(ephemeris.error_bound().after(0.0), f64::INFINITY);
}
